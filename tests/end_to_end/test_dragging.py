"""Ten seconds of dragging in the whole program, a simulated board in a process of its own."""

import sys
import time

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatorProcess
from trex_gui.link.motors import DRIVE_INTERVAL, REPEATS
from trex_gui.link.settings import LinkSettings
from trex_gui.link.transport import SerialTransport
from trex_gui.model.device import Link
from trex_gui.protocol.commands import Drive, DriveMotor
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

_SECONDS, _RATE, _CYCLE = 10.0, 1000, 127
_LATEST_MS = 200
"""Between a position and a packet that still shows an older one, in the median, on a computer that
does much else at the same time; in virtual time it is none (tests/link/test_dragging.py)."""


def test_a_drag_never_floods_the_line_and_its_last_position_arrives(
    program: Program, qtbot: QtBot, simulator: SimulatorProcess, monkeypatch: pytest.MonkeyPatch
) -> None:
    packets: list[tuple[float, int]] = []
    write = SerialTransport.write

    def note(port: SerialTransport, data: bytes) -> None:
        if data[0] == DriveMotor(1, Drive.at(1)).opcode:
            packets.append((time.monotonic(), data[1]))
        write(port, data)

    monkeypatch.setattr(SerialTransport, "write", note)
    motors = program.device.motors
    program.device.connect_to(LinkSettings(simulator.url))
    qtbot.waitUntil(lambda: program.device.link is Link.UP and motors.can_arm)
    motors.arm()
    motors.accelerate = False
    begun, move = time.monotonic(), 0
    moved: list[float] = []
    while move < _SECONDS * _RATE:  # where the computer is slower than the hand, it takes longer
        while move < min((time.monotonic() - begun) * _RATE, _SECONDS * _RATE):
            motors.set_speed(1, 1 + move % _CYCLE)
            moved.append(time.monotonic())
            move += 1
        qtbot.wait(1)
    last = 1 + (move - 1) % _CYCLE
    qtbot.waitUntil(lambda: simulator.show()["motors"][0]["speed"] == last)
    assert len(packets) <= (moved[-1] - begun) / DRIVE_INTERVAL + 2 + len(REPEATS)
    late = []
    for moment, speed in packets:
        newest = sum(1 for at in moved if at <= moment) - 1
        wanted = newest - (newest - (speed - 1)) % _CYCLE  # the move that this packet shows
        overtaken_at = moved[wanted + 1] if wanted + 1 < len(moved) else moment
        late.append(1000 * (moment - overtaken_at))
    assert sorted(late)[len(late) // 2] < _LATEST_MS
    motors.stop()
    qtbot.waitUntil(lambda: not program.device.may_move)
