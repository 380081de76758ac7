"""A fast drag in the whole program, on a line that takes its time."""

from bisect import bisect_right
from functools import partial

from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QSlider

from tests.support.pages.motors import MotorsPage
from tests.support.virtual_devices import VirtualSimulator
from tests.support.virtual_time import VirtualRuntime
from tests.support.window import LEFT, WindowDriver
from trex_gui.devices.trex.driving.motor_driver import DRIVE_INTERVAL
from trex_gui.devices.trex.driving.requests import SetMotor
from trex_gui.devices.trex.driving.setpoints import REPEATS
from trex_gui.devices.trex.protocol.commands import DriveMotor
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.ui.runtime import now

MOVES = 1000
RATE = 500  # moves in a second
CYCLE = 127


def move_mouse(slider: QSlider, place: QPoint) -> None:
    """Move with the button down, at less cost than QTest does."""
    kind, none = QEvent.Type.MouseMove, Qt.MouseButton.NoButton
    there = slider.mapToGlobal(place)
    event = QMouseEvent(
        kind, QPointF(place), QPointF(there), none, LEFT, Qt.KeyboardModifier.NoModifier
    )
    QApplication.sendEvent(slider, event)


def test_drag_never_floods_line_and_last_position_arrives(
    window: WindowDriver, simulator: VirtualSimulator, virtual_time: VirtualRuntime
) -> None:
    window.connect(simulator.url)
    page = MotorsPage(window, simulator)
    page.motors.accelerate = False
    page.arm()
    packets: list[tuple[float, int]] = []
    requested: list[tuple[float, int]] = []

    def note_packet(data: bytes) -> None:
        if data[0] == DriveMotor(1, Drive.at(1)).opcode:
            packets.append((now(), data[1]))

    def note_request(request: SetMotor) -> None:
        """Comes after the program has handed it over."""
        requested.append((now(), request.drive.signed))

    simulator.on_write = note_packet
    page.motors.requested.connect(note_request)
    slider = page.find(QSlider, "motor1Slider")
    places = [page.handle_of(slider, 1 + value) for value in range(CYCLE)]
    QTest.mousePress(slider, LEFT, pos=page.handle_of(slider))
    start = now()
    for move in range(MOVES):
        step = partial(move_mouse, slider, places[move % CYCLE])
        virtual_time.at(start + move / RATE, step, of_gui=True)
    last = 1 + (MOVES - 1) % CYCLE
    page.wait(lambda: now() > start + MOVES / RATE)
    QTest.mouseRelease(slider, LEFT, pos=places[(MOVES - 1) % CYCLE])
    assert len(requested) > MOVES / 4, "the slider did not follow"
    assert requested[-1][1] == slider.value() == last
    page.wait(lambda: simulator.show()["motors"][0]["speed"] == last)
    assert len(packets) <= (requested[-1][0] - start) / DRIVE_INTERVAL + 2 + len(REPEATS)
    assert waiting_packets(requested, packets) <= 1
    page.motors.stop()
    page.wait(lambda: not page.device.may_move)


def waiting_packets(requested: list[tuple[float, int]], packets: list[tuple[float, int]]) -> int:
    """Return how many packets the line was ever behind the hand, at most.

    A packet that shows an older setpoint than the newest when the one before it left is a second
    one that had been waiting.
    """
    times = [moment for moment, _ in requested]
    most, sent_at = 0, [moment for moment, _ in packets]
    for index, (moment, speed) in enumerate(packets):
        newest = min(bisect_right(times, moment), len(requested) - 1)  # may be noted just after
        shown = next(number for number in range(newest, -1, -1) if requested[number][1] == speed)
        if shown + 1 < len(requested):  # packets that left since it was overtaken, without it
            overtaken_at = times[shown + 1]
            most = max(most, index - bisect_right(sent_at, overtaken_at, hi=index))
    return most
