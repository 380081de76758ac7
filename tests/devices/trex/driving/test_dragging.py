"""A hand that moves a thousand times a second, and a line that carries fifty packets in it."""

import pytest

from tests.devices.trex.session.helpers import run_for, seen_at, staged
from trex_gui.devices.trex.driving.motor_driver import DRIVE_INTERVAL
from trex_gui.devices.trex.driving.requests import SetMotor
from trex_gui.devices.trex.driving.setpoints import REPEATS
from trex_gui.devices.trex.protocol.commands import DriveMotor
from trex_gui.devices.trex.protocol.driving import Drive

_MOVES = 3_000
_RATE = 1000


@pytest.mark.parametrize("baud", [1200, 19200, 115200])
def test_drag_sends_newest_positions_and_delivers_last_one(
    baud: int,
) -> None:
    stage, settings = staged(baud)
    start = 1.0 + 4.0 * 1200 / baud
    for move in range(_MOVES):
        stage.script.at(start + move / _RATE, SetMotor(1, Drive.at(move % 128)))
    end = start + _MOVES / _RATE
    speeds = seen_at(stage, end + 0.3, lambda: stage.board.motors[0].speed)
    run_for(stage, end + 0.4, settings)
    opcode = DriveMotor(1, Drive.at(1)).opcode
    sent = [(moment, data[1]) for moment, data in stage.transport.written if data[0] == opcode]
    assert speeds == [(_MOVES - 1) % 128]
    assert len(sent) <= _MOVES / _RATE / DRIVE_INTERVAL + 1 + len(REPEATS)
    for moment, speed in sent:
        newest = min(int((moment - start) * _RATE + 1e-6), _MOVES - 1)
        assert (newest - speed) % 128 <= 1, "an older position was sent than the newest"
