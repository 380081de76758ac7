"""Active and past errors on the Problems page and in the log."""

from pathlib import Path

from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QLabel, QLineEdit, QPlainTextEdit, QTabWidget, QTextBrowser

from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.plotting.export import ExportButton
from trex_gui.ui.plotting.plot import TracePlot


def test_errors_are_shown_until_they_are_cleared_and_reset(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    page = window.open_page("errorsPage")

    def title(bit: str) -> str:
        """Return the title of a card. Empty without a card."""
        labels = [each for each in page.find_all(QLabel) if each.objectName() == f"{bit}Title"]
        return labels[0].text() if labels else ""

    assert page.text("errorsNote").startswith("Nothing is connected.")
    assert not page.find(QLabel, "errorsReading1").isVisible()
    quick_simulator.do("fault 2 on", "fault 2 off")
    window.connect(quick_simulator.url)
    tabs, index = window.find(QTabWidget, "diagnosticsTabs"), 0
    page.wait(lambda: title("MOTOR2_FAULT") == "Motor 2 fault")
    assert "before connecting" in page.text("MOTOR2_FAULTTimes")
    texts = [event.text for event in window.device.events.all]
    assert any(text.startswith("Latched before connecting") for text in texts)
    assert tabs.tabText(index) == "Problems", "an error before the connection is not counted"
    assert not page.button("MOTOR2_FAULTClear").isVisible()
    page.click("resetCountsButton")
    page.wait(lambda: not title("MOTOR2_FAULT"))
    assert page.text("errorsNote").startswith("Nothing has gone wrong since ")
    assert not page.is_enabled("resetCountsButton")

    quick_simulator.do("fault 1 on")
    page.wait(lambda: title("MOTOR1_FAULT") == "Motor 1 fault, active now, stops the motors")
    assert "let the driver cool" in page.text("MOTOR1_FAULTText")
    assert tabs.tabText(index) == "Problems (1)"
    assert window.find(QTabWidget, "tabs").tabBar().accessibleTabName(5) == "Diagnostics (1)"
    window.find(QLineEdit, "diagnosticsSearch").setText("no such problem")
    assert not page.find(QLabel, "MOTOR1_FAULTTitle").isVisible()
    window.find(QLineEdit, "diagnosticsSearch").clear()
    window.click("diagnosticsCopy")
    assert "Motor 1 fault, active now" in QGuiApplication.clipboard().text()

    quick_simulator.do("fault 1 off")
    page.wait(lambda: title("MOTOR1_FAULT") == "Motor 1 fault, no longer active")
    page.click("MOTOR1_FAULTClear")
    assert tabs.tabText(index) == "Problems"
    assert title("MOTOR1_FAULT"), "the card of a past error remains"

    page.wait(lambda: page.text("errorsReading1") == "100.0 %")
    assert int(page.text("errorsReading2")) > 100
    assert page.text("errorsReading4").startswith("0:00:")
    quick_simulator.do("power off")
    window.wait(lambda: window.device.link is ConnectionState.NOT_RESPONDING)
    assert page.text("errorsReading1") == "–"
    quick_simulator.do("power on")
    restarts = page.find(QLabel, "errorsReading5")
    page.wait(lambda: restarts.toolTip().endswith("Returns after silence: 1."))
    quick_simulator.do("jumper mode rc", "power cycle")
    page.wait(lambda: restarts.text() == "1")
    window.disconnect()
    assert page.text("errorsReading4") == "–"


def test_card_opens_help_transcript_and_plot_of_problem(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    page = window.open_page("errorsPage")
    window.connect(quick_simulator.url)
    quick_simulator.do("line error framing")
    page.wait(lambda: window.has("FRAMINGShow"))
    page.click("FRAMINGExplain")
    window.wait(window.help.isVisible)
    (browser,) = window.help.findChildren(QTextBrowser)
    assert browser.source().fragment() == "framing-error"
    page.click("FRAMINGShow")
    assert window.find(QTabWidget, "diagnosticsTabs").currentIndex() == 2
    assert window.find(QPlainTextEdit, "transcriptDetails").toPlainText(), "a row is selected"

    page = window.open_page("errorsPage")
    quick_simulator.do("fault 2 on")
    page.wait(lambda: window.has("MOTOR2_FAULTShow"))
    start = window.device.events.all[-1].time
    quick_simulator.do("fault 2 off")
    page.wait(lambda: window.device.telemetry.latest > start + 40, timeout=60_000)
    page.click("MOTOR2_FAULTShow")
    plot = window.find_only(TracePlot)
    assert plot.cursor_time == start
    assert plot.span.start < start < plot.span.end


def test_log_retains_events_after_disconnecting(
    window: WindowDriver, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    window.program.complete()
    window.program.create_plots()
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
    position = 0
    for part in (
        f"Connected to TReX 1.2 on {url}",
        "Stop: The screen was locked.",
        "⚠ The screen was locked, so the motors were stopped.",
        "Apply: Serial Timeout",
        "1 setting written and verified.",
        "Apply: Reset to factory defaults",
        "⚠ The board stopped responding.",
        "The board responds again",
        "Disconnected",
        f"⚠ The connection to {url} is gone.",
        f"The picture was written to {tmp_path}",
    ):
        position = text.find(part, position)
        assert position >= 0, f"{part} in {text}"
    window.connect_to_demo("aracna")
    log = window.program.workspace("aracna").log
    assert not any(url in entry.text for entry in log.entries), "each device has its own log"
