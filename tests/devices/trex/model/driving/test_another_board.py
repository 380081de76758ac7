"""Another board at the port while motors of the first may turn."""

from collections.abc import Callable

import pytest
from pytestqt.qtbot import QtBot

from tests.support.pages.motors import is_stopped
from tests.support.simulator import StartSimulator
from tests.support.virtual_devices import VirtualSimulator
from trex_gui.core.events import EventKind
from trex_gui.devices.trex.model.controller import TrexController
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.devices.connection import ConnectionState

Start = Callable[..., VirtualSimulator]


class DrivenBoard:
    """Device with a board whose motor 1 runs, and its messages."""

    def __init__(
        self,
        controller: TrexController,
        board: VirtualSimulator,
        unpowered: VirtualSimulator,
        qtbot: QtBot,
    ) -> None:
        self.controller = controller
        self.device = device = controller.device
        self.unpowered = unpowered
        unpowered.do("power off")
        self.board = board
        self.qtbot = qtbot
        self.errors: list[str] = []
        for said in (device.notifier.error, device.notifier.danger):
            said.connect(self.errors.append)
        self.connect(board.url)
        self.drive(board)

    def connect(self, url: str) -> None:
        self.device.connect_to(ConnectionSettings(url))
        self.wait(self.is_ready)
        self.wait(lambda: not self.device.may_move)

    def is_ready(self) -> bool:
        return self.device.link is ConnectionState.CONNECTED and self.device.motors.is_available

    def drive(self, board: VirtualSimulator) -> None:
        self.device.motors.arm()
        self.device.motors.set_speed(1, 90)
        self.wait(lambda: self.runs(board))

    def runs(self, board: VirtualSimulator) -> bool:
        return bool(board.show()["motors"][0]["direction"] == "forward")

    def unplug(self, board: VirtualSimulator) -> None:
        """Remove the board from the open port. It stays powered."""
        board.move_cable_to(self.unpowered)
        self.wait(lambda: self.device.link is ConnectionState.NOT_RESPONDING)

    def plug(self, board: VirtualSimulator) -> None:
        self.unpowered.move_cable_to(board)
        self.wait(self.is_ready)
        self.wait(lambda: not self.device.may_move)

    def exchange(self, other: VirtualSimulator) -> None:
        """Plug another board into the open port."""
        self.unplug(self.board)
        self.plug(other)

    def closing_text(self) -> str:
        """Disconnect, and return the warning of a closing window."""
        self.device.disconnect_line()
        self.wait(lambda: self.device.link is ConnectionState.DISCONNECTED)
        return self.controller.unconfirmed_stop

    def wait(self, condition: Callable[[], bool]) -> None:
        self.qtbot.waitUntil(condition)


@pytest.fixture
def driven(
    controller: TrexController, quick_simulator: VirtualSimulator, start: Start, qtbot: QtBot
) -> DrivenBoard:
    return DrivenBoard(controller, quick_simulator, start(), qtbot)


@pytest.fixture
def start(start_simulator: StartSimulator) -> Start:
    def start_unpaced(*arguments: str) -> VirtualSimulator:
        simulator = start_simulator("--unpaced", *arguments)
        assert isinstance(simulator, VirtualSimulator)
        return simulator

    return start_unpaced


def runs_on(driven: DrivenBoard) -> str:
    return (
        f"The stop may not have reached the TReX 1.2 that was driven at {driven.board.url}: "
        "another board responded. If its motor still turns, cut its power."
    )


def test_another_model_does_not_confirm_the_stop(driven: DrivenBoard, start: Start) -> None:
    driven.exchange(start("--model", "trexjr"))
    text = f"Another board responds now: TReX Jr 1.2, at {driven.board.url}. {runs_on(driven)}"
    assert driven.errors[-1] == text
    assert driven.closing_text() == runs_on(driven)


def test_other_stored_settings_suggest_another_board(driven: DrivenBoard, start: Start) -> None:
    other = start()
    other.do("eeprom serial_timeout 7")
    driven.exchange(other)
    assert driven.errors[-1].startswith("This may be another board: TReX 1.2, at ")
    assert driven.closing_text() == runs_on(driven)


def test_board_with_equal_settings_counts_as_the_same(driven: DrivenBoard, start: Start) -> None:
    driven.exchange(start())
    assert driven.closing_text() == ""


def test_power_cycle_with_a_moved_jumper_is_the_same_board(driven: DrivenBoard) -> None:
    driven.board.do("power off")
    driven.wait(lambda: driven.device.link is ConnectionState.NOT_RESPONDING)
    driven.board.do("jumper mode analog")
    driven.board.do("power on")
    driven.wait(lambda: driven.device.link is ConnectionState.CONNECTED)
    assert driven.closing_text() == ""


def test_driven_board_that_is_back_is_stopped(driven: DrivenBoard, start: Start) -> None:
    other = start("--model", "trexjr")
    driven.exchange(other)
    assert driven.runs(driven.board)
    driven.unplug(other)
    may_move: list[bool] = []
    device = driven.device
    device.motors.stop_requested.connect(lambda: may_move.append(device.may_move))
    driven.plug(driven.board)
    assert True in may_move, "it may turn until its stop is confirmed"
    assert is_stopped(driven.board)
    assert driven.closing_text() == ""


def test_driven_board_at_another_port_is_stopped(driven: DrivenBoard, start: Start) -> None:
    driven.exchange(start("--model", "trexjr"))
    driven.device.disconnect_line()
    driven.wait(lambda: driven.device.link is ConnectionState.DISCONNECTED)
    driven.controller.press_stop()
    # The known serial timeout belongs to the other board.
    assert driven.errors[-1] == runs_on(driven)
    driven.connect(driven.board.url)
    assert is_stopped(driven.board)
    assert driven.closing_text() == ""


def test_stop_of_a_board_that_was_not_read_does_not_count(
    driven: DrivenBoard, start: Start
) -> None:
    driven.unplug(driven.board)
    driven.unpowered.move_cable_to(start())
    assert "not confirmed" in driven.closing_text()


def test_another_board_behind_a_line_that_was_lost_is_noticed(
    driven: DrivenBoard, start: Start
) -> None:
    other = start("--model", "trexjr")
    driven.board.do("line unplug")
    driven.wait(lambda: driven.device.link is ConnectionState.DISCONNECTED)
    assert driven.device.may_move
    driven.connect(other.url)
    assert driven.errors[-1].endswith(runs_on(driven))
    assert driven.closing_text() == runs_on(driven)


def test_every_lost_board_has_to_be_stopped(driven: DrivenBoard, start: Start) -> None:
    second, third = start("--model", "trexjr"), start("--firmware", "1.0")
    driven.exchange(second)
    driven.drive(second)
    second.do("line unplug")
    driven.wait(lambda: driven.device.link is ConnectionState.DISCONNECTED)
    driven.connect(third.url)
    driven.connect(second.do("line plug").split()[-1])
    assert driven.closing_text() == runs_on(driven)
    driven.connect(driven.board.url)
    assert driven.closing_text() == ""


def test_failed_connection_adds_no_board_to_those_lost(driven: DrivenBoard, start: Start) -> None:
    silent, third = start(), start("--firmware", "1.0")
    silent.do("line mute on")
    driven.exchange(start("--model", "trexjr"))
    driven.device.disconnect_line()
    driven.wait(lambda: driven.device.link is ConnectionState.DISCONNECTED)
    driven.device.connect_to(ConnectionSettings(silent.url))
    driven.wait(lambda: driven.device.link is ConnectionState.DISCONNECTED)
    assert not driven.device.may_move
    driven.connect(third.url)
    driven.connect(driven.board.url)
    assert driven.closing_text() == ""


def test_interrupted_apply_does_not_make_it_another_board(driven: DrivenBoard) -> None:
    device = driven.device
    device.parameters.edit("serial_timeout", 15)
    device.parameters.edit("motor1_acceleration", 3)
    device.writer.apply()
    driven.board.do("power off")
    driven.wait(lambda: device.link is ConnectionState.NOT_RESPONDING)
    driven.board.do("power on")
    driven.wait(lambda: device.link is ConnectionState.CONNECTED)
    assert driven.closing_text() == ""


def test_write_of_another_program_stops_motors(
    driven: DrivenBoard,
) -> None:
    driven.board.do("eeprom serial_timeout 20")
    driven.wait(lambda: not driven.device.motors.armed)
    assert driven.device.motors.stop_reason == (
        "A setting of the board changed, so the motors were stopped."
    )
    links = [event.text for event in driven.device.events.all if event.kind is EventKind.LINK]
    assert links[1:] == [
        "A setting changed: the board was restarted, or another program wrote to it"
    ]
