"""Scan for boards with unknown line settings."""

import sys

import pytest
from PySide6.QtWidgets import QProgressBar, QPushButton, QToolButton

from tests.support.keyboard import check_keyboard
from tests.support.pages.find_dialog import FindBoardDialog
from tests.support.program import trex
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.window import WindowDriver
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.frame.find_dialog import FindDialog
from trex_gui.ui.runtime import open_transport

if sys.platform == "win32":
    pytest.skip("has no pseudo-terminals", allow_module_level=True)

pytestmark = pytest.mark.usefixtures("no_ports")

EVEN = LineSettings(57600, Detection.EVEN)


@pytest.fixture
def dialog(no_ports: None, window: WindowDriver) -> FindBoardDialog:
    window.trigger("find")
    dialog = window.find(FindDialog, "findDialog")
    return FindBoardDialog(dialog, window.program.device_manager.scanner, window.qtbot)


def store(simulator: SimulatedDevice, line: LineSettings) -> None:
    """Store line settings in a board and power-cycle the board."""
    simulator.do(f"eeprom uart_settings {line.to_wire()}", "power cycle")


def test_board_at_unknown_line_settings_is_found_and_connected(
    window: WindowDriver, dialog: FindBoardDialog, quick_simulator: SimulatedDevice
) -> None:
    url = quick_simulator.url
    store(quick_simulator, LineSettings(57600))
    progress: list[tuple[str, int]] = []
    bar = dialog.find(QProgressBar, "findProgress")
    dialog.finder.progressed.connect(
        lambda: progress.append((dialog.text("findProgressText"), bar.maximum()))
    )
    traffic = window.device.connection.traffic
    dialog.search(window, url)
    assert dialog.root.focusWidget() is dialog.find(QPushButton, "findCancelButton")
    assert not dialog.is_enabled("findStartButton")
    dialog.wait(lambda: dialog.has("connectFound0"), 60_000)
    at_115200 = [
        maximum for text, maximum in progress if text.startswith("Looking for TReX at 115200")
    ]
    assert set(at_115200) == {102}, "number of probes for all devices"
    assert dialog.text("findText0").startswith(f"TReX 1.2, device 7 on {url} at 57600 baud.")
    dialog.wait_for_end()
    assert dialog.text("findProgressText") == "1 board found."
    assert dialog.root.focusWidget() is dialog.find(QPushButton, "connectFound0")
    meanings = [traffic.decoder.decoded(row).text for row in traffic.without_polling.rows]
    assert "search: get signature → TReX 1.2" in meanings
    assert "search: get signature → no reply" in meanings
    assert any(text.startswith("search: Set to 57600 baud") for text in meanings)
    assert traffic.faults == 0, "a probe without reply is no fault"
    check_keyboard(dialog.root)
    dialog.click("connectFound0")
    assert not dialog.root.isVisible()
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    assert window.device.settings is not None
    assert window.device.settings.line == LineSettings(57600)
    assert window.find(QToolButton, "lineButton").text() == "57600 baud"
    entries = window.device.board.errors.entries
    window.wait(lambda: any(entry.is_earlier for entry in window.device.board.errors.entries))
    assert not any(entry.count for entry in entries), "errors that the scan caused are not counted"
    assert all(motor["direction"] == "brake" for motor in quick_simulator.show()["motors"])

    window.click("findButton")
    assert f"{url} – connected to this window" in dialog.rows()
    assert dialog.text("findBusyLabel").startswith(f"{url} is connected to this window")
    dialog.click("findDisconnectButton")
    window.wait(lambda: window.device.link is ConnectionState.DISCONNECTED)
    assert not dialog.has("findBusyLabel")
    progress.clear()
    dialog.click("findStartButton")
    dialog.wait(lambda: dialog.has("connectFound0"), 60_000)
    dialog.wait_for_end()
    assert not any("Looking for" in text for text, _ in progress), (
        "the board is found where it was before"
    )


@pytest.mark.slow
@pytest.mark.realtime
@pytest.mark.timeout(120)
@pytest.mark.filterwarnings("ignore:set(Daemon|Name):DeprecationWarning")
def test_board_with_parity_is_found_over_rfc2217(
    window: WindowDriver, dialog: FindBoardDialog, start_simulator: StartSimulator
) -> None:
    simulator = start_simulator("--unpaced", "--rfc2217", "127.0.0.1:0")
    store(simulator, EVEN)
    dialog.finder.start([window.program.ports.add_typed(simulator.url)])
    assert dialog.has("findCancelButton")
    dialog.wait_for_end()
    (finding,) = dialog.finder.findings
    assert finding.text == f"TReX 1.2, device 7 on {simulator.url} at 57600 baud, even parity."
    dialog.click("connectFound0")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    assert window.device.settings is not None
    assert window.device.settings.line == EVEN


def test_search_ends_when_cancelled_or_dialog_closes(
    window: WindowDriver, dialog: FindBoardDialog, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("power off")
    dialog.search(window, quick_simulator.url)
    dialog.wait(lambda: dialog.finder.done > 1)
    dialog.click("findCancelButton")
    dialog.wait_for_end()
    assert dialog.text("findProgressText") == "Search cancelled."
    assert dialog.is_enabled("findStartButton")
    assert not dialog.has("findText0")

    dialog.click("findStartButton")
    assert dialog.is_searching()
    dialog.click("findCloseButton")
    dialog.wait_for_end()
    assert dialog.finder.summary == "Search cancelled."

    dialog.search(window, quick_simulator.url)
    assert dialog.is_searching()
    window.window.close()
    assert not dialog.is_searching()
    assert not dialog.root.isVisible()


def test_failed_connection_offers_the_settings_of_the_board(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    store(quick_simulator, EVEN)
    controller = trex(window.program).controller
    controller.set_settings(ConnectionSettings("", LineSettings(57600)))
    window.connect_port(window.program.ports.add_typed(quick_simulator.url))
    window.wait_for_text("bannerText", "even parity, but this connection uses 57600 baud")
    assert not window.has("bannerFind")
    window.click("bannerConnectWith")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    assert not window.has("bannerText")
    assert controller.settings.line == EVEN, "the settings are saved"


def test_search_without_board_reports_why_none_was_found(
    window: WindowDriver, dialog: FindBoardDialog, quick_simulator: SimulatedDevice
) -> None:
    url = quick_simulator.url
    quick_simulator.do("power off")
    trex(window.program).controller.connect_to(window.program.ports.add_typed(url))
    window.wait_for_text("bannerText", "No TReX responds on")
    assert window.device.link is ConnectionState.DISCONNECTED

    dialog.root.close()
    window.click("bannerFind")
    assert dialog.is_searching(), "the scan starts at once"
    dialog.wait_for_end()
    assert not dialog.has("findText1"), "no other port is scanned"
    assert dialog.text("findText0").startswith(f"No TReX responds on {url} at any")
    assert not dialog.has("connectFound0")
    assert dialog.text("findProgressText") == "No board was found."

    other = open_transport(ConnectionSettings(url))
    dialog.click("findStartButton")
    dialog.wait_for_end()
    other.close()
    assert "is in use" in dialog.text("findText0")
