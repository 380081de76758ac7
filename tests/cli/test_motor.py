"""motor: it runs, and it stops, whatever happens."""

import signal
import subprocess
import sys
from functools import partial

import pytest

from tests.cli.conftest import Run, Start, becomes, outputs
from tests.support.simulator import SimulatedDevice, StartSimulator

pytestmark = pytest.mark.realtime


def runs_or_ended(
    process: "subprocess.Popen[str]", simulator: SimulatedDevice, wanted: list[int]
) -> bool:
    return outputs(simulator) == wanted or process.poll() is not None


def runs(process: "subprocess.Popen[str]", simulator: SimulatedDevice, *speeds: int) -> bool:
    """Wait until the motors run at these speeds, or the program has ended."""
    wanted = list(speeds)
    becomes(partial(runs_or_ended, process, simulator, wanted), True)
    if process.poll() is not None:
        _, errors = process.communicate()
        pytest.fail(f"it has ended: {errors}")
    return outputs(simulator) == wanted


def braked(simulator: SimulatedDevice) -> bool:
    motors = simulator.show()["motors"]
    return all((m["direction"], m["speed"]) == ("brake", 127) for m in motors)


@pytest.mark.parametrize(
    ("words", "speeds"),
    [
        (("1", "50"), (50, 0, 0)),
        (("2", "-127"), (0, -127, 0)),
        (("aux", "30"), (0, 0, 30)),
        (("2", "40", "--accelerate"), (0, 40, 0)),
    ],
)
@pytest.mark.skipif(sys.platform == "win32", reason="sends signals")
def test_a_motor_runs_until_it_is_interrupted(
    words: tuple[str, ...],
    speeds: tuple[int, ...],
    start: Start,
    quick_simulator: SimulatedDevice,
) -> None:
    process = start("motor", *words)
    assert runs(process, quick_simulator, *speeds)
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=20)
    assert (process.returncode, "Stopped." in errors) == (0, True)
    assert "Traceback" not in errors
    assert outputs(quick_simulator) == [0, 0, 0]
    assert braked(quick_simulator)


@pytest.mark.skipif(sys.platform == "win32", reason="sends signals")
@pytest.mark.usefixtures("signals_as_usual")
@pytest.mark.parametrize("name", ["SIGTERM", "SIGHUP", "SIGQUIT", "SIGTSTP"])
def test_every_way_to_end_the_program_stops_the_motor(
    name: str, start: Start, quick_simulator: SimulatedDevice
) -> None:
    process = start("motor", "1", "60")
    assert runs(process, quick_simulator, 60, 0, 0)
    process.send_signal(getattr(signal, name))
    process.communicate(timeout=20)
    assert braked(quick_simulator)


@pytest.mark.skipif(sys.platform == "win32", reason="sends signals")
def test_behind_nohup_a_closed_terminal_ends_nothing(
    start: Start, quick_simulator: SimulatedDevice
) -> None:
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        process = start("motor", "1", "60")
    finally:
        signal.signal(signal.SIGHUP, before)
    assert runs(process, quick_simulator, 60, 0, 0)
    process.send_signal(signal.SIGHUP)
    with pytest.raises(subprocess.TimeoutExpired):
        process.wait(1)
    assert outputs(quick_simulator) == [60, 0, 0]
    process.send_signal(signal.SIGTERM)
    process.communicate(timeout=20)
    assert braked(quick_simulator)


@pytest.mark.skipif(sys.platform == "win32", reason="sends signals")
def test_an_impatient_person_does_not_keep_the_motor_from_stopping(
    start: Start, quick_simulator: SimulatedDevice
) -> None:
    process = start("motor", "1", "60")
    assert runs(process, quick_simulator, 60, 0, 0)
    for _ in range(5):
        process.send_signal(signal.SIGINT)
    process.communicate(timeout=20)
    assert braked(quick_simulator)


def test_a_motor_runs_for_some_seconds_and_stops(
    trexcmd: Run, quick_simulator: SimulatedDevice
) -> None:
    result = trexcmd("motor", "1", "50", "--seconds", "0.2")
    assert result.exit_code == 0, result.stderr
    assert "Stopped." in result.stderr
    assert braked(quick_simulator)


def test_a_missing_timeout_is_warned_of(trexcmd: Run) -> None:
    assert "Serial Timeout is off" in trexcmd("motor", "1", "5", "--seconds", "0.01").stderr


def test_a_short_timeout_of_the_board_is_fed(
    trexcmd: Run, quick_simulator: SimulatedDevice
) -> None:
    assert trexcmd("set", "serial_timeout", "0.2 s").exit_code == 0
    for _ in range(15):  # a busy computer may itself stand still for so long
        result = trexcmd("motor", "1", "50", "--seconds", "1")
        if result.exit_code == 0:
            break
    assert result.exit_code == 0, result.stderr
    assert "Serial Timeout" not in result.stderr
    assert "Serial timeout" not in result.stderr


def test_a_motor_can_be_braked(
    trexcmd: Run, start: Start, quick_simulator: SimulatedDevice
) -> None:
    process = start("motor", "1", "33", "--brake")
    assert becomes(
        lambda: [quick_simulator.show()["motors"][0][key] for key in ("direction", "speed")],
        ["brake", 33],
    )
    process.terminate()
    process.communicate(timeout=20)


def test_where_serial_does_not_control_the_motors_nothing_is_sent(
    trexcmd: Run, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("jumper mode rc")
    quick_simulator.do("power cycle")
    result = trexcmd("motor", "1", "50", "--seconds", "0.1")
    assert result.exit_code == 1
    assert "RC channels control the motors" in result.stderr
    assert "Running" not in result.stderr


def test_joint_mode_is_told_where_motor_2_is_asked_for(
    trexcmd: Run, quick_simulator: SimulatedDevice
) -> None:
    trexcmd("set", "motor_mode", "joint")
    quick_simulator.do("power cycle")
    assert "motor 2 is ignored" in trexcmd("motor", "2", "5", "--seconds", "0.01").stderr


def test_a_fault_of_the_driver_ends_the_run(start: Start, quick_simulator: SimulatedDevice) -> None:
    process = start("motor", "1", "60")
    assert runs(process, quick_simulator, 60, 0, 0)
    quick_simulator.do("fault 1 on")
    _, errors = process.communicate(timeout=20)
    assert process.returncode == 1
    assert "Motor 1 fault" in errors
    assert braked(quick_simulator)


@pytest.mark.skipif(sys.platform == "win32", reason="sends signals")
def test_damage_on_the_line_does_not_end_the_run(
    start: Start, quick_simulator: SimulatedDevice
) -> None:
    def counted(what: str) -> int:
        return int(quick_simulator.show()["counters"]["line"][what])

    process = start("motor", "1", "60", patience=2)  # for a byte that is lost
    assert runs(process, quick_simulator, 60, 0, 0)
    lost = counted("dropped")
    quick_simulator.do("line drop 1")
    assert becomes(lambda: counted("dropped"), lost + 1)
    came = counted("received")
    assert becomes(lambda: counted("received") > came + 20 or process.poll() is not None, True)
    assert runs(process, quick_simulator, 60, 0, 0)
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=40)
    assert process.returncode == 0, errors
    assert braked(quick_simulator)


def test_a_board_that_falls_silent_ends_the_run_with_a_sentence(
    start: Start, quick_simulator: SimulatedDevice
) -> None:
    for _ in range(5):  # one that stands still before it is mute ends the run too
        process = start("motor", "1", "60", patience=0.05)
        becomes(partial(runs_or_ended, process, quick_simulator, [60, 0, 0]), True)
        quick_simulator.do("line mute on")
        _, errors = process.communicate(timeout=30)
        if "does not confirm" in errors:
            break
        quick_simulator.do("line mute off")
    assert process.returncode == 1
    assert "does not confirm" in errors
    assert "cut its power" in errors
    assert becomes(lambda: braked(quick_simulator), True)  # it has heard what it could not confirm


def test_a_cable_that_is_pulled_ends_the_run_with_a_sentence(
    start: Start, start_simulator: StartSimulator
) -> None:
    simulator = start_simulator("--unpaced")
    process = start("motor", "1", "60", url=simulator.url)
    assert runs(process, simulator, 60, 0, 0)
    simulator.do("line unplug")
    _, errors = process.communicate(timeout=20)
    assert process.returncode == 1
    assert "is gone" in errors
    assert "cut its power" in errors
    assert "Traceback" not in errors


@pytest.mark.parametrize(
    "words",
    [
        ("1", "128"),
        ("1", "-128"),
        ("3", "10"),
        ("aux", "-1"),
        ("aux", "128"),
        ("aux", "5", "--brake"),
        ("1", "-5", "--brake"),
        ("1", "fast"),
        ("1",),
        ("1", "5", "--seconds", "0"),
        ("1", "5", "--secnds", "1"),
    ],
)
def test_what_no_motor_can_do_is_wrong_usage(trexcmd: Run, words: tuple[str, ...]) -> None:
    assert trexcmd("motor", *words).exit_code == 2


def test_a_stop_that_channels_drive_through_fails(
    trexcmd: Run, quick_simulator: SimulatedDevice
) -> None:
    for line in ("jumper mode rc", "power cycle"):
        quick_simulator.do(line)
    becomes(lambda: trexcmd("status").exit_code, 0)
    quick_simulator.do("channel 1 1900us")
    becomes(lambda: quick_simulator.show()["motors"][0]["speed"] > 50, True)
    result = trexcmd("stop")
    assert result.exit_code == 1
    assert "Stopped." not in result.stderr
    assert "Let go of the sticks, or cut the power." in result.stderr
    assert quick_simulator.show()["motors"][0]["speed"] > 50


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells who holds a port")
def test_where_the_window_holds_the_port_a_stop_says_what_stops(
    start: Start, trexcmd: Run, quick_simulator: SimulatedDevice
) -> None:
    holder = start("motor", "1", "40")
    assert runs(holder, quick_simulator, 40, 0, 0)
    result = trexcmd("stop")
    assert result.exit_code == 1
    assert f"(process {holder.pid})" in result.stderr
    assert "Esc in its window stops the motors" in result.stderr
    holder.terminate()
    holder.communicate(timeout=20)
