"""The commands `list` and `find`."""

import json
import shlex
import signal
import sys

import pytest
from click.testing import CliRunner

from tests.devices.trex.cli.conftest import becomes, outputs
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_command import RunCommand, StartCommand
from trex_gui.cli import main
from trex_gui.devices.trex.cli.common import as_options
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings


def test_list_names_port_and_board(trexcmd: RunCommand, quick_simulator: SimulatedDevice) -> None:
    assert trexcmd("list").stdout == f"{quick_simulator.url}\tTReX 1.2\n"
    (row,) = json.loads(trexcmd("list", "--json").stdout)
    assert row["port"] == quick_simulator.url
    assert (row["product"], row["firmware"]) == ("TReX", "1.2")


def test_list_rejects_missing_port(trexcmd: RunCommand) -> None:
    assert "There is no port" in trexcmd("list", "--port", "/dev/ttyNOTHERE", exits=1).stdout


def test_find_prints_the_options_that_reach_the_board(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    result = trexcmd("find")
    assert result.stdout == f"--port {quick_simulator.url} --baud 19200\n"
    assert "TReX 1.2" in result.stderr


@pytest.mark.parametrize(
    "line", [LineSettings(9600), LineSettings(57600), LineSettings(57600, Detection.CRC7)]
)
def test_options_printed_by_find_reach_the_board(
    line: LineSettings, trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    trexcmd("set", "uart_settings", str(line.to_wire()))
    quick_simulator.do("power cycle")
    (row,) = json.loads(trexcmd("find", "--json").stdout)
    assert (row["baud"], row["detection"]) == (line.baud, line.detection.name.lower())
    assert trexcmd("get", "device_number", *row["options"].split()).stdout == "7\t7\n"
    assert outputs(quick_simulator) == [0, 0, 0]


@pytest.mark.parametrize("name", ["/dev/a b", "socket://host:1?a=1&b='2'"])
def test_printed_options_are_quoted_for_a_shell(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    words = ["--port", name, "--baud", "19200"]
    assert shlex.split(as_options(ConnectionSettings(name))) == words
    monkeypatch.setattr(sys, "platform", "win32")
    assert as_options(ConnectionSettings(name)) == f'--port "{name}" --baud 19200'
    assert as_options(ConnectionSettings("COM3")) == "--port COM3 --baud 19200"


@pytest.mark.realtime
@pytest.mark.slow
@pytest.mark.timeout(120)
@pytest.mark.filterwarnings("ignore:set(Daemon|Name):DeprecationWarning")
def test_find_detects_parity_on_port_that_shows_it(start_simulator: StartSimulator) -> None:
    simulator = start_simulator("--rfc2217", "127.0.0.1:0")
    port = ("--port", simulator.url)
    wire = LineSettings(19200, Detection.EVEN).to_wire()
    assert CliRunner().invoke(main, ["set", *port, "uart_settings", str(wire)]).exit_code == 0
    simulator.do("power cycle")
    result = CliRunner().invoke(main, ["find", *port])
    assert result.stdout == f"--port {simulator.url} --baud 19200 --parity even\n"
    assert outputs(simulator) == [0, 0, 0]


def test_interrupted_search_ends_within_a_second(
    start: StartCommand, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("power off")
    command = start("find")
    assert becomes(lambda: quick_simulator.show()["counters"]["line"]["sent"] > 0, True)
    command.send_signal(signal.SIGINT)
    _, errors = command.communicate(timeout=1)
    assert command.returncode == 1
    assert errors.startswith("Searching")
    assert "Search cancelled" in errors


def test_find_without_board_prints_hints(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("power off")
    result = trexcmd("find", exits=1)
    assert result.stdout == ""
    assert "an LED is lit" in result.stderr


# --- Lost bytes -------------------------------------------------------------------------


@pytest.mark.parametrize(
    "words", [("status",), ("set", "serial_timeout", "5"), ("find",)], ids=lambda words: words[0]
)
def test_command_succeeds_on_line_that_loses_bytes(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, words: tuple[str, ...]
) -> None:
    quick_simulator.do("line drop 40")
    trexcmd(*words)
