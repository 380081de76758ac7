"""trex-sim --aracna as a process of its own, in real time."""

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
def test_two_motor_robot_answers_over_tcp(start: Start) -> None:
    robot = start("--motors", "2", "--tcp", "127.0.0.1:0", "--unpaced")
    with open_port(robot) as port:
        port.write(b".q\n")
        answer = b""
        while not answer.endswith(b".q0,2\r\n"):
            answer += port.read(1)
    shown = robot.show()
    assert (shown["version"], shown["motors"], len(shown["servos"])) == (0, 2, 2)


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


def test_help_lists_aracna_option() -> None:
    assert "--aracna" in CliRunner().invoke(main, ["--help"]).output
