"""From a file to a board and back: what is saved is the same file again, byte for byte."""

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import Result

from tests.settings.samples import factory
from tests.settings.test_samples import BOARDS, GOLDEN, SAMPLES, every_board, text_of
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_command import VirtualCommand
from tests.support.virtual_time import VirtualRuntime
from trex_gui.protocol.calibration import Calibration
from trex_gui.protocol.line_settings import Detection, LineSettings
from trex_gui.protocol.parameters import parameters_of
from trex_gui.settings.document import CALIBRATION_KEYS, Settings
from trex_gui.settings.reader import read_settings
from trex_gui.settings.writer import write_settings

_TITLE = re.compile(rb"# Read from the board by trexcmd \S+\n")
_REACHED = re.compile(r"is reached with (.*)")


class Bench:
    """A simulated board, and the program with the options that reach it."""

    def __init__(self, simulator: SimulatedDevice, runtime: VirtualRuntime, folder: Path) -> None:
        self._simulator = simulator
        self._runtime = runtime
        self._folder = folder
        self._files = 0
        self._options: list[str] = []
        self._coming: list[str] = []
        self.make_new()

    def make_new(self) -> None:
        """Take a board as it comes from the factory."""
        self._simulator.do("factory")
        self._options = ["--port", self._simulator.url]

    def run(self, *words: str) -> Result:
        command = VirtualCommand(self._runtime, [*words, *self._options], {})
        command.wait()
        result = command.result
        assert result.exit_code == 0, result.stderr
        if found := _REACHED.search(result.stderr):
            self._coming = found[1].split()
        return result

    def save(self) -> bytes:
        """Read the board; its head may name the program's version, but no time."""
        self._files += 1
        path = self._folder / f"{self._files}.txt"
        self.run("get-settings", str(path))
        return path.read_bytes()

    def give(self, data: bytes) -> None:
        """Give the board a file, and switch it off and on.

        Calibrations of inputs that it only reads then are given once more.
        """
        path = self._folder / "given.txt"
        path.write_bytes(data)
        told = self.run("set-settings", str(path)).stderr
        self.power_cycle()
        if "analog_channel_1" in told and b"channel_input_source: 1" in data:
            self.run("set-settings", str(path))

    def power_cycle(self) -> None:
        self._simulator.do("power cycle")
        self._options, self._coming = self._coming or self._options, []


Take = Callable[[str, str], Bench]


@pytest.fixture
def take(start_simulator: StartSimulator, virtual_time: VirtualRuntime, tmp_path: Path) -> Take:
    """Take a board of a model and a firmware to the bench."""

    def bench(model: str, firmware: str) -> Bench:
        words = ("--model", model, "--firmware", firmware, "--unpaced")
        return Bench(start_simulator(*words), virtual_time, tmp_path)

    return bench


def other_settings(model: str, firmware: str, *, analog: bool, line: LineSettings) -> Settings:
    """Return settings that differ from the factory's in everything."""
    specs = parameters_of(model, firmware).readable
    values = {
        spec.key: max(spec.valid) if spec.default != max(spec.valid) else min(spec.valid)
        for spec in specs
    }
    values |= {
        "channel_input_source": int(analog),
        "crc7_polynomial": 0x15,
        "uart_settings": line.to_wire(),
    }
    calibrations = {
        place: Calibration(100 + place[1], 400 + place[1], 800 + place[1], 10 + place[1])
        for place in CALIBRATION_KEYS.values()
        if (place[0].value == "analog") is analog
    }
    return replace(factory(model, firmware), parameters=values, calibrations=calibrations)


def there_and_back(bench: Bench, data: bytes) -> bytes:
    """Give a file to a board, save it, and do the same with that on a new board."""
    bench.give(data)
    first = bench.save()
    bench.make_new()
    bench.give(first)
    assert bench.save() == first
    return first


@every_board
def test_the_golden_file_comes_back_as_it_is(model: str, firmware: str, take: Take) -> None:
    golden = (GOLDEN / f"{model}-{firmware}.txt").read_bytes()
    saved = there_and_back(take(model, firmware), golden)
    shown = golden[: golden.index(b"\n# Calibrations for analog voltages")]
    assert _TITLE.sub(b"", saved, count=1) == shown


@pytest.mark.parametrize(
    ("model", "firmware", "inputs"),
    [(*board, "RC") for board in BOARDS]
    + [(*board, "analog") for board in BOARDS if board[1] in {"1.0", "1.3"}],
)
def test_other_settings_come_back_as_they_are(
    model: str, firmware: str, inputs: str, take: Take
) -> None:
    line = LineSettings(57600, Detection.CRC7, 2)
    wanted = other_settings(model, firmware, analog=inputs == "analog", line=line)
    data = write_settings(wanted).encode()
    saved = there_and_back(take(model, firmware), data)
    assert _TITLE.sub(b"", saved, count=1) == data


@pytest.mark.parametrize("baud", [28800, 38400])
def test_rates_that_old_firmware_halves_come_back_too(baud: int, take: Take) -> None:
    line = LineSettings(baud, stop_bits=2)
    wanted = other_settings("trexjr", "1.1", analog=False, line=line)
    data = write_settings(wanted).encode()
    assert _TITLE.sub(b"", there_and_back(take("trexjr", "1.1"), data), count=1) == data


@pytest.mark.parametrize("name", SAMPLES)
def test_a_sample_comes_back_with_every_value(name: str, take: Take) -> None:
    text = text_of(name)
    wanted = read_settings(text)[0]
    model, firmware = wanted.product.key, wanted.product.firmware[0]
    saved, findings = read_settings(there_and_back(take(model, firmware), text.encode()))
    assert findings == ()
    assert saved.parameters.items() >= wanted.parameters.items()
    assert saved.firmware == firmware
    assert saved.calibrations.items() <= factory(model, firmware).calibrations.items()


def test_a_saved_file_changes_nothing_on_the_board_it_comes_from(take: Take) -> None:
    bench = take("trex", "1.2")
    saved = bench.save()
    bench.give(saved)
    assert bench.save() == saved == bench.save()
