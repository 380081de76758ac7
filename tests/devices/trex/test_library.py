"""Library and its examples on simulated boards."""

import subprocess
import sys

import pytest

import trex_gui as public
from tests.devices.trex.cli.conftest import comes_true
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


def motor(simulator: SimulatedDevice, number: int = 1) -> tuple[str, int]:
    state = simulator.show()["motors"][number - 1]
    return state["direction"], state["speed"]


STOPPED = ("brake", 127)


# --- Stops --------------------------------------------------------------------------------


def test_end_of_the_block_stops_the_motors(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    def run() -> None:
        with Trex(quick_simulator.url) as trex:
            trex.drive(80, -30, auxiliary=20)
            trex.wait(0.3)
            assert motor(quick_simulator) == ("forward", 80)
            assert motor(quick_simulator, 2) == ("reverse", 30)
            raise KeyError("a mistake of the program")

    program = Program(virtual_time, run)
    with pytest.raises(KeyError):
        program.end()
    assert motor(quick_simulator) == motor(quick_simulator, 2) == STOPPED
    assert quick_simulator.show()["aux"]["speed"] == 0


def test_program_that_does_not_respond_is_stopped(
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
    ("control_line", "error"),
    [("fault 1 on", "Motor 1 fault"), ("power off", "stopped responding")],
)
def test_drive_ends_with_its_cause(
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


def test_logger_goes_on_when_the_board_is_back(
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


def test_silent_board_is_not_driven_again(
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


def test_program_sees_setpoints_and_serial_errors(
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


def test_errors_from_before_the_block_do_not_end_a_drive(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    board = Trex(quick_simulator.url)

    def run() -> None:
        with board:
            board.set_parameters(serial_timeout="0.5 s")
        virtual_time.sleep(2)
        with board:  # once more: the board was silent for longer than its timeout
            assert board.parameter("serial_timeout") == 5
            board.drive(60)
            board.wait(1)
            assert motor(quick_simulator) == ("forward", 60)
            board.stop()
            assert "Serial timeout" in board.status().errors
            earlier = {entry.name: entry.count for entry in board.errors() if entry.is_earlier}
            assert earlier["Serial timeout"] == 0

    Program(virtual_time, run).end()


def test_nothing_is_done_outside_of_the_block(
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


def test_inner_block_does_not_close_the_line(
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


def test_invalid_values_send_nothing(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("jumper mode rc")
    quick_simulator.do("power cycle")

    def run() -> None:
        with Trex(quick_simulator.url) as trex:
            for attempt in (
                lambda: trex.drive(80),
                lambda: trex.drive(128),
                lambda: trex.drive(auxiliary=-1),
                lambda: trex.parameter("nosuch"),
                lambda: trex.set_parameters(serial_timeout="13 s"),
                lambda: trex.calibration(9),
                lambda: trex.set_calibration(1, Calibration(9, 5, 1, 0)),
            ):
                with pytest.raises(BadRequest):
                    attempt()
            with pytest.raises(TypeError):
                trex.drive(2.5)  # type: ignore[arg-type]
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
    with pytest.raises(BadRequest):
        Trex("port", baud=1)
    with pytest.raises(BadRequest, match="detection"):
        Trex("port", detection="crc8")  # type: ignore[arg-type]


# --- The package ----------------------------------------------------------------------------


def test_library_is_imported_when_it_is_used_and_without_qt() -> None:
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


def test_line_is_shared_with_other_devices_only_with_a_number() -> None:
    Trex("COM3", device_number=7, reserved=[0, 1])
    for number in (None, 1):
        with pytest.raises(BadRequest):
            Trex("COM3", device_number=number, reserved=[0, 1])


def test_reset_to_the_number_of_another_board_is_refused(
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


_CLOSES_ALL = """
import os, sys, time
from trex_gui import Trex
with Trex(sys.argv[1]) as trex:
    trex.drive(50)
    trex.wait(0.5)
    os.closerange(3, 64)
    print("closed", flush=True)
    time.sleep(60)
"""


@pytest.mark.realtime
def test_board_of_a_program_that_closes_every_descriptor_is_stopped(
    start_simulator: StartSimulator,
) -> None:
    board = start_simulator()
    command = [sys.executable, "-c", _CLOSES_ALL, board.url]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as program:
        assert program.stdout is not None
        assert program.stdout.readline() == b"closed\n"
        try:
            assert comes_true(lambda: motor(board) == ("brake", 127))
            assert comes_true(
                lambda: [how for _, how in logged_stops(0)[1]] == [StopResult.CONFIRMED]
            )
        finally:
            program.kill()


@pytest.mark.realtime
def test_board_stopped_by_the_end_of_the_block_is_not_left_running(
    start_simulator: StartSimulator,
) -> None:
    with Trex(start_simulator().url) as trex:
        trex.drive(60)
        trex.wait(0.5)
        assert len(list((data_folder() / "driven").iterdir())) == 1
    assert driven_boards() == {}


@pytest.mark.realtime
def test_silence_ends_a_drive_although_commands_are_repeated(
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
    started = start_simulator("--unpaced", "--device", "7", "--device", "9:trexjr")
    assert isinstance(started, VirtualSimulator)
    return started


def speeds(line: VirtualSimulator) -> list[int]:
    """Return the speeds of both motors of both boards. A braking motor has 0."""
    motors = [motor for name in ("@7", "@9") for motor in line.show(name)["motors"]]
    signs = {"forward": 1, "reverse": -1, "brake": 0}
    return [signs[one["direction"]] * one["speed"] for one in motors]


def test_boards_of_a_line_are_driven_together(
    virtual_time: VirtualRuntime, two_boards: VirtualSimulator
) -> None:
    def run() -> None:
        with TrexLine(two_boards.url, boards=(7, 9)) as line:
            assert [one.product for one in line.status().values()] == ["TReX", "TReX Jr"]
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
            assert (line[7].parameter("serial_timeout"), line[9].parameter("serial_timeout")) == (
                0,
                5,
            )
            line.drive(40)
            line.wait(0.3)

    Program(virtual_time, run).end()
    assert speeds(two_boards) == [0, 0, 0, 0]


@pytest.mark.parametrize("board", [7, 9])
def test_board_that_is_lost_stops_the_others_and_is_named(
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
def test_boards_of_a_line_have_numbers_of_their_own(boards: tuple[int, ...]) -> None:
    with pytest.raises(BadRequest):
        TrexLine("/dev/ttyUSB0", boards=boards)


DRIVES_TWO = """
import sys
from trex_gui import TrexLine
with TrexLine(sys.argv[1], boards=(7, 9)) as line:
    line.drive(60, -60)
    line.wait(0.5)
    print("drives", flush=True)
    line.wait(60)
"""


@pytest.mark.realtime
def test_every_board_of_a_program_that_is_killed_is_stopped(
    start_simulator: StartSimulator,
) -> None:
    boards = start_simulator("--device", "7", "--device", "9")
    command = [sys.executable, "-c", DRIVES_TWO, boards.url]
    with subprocess.Popen(command, stdout=subprocess.PIPE) as program:
        assert program.stdout is not None
        assert program.stdout.readline() == b"drives\n"
        program.kill()

    def directions() -> set[str]:
        return {boards.show(name)["motors"][0]["direction"] for name in ("@7", "@9")}

    assert comes_true(lambda: directions() == {"brake"})
    assert comes_true(lambda: [how for _, how in logged_stops(0)[1]] == [StopResult.CONFIRMED])
