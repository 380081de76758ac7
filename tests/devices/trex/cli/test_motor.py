"""The commands `motor` and `stop`."""

import signal
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import replace

import pytest

from tests.devices.trex.cli.conftest import LONG_TIMEOUT, StartProcess, becomes, outputs
from tests.devices.trex.conftest import STOPPED, motor
from tests.devices.trex.simulator.waiting import comes_true
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_command import RunCommand, StartCommand, VirtualCommand
from tests.support.virtual_devices import VirtualSimulator
from tests.support.virtual_time import VirtualRuntime
from trex_gui.core.transport.guarded import GuardedTransport
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.trex.driving.timeout_stop import TimeoutTrial
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.settings.board_records import BoardRecords
from trex_gui.devices.trex.settings.edit_files import BoardIdentity


def run_motor(
    start: StartCommand, simulator: SimulatedDevice, *words: str, speeds: Sequence[int]
) -> VirtualCommand:
    """Start the command `motor`, and wait until the three motors have these speeds."""
    command = start("motor", *words, url=simulator.url)
    assert becomes(lambda: outputs(simulator) == list(speeds) or command.returncode, True)
    return command


def run_motor_1(start: StartCommand, simulator: SimulatedDevice) -> VirtualCommand:
    return run_motor(start, simulator, "1", "60", speeds=(60, 0, 0))


def braked(simulator: SimulatedDevice) -> bool:
    return all(motor(simulator, number) == STOPPED for number in (1, 2))


@pytest.mark.parametrize(
    ("words", "speeds"),
    [
        (("1", "50"), (50, 0, 0)),
        (("2", "-127"), (0, -127, 0)),
        (("aux", "30"), (0, 0, 30)),
        (("2", "40", "--accelerate"), (0, 40, 0)),
    ],
)
def test_motor_runs_until_interrupted(
    words: tuple[str, ...],
    speeds: tuple[int, ...],
    start: StartCommand,
    quick_simulator: SimulatedDevice,
) -> None:
    command = run_motor(start, quick_simulator, *words, speeds=speeds)
    command.send_signal(signal.SIGINT)
    assert "Stopped." in command.ends(0).stderr
    assert outputs(quick_simulator) == [0, 0, 0]
    assert braked(quick_simulator)


@pytest.mark.skipif(sys.platform == "win32", reason="sends signals")
@pytest.mark.parametrize("name", ["SIGTERM", "SIGHUP", "SIGQUIT", "SIGTSTP", "SIGUSR1"])
def test_every_terminating_signal_stops_motor(
    name: str, start: StartCommand, quick_simulator: SimulatedDevice
) -> None:
    command = run_motor_1(start, quick_simulator)
    command.send_signal(getattr(signal, name))
    assert "Stopped." in command.ends(0).stderr
    assert braked(quick_simulator)


@pytest.mark.realtime
@pytest.mark.skipif(sys.platform == "win32", reason="sends signals")
def test_signal_to_process_stops_motor(
    start_process: StartProcess, quick_simulator: SimulatedDevice
) -> None:
    process = start_process("motor", "1", "60")
    assert comes_true(lambda: outputs(quick_simulator) == [60, 0, 0])
    process.terminate()
    _, errors = process.communicate(timeout=60)
    assert (process.returncode, "Stopped." in errors) == (0, True)
    assert "Traceback" not in errors
    assert braked(quick_simulator)


@pytest.mark.skipif(sys.platform == "win32", reason="sends signals")
def test_terminal_in_background_does_not_suspend_motor_command(
    start: StartCommand, quick_simulator: SimulatedDevice
) -> None:
    command = run_motor_1(start, quick_simulator)
    for number in (signal.SIGTTIN, signal.SIGTTOU):
        assert signal.getsignal(number) is signal.SIG_IGN
    command.terminate()
    command.communicate()
    assert signal.getsignal(signal.SIGTTIN) is signal.SIG_DFL


@pytest.mark.skipif(sys.platform == "win32", reason="sends signals")
def test_sighup_under_nohup_does_not_stop_motor(
    start: StartCommand, quick_simulator: SimulatedDevice
) -> None:
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        command = run_motor_1(start, quick_simulator)
        command.send_signal(signal.SIGHUP)
        assert not becomes(lambda: command.returncode is None, False, seconds=5)
        assert outputs(quick_simulator) == [60, 0, 0]
        command.terminate()
        command.communicate()
    finally:
        signal.signal(signal.SIGHUP, before)
    assert braked(quick_simulator)


def test_repeated_ctrl_c_stops_motor(start: StartCommand, quick_simulator: SimulatedDevice) -> None:
    command = run_motor_1(start, quick_simulator)
    for _ in range(5):
        command.send_signal(signal.SIGINT)
    command.communicate()
    assert braked(quick_simulator)


def test_ctrl_c_ends_motor_command_while_its_port_opens(
    start: StartCommand, virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    def open_slowly(settings: PortSettings) -> Transport:
        virtual_time.sleep(600)
        raise AssertionError(settings)

    assert isinstance(quick_simulator, VirtualSimulator)
    quick_simulator.open = open_slowly  # type: ignore[method-assign]  # as a remote computer may
    command = start("motor", "1", "60")
    assert not becomes(lambda: command.returncode is None, False, seconds=5)
    command.send_signal(signal.SIGINT)
    assert command.wait(1) == 1


def test_motor_stops_after_given_seconds(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    assert "Stopped." in trexcmd("motor", "1", "50", "--seconds", "0.2").stderr
    assert braked(quick_simulator)


def test_motor_command_warns_of_a_timeout_that_may_not_stop(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    run = ("motor", "1", "5", "--seconds", "0.01")
    quick_simulator.do("eeprom uart_error_shutdown 0", "power cycle")
    errors = trexcmd(*run).stderr
    assert "Serial Timeout is off" in errors
    shutdown = "`trexcmd set uart_error_shutdown on`."
    assert f'Remedy: `trexcmd set serial_timeout "0.5 s"` and {shutdown}' in errors
    quick_simulator.do("eeprom serial_timeout 5", "power cycle")
    errors = trexcmd(*run).stderr
    assert "UART-Error Shutdown is off, so the motor may keep" in errors
    assert "fails (twin)." in errors
    assert f"Remedy: {shutdown}" in errors


def test_motor_command_reports_that_serial_timeout_failed_a_trial(
    trexcmd: RunCommand, start: StartCommand, quick_simulator: SimulatedDevice
) -> None:
    trexcmd("set", "serial_timeout", "0.5 s")
    records, board = BoardRecords(), BoardIdentity(device_table().model("trex"), "1.2", 7)
    record = records.load(board)
    assert record is not None
    trial = TimeoutTrial(stopped=False, shutdown=True)
    records.save(board, replace(record, trial=trial))
    command = run_motor_1(start, quick_simulator)
    quick_simulator.do("line unplug")
    _, errors = command.communicate()
    assert "Serial Timeout did not stop the motors of this board when it was tried" in errors
    assert "Remedy" not in errors
    assert "Motor 1 may still be turning. Cut the power." in errors


def test_motor_command_prevents_a_short_serial_timeout(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    trexcmd("set", "serial_timeout", "0.2 s")
    result = trexcmd("motor", "1", "50", "--seconds", "1")
    assert "Serial Timeout" not in result.stderr
    assert "Serial timeout" not in result.stderr


def test_brake_option_brakes_motor(start: StartCommand, quick_simulator: SimulatedDevice) -> None:
    command = start("motor", "1", "33", "--brake")
    assert becomes(lambda: motor(quick_simulator), ("brake", 33))
    command.terminate()
    command.communicate()


def test_motor_command_fails_in_rc_mode(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("jumper mode rc", "power cycle")
    result = trexcmd("motor", "1", "50", "--seconds", "0.1", exits=1)
    assert "RC channels control the motors" in result.stderr
    assert "Running" not in result.stderr


def test_motor_2_in_joint_mode_prints_a_warning(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    trexcmd("set", "motor_mode", "joint")
    quick_simulator.do("power cycle")
    assert "Motor 2 ignores commands" in trexcmd("motor", "2", "5", "--seconds", "0.01").stderr


def test_motor_fault_ends_the_run(start: StartCommand, quick_simulator: SimulatedDevice) -> None:
    command = run_motor_1(start, quick_simulator)
    quick_simulator.do("fault 1 on")
    errors = command.ends(1).stderr
    assert "Motor 1 fault" in errors
    assert braked(quick_simulator)


def test_lost_data_on_the_line_does_not_end_the_run(
    start: StartCommand, quick_simulator: SimulatedDevice
) -> None:
    def line_counter(name: str) -> int:
        return int(quick_simulator.show()["counters"]["line"][name])

    command = run_motor_1(start, quick_simulator)
    dropped = line_counter("dropped")
    quick_simulator.do("line drop 1")
    assert becomes(lambda: line_counter("dropped"), dropped + 1)
    received = line_counter("received")
    assert becomes(lambda: line_counter("received") > received + 20, True)
    assert outputs(quick_simulator) == [60, 0, 0]
    command.send_signal(signal.SIGINT)
    command.ends(0)
    assert braked(quick_simulator)


def test_missing_replies_end_the_run_with_a_message(
    start: StartCommand, quick_simulator: SimulatedDevice
) -> None:
    command = run_motor_1(start, quick_simulator)
    quick_simulator.do("line mute on")
    errors = command.ends(1).stderr
    assert "does not confirm" in errors
    assert "cut its power" in errors
    assert braked(quick_simulator)  # the board received the stop, but its reply was lost


def test_motor_on_missing_port_fails_with_a_message(trexcmd: RunCommand) -> None:
    result = trexcmd("motor", "1", "50", TREX_PORT="/dev/no-such-port", exits=1)
    assert "/dev/no-such-port" in result.stderr
    assert "Stopped." not in result.stderr


def test_interruption_while_connecting_starts_no_motor(
    start: StartCommand, quick_simulator: SimulatedDevice
) -> None:
    command = start("motor", "1", "60")
    assert becomes(lambda: quick_simulator.show()["counters"]["line"]["received"] > 0, True)
    command.send_signal(signal.SIGINT)
    errors = command.ends(1).stderr
    assert "Interrupted before the motor was started." in errors
    assert outputs(quick_simulator) == [0, 0, 0]


def test_unplugging_ends_the_run_with_a_message(
    start: StartCommand, start_simulator: StartSimulator
) -> None:
    simulator = start_simulator("--unpaced")
    command = run_motor_1(start, simulator)
    simulator.do("line unplug")
    errors = command.ends(1).stderr
    assert "Motor 1 may still be turning. Cut the power. The connection" in errors


def test_stop_fails_while_rc_channels_drive(
    start: StartCommand, trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("jumper mode rc", "power cycle")
    assert becomes(lambda: start("status").wait(), 0)
    quick_simulator.do("channel 1 1900us")
    assert becomes(lambda: quick_simulator.show()["motors"][0]["speed"] > 50, True)
    result = trexcmd("stop", exits=1)
    assert "Stopped." not in result.stderr
    assert "Release the sticks, or cut the power." in result.stderr
    assert quick_simulator.show()["motors"][0]["speed"] > 50


def test_stop_without_reply_is_reported_as_unconfirmed(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    result = trexcmd("stop", "--baud", "57600", exits=1)
    assert "The stop is not confirmed. If a motor is still turning, cut its power." in result.stderr
    quick_simulator.do("power off")
    assert "No TReX responds" in trexcmd("stop", "--timeout=0", exits=1).stderr


@pytest.mark.realtime
@pytest.mark.skipif(sys.platform == "win32", reason="the guardian inherits a descriptor")
def test_stop_names_the_process_that_holds_the_port(
    start_process: StartProcess, quick_simulator: SimulatedDevice
) -> None:
    holder = start_process("motor", "1", "40")
    assert comes_true(lambda: outputs(quick_simulator) == [40, 0, 0])
    stop = start_process("stop")
    _, errors = stop.communicate(timeout=60)
    assert stop.returncode == 1
    if sys.platform == "linux":  # other systems do not show which process holds a port
        assert f"(process {holder.pid})" in errors
        assert "press Esc in its window" in errors
    assert outputs(quick_simulator) == [40, 0, 0]
    holder.kill()  # its guardian stops the motor
    assert comes_true(lambda: braked(quick_simulator))
    _, errors = holder.communicate()
    assert "The program ended while motors could move. The stop was sent" in errors


@pytest.mark.realtime
@pytest.mark.skipif(sys.platform == "win32", reason="the guardian inherits a descriptor")
def test_guardian_works_without_standard_streams(quick_simulator: SimulatedDevice) -> None:
    """The descriptor of the port is then the number of a closed standard stream."""
    run = [sys.executable, "-m", "trex_gui.cli", "motor", "1", "60", "--port"]
    command = ["sh", "-c", 'exec "$@" <&- >&- 2>&-', "sh", *run, quick_simulator.url]
    with subprocess.Popen([*command, f"--timeout={LONG_TIMEOUT:g}"]) as process:
        assert comes_true(lambda: outputs(quick_simulator) == [60, 0, 0])
        errors = quick_simulator.show()["counters"]["uart_errors"]
        process.kill()
    assert comes_true(lambda: braked(quick_simulator))
    assert quick_simulator.show()["counters"]["uart_errors"] == errors


def test_missing_guardian_is_reported_without_timeout_stop(
    start: StartCommand, quick_simulator: SimulatedDevice, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(GuardedTransport, "is_guarded", False)
    command = run_motor_1(start, quick_simulator)
    command.send_signal(signal.SIGINT)
    _, errors = command.communicate()
    assert "computer fails, or if this program is killed." in errors


@pytest.mark.parametrize("moment", [0.61, 0.83, 1.2])
def test_restart_of_the_board_ends_the_command(
    start: StartCommand,
    start_simulator: StartSimulator,
    virtual_time: VirtualRuntime,
    moment: float,
) -> None:
    simulator = start_simulator()
    command = run_motor_1(start, simulator)
    virtual_time.advance(moment)
    simulator.do("power cycle")
    assert becomes(lambda: command.returncode, 1, seconds=10)
    assert "restarted" in command.result.stderr
    assert braked(simulator)
