"""Commands of `trexcmd aracna`, with a robot on an unpaced line."""

import json
import re
import signal
from pathlib import Path

import pytest

from tests.support.simulator import SimulatedDevice
from tests.support.virtual_command import RunCommand, StartCommand, VirtualCommand
from tests.support.virtual_devices import VirtualSimulator
from tests.support.virtual_time import VirtualRuntime

FILE = """Aracna:8:1024:1024:1024:1024:1024:1024:1024:1024
Pose=low:400, 300, 400, 300, 400, 300, 400, 300
Pose=high:450, 350, 450, 350, 450, 350, 450, 350
Pose=far:1000, 300, 400, 300, 400, 300, 400, 300
Seq=nod: low|300, high|300
Seq=reach: far|300
Seq=ghost: nowhere|300
"""


@pytest.fixture
def start(virtual_time: VirtualRuntime, robot: SimulatedDevice) -> StartCommand:
    return lambda *words: VirtualCommand(virtual_time, words, {"TREX_PORT": robot.url})


@pytest.fixture
def trexcmd(start: StartCommand) -> RunCommand:
    """Run `trexcmd` to its end, by default without an error."""
    return lambda *words, exits=0: start(*words).ends(exits)


@pytest.fixture
def file(tmp_path: Path) -> str:
    path = tmp_path / "poses.ppr"
    path.write_text(FILE, encoding="utf-8")
    return str(path)


def positions(robot: SimulatedDevice) -> list[int]:
    return [servo["position"] for servo in robot.show()["servos"]]


def near(robot: SimulatedDevice, goals: list[int]) -> bool:
    return all(abs(a - b) <= 2 for a, b in zip(positions(robot), goals, strict=True))


# --- query, speeds --------------------------------------------------------------------------


def test_query_prints_firmware_and_motor_count(trexcmd: RunCommand, robot: SimulatedDevice) -> None:
    assert trexcmd("aracna", "query").stdout == "Aracna, firmware 1, 8 motors\n"
    row = json.loads(trexcmd("aracna", "query", "--json").stdout)
    assert row == {"port": robot.url, "product": "Aracna", "firmware": 1, "motors": 8}


def test_query_of_trex_reports_no_aracna(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    result = trexcmd("aracna", "query", "--port", quick_simulator.url, exits=1)
    assert "No Aracna responds" in result.stderr or "not from an Aracna" in result.stderr


def test_speeds_sets_motors_and_prints_held_speeds(
    trexcmd: RunCommand, robot: SimulatedDevice
) -> None:
    assert trexcmd("aracna", "speeds", "200").stdout == "200 200 200 200 200 200 200 200\n"
    assert trexcmd("aracna", "speeds", *map(str, range(8))).stdout == "0 1 2 3 4 5 6 7\n"
    assert [servo["speed"] for servo in robot.show()["servos"]] == list(range(8))


def test_speeds_names_unresponsive_servo_and_exits_1(
    trexcmd: RunCommand, robot: SimulatedDevice
) -> None:
    robot.do("servo 4 dead")
    result = trexcmd("aracna", "speeds", "50", exits=1)
    assert result.stdout == "50 50 50 50 -1 50 50 50\n"
    assert "Motor 4 did not accept speed 50: it does not respond." in result.stderr


@pytest.mark.parametrize(
    "words", [["speeds", "1", "2"], ["speeds", "1024"], ["pose", "1", "2", "--no-limits"], ["pose"]]
)
def test_wrong_number_or_range_of_values_is_a_usage_error(
    trexcmd: RunCommand, words: list[str]
) -> None:
    trexcmd("aracna", *words, exits=2)


# --- pose -----------------------------------------------------------------------------------


def test_pose_moves_slowly_and_reports_each_motor(
    trexcmd: RunCommand, robot: SimulatedDevice
) -> None:
    result = trexcmd("aracna", "pose", *["530"] * 8)
    assert near(robot, [530] * 8)
    assert [abs(int(value) - 530) <= 2 for value in result.stdout.split()] == [True] * 8
    assert [f"motor {motor}:" in result.stderr for motor in range(8)] == [True] * 8
    assert {servo["speed"] for servo in robot.show()["servos"]} == {100}


def test_pose_outside_joint_limits_is_rejected_before_sending(
    trexcmd: RunCommand, robot: SimulatedDevice
) -> None:
    result = trexcmd("aracna", "pose", "20", *["551"] * 7, exits=2)
    assert "motor 0 must be 50 to 600, not 20" in result.stderr
    assert "motor 7 must be 0 to 550, not 551" in result.stderr
    assert robot.show()["counters"]["line"]["sent"] == 0
    trexcmd("aracna", "pose", "--no-limits", "--speed", "0", "20", *["551"] * 7)
    assert near(robot, [20] + [551] * 7)


def test_led_is_switched_and_reported(trexcmd: RunCommand, robot: SimulatedDevice) -> None:
    for state in ("on", "off"):
        assert trexcmd("aracna", "led", state).stdout == f"{state}\n"
        assert robot.show()["led"] == (state == "on")
    trexcmd("aracna", "led", "2", exits=2)


def test_named_pose_is_clamped_to_the_limits(
    trexcmd: RunCommand, robot: SimulatedDevice, file: str
) -> None:
    result = trexcmd("aracna", "pose", "--pose", "stand", "--speed", "500")  # built in
    assert near(robot, [512, 550] * 4)
    assert "limit" not in result.stderr
    trexcmd("aracna", "pose", "--pose", "low", "--file", file, "--speed", "0")
    assert near(robot, [400, 300] * 4)
    wrong = trexcmd("aracna", "pose", "--pose", "lwo", "--file", file, exits=2)
    assert "Known poses: low, high, far." in wrong.stderr
    result = trexcmd("aracna", "pose", "--pose", "far", "--file", file, "--speed", "0")
    assert "far: motor 0 moves to its limit 600 instead of 1000." in result.stderr


def test_pose_names_blocked_motor_and_exits(trexcmd: RunCommand, robot: SimulatedDevice) -> None:
    robot.do("servo 2 block")
    result = trexcmd("aracna", "pose", "--speed", "1000", *["530"] * 8, exits=1)
    assert "is waiting for motor 2" in result.stderr
    assert "servo power" in result.stderr


def test_pose_reports_unreadable_position(trexcmd: RunCommand, robot: SimulatedDevice) -> None:
    robot.do("servo 6 lose position")
    result = trexcmd("aracna", "pose", *["515"] * 8, exits=1)
    assert result.stdout.split()[6] == "-1"
    assert "Motor 6 did not report its position (−1)." in result.stderr


def test_ctrl_c_during_pose_warns_that_motion_continues(
    start: StartCommand, robot: SimulatedDevice, virtual_time: VirtualRuntime
) -> None:
    command = start("aracna", "pose", *["300"] * 8, "--speed", "20")
    assert virtual_time.run_until(lambda: robot.show()["servos"][7]["moving"], 10)
    command.send_signal(signal.SIGINT)
    out, errors = command.communicate()
    assert "No command stops a running motion" in errors
    assert "cut the servo power" in errors
    assert len(out.split()) == 8
    assert command.returncode == 0


def test_ctrl_c_while_connecting_moves_nothing(
    start: StartCommand, robot: SimulatedDevice, virtual_time: VirtualRuntime
) -> None:
    assert isinstance(robot, VirtualSimulator)
    command = start("aracna", "pose", *["300"] * 8)
    assert virtual_time.run_until(lambda: robot.host is not None, 1)
    command.send_signal(signal.SIGINT)
    errors = command.ends(1).stderr
    assert "before anything was moved" in errors
    assert not any(servo["torque"] for servo in robot.show()["servos"])


# --- play -----------------------------------------------------------------------------------


def test_play_blends_in_and_plays_every_step(
    trexcmd: RunCommand, robot: SimulatedDevice, file: str
) -> None:
    result = trexcmd("aracna", "play", file, "--sequence", "nod", "--rounds", "2", "--scale", "1.5")
    steps = re.findall(r"^round \d+, step \d+", result.stderr, re.MULTILINE)
    assert steps == ["round 1, step 1", "round 1, step 2", "round 2, step 1", "round 2, step 2"]
    assert "blend in" in result.stderr
    assert near(robot, [450, 350] * 4)


def test_play_reports_error_of_early_step_at_the_end(
    trexcmd: RunCommand, robot: SimulatedDevice, file: str
) -> None:
    robot.do("servo 2 lose position 1")
    result = trexcmd("aracna", "play", file, "--sequence", "nod", exits=1)
    assert "Played." in result.stderr
    assert "Motor 2 did not report its position (−1)." in result.stderr


@pytest.mark.parametrize(
    ("words", "code", "message"),
    [
        ((), 2, "Select a sequence"),
        (("--sequence", "x"), 2, "The file contains: nod, reach, ghost."),
        (("--sequence", "ghost"), 1, "nowhere"),
        (("--sequence", "nod", "--scale", "0"), 2, "--scale"),
        (("--sequence", "nod", "--loop", "--rounds", "3"), 2, "not both"),
    ],
)
def test_play_rejects_invalid_options(
    trexcmd: RunCommand, file: str, words: tuple[str, ...], code: int, message: str
) -> None:
    assert message in trexcmd("aracna", "play", file, *words, exits=code).stderr


def test_ctrl_c_ends_play_loop_after_current_step(
    start: StartCommand, robot: SimulatedDevice, file: str, virtual_time: VirtualRuntime
) -> None:
    command = start("aracna", "play", file, "--sequence=nod", "--loop")
    virtual_time.advance(10)
    assert command.poll() is None
    command.send_signal(signal.SIGINT)
    out, errors = command.communicate()
    assert "round 2" in errors
    assert "Stopped." in errors
    assert command.returncode == 0
    assert not any(servo["moving"] for servo in robot.show()["servos"])
    assert len(out.split()) == 8


# --- list, find -----------------------------------------------------------------------------


def test_list_names_aracna_and_silent_port(trexcmd: RunCommand, robot: SimulatedDevice) -> None:
    assert trexcmd("list", "--port", robot.url).stdout == f"{robot.url}\tAracna 1, 8 motors\n"
    (row,) = json.loads(trexcmd("list", "--json", "--port", robot.url).stdout)
    assert (row["product"], row["firmware"]) == ("Aracna", "1")
    robot.do("power off")
    assert trexcmd("list").stdout == f"{robot.url}\tno reply\n"


def test_find_prints_port_option_for_aracna(trexcmd: RunCommand, robot: SimulatedDevice) -> None:
    result = trexcmd("find")
    assert result.stdout == f"--port {robot.url}\n"
    searching, found = result.stderr.splitlines()
    assert searching == f"Searching {robot.url} ..."
    assert found.startswith(f"Aracna 1, 8 motors, on {robot.url} at 38400 baud, no error detection")
    assert not any(servo["torque"] for servo in robot.show()["servos"])
    trexcmd("aracna", "query", *result.stdout.split())
