"""A settings file that is written to a board and read back is unchanged."""

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import Result

from tests.devices.trex.settings.samples import factory
from tests.devices.trex.settings.test_samples import BOARDS, GOLDEN, SAMPLES, every_board, text_of
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_command import VirtualCommand
from tests.support.virtual_time import VirtualRuntime
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings

_TITLE = re.compile(rb"# Read from the board by trexcmd \S+\n")
_OPTIONS = re.compile(r"off and on, connect with (.*)")


class CommandLineBoard:
    """Simulated board, and the `trexcmd` options that connect to it."""

    def __init__(self, simulator: SimulatedDevice, runtime: VirtualRuntime, folder: Path) -> None:
        self._simulator = simulator
        self._runtime = runtime
        self._folder = folder
        self._files = 0
        self._options: list[str] = []
        self._next_options: list[str] = []
        self.factory_reset()

    def factory_reset(self) -> None:
        self._simulator.do("factory")
        self._options = ["--port", self._simulator.url]

    def run(self, *arguments: str) -> Result:
        command = VirtualCommand(self._runtime, [*arguments, *self._options], {})
        command.wait()
        result = command.result
        assert result.exit_code == 0, result.stderr
        if found := _OPTIONS.search(result.stderr):
            self._next_options = found[1].split()
        return result

    def save(self) -> bytes:
        """Return the settings of the board as a file."""
        self._files += 1
        path = self._folder / f"{self._files}.txt"
        self.run("get-settings", str(path))
        return path.read_bytes()

    def write(self, data: bytes) -> None:
        """Write a settings file to the board and power-cycle it.

        Write the file again if the input source has changed, because the board accepts only
        calibrations of the active source.
        """
        path = self._folder / "written.txt"
        path.write_bytes(data)
        messages = self.run("set-settings", str(path)).stderr
        self.power_cycle()
        if "analog_channel_1" in messages and b"channel_input_source: 1" in data:
            self.run("set-settings", str(path))

    def power_cycle(self) -> None:
        self._simulator.do("power cycle")
        self._options, self._next_options = self._next_options or self._options, []


StartBoard = Callable[[str, str], CommandLineBoard]


@pytest.fixture
def start_board(
    start_simulator: StartSimulator, virtual_time: VirtualRuntime, tmp_path: Path
) -> StartBoard:
    """Function that starts a simulated board of a model and a firmware."""

    def start(model: str, firmware: str) -> CommandLineBoard:
        options = ("--model", model, "--firmware", firmware, "--unpaced")
        return CommandLineBoard(start_simulator(*options), virtual_time, tmp_path)

    return start


def other_settings(model: str, firmware: str, *, analog: bool, line: LineSettings) -> Settings:
    """Return settings that differ from all factory defaults."""
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
        key: Calibration(*(count + key.channel for count in (100, 400, 800, 10)))
        for key in CalibrationKey
        if (key.source.value == "analog") is analog
    }
    return replace(factory(model, firmware), parameters=values, calibrations=calibrations)


def round_trip(board: CommandLineBoard, data: bytes) -> bytes:
    """Write a file and read it back, then write the result to a reset board. Return the result."""
    board.write(data)
    first = board.save()
    board.factory_reset()
    board.write(first)
    assert board.save() == first
    return first


@every_board
def test_golden_file_survives_round_trip(
    model: str, firmware: str, start_board: StartBoard
) -> None:
    golden = (GOLDEN / f"{model}-{firmware}.txt").read_bytes()
    saved = round_trip(start_board(model, firmware), golden)
    expected = golden[: golden.index(b"\n# Calibrations for analog voltages")]
    assert _TITLE.sub(b"", saved, count=1) == expected


@pytest.mark.parametrize(
    ("model", "firmware", "inputs"),
    [(*board, "RC") for board in BOARDS]
    + [(*board, "analog") for board in BOARDS if board[1] in {"1.0", "1.3"}],
)
def test_non_default_settings_survive_round_trip(
    model: str, firmware: str, inputs: str, start_board: StartBoard
) -> None:
    line = LineSettings(57600, Detection.CRC7, 2)
    settings = other_settings(model, firmware, analog=inputs == "analog", line=line)
    data = write_settings(settings).encode()
    saved = round_trip(start_board(model, firmware), data)
    assert _TITLE.sub(b"", saved, count=1) == data


@pytest.mark.parametrize("baud", [28800, 38400])
def test_baud_rate_halved_by_old_firmware_survives_round_trip(
    baud: int, start_board: StartBoard
) -> None:
    line = LineSettings(baud, stop_bits=2)
    settings = other_settings("trexjr", "1.1", analog=False, line=line)
    data = write_settings(settings).encode()
    assert _TITLE.sub(b"", round_trip(start_board("trexjr", "1.1"), data), count=1) == data


@pytest.mark.parametrize("name", SAMPLES)
def test_sample_settings_survive_round_trip(name: str, start_board: StartBoard) -> None:
    text = text_of(name)
    settings = read_settings(text)[0]
    model, firmware = settings.product.key, settings.product.firmware[0]
    saved, findings = read_settings(round_trip(start_board(model, firmware), text.encode()))
    assert findings == ()
    assert saved.parameters.items() >= settings.parameters.items()
    assert saved.firmware == firmware
    assert saved.calibrations.items() <= factory(model, firmware).calibrations.items()
