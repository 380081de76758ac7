"""Ten seconds of dragging in the whole program, a simulated board in a process of its own."""

import sys
from bisect import bisect_right

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QStyle, QStyleOptionSlider
from pytestqt.qtbot import QtBot

from tests.support.virtual_devices import VirtualSimulator
from trex_gui.link.messages import SetDrive
from trex_gui.link.motors import DRIVE_INTERVAL
from trex_gui.link.repeating import REPEATS
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.protocol.commands import Drive, DriveMotor
from trex_gui.runtime import now
from trex_gui.views.widgets.speed_slider import SpeedSlider
from trex_gui.window import Program

pytestmark = [
    pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals"),
    pytest.mark.timeout(240),  # ten thousand moves, on a computer that is slower than the hand
]

_SECONDS, _RATE, _CYCLE = 2.0, 500, 127
_AT_A_TURN = 50
"""Moves before the window has a turn of its own: one that never has is taken for a hung one."""

LEFT = Qt.MouseButton.LeftButton


def place_of(slider: SpeedSlider, value: int) -> QPoint:
    """Where the handle is at this value."""
    option = QStyleOptionSlider()
    slider.initStyleOption(option)
    style, part = slider.style(), QStyle.SubControl.SC_SliderHandle
    handle = style.subControlRect(QStyle.ComplexControl.CC_Slider, option, part, slider)
    room = slider.width() - handle.width()
    along = QStyle.sliderPositionFromValue(slider.minimum(), slider.maximum(), value, room)
    return QPoint(along + handle.width() // 2, handle.center().y())


def move_mouse(slider: SpeedSlider, place: QPoint) -> None:
    """Move with the button down, at a cost that lets a thousand moves be made in a second."""
    there = slider.mapToGlobal(place)
    kind, none = QEvent.Type.MouseMove, Qt.MouseButton.NoButton
    event = QMouseEvent(
        kind, QPointF(place), QPointF(there), none, LEFT, Qt.KeyboardModifier.NoModifier
    )
    QApplication.sendEvent(slider, event)


def test_a_drag_never_floods_the_line_and_its_last_position_arrives(
    program: Program, qtbot: QtBot, simulator: VirtualSimulator, monkeypatch: pytest.MonkeyPatch
) -> None:
    packets: list[tuple[float, int]] = []

    def note(data: bytes) -> None:
        if data[0] == DriveMotor(1, Drive.at(1)).opcode:
            packets.append((now(), data[1]))

    simulator.on_write = note
    asked: list[tuple[float, int]] = []

    def note_wish(wish: SetDrive) -> None:
        """Comes after the program has handed it over."""
        asked.append((now(), wish.drive.signed))

    motors = program.device.motors
    program.device.connect_to(LinkSettings(simulator.url))
    qtbot.waitUntil(lambda: program.device.link is Link.UP and motors.can_arm)
    program.window.pages.setCurrentIndex(3)
    motors.arm()
    motors.accelerate = False
    motors.requested.connect(note_wish)
    slider = program.window.findChild(SpeedSlider, "motor1Slider")
    assert isinstance(slider, SpeedSlider)
    places = [place_of(slider, 1 + value) for value in range(_CYCLE)]
    QTest.mousePress(slider, LEFT, pos=place_of(slider, 0))
    begun, move, turn = now(), 0, 0
    while move < _SECONDS * _RATE:  # where the computer is slower than the hand, it takes longer
        due = min((now() - begun) * _RATE, _SECONDS * _RATE)
        while move < min(due, turn + _AT_A_TURN):
            move_mouse(slider, places[move % _CYCLE])
            move += 1
        turn = move
        qtbot.wait(4)
    last = slider.value()
    QTest.mouseRelease(slider, LEFT, pos=places[(move - 1) % _CYCLE])
    assert len(asked) > move / 4, "the slider did not follow"
    assert asked[-1][1] == last > 0
    qtbot.waitUntil(lambda: simulator.show()["motors"][0]["speed"] == last)
    assert len(packets) <= (asked[-1][0] - begun) / DRIVE_INTERVAL + 2 + len(REPEATS)
    assert waiting_packets(asked, packets) <= 1
    motors.stop()
    qtbot.waitUntil(lambda: not program.device.may_move)


def waiting_packets(asked: list[tuple[float, int]], packets: list[tuple[float, int]]) -> int:
    """Return how many packets the line was ever behind the hand, at most.

    A packet that shows an older wish than the newest when the one before it left is a second
    one that had been waiting. However long the computer takes over anything, this stays.
    """
    times = [moment for moment, _ in asked]
    most, sent_at = 0, [moment for moment, _ in packets]
    for index, (moment, speed) in enumerate(packets):
        newest = min(bisect_right(times, moment), len(asked) - 1)  # one may be noted just after
        shown = next(number for number in range(newest, -1, -1) if asked[number][1] == speed)
        if shown + 1 < len(asked):  # packets that left since it was overtaken, without it
            overtaken_at = times[shown + 1]
            most = max(most, index - bisect_right(sent_at, overtaken_at, hi=index))
    return most
