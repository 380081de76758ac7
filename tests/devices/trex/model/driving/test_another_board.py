"""Another board at the port while motors of the first board may turn."""

from collections.abc import Callable

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.trex.model.device_setup import DeviceSetup
from tests.support.pages.motors import is_stopped
from tests.support.simulator import StartSimulator
from tests.support.virtual_devices import VirtualSimulator
from trex_gui.core.events import EventKind
from trex_gui.core.transport.adapters import Adapter
from trex_gui.devices.trex.model.controller import TrexController
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.ports import Port, PortKind

Start = Callable[..., VirtualSimulator]


class DrivenBoard(DeviceSetup):
    """Device that drives motor 1 of a board, and its messages."""

    def __init__(
        self,
        controller: TrexController,
        board: VirtualSimulator,
        unpowered: VirtualSimulator,
        qtbot: QtBot,
    ) -> None:
        super().__init__(qtbot, board, controller.device)
        self.controller = controller
        self.unpowered = unpowered
        unpowered.do("power off")
        self.board = board
        self.errors: list[str] = []
        self.device.notifier.error.connect(self.errors.append)
        self.device.notifier.danger.connect(self.errors.append)
        self.connect()
        self.drive(board)

    def connect(self, url: str = "") -> None:
        super().connect(url)
        self.until_ready()

    def until_ready(self) -> None:
        self.until_link(ConnectionState.CONNECTED)
        self.until(lambda: self.device.motors.is_available and not self.device.may_move)

    def drive(self, board: VirtualSimulator) -> None:
        self.device.motors.arm()
        self.device.motors.set_speed(1, 90)
        self.until(lambda: self.runs(board))

    def runs(self, board: VirtualSimulator) -> bool:
        return bool(board.show()["motors"][0]["direction"] == "forward")

    def unplug(self, board: VirtualSimulator) -> None:
        """Remove the board from the open port. It stays powered."""
        board.move_cable_to(self.unpowered)
        self.until_link(ConnectionState.NOT_RESPONDING)

    def plug(self, board: VirtualSimulator) -> None:
        self.unpowered.move_cable_to(board)
        self.until_ready()

    def replace_board(self, new: VirtualSimulator) -> None:
        """Plug another board into the open port."""
        self.unplug(self.board)
        self.plug(new)

    def lose(self, board: VirtualSimulator) -> None:
        """Unplug the cable of the connected board from the computer."""
        board.do("line unplug")
        self.until_link(ConnectionState.DISCONNECTED)

    def closing_text(self) -> str:
        """Disconnect, and return the warning of a closing window."""
        self.disconnect()
        return self.controller.unconfirmed_stop


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


def warning_of(driven: DrivenBoard) -> str:
    return (
        f"The stop may not have reached the TReX 1.2 that was driven at {driven.board.url}: "
        "another board responded. If a motor of that board is still turning, cut its power."
    )


def test_another_model_does_not_confirm_the_stop(driven: DrivenBoard, start: Start) -> None:
    driven.replace_board(start("--model", "trexjr"))
    text = f"Another board responds now: TReX Jr 1.2, at {driven.board.url}. {warning_of(driven)}"
    assert driven.errors[-1] == text
    assert driven.closing_text() == warning_of(driven)


def test_different_stored_settings_suggest_another_board(driven: DrivenBoard, start: Start) -> None:
    second = start()
    second.do("eeprom serial_timeout 7")
    driven.replace_board(second)
    assert driven.errors[-1].startswith("This may be another board: the settings of TReX 1.2, at ")
    assert driven.closing_text() == warning_of(driven)


def test_board_with_equal_settings_counts_as_the_same_board(
    driven: DrivenBoard, start: Start
) -> None:
    driven.replace_board(start())
    assert driven.closing_text() == ""


def test_equal_board_at_another_adapter_may_not_be_the_driven_board(
    driven: DrivenBoard, start: Start
) -> None:
    driven.board.do("line mute on")
    driven.until_link(ConnectionState.NOT_RESPONDING)
    url = start().url
    driven.controller.connect_to(Port(PortKind.SERIAL, url, url, "trex", Adapter("0403:6001", "A")))
    driven.until_ready()
    assert driven.errors[-1].startswith(f"The connection to {driven.board.url} was lost before a")


def test_moved_jumper_does_not_mean_another_board(driven: DrivenBoard) -> None:
    driven.cycle_power("jumper mode analog")
    assert driven.closing_text() == ""


def test_replugged_driven_board_is_stopped(driven: DrivenBoard, start: Start) -> None:
    second = start("--model", "trexjr")
    driven.replace_board(second)
    assert driven.runs(driven.board)
    driven.unplug(second)
    may_move: list[bool] = []
    device = driven.device
    device.motors.stop_requested.connect(lambda: may_move.append(device.may_move))
    driven.plug(driven.board)
    assert True in may_move, "the motor may turn until its stop is confirmed"
    assert is_stopped(driven.board)
    assert driven.closing_text() == ""


def test_driven_board_at_another_port_is_stopped(driven: DrivenBoard, start: Start) -> None:
    driven.replace_board(start("--model", "trexjr"))
    driven.disconnect()
    driven.controller.press_stop()
    # The serial timeout that was read belongs to the other board.
    assert driven.errors[-1] == warning_of(driven)
    driven.connect(driven.board.url)
    assert is_stopped(driven.board)
    assert driven.closing_text() == ""


def test_stop_before_the_board_is_read_does_not_count(driven: DrivenBoard, start: Start) -> None:
    driven.unplug(driven.board)
    driven.unpowered.move_cable_to(start())
    assert "not confirmed" in driven.closing_text()


def test_another_board_after_a_lost_line_is_reported(driven: DrivenBoard, start: Start) -> None:
    second = start("--model", "trexjr")
    driven.lose(driven.board)
    assert driven.device.may_move
    driven.connect(second.url)
    assert driven.errors[-1].endswith(warning_of(driven))
    assert driven.closing_text() == warning_of(driven)


def test_warning_stays_until_every_lost_board_is_stopped(driven: DrivenBoard, start: Start) -> None:
    second, third = start("--model", "trexjr"), start("--firmware", "1.0")
    driven.replace_board(second)
    driven.drive(second)
    driven.lose(second)
    driven.connect(third.url)
    driven.connect(second.do("line plug").split()[-1])
    assert driven.closing_text() == warning_of(driven)
    driven.connect(driven.board.url)
    assert driven.closing_text() == ""


def test_failed_connection_adds_no_lost_board(driven: DrivenBoard, start: Start) -> None:
    silent, third = start(), start("--firmware", "1.0")
    silent.do("line mute on")
    driven.replace_board(start("--model", "trexjr"))
    driven.disconnect()
    driven.device.connect_to(ConnectionSettings(silent.url))
    driven.until_link(ConnectionState.DISCONNECTED)
    assert not driven.device.may_move
    driven.connect(third.url)
    driven.connect(driven.board.url)
    assert driven.closing_text() == ""


def test_interrupted_apply_does_not_mean_another_board(driven: DrivenBoard) -> None:
    device = driven.device
    device.parameters.edit("serial_timeout", 15)
    device.parameters.edit("motor1_acceleration", 3)
    device.writer.apply()
    driven.cycle_power()
    assert driven.closing_text() == ""


def test_setting_written_by_another_program_stops_motors(driven: DrivenBoard) -> None:
    driven.board.do("eeprom serial_timeout 20")
    driven.until(lambda: not driven.device.motors.armed)
    assert driven.device.motors.stop_reason == (
        "A setting of the board changed, so the motors were stopped."
    )
    links = [event.text for event in driven.device.events.all if event.kind is EventKind.LINK]
    assert links[1:] == [
        "A setting changed: the board was restarted, or another program wrote to it"
    ]
