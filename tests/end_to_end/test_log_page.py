"""What happened to a TReX can be found again on the Log page."""

from pathlib import Path

from PySide6.QtWidgets import QPlainTextEdit

from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.plotting.export import ExportButton


def test_log_keeps_what_happened_over_disconnects(
    window: WindowDriver, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    window.program.complete()
    window.program.make_plots()
    device, url = window.device, quick_simulator.url
    window.connect(url)
    window.click("runButton")
    window.program.device_manager.stop_because("The screen was locked")
    window.wait_for_text("bannerText", "so the motors were stopped")
    device.parameters.edit("serial_timeout", 15)
    device.writer.apply()
    window.wait(lambda: not device.writer.running and not device.draft.pending)
    device.writer.reset_to_factory()
    window.wait(lambda: device.draft.reset_pending)
    quick_simulator.do("line mute on")
    window.wait(lambda: device.link is ConnectionState.NOT_RESPONDING)
    quick_simulator.do("line mute off")
    window.wait(lambda: device.link is ConnectionState.CONNECTED)
    quick_simulator.do("line unplug")
    window.wait(lambda: device.link is ConnectionState.DISCONNECTED)
    window.click("bannerDismiss")

    export = window.find(ExportButton, "exportButton")
    export.save_picture(tmp_path / "currents.png")
    window.wait_for_files()

    window.open_page("trexLogPage")
    text = window.find(QPlainTextEdit, "trexLog").toPlainText()
    place = 0
    for part in (
        f"Connected to TReX 1.2 on {url}",
        "Stop: The screen was locked.",
        "⚠ The screen was locked, so the motors were stopped.",
        "Apply: Serial Timeout",
        "1 setting written and verified.",
        "Apply: Reset to factory defaults",
        "⚠ The board stopped responding",
        "The board responds again",
        "Disconnected",
        f"⚠ The line to {url} is gone.",
        f"The picture was written to {tmp_path}",
    ):
        place = text.find(part, place)
        assert place >= 0, f"{part} in {text}"
    window.connect_to_demo("aracna")
    log = window.program.workspace("aracna").log
    assert not any(url in entry.text for entry in log.entries), "each device has its own"
