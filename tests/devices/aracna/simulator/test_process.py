"""trex-sim --aracna as a process of its own, in real time."""

import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator

import pytest
import serial
from click.testing import CliRunner

from tests.support.aracna import AracnaProcess
from trex_gui.cli.simulator import main

LONG_TIMEOUT = 20.0
VERSION = b".q1,8\r\n"

needs_pty = pytest.mark.skipif(sys.platform == "win32", reason="has no pseudo-terminals")

Start = Callable[..., AracnaProcess]


@pytest.fixture
def start() -> Iterator[Start]:
    running: list[AracnaProcess] = []

    def starter(*arguments: str) -> AracnaProcess:
        running.append(AracnaProcess(*arguments))
        return running[-1]

    yield starter
    for process in running:
        process.end()


def open_port(process: AracnaProcess, baud: int = 38400) -> serial.Serial:
    return serial.serial_for_url(process.url, baudrate=baud, timeout=LONG_TIMEOUT)


def wait_until(condition: Callable[[], bool]) -> None:
    """Poll a condition that asks the simulator, which takes a round trip each time."""
    end = time.monotonic() + LONG_TIMEOUT
    while not condition():
        assert time.monotonic() < end


@pytest.mark.realtime
@needs_pty
def test_reset_board_says_hello_and_answers_a_second_later(start: Start) -> None:
    robot = start()
    with open_port(robot) as port:
        port.write(b".q\n")
        while port.readline() != VERSION:
            pass
        begun = time.monotonic()
        robot.do("reset")
        assert port.readline() == b".h\r\n"
        port.write(b".q\n")
        assert port.readline() == VERSION
        assert time.monotonic() - begun >= 1
    assert robot.show()["state"] == "idle"


@pytest.mark.realtime
@pytest.mark.slow
@needs_pty
def test_simulator_sees_baud_rate_of_host(start: Start) -> None:
    robot = start()
    with open_port(robot, 9600) as port:
        port.timeout = 1.5
        port.write(b".q\n")
        wait_until(lambda: robot.show()["counters"]["line"]["garbled"] > 0)
        assert VERSION not in port.read(50)


@pytest.mark.realtime
@pytest.mark.slow
def test_two_motor_robot_answers_over_tcp(start: Start) -> None:
    robot = start("--motors", "2", "--tcp", "127.0.0.1:0", "--unpaced")
    with open_port(robot) as port:
        port.write(b".q\n")
        answer = b""
        while not answer.endswith(b".q0,2\r\n"):
            answer += port.read(1)
    shown = robot.show()
    assert (shown["version"], shown["motors"], len(shown["servos"])) == (0, 2, 2)


@pytest.mark.realtime
@pytest.mark.slow
@pytest.mark.filterwarnings("ignore:set(Daemon|Name):DeprecationWarning")  # pyserial 3.5
def test_rfc2217_port_passes_parity_of_host(start: Start) -> None:
    robot = start("--rfc2217", "127.0.0.1:0")
    with serial.serial_for_url(robot.url, baudrate=38400, parity="E", timeout=1.5) as port:
        port.write(b".q\n")
        assert VERSION not in port.read(50)
    with serial.serial_for_url(robot.url, baudrate=38400, timeout=LONG_TIMEOUT) as port:
        port.timeout = 1.5
        answer = b""
        while VERSION not in answer:  # its board may still be starting
            port.write(b"\n\n.q\n")
            answer += port.read(50)


@pytest.mark.realtime
def test_unplug_closes_connection_and_plug_reopens_port(start: Start) -> None:
    robot = start("--tcp", "127.0.0.1:0")
    host, number = robot.url.removeprefix("socket://").split(":")
    with socket.create_connection((host, int(number)), LONG_TIMEOUT) as other:
        assert robot.do("line unplug") == "unplugged"
        while other.recv(100):
            pass
    with pytest.raises(ConnectionRefusedError):
        socket.create_connection((host, int(number)), LONG_TIMEOUT)
    assert robot.do("line plug") == f"plugged {robot.url}"
    socket.create_connection((host, int(number)), LONG_TIMEOUT).close()


@pytest.mark.realtime
def test_quit_ends_process() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "trex_gui.cli.simulator", "--aracna", "--tcp", "127.0.0.1:0"],
        check=False,
        capture_output=True,
        input="warp\nquit\n",
        text=True,
        timeout=LONG_TIMEOUT,
    )
    ready, refused, bye = done.stdout.splitlines()
    assert ready.startswith("ready socket://")
    assert refused.startswith("error 'warp' is not a command")
    assert bye == "ok bye"
    assert (done.returncode, done.stderr) == (0, "")


MEANINGLESS = [
    ["--model", "trexjr"],
    ["--model", "trex"],  # the default, but somebody meant something by it
    ["--firmware", "1.0"],
    ["--mode", "rc"],
    ["--mix"],
    ["--echo"],
    ["--eeprom", "somewhere"],
    ["--device", "7"],
    ["--demo"],
]


@pytest.mark.parametrize("option", MEANINGLESS, ids=" ".join)
def test_trex_options_are_rejected_with_explanation(option: list[str]) -> None:
    result = CliRunner().invoke(main, ["--aracna", *option])
    assert result.exit_code == 2
    assert f"{option[0]} does not apply to the device aracna" in result.output


def test_motors_option_requires_aracna() -> None:
    result = CliRunner().invoke(main, ["--motors", "2"])
    assert result.exit_code == 2
    assert "--motors does not apply to the device trex" in result.output


@pytest.mark.parametrize("motors", ["0", "9", "many"])
def test_invalid_motor_count_is_rejected(motors: str) -> None:
    assert CliRunner().invoke(main, ["--aracna", "--motors", motors]).exit_code == 2


def test_unavailable_endpoint_is_reported() -> None:
    with socket.create_server(("127.0.0.1", 0)) as other:
        address = f"127.0.0.1:{other.getsockname()[1]}"
        result = CliRunner().invoke(main, ["--aracna", "--tcp", address])
    assert result.exit_code == 1
    assert address in result.output


def test_help_lists_aracna_option() -> None:
    assert "--aracna" in CliRunner().invoke(main, ["--help"]).output
