"""EEPROM of the simulated board, its file, and power cuts during writes."""

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION, Calibration
from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.simulator.command import simulate
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.memory import Eeprom, EepromError

RC, ANALOG = InputSource.RC, InputSource.ANALOG
OLD = Calibration(2400, 3600, 4800, 60)
NEW = Calibration(2600, 3660, 4700, 50)
FACTORY = DEFAULT_CALIBRATION[RC]


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "eeprom.json"


@pytest.mark.parametrize("model", ["trex", "trexjr"])
def test_new_eeprom_holds_factory_defaults(model: str) -> None:
    eeprom = Eeprom(model)
    for spec in parameters_of(model, "1.3").readable:
        assert eeprom[spec.key] == spec.default
    for source in InputSource:
        assert eeprom.learned(source) == 0
        assert eeprom.calibration(source, 3) == DEFAULT_CALIBRATION[source]


def test_written_values_are_loaded_from_file(path: Path) -> None:
    eeprom = Eeprom.open(path, "trexjr")
    eeprom.write("serial_timeout", 12)
    eeprom.write("uart_settings", 0x2A)
    eeprom.write_calibration(InputSource.RC, 5, NEW)
    eeprom.request_reset()

    loaded = Eeprom.open(path, "trexjr")
    assert loaded["serial_timeout"] == 12
    assert loaded["uart_settings"] == 0x2A
    assert loaded.calibration(InputSource.RC, 5) == NEW
    assert loaded.calibration(InputSource.ANALOG, 5) != NEW
    assert loaded.learned(InputSource.RC) == 0b10000
    assert loaded.reset_pending


def test_reset_restores_parameters_and_keeps_calibrations() -> None:
    eeprom = Eeprom()
    eeprom.write("serial_timeout", 12)
    eeprom.write_calibration(InputSource.RC, 1, NEW)
    eeprom.request_reset()
    assert eeprom["serial_timeout"] == 12
    eeprom.reset_if_pending()
    assert eeprom["serial_timeout"] == 0
    assert eeprom.calibration(InputSource.RC, 1) == NEW
    assert not eeprom.reset_pending


def test_file_is_json_and_no_temporary_file_remains(path: Path) -> None:
    Eeprom.open(path).write("device_number", 9)
    document = json.loads(path.read_text(encoding="utf-8"))
    assert document["parameters"]["device_number"] == 9
    assert document["rc_calibration"][0]["neutral"] == 3750
    assert list(path.parent.iterdir()) == [path]


@pytest.mark.parametrize("key", ["serial_timeouts", "factory_reset"])
def test_unreadable_parameter_raises_key_error(key: str) -> None:
    with pytest.raises(KeyError):
        Eeprom()[key]


def test_out_of_range_value_is_rejected() -> None:
    eeprom = Eeprom()
    with pytest.raises(ValueError, match="Motor Mode"):
        eeprom.write("motor_mode", 2)
    assert eeprom["motor_mode"] == 0


def _document(**changes: Any) -> str:
    eeprom = Eeprom()
    return json.dumps(eeprom._document() | changes)


def _calibrated(**changes: float) -> str:
    row = {"minimum": 5, "neutral": 6, "maximum": 9, "deadband": 1} | changes
    return _document(rc_calibration=[row] * 5)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "line 1"),
        ('{"what": ', "line 1"),
        ("[" * 100_000, "nested"),
        ("[]", "does not begin"),
        ("{}", "does not begin"),
        (_document(model="trexjr"), "belongs to model trexjr"),
        (_document(parameters=[]), '"parameters" is not a table'),
        (_document(parameters={"serial_timeout": 128}), "Serial Timeout"),
        (_document(parameters={"serial_timeout": True}), "serial_timeout is not a whole number"),
        (_document(parameters={"uart_settings": 0x0B}), "UART Settings"),
        (_document(parameters={"warp_factor": 9}), "no parameter warp_factor"),
        (_document(rc_calibration=[]), "rc_calibration is not a list of 5"),
        (_document(rc_calibration=[3] * 5), "rc_calibration, channel 1"),
        (
            _document(analog_calibration=[{"minimum": 5, "neutral": 4, "maximum": 9}] * 5),
            "analog_calibration, channel 1 does not have minimum",
        ),
        (_calibrated(maximum=16384), "maximum is not a number from 0 to 16383"),
        (_calibrated(neutral=4.5), "neutral is not a number"),
    ],
)
def test_damaged_file_is_reported_in_one_line(path: Path, text: str, reason: str) -> None:
    path.write_text(text, encoding="utf-8")
    with pytest.raises(EepromError) as caught:
        Eeprom.open(path)
    message = str(caught.value)
    assert str(path) in message
    assert reason in message
    assert "\n" not in message
    assert path.read_text(encoding="utf-8") == text


def test_calibration_values_out_of_order_are_loaded(path: Path) -> None:
    row = {"minimum": 9, "neutral": 4, "maximum": 4, "deadband": 16383}
    path.write_text(_document(analog_calibration=[row] * 5), encoding="utf-8")
    eeprom = Eeprom.open(path)
    assert eeprom.calibration(InputSource.ANALOG, 3) == Calibration(9, 4, 4, 16383)
    assert eeprom.learned(InputSource.ANALOG) == 0b11111


def test_factory_state_is_restored_in_file(path: Path) -> None:
    eeprom = Eeprom.open(path, "trexjr")
    new = path.read_text(encoding="utf-8")
    eeprom.write("uart_settings", 0x2A)
    eeprom.write_calibration(InputSource.RC, 5, NEW)
    eeprom.write_calibration(InputSource.ANALOG, 1, NEW)
    eeprom.request_reset()
    eeprom.factory_reset()
    assert path.read_text(encoding="utf-8") == new
    assert eeprom["uart_settings"] == 5
    assert eeprom.learned(InputSource.RC) == eeprom.learned(InputSource.ANALOG) == 0
    assert not eeprom.reset_pending


def test_unusable_path_raises_eeprom_error(tmp_path: Path) -> None:
    with pytest.raises(EepromError, match="cannot be written"):
        Eeprom.open(tmp_path / "missing" / "eeprom.json")
    with pytest.raises(EepromError, match="cannot be read"):
        Eeprom.open(tmp_path)


@pytest.mark.parametrize("default", ["on", "off"])
def test_stray_byte_stops_motor_if_error_shutdown_is_the_default(default: str) -> None:
    simulation = simulate(error_shutdown=default)
    line = simulation.line
    assert isinstance(line, SimulatedBoards)
    for control_line in ("power on", "factory"):
        simulation.control(control_line)
        simulation.control("power cycle")
        line.advance(2)
        line.send(bytes.fromhex("C2 50"))
        line.advance(0.1)
        line.send(b"\r")  # sent by a program that ends each command with a line end
        line.advance(0.1)
        assert (line.boards[0].motors[0].speed == 0x50) is (default == "off")


# --- Power cuts during writes ---------------------------------------------------------


def open_board(path: Path) -> Board:
    eeprom = Eeprom.open(path)
    eeprom.write("serial_timeout", 20)
    eeprom.write("motor1_acceleration", 7)
    eeprom.write_calibration(RC, 2, OLD)
    return Board(eeprom=eeprom)


def test_power_cut_cancels_unfinished_factory_reset_request(path: Path) -> None:
    board = open_board(path)
    board.set_parameter(0x7F, 0x7F)
    board.advance(0.002)
    board.power_cycle()
    assert board.memory.active["serial_timeout"] == 20
    assert not Eeprom.open(path).reset_pending


@examples(40)
@given(seconds=st.floats(0, 0.04), channel=st.integers(1, 5))
def test_each_value_is_new_old_or_default_after_power_cut(seconds: float, channel: int) -> None:
    board = Board()
    board.eeprom.write_calibration(RC, channel, OLD)
    assert board.set_calibration(channel, NEW) is ResultCode.OK
    board.advance(seconds)
    board.power_cycle()
    written = min(4, int(seconds / 0.008 + 1e-6))
    for index, field in enumerate(("minimum", "neutral", "maximum", "deadband")):
        expected = NEW if index < written else FACTORY if index == written else OLD
        assert getattr(board.calibration(channel), field) == getattr(expected, field)
    assert board.calibration(channel % 5 + 1) == FACTORY
    assert board.eeprom.calibration(ANALOG, channel) == DEFAULT_CALIBRATION[ANALOG]
