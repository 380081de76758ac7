"""What is active and what happened: the pages of errors and of the log."""

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QPlainTextEdit, QTableWidget, QTabWidget

from tests.support.simulator import SimulatedDevice
from tests.support.window import WidgetDriver, WindowDriver
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.plotting.export import ExportButton


def row(page: WidgetDriver, error: str) -> dict[str, str]:
    """Return the cells of an error by the title of their column."""
    model = page.find(QTableWidget, "errorsTable").model()
    titles = [
        model.headerData(column, Qt.Orientation.Horizontal) for column in range(model.columnCount())
    ]
    for number in range(model.rowCount()):
        cells = [str(model.index(number, column).data()) for column in range(len(titles))]
        if cells[0] == error:
            return dict(zip(titles, cells, strict=True))
    raise AssertionError(f"no row {error}")


def is_bold(page: WidgetDriver, error: str) -> bool:
    (item,) = page.find(QTableWidget, "errorsTable").findItems(error, Qt.MatchFlag.MatchExactly)
    return item.font().bold()


def test_errors_are_shown_until_they_are_cleared_and_reset(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    page = window.open_page("errorsPage")
    assert row(page, "Motor 2 fault")["Active now"] == "N/A"
    assert row(page, "Motor 2 fault")["Stopping the motors"] == "N/A"
    window.window.resize(1024, 600)
    value = page.find(QLabel, "restartsValue")
    page.wait(lambda: value.isVisible() and value.height() < 2 * value.fontMetrics().lineSpacing())
    quick_simulator.do("fault 2 on")
    quick_simulator.do("fault 2 off")
    window.connect(quick_simulator.url)
    assert page.text("rateValue") == "–", "short, so that it is in one line"
    tabs, index = window.find(QTabWidget, "diagnosticsPage"), 0
    page.wait(lambda: row(page, "Motor 2 fault")["Last seen"] == "before connecting")
    assert row(page, "Motor 2 fault")["Count"] == "0"
    texts = [event.text for event in window.device.events.all]
    assert any(text.startswith("Latched before connecting") for text in texts)
    assert tabs.tabText(index) == "Errors"
    assert not page.is_enabled("clearErrorsButton")
    page.click("resetCountsButton")
    assert row(page, "Motor 2 fault")["Last seen"] == "never"
    fault = row(page, "Motor 1 fault")
    assert [fault["Active now"], fault["Count"], fault["Last seen"]] == ["No", "0", "never"]

    quick_simulator.do("fault 1 on")
    page.wait(lambda: row(page, "Motor 1 fault")["Active now"] == "⚠ Yes")
    fault = row(page, "Motor 1 fault")
    assert fault["Stopping the motors"] == "⚠ Yes"
    assert "let it cool" in fault["What it means, and what to do"]
    assert "let it cool" not in row(page, "Motor 2 fault")["What it means, and what to do"]
    assert is_bold(page, "Motor 1 fault")
    assert not is_bold(page, "Motor 2 fault")
    assert tabs.tabText(index) == "Errors (1)"
    page.click("clearErrorsButton")
    assert not is_bold(page, "Motor 1 fault")
    page.wait(lambda: is_bold(page, "Motor 1 fault"))  # it is still active

    quick_simulator.do("fault 1 off")
    page.wait(lambda: row(page, "Motor 1 fault")["Active now"] == "No")
    count = row(page, "Motor 1 fault")["Count"]
    assert int(count) > 2
    page.click("clearErrorsButton")
    assert tabs.tabText(index) == "Errors"
    assert row(page, "Motor 1 fault")["Count"] == count

    page.click("resetCountsButton")
    assert row(page, "Motor 1 fault")["Count"] == "0"
    assert row(page, "Motor 1 fault")["Last seen"] == "never"
    assert not page.is_enabled("resetCountsButton")

    page.wait(lambda: "good: " in page.text("qualityValue"))
    assert int(page.text("rateValue")) > 100
    assert page.text("connectedValue").startswith("0:00:")
    assert page.text("returnsValue") == "0"
    assert page.text("restartsValue") == "0"
    quick_simulator.do("power off")
    window.wait(lambda: window.device.link is ConnectionState.NOT_RESPONDING)
    assert page.text("qualityValue") == "N/A"
    quick_simulator.do("power on")
    page.wait(lambda: page.text("returnsValue") == "1")
    quick_simulator.do("jumper mode rc")
    quick_simulator.do("power cycle")
    page.wait(lambda: page.text("restartsValue") == "1")

    window.disconnect()
    assert page.text("connectedValue") == "N/A"
    assert not page.is_enabled("errorsTable")


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
