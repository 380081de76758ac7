"""Two boards that are driven as one robot."""

import pytest

from tests.end_to_end.test_boards_on_one_line import connect, find_boards, rows
from tests.support.pages.motors import MotorsPage, signed_speeds
from tests.support.simulator import StartSimulator
from tests.support.virtual_devices import VirtualSimulator
from tests.support.window import WindowDriver
from trex_gui.devices.trex.client.telemetry import Control
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.runtime import now


@pytest.fixture
def boards(window: WindowDriver, start_simulator: StartSimulator) -> VirtualSimulator:
    """Boards 7 (left wheels) and 9 (right wheels), found and joined on one line."""
    started = start_simulator("--unpaced", "--device", "7", "--device", "9:trexjr")
    assert isinstance(started, VirtualSimulator)
    connect(window, started.url, 7)
    find_boards(window)
    window.click("groupButton")
    dialog = window.dialog("groupDialog")
    dialog.combo("wheel72Side").setCurrentIndex(0)
    dialog.combo("wheel91Side").setCurrentIndex(1)
    dialog.click("joinBoards")
    window.wait(lambda: window.device.is_connected and window.motors.is_available)
    return started


def speeds(boards: VirtualSimulator) -> list[int]:
    return [*signed_speeds(boards, "@7"), *signed_speeds(boards, "@9")]


def test_two_boards_are_driven_with_one_pad(window: WindowDriver, boards: VirtualSimulator) -> None:
    page = MotorsPage(window, boards)
    page.arm()
    window.motors.set_speeds(20, -10)
    window.wait(lambda: speeds(boards) == [20, 20, -10, -10])
    window.click("stopButton")
    window.wait(lambda: speeds(boards) == [0, 0, 0, 0])
    window.wait(lambda: not window.device.may_move)


def test_lost_board_stops_the_other_and_is_named(
    window: WindowDriver, boards: VirtualSimulator
) -> None:
    page = MotorsPage(window, boards)
    page.arm()
    window.motors.set_speeds(20, 20)
    window.wait(lambda: speeds(boards) == [20, 20, 20, 20])
    boards.do("@9 power off")
    window.wait(lambda: speeds(boards)[:2] == [0, 0])
    window.wait(lambda: not window.motors.armed)
    assert window.device.may_move, "board 9 has not confirmed its stop"
    assert not window.is_enabled("partButton")
    window.wait_for_text("bannerText", "Board 9")
    assert not window.motors.can_arm
    boards.do("@9 power on")
    window.wait(lambda: window.motors.is_available and not window.device.may_move)
    assert window.is_enabled("partButton")
    window.disconnect()
    window.connect_to_demo()
    assert not window.has("groupCards")


def test_board_that_leaves_serial_control_is_named(
    window: WindowDriver, boards: VirtualSimulator
) -> None:
    MotorsPage(window, boards).arm()
    (other,) = window.device.other_devices
    other.board.newest.update(Control(now(), by_serial=False))
    window.device.driving.update_available()
    assert not window.motors.armed
    assert window.motors.stop_reason.startswith("Board 9: Serial commands no longer reach")


def test_group_can_be_left_without_a_scan_for_boards(
    window: WindowDriver, start_simulator: StartSimulator
) -> None:
    line = start_simulator("--unpaced", "--device", "7", "--device", "9")
    settings = ConnectionSettings(line.url).with_group((7, 9))
    port = window.program.ports.add_typed(line.url)
    window.program.device_manager.connect_with(port, settings)
    window.wait(lambda: window.device.is_connected and window.motors.is_available)
    assert [name for name, *_ in rows(window)] == ["7 · TReX 1.2", "9"]
    window.click("partButton")
    window.wait(lambda: window.has("groupButton"))
    assert not window.has("groupCards")


def test_group_without_one_board_can_be_left(
    window: WindowDriver, boards: VirtualSimulator
) -> None:
    window.disconnect()
    boards.do("@9 power off")
    window.click("connectButton")
    window.wait_for_text("bannerText", "Board 9")
    window.click("connectButton")
    window.wait(lambda: window.device.is_connected)
    assert not window.has("groupCards")
    MotorsPage(window, boards).arm()
    window.motors.set_speeds(20, -10)
    window.wait(lambda: speeds(boards)[:2] == [20, -10])
