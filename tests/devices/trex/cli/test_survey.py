"""The command `survey`."""

import random
import signal
import tomllib
from collections.abc import Mapping
from functools import partial
from operator import setitem
from pathlib import Path
from typing import Any

import pytest

from tests.devices.trex.cli.conftest import becomes
from tests.support.matrix import sampled
from tests.support.scripts import load_script
from tests.support.virtual_command import RunCommand, StartCommand, VirtualCommand
from tests.support.virtual_devices import VirtualSimulator
from trex_gui.core.resource_files import resource
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import Mode
from trex_gui.devices.trex.protocol.framing import Packet, PacketParser
from trex_gui.devices.trex.protocol.parameters import Grade, ParameterSpec, parameters_of
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.memory import PARAMETER_WRITE_S, Eeprom, Memory, _Step

take_survey = load_script("take_survey")

_SKIPPED_KEYS = {"device_number", "crc7_polynomial", "uart_settings"}


def is_tried(spec: ParameterSpec) -> bool:
    return spec.grade("min", "max") is not Grade.SOURCED and spec.key not in _SKIPPED_KEYS


class HiddenMemory(Memory):
    """Memory with a table that the program does not know.

    Attributes:
        ranges: smallest and largest value, by parameter number.
        cells: stored value, by parameter number.
    """

    def __init__(self, firmware: str, model: str, rng: random.Random, *, as_new: bool) -> None:
        eeprom = Eeprom(model)
        eeprom.write("device_number", rng.randrange(128))
        super().__init__(eeprom, firmware)
        self.ranges: dict[int, tuple[int, int]] = {}
        for spec in parameters_of(model, "1.3").readable:
            values = [wire for wire in range(128) if wire in spec.valid or spec.is_open(wire)]
            ends = rng.choice(values), rng.choice(values)
            if not is_tried(spec):
                ends = values[0], values[-1]
            if spec.number == 0 or rng.random() < 0.85:
                self.ranges[spec.number] = min(ends), max(ends)
        for number in rng.sample(range(0x18, 0x7B), rng.randrange(7)):
            self.ranges[number] = 0, 127
        self.defaults = {number: rng.randint(*ends) for number, ends in self.ranges.items()}
        self.defaults[0] = eeprom["device_number"]
        self.cells = dict(self.defaults)
        if not as_new:
            self.cells |= {n: rng.randint(*ends) for n, ends in self.ranges.items() if n}

    def get(self, number: int) -> int | None:
        return self.cells.get(number)

    def set(self, number: int, value: int, mode: Mode) -> ResultCode:
        if not mode.is_serial:
            return ResultCode.NOT_SERIAL_MODE
        if number not in self.ranges:
            return ResultCode.BAD_PARAMETER
        low, high = self.ranges[number]
        if not low <= value <= high:
            return ResultCode.BAD_VALUE
        store = partial(setitem, self.cells, number, value)
        self._steps.append(_Step(PARAMETER_WRITE_S, store, lambda: None))
        return ResultCode.OK


def board_of(simulator: VirtualSimulator) -> Board:
    assert isinstance(simulator.line, SimulatedBoards)
    return simulator.line.boards[0]


def numbers_in(spans: str) -> list[int]:
    """Return the numbers in spans such as `18-1F 40`."""
    ends = (list(map(partial(int, base=16), span.split("-"))) for span in spans.split())
    return [number for span in ends for number in range(span[0], span[-1] + 1)]


def by_hex_number(values: Mapping[int, Any]) -> dict[str, Any]:
    return {f"0x{number:02X}": value for number, value in values.items()}


@pytest.mark.parametrize("seed", sampled(range(200), every=200))
def test_every_fact_of_a_hidden_table_is_found_and_nothing_changes(
    trexcmd: RunCommand, quick_simulator: VirtualSimulator, tmp_path: Path, seed: int
) -> None:
    rng = random.Random(seed)
    model, firmware = rng.choice(["trex", "trexjr"]), rng.choice(["1.0", "1.1", "1.2", "1.3"])
    as_new = rng.random() < 0.5
    board = board_of(quick_simulator)
    memory = HiddenMemory(firmware, model, rng, as_new=as_new)
    board.model, board.firmware = device_table().model(model), firmware
    board.eeprom, board.memory = memory.eeprom, memory
    reply = rng.choice([None, 0xFF, rng.randrange(256)])
    board.unknown_reply = b"" if reply is None else bytes([reply])
    board.rejection_is_error = rng.random() < 0.5
    before, sent, file = dict(memory.cells), bytearray(), tmp_path / "survey.toml"
    quick_simulator.on_write = sent.extend

    trexcmd("survey", str(file), "--limits", *["--as-new"] * as_new, stdin="y\n")
    found = tomllib.loads(file.read_text("utf-8"))
    tried = {
        spec.number: memory.ranges[spec.number]
        for spec in parameters_of(model, firmware).readable
        if spec.number in memory.ranges and is_tried(spec)
    }
    ranges = {n: f"{low}-{high}" if low < high else str(low) for n, (low, high) in tried.items()}
    assert found["board"] == {"model": model, "firmware": firmware, "stores_defaults": as_new}
    assert found["stored"] == by_hex_number(before)
    assert found["ranges"] == by_hex_number(ranges)
    assert found["altered"] == {}
    ((recorded_reply, numbers),) = found["unknown"].items()
    assert recorded_reply == ("no reply" if reply is None else f"{reply:02X}")
    assert numbers_in(numbers) == sorted(set(range(128)) - before.keys())
    assert found["errors"]["unknown_number"] == ["FORMAT"]
    rejected = found["errors"].get("rejected_write")
    assert rejected == (["FORMAT"] if board.rejection_is_error else []) or rejected is None
    assert rejected is not None or set(ranges.values()) <= {"0-127", "0-1"}

    assert memory.cells == before
    packets = (event for event in PacketParser().feed(bytes(sent)) if isinstance(event, Packet))
    assert not any(packet.command.moves for packet in packets)

    table = resource("trex_parameters.toml").read_text("utf-8")
    rows = {
        row["number"]: row for row in tomllib.loads(take_survey.updated(table, found))["parameter"]
    }
    for number, ends in tried.items():
        assert (rows[number]["min"], rows[number]["max"]) == ends
        assert rows[number]["source"]["max"] == "sourced"
    for number in memory.defaults.keys() & rows.keys() if as_new else ():
        assert rows[number][f"default_{model}"] == memory.defaults[number]
        assert rows[number]["source"][f"default_{model}"] == "sourced"


def test_bits_that_are_not_stored_are_found(
    trexcmd: RunCommand, quick_simulator: VirtualSimulator, tmp_path: Path
) -> None:
    board_of(quick_simulator).unknown_reply = b"\xff"
    quick_simulator.do("accept motor1_pwm_prescaler 127 3")
    trexcmd("survey", str(tmp_path / "s"), "--limits", stdin="y\n")
    found = tomllib.loads((tmp_path / "s").read_text("utf-8"))
    assert found["ranges"]["0x09"] == "0-3"
    assert found["altered"]["0x09"].startswith("4 as 0, 8 as 0, ")


def test_survey_prompts_before_writing_and_saves_no_port_name(
    trexcmd: RunCommand, quick_simulator: VirtualSimulator, tmp_path: Path
) -> None:
    board_of(quick_simulator).unknown_reply = b"\xff"
    file = tmp_path / "survey.toml"
    file.write_text("mine", "utf-8")
    trexcmd("survey", str(file), "--limits", stdin="n\n", exits=1)
    assert file.read_text("utf-8") == "mine"
    assert quick_simulator.show()["counters"]["eeprom_writes"] == 0
    trexcmd("survey", str(file))
    assert quick_simulator.url not in file.read_text("utf-8")
    assert quick_simulator.show()["counters"]["eeprom_writes"] == 0


def start_survey(start: StartCommand, simulator: VirtualSimulator, file: Path) -> VirtualCommand:
    """Start a survey, and return it while the board stores a trial value."""
    board = board_of(simulator)
    board.unknown_reply = b"\xff"  # saves a timeout for each unknown number
    command = start("survey", str(file), "--limits", stdin="y\n")
    assert becomes(lambda: board.eeprom["required_channels"] != 1, True, 600)
    return command


def test_interrupted_survey_restores_the_board(
    start: StartCommand, quick_simulator: VirtualSimulator, tmp_path: Path
) -> None:
    command = start_survey(start, quick_simulator, tmp_path / "s")
    command.send_signal(signal.SIGINT)
    command.send_signal(signal.SIGINT)
    assert command.wait() == 1
    assert quick_simulator.show()["parameters"]["required_channels"] == 1
    assert not (tmp_path / "s").exists()


def test_next_start_reports_differences_after_a_lost_cable(
    start: StartCommand, trexcmd: RunCommand, quick_simulator: VirtualSimulator, tmp_path: Path
) -> None:
    command = start_survey(start, quick_simulator, tmp_path / "s")
    quick_simulator.do("line unplug")
    assert "The settings in the board may have changed." in command.ends(1).stderr
    quick_simulator.do("line plug")
    assert trexcmd("diff", "--last", exits=1).stdout.startswith("required_channels  ")
