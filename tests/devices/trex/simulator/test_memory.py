"""Writes to the EEPROM in time, and what a power cut leaves of them."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION, Calibration
from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.memory import Eeprom

RC, ANALOG = InputSource.RC, InputSource.ANALOG
OLD = Calibration(2400, 3600, 4800, 60)
NEW = Calibration(2600, 3660, 4700, 50)
FACTORY = DEFAULT_CALIBRATION[RC]


def a_board(path: Path) -> Board:
    eeprom = Eeprom.open(path)
    eeprom.write("serial_timeout", 20)
    eeprom.write("motor1_acceleration", 7)
    eeprom.write_calibration(RC, 2, OLD)
    return Board(eeprom=eeprom)


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "eeprom.json"


def test_calibration_out_of_order_after_power_cut_is_loaded(path: Path) -> None:
    board = a_board(path)
    board.set_calibration(2, Calibration(6000, 6100, 6200, 10))
    board.advance(0.009)
    board.power_off()
    left = Calibration(6000, FACTORY.neutral, OLD.maximum, OLD.deadband)
    assert left.minimum > left.neutral
    again = Board(eeprom=Eeprom.open(path))
    assert again.calibration(2) == left
    again.advance(0.1)
    assert all(-127 <= value <= 127 for value in again.remapped)


def test_power_cut_cancels_unfinished_factory_reset_request(path: Path) -> None:
    board = a_board(path)
    board.set_parameter(0x7F, 0x7F)
    board.advance(0.002)
    board.power_cycle()
    assert board.memory.active["serial_timeout"] == 20
    assert not Eeprom.open(path).reset_pending


@given(seconds=st.floats(0, 0.04), channel=st.integers(1, 5))
def test_power_cut_leaves_each_value_new_old_or_default(seconds: float, channel: int) -> None:
    board = Board()
    board.eeprom.write_calibration(RC, channel, OLD)
    assert board.set_calibration(channel, NEW) is ResultCode.OK
    board.advance(seconds)
    board.power_cycle()
    left = board.calibration(channel)
    written = min(4, int(seconds / 0.008 + 1e-6))
    for index, field in enumerate(("minimum", "neutral", "maximum", "deadband")):
        value = getattr(left, field)
        if index < written:
            assert value == getattr(NEW, field)
        elif index == written:
            assert value == getattr(FACTORY, field)
        else:
            assert value == getattr(OLD, field)
    assert board.calibration(channel % 5 + 1) == FACTORY
    assert board.eeprom.calibration(ANALOG, channel) == DEFAULT_CALIBRATION[ANALOG]
