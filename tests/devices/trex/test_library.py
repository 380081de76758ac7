"""Library on simulated boards."""

import subprocess
import sys
from types import SimpleNamespace
from typing import cast

import pytest

import trex_gui as public
from tests.devices.trex.conftest import STOPPED, motor, running_script
from tests.devices.trex.simulator.waiting import comes_true
from tests.support.library_program import Program
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_devices import VirtualSimulator
from tests.support.virtual_time import VirtualRuntime
from trex_gui import (
    BadRequest,
    Calibration,
    MotorSetpoint,
    MotorsStoppedError,
    NoReply,
    PortUnavailable,
    SetpointSource,
    StudioError,
    Trex,
    TrexLine,
)
from trex_gui.core.files import data_folder
from trex_gui.core.guardian.log import StopResult, logged_stops
from trex_gui.core.transport.driven import driven_boards
from trex_gui.devices.trex.driving.requests import MotorsStopped
from trex_gui.devices.trex.open_board import OpenBoard, OpenSession
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import ErrorCode

# --- Stops --------------------------------------------------------------------------------


def test_end_of_block_stops_the_motors(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    def run() -> None:
        with Trex(quick_simulator.url) as trex:
            trex.drive(80, -30, auxiliary=20)
            trex.wait(0.3)
            assert motor(quick_simulator) == ("forward", 80)
            assert motor(quick_simulator, 2) == ("reverse", 30)
            raise KeyError("an error of the program")

    program = Program(virtual_time, run)
    with pytest.raises(KeyError):
        program.end()
    assert motor(quick_simulator) == motor(quick_simulator, 2) == STOPPED
    assert quick_simulator.show()["aux"]["speed"] == 0


def test_program_that_hangs_is_stopped(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    def run() -> None:
        with Trex(quick_simulator.url) as trex:
            trex.drive(80)
            virtual_time.sleep(2)
            assert motor(quick_simulator) == STOPPED
            trex.drive(80)

    with pytest.raises(MotorsStoppedError, match="did not call the board"):
        Program(virtual_time, run).end()
    assert motor(quick_simulator) == STOPPED


@pytest.mark.parametrize(
    ("confirmed", "sentence"),
    [(True, "The motors were stopped."), (False, "The stop is not confirmed.")],
)
def test_only_a_confirmed_stop_is_reported_as_a_stop(*, confirmed: bool, sentence: str) -> None:
    session = cast("OpenSession", SimpleNamespace(clock=lambda: 0.0, is_armed=True))
    board = OpenBoard(session, None, ConnectionSettings("virtual"))
    report = MotorsStopped(ErrorCode.MAY_HAVE_RESTARTED, confirmed)
    with pytest.raises(MotorsStoppedError, match=sentence):
        list(board.handle(report))


@pytest.mark.parametrize(
    ("control_line", "error"),
    [("fault 1 on", "Motor 1 fault"), ("power off", "stopped responding")],
)
def test_drive_ends_with_error_of_the_board(
    virtual_time: VirtualRuntime,
    quick_simulator: SimulatedDevice,
    control_line: str,
    error: str,
) -> None:
    def run() -> None:
        with Trex(quick_simulator.url) as trex:
            trex.drive(80)
            trex.wait(0.5)
            quick_simulator.do(control_line)
            trex.wait(20)

    with pytest.raises(StudioError, match=error):
        Program(virtual_time, run).end()


def test_drive_ends_when_channels_take_control(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("jumper mode rc", "power cycle")
    virtual_time.advance(1)  # ends safe-start
    quick_simulator.do("channel 5 1000us")  # gives control to serial commands

    def run() -> None:
        with Trex(quick_simulator.url) as trex:
            trex.drive(80)
            trex.wait(0.3)
            assert motor(quick_simulator) == ("forward", 80)
            quick_simulator.do("channel 5 2000us")
            trex.wait(2)

    with pytest.raises(MotorsStoppedError, match="RC channels control the motors"):
        Program(virtual_time, run).end()


def test_measurements_continue_after_return_of_board(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    def run() -> None:
        with Trex(quick_simulator.url) as trex:
            quick_simulator.do("power off")
            for _ in range(2):
                with pytest.raises(NoReply):
                    list(trex.measurements(3))
            quick_simulator.do("power on")
            trex.wait(3)
            assert list(trex.measurements(1))

    Program(virtual_time, run).end()


def test_silent_board_is_driven_only_after_its_return(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    def run() -> None:
        with Trex(quick_simulator.url) as board:
            quick_simulator.do("line mute on")
            with pytest.raises(NoReply):
                board.wait(20)
            with pytest.raises(NoReply, match="does not respond"):
                board.drive(80)
            assert "does not respond" in board.motor_status()[0]
            quick_simulator.do("line mute off")
            board.wait(3)
            board.drive(60)
            board.wait(0.5)
            assert motor(quick_simulator) == ("forward", 60)

    Program(virtual_time, run).end()


def test_library_reports_motor_state_and_line_quality(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    def run() -> None:
        with Trex(quick_simulator.url) as board:
            assert board.motor_status()[0].startswith("Not armed")
            assert board.line_quality.is_noisy is None
            quick_simulator.do("fault 2 on")
            board.wait(12)
            assert board.motor_status()[0].startswith("Motor 2 is off")
            assert board.line_quality.is_noisy is False

    Program(virtual_time, run).end()


def test_library_returns_setpoints_and_events(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    def run() -> None:
        with Trex(quick_simulator.url) as board:
            assert board.setpoint(1) == MotorSetpoint(SetpointSource.NOT_ARMED)
            assert board.events()[0].text.startswith("Connected to TReX 1.2")
            board.set_parameters(uart_error_shutdown=0)
            board.drive(80, auxiliary=20)
            quick_simulator.do("line error framing")
            board.wait(0.5)
            assert board.setpoint(1) == MotorSetpoint(SetpointSource.SERIAL, 80)
            assert board.setpoint(3) == MotorSetpoint(SetpointSource.SERIAL, 20)
            texts = [event.text for event in board.events()]
            assert "Framing error" in texts
            assert any("motor commands are repeated" in text for text in texts)
            board.stop()
            assert board.setpoint(1) == MotorSetpoint(SetpointSource.NOT_ARMED)
            assert board.events() == ()

    Program(virtual_time, run).end()


def test_errors_before_the_block_do_not_end_a_drive(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    board = Trex(quick_simulator.url)

    def run() -> None:
        with board:
            board.set_parameters(serial_timeout="0.5 s")
        virtual_time.sleep(2)
        with board:  # the serial timeout of the board has expired
            assert board.parameter("serial_timeout") == 5
            board.drive(60)
            board.wait(1)
            assert motor(quick_simulator) == ("forward", 60)
            board.stop()
            assert "Serial timeout" in board.status().errors
            earlier = {entry.name: entry.count for entry in board.errors() if entry.is_earlier}
            assert earlier["Serial timeout"] == 0

    Program(virtual_time, run).end()


def test_calls_outside_the_block_are_rejected(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    def run() -> None:
        board = Trex(quick_simulator.url)
        attempts = (
            lambda: board.drive(60),
            lambda: board.wait(1),
            board.stop,
            board.status,
            lambda: list(board.measurements(1)),
            lambda: board.set_parameters(serial_timeout=5),
        )
        for _ in range(2):
            for attempt in attempts:
                with pytest.raises(PortUnavailable, match="`with` block"):
                    attempt()
            with board:
                pass

    Program(virtual_time, run).end()


def test_inner_block_is_rejected_and_keeps_the_line_open(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    board = Trex(quick_simulator.url)

    def run() -> None:
        with board:
            board.drive(60)
            with pytest.raises(PortUnavailable, match="already open"), board:
                pass
            board.wait(0.2)
            assert motor(quick_simulator) == ("forward", 60)
        assert motor(quick_simulator) == STOPPED
        with board:
            pass

    Program(virtual_time, run).end()


def test_invalid_values_are_rejected(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    def run() -> None:
        with Trex(quick_simulator.url) as trex:
            for attempt, words in (
                (lambda: trex.drive(128), "not 128"),
                (lambda: trex.drive(auxiliary=-1), "not -1"),
                (lambda: trex.parameter("nosuch"), "nosuch"),
                (lambda: trex.set_parameters(serial_timeout="13 s"), "13 s"),
                (lambda: trex.calibration(9), "channel 9"),
                (lambda: trex.set_calibration(1, Calibration(9, 5, 1, 0)), "channel 1"),
            ):
                with pytest.raises(BadRequest, match=words):
                    attempt()
            with pytest.raises(TypeError):
                trex.drive(2.5)  # type: ignore[arg-type]

    Program(virtual_time, run).end()
    assert motor(quick_simulator) == ("brake", 0), "no motor command was sent"
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 0


def test_board_in_rc_mode_is_neither_driven_nor_written(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("jumper mode rc")
    quick_simulator.do("power cycle")

    def run() -> None:
        with Trex(quick_simulator.url) as trex:
            with pytest.raises(BadRequest, match="RC channels"):
                trex.drive(80)
            with pytest.raises(StudioError, match="not in serial mode"):
                trex.set_parameters(serial_timeout=5)

    Program(virtual_time, run).end()
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 0


def test_missing_board_is_explained(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("power off")

    def run() -> None:
        with Trex(quick_simulator.url, baud=9600):
            raise AssertionError

    with pytest.raises(NoReply, match="No TReX responds"):
        Program(virtual_time, run).end()


def test_invalid_line_settings_are_rejected() -> None:
    with pytest.raises(BadRequest, match="not 1"):
        Trex("port", baud=1)
    with pytest.raises(BadRequest, match="detection"):
        Trex("port", detection="crc8")  # type: ignore[arg-type]


# --- The package ----------------------------------------------------------------------------


def test_library_is_imported_on_first_use_without_qt() -> None:
    code = (
        "import sys, trex_gui as trex\n"
        "assert 'trex_gui.devices.trex.library' not in sys.modules\n"
        "assert trex.Trex.__name__ == 'Trex'\n"
        "assert not [name for name in sys.modules if name.startswith('PySide6')]\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)
    for name in public.__all__:
        assert getattr(public, name) is not None
    with pytest.raises(AttributeError):
        _ = public.nosuch  # type: ignore[attr-defined]


def test_shared_line_requires_a_free_device_number() -> None:
    Trex("COM3", device_number=7, reserved=[0, 1])
    for number in (None, 1):
        with pytest.raises(BadRequest):
            Trex("COM3", device_number=number, reserved=[0, 1])


def test_reset_to_number_of_another_board_is_rejected(
    virtual_time: VirtualRuntime, start_simulator: StartSimulator
) -> None:
    boards = start_simulator("--unpaced", "--device", "7", "--device", "9")

    def run() -> None:
        with Trex(boards.url, device_number=9) as board:
            board.set_parameters(serial_timeout=5)
            with pytest.raises(BadRequest, match="device number 7"):
                board.restore_defaults()

    Program(virtual_time, run).end()
    boards.do("@9 power cycle")
    assert boards.show("@9")["parameters"]["serial_timeout"] == 5


_CLOSE_ALL = """
import os, sys, time
from trex_gui import Trex
with Trex(sys.argv[1]) as trex:
    trex.drive(50)
    trex.wait(0.5)
    os.closerange(3, 64)
    print("ready", flush=True)
    time.sleep(60)
"""


def stop_is_logged() -> bool:
    """Return whether the guardian has logged one confirmed stop."""
    return [result for _, result in logged_stops(0)[1]] == [StopResult.CONFIRMED]


@pytest.mark.realtime
def test_program_that_closes_every_descriptor_is_stopped(
    start_simulator: StartSimulator,
) -> None:
    board = start_simulator()
    with running_script(_CLOSE_ALL, board.url):
        assert comes_true(lambda: motor(board) == STOPPED)
        assert comes_true(stop_is_logged)


@pytest.mark.realtime
def test_end_of_block_clears_record_of_driven_board(
    start_simulator: StartSimulator,
) -> None:
    with Trex(start_simulator().url) as trex:
        trex.drive(60)
        trex.wait(0.5)
        assert len(list((data_folder() / "driven").iterdir())) == 1
    assert driven_boards() == {}


@pytest.mark.realtime
def test_silence_ends_a_drive_despite_repeated_commands(
    start_simulator: StartSimulator,
) -> None:
    """With the longer deadlines of real adapters, repeated setpoints must leave time for polls."""
    simulator = start_simulator()
    with Trex(simulator.url) as trex:
        trex.drive(60, 60)
        trex.wait(0.5)
        simulator.do("line mute on")
        with pytest.raises(NoReply, match="stopped responding"):
            trex.wait(20)
        assert comes_true(lambda: motor(simulator) == STOPPED)
        simulator.do("line mute off")


# --- Several boards -----------------------------------------------------------------------


@pytest.fixture
def two_boards(start_simulator: StartSimulator) -> VirtualSimulator:
    line = start_simulator("--unpaced", "--device", "7", "--device", "9:trexjr")
    assert isinstance(line, VirtualSimulator)
    return line


def speeds(line: VirtualSimulator) -> list[int]:
    """Return the speeds of both motors of both boards. A braking motor has 0."""
    motors = [motor for name in ("@7", "@9") for motor in line.show(name)["motors"]]
    signs = {"forward": 1, "reverse": -1, "brake": 0}
    return [signs[motor["direction"]] * motor["speed"] for motor in motors]


def test_boards_of_one_line_are_driven_together(
    virtual_time: VirtualRuntime, two_boards: VirtualSimulator
) -> None:
    def run() -> None:
        with TrexLine(two_boards.url, boards=(7, 9)) as line:
            assert [status.product for status in line.status().values()] == ["TReX", "TReX Jr"]
            line.drive(40, -20)
            line.wait(0.3)
            assert speeds(two_boards) == [40, -20, 40, -20]
            line[9].drive(60)
            line.wait(0.3)
            assert speeds(two_boards) == [40, -20, 60, -20]
            assert line[9].setpoint(1).speed == 60
            line[7].stop()
            assert speeds(two_boards) == [0, 0, 0, 0]
            line[9].set_parameters(serial_timeout=5)
            assert [line[number].parameter("serial_timeout") for number in (7, 9)] == [0, 5]
            line.drive(40)
            line.wait(0.3)

    Program(virtual_time, run).end()
    assert speeds(two_boards) == [0, 0, 0, 0]


@pytest.mark.parametrize("board", [7, 9])
def test_lost_board_stops_the_other_and_is_named(
    virtual_time: VirtualRuntime, two_boards: VirtualSimulator, board: int
) -> None:
    def run() -> None:
        with TrexLine(two_boards.url, boards=(7, 9)) as line:
            line.drive(40, 40)
            line.wait(0.3)
            two_boards.do(f"@{board} power off")
            with pytest.raises(MotorsStoppedError, match=f"Board {board} no longer follows"):
                line.wait(2)
            assert speeds(two_boards) == [0, 0, 0, 0]
            with pytest.raises(NoReply, match=f"Board {board}: "):
                line.drive(40)
            two_boards.do(f"@{board} power on")
            line.wait(3)
            line.drive(20, 20)
            line.wait(0.3)
            assert speeds(two_boards) == [20, 20, 20, 20]

    Program(virtual_time, run).end()


@pytest.mark.parametrize("boards", [(), (7,), (7, 7), (7, 200)])
def test_boards_of_one_line_need_valid_unique_numbers(boards: tuple[int, ...]) -> None:
    with pytest.raises(BadRequest):
        TrexLine("/dev/ttyUSB0", boards=boards)


DRIVE_TWO = """
import sys
from trex_gui import TrexLine
with TrexLine(sys.argv[1], boards=(7, 9)) as line:
    line.drive(60, -60)
    line.wait(0.5)
    print("ready", flush=True)
    line.wait(60)
"""


@pytest.mark.realtime
def test_kill_of_program_stops_every_board(
    start_simulator: StartSimulator,
) -> None:
    boards = start_simulator("--device", "7", "--device", "9")
    with running_script(DRIVE_TWO, boards.url) as program:
        program.kill()

    def directions() -> set[str]:
        return {boards.show(name)["motors"][0]["direction"] for name in ("@7", "@9")}

    assert comes_true(lambda: directions() == {"brake"})
    assert comes_true(stop_is_logged)
