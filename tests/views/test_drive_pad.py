"""Pad and slider: what a hand does in them, and every way in which that ends."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtGui import QPointingDevice, QTouchEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QHBoxLayout, QPushButton, QWidget
from pytestqt.qtbot import QtBot

from trex_gui.views.widgets.drive_pad import DrivePad
from trex_gui.views.widgets.speed_entry import SpeedEntry
from trex_gui.views.widgets.speed_slider import SpeedSlider

LEFT = Qt.MouseButton.LeftButton


class Bench:
    """A pad, a slider and a button in a window; what the pad and the slider told."""

    def __init__(self, qtbot: QtBot) -> None:
        self.window = QWidget()
        qtbot.addWidget(self.window)
        self.pad = DrivePad(self.window)
        self.slider = SpeedSlider(-127, self.window)
        self.button = QPushButton("other", self.window)
        layout = QHBoxLayout(self.window)
        for widget in (self.pad, self.slider, self.button):
            layout.addWidget(widget)
        self.wishes: list[tuple[float, float]] = []
        self.ends: list[str] = []
        self.pad.steered.connect(self._on_steered)
        self.pad.released.connect(self._on_pad_released)
        self.slider.released.connect(self._on_slider_released)
        self.window.resize(600, 300)
        with qtbot.waitExposed(self.window):
            self.window.show()
        self.window.activateWindow()
        qtbot.waitUntil(self.window.isActiveWindow)

    def _on_steered(self, forward: float, turn: float) -> None:
        self.wishes.append((forward, turn))

    def _on_pad_released(self) -> None:
        self.ends.append("pad")

    def _on_slider_released(self) -> None:
        self.ends.append("slider")

    def hold_both(self) -> None:
        QTest.mousePress(self.slider, LEFT, pos=self.slider.rect().center())
        self.hold_pad()

    def hold_pad(self) -> None:
        QTest.mousePress(self.pad, LEFT, pos=self.pad.rect().center() - QPoint(0, 40))


@pytest.fixture
def bench(qtbot: QtBot) -> Bench:
    return Bench(qtbot)


def test_up_is_forward_and_right_is_right(bench: Bench) -> None:
    QTest.mousePress(bench.pad, LEFT, pos=bench.pad.rect().center() + QPoint(40, -80))
    forward, turn = bench.wishes[-1]
    assert 0 < turn < forward <= 1


def test_what_is_hardly_off_an_axis_is_on_it(bench: Bench) -> None:
    QTest.mousePress(bench.pad, LEFT, pos=bench.pad.rect().center() + QPoint(2, -80))
    assert bench.wishes[-1][1] == 0


def test_beyond_its_edge_the_pad_gives_all_and_no_more(bench: Bench) -> None:
    bench.hold_pad()
    QTest.mouseMove(bench.pad, QPoint(3000, 3000))
    assert bench.wishes[-1] == (-1, 1)


def test_without_a_turn_axis_the_pad_only_goes_ahead(bench: Bench) -> None:
    bench.pad.set_can_turn(False)
    QTest.mousePress(bench.pad, LEFT, pos=bench.pad.rect().center() + QPoint(60, -60))
    assert bench.wishes[-1][0] > 0
    assert bench.wishes[-1][1] == 0


def cancel_touch(pad: DrivePad) -> None:
    finger = QTest.createTouchDevice()
    assert isinstance(finger, QPointingDevice)
    cancelled = QTouchEvent(QEvent.Type.TouchCancel, finger)
    QApplication.sendEvent(pad, cancelled)


@pytest.mark.qt_log_ignore("not accepted by receiving widget", extend=True)  # it is disabled
@pytest.mark.parametrize(
    "end",
    [
        lambda bench: QTest.mouseRelease(bench.pad, LEFT, pos=QPoint(5, 5)),
        lambda bench: QTest.mousePress(bench.pad, Qt.MouseButton.RightButton),
        lambda bench: bench.button.setFocus(),
        lambda bench: bench.pad.setEnabled(False),
        lambda bench: bench.window.setEnabled(False),
        lambda bench: bench.pad.hide(),
        lambda bench: bench.window.hide(),
        lambda bench: bench.pad.set_can_turn(False),
        lambda bench: bench.pad.let_go(),
        lambda bench: cancel_touch(bench.pad),
        lambda bench: QApplication.sendEvent(bench.pad, QEvent(QEvent.Type.UngrabMouse)),
        lambda bench: QApplication.sendEvent(bench.pad, QEvent(QEvent.Type.WindowDeactivate)),
    ],
)
def test_the_pad_is_let_go_once_and_follows_no_more(
    bench: Bench, end: Callable[[Bench], object]
) -> None:
    bench.hold_pad()
    end(bench)
    assert bench.ends == ["pad"]
    told = len(bench.wishes)
    QTest.mouseMove(bench.pad, QPoint(20, 20))
    assert len(bench.wishes) == told
    assert "At rest" in bench.pad.accessibleDescription()


@pytest.mark.parametrize(
    "end",
    [
        lambda bench: QTest.mouseRelease(bench.slider, LEFT, pos=QPoint(5, 5)),
        lambda bench: bench.button.setFocus(),
        lambda bench: bench.slider.setEnabled(False),
        lambda bench: bench.window.hide(),
        lambda bench: bench.slider.let_go(),
        lambda bench: QApplication.sendEvent(bench.slider, QEvent(QEvent.Type.UngrabMouse)),
    ],
)
def test_a_slider_is_let_go_once_and_follows_no_more(
    bench: Bench, end: Callable[[Bench], object]
) -> None:
    QTest.mousePress(bench.slider, LEFT, pos=QPoint(20, bench.slider.height() // 2))
    assert bench.slider.held
    end(bench)
    assert bench.ends == ["slider"]
    value = bench.slider.value()
    QTest.mouseMove(bench.slider, QPoint(100, 8))
    assert bench.slider.value() == value


def test_no_single_key_means_full_speed(bench: Bench) -> None:
    bench.slider.setFocus()
    bench.slider.setValue(40)
    QTest.keyClick(bench.slider, Qt.Key.Key_End)
    assert bench.slider.value() == 40
    QTest.keyClick(bench.slider, Qt.Key.Key_Home)
    assert bench.slider.value() == 0


def test_a_second_finger_changes_nothing(bench: Bench) -> None:
    finger = QTest.createTouchDevice()
    assert isinstance(finger, QPointingDevice)
    centre = bench.pad.rect().center()
    QTest.touchEvent(bench.pad, finger).press(0, centre - QPoint(0, 60), bench.pad).commit()
    first = bench.wishes[-1]
    both = QTest.touchEvent(bench.pad, finger)
    both.stationary(0)
    both.press(1, centre + QPoint(0, 60), bench.pad).commit()
    assert bench.wishes[-1] == first
    assert bench.pad.held
    one = QTest.touchEvent(bench.pad, finger)
    one.release(0, centre, bench.pad)
    one.stationary(1).commit()
    assert bench.ends == ["pad"]
    QTest.touchEvent(bench.pad, finger).release(1, centre, bench.pad).commit()


@pytest.mark.parametrize("button", [Qt.MouseButton.MiddleButton, Qt.MouseButton.RightButton])
@pytest.mark.qt_log_ignore("not accepted by receiving widget", extend=True)
def test_only_the_left_button_moves_a_slider(bench: Bench, button: Qt.MouseButton) -> None:
    QTest.mousePress(bench.slider, button, pos=QPoint(20, 12))
    QTest.mouseMove(bench.slider, QPoint(30, 12))
    QTest.mouseRelease(bench.slider, button, pos=QPoint(30, 12))
    assert bench.slider.value() == 0
    assert not bench.slider.held


@pytest.mark.qt_log_ignore("not accepted by receiving widget", extend=True)
def test_another_button_does_not_end_a_drag(bench: Bench) -> None:
    QTest.mousePress(bench.slider, LEFT, pos=QPoint(20, 12))
    QTest.mouseRelease(bench.slider, Qt.MouseButton.RightButton, pos=QPoint(20, 12))
    assert bench.slider.held


def test_a_slider_key_that_goes_up_under_another_name_lets_go(bench: Bench) -> None:
    bench.slider.setFocus()
    QTest.keyPress(bench.slider, Qt.Key.Key_PageUp)
    assert bench.slider.held
    QTest.keyRelease(bench.slider, Qt.Key.Key_9)
    assert bench.ends == ["slider"]


def test_a_slider_key_that_repeats_does_not_take_hold_again(bench: Bench) -> None:
    bench.slider.setFocus()
    QTest.keyPress(bench.slider, Qt.Key.Key_PageUp)
    bench.slider.let_go()
    value = bench.slider.value()
    key, none = Qt.Key.Key_PageUp, Qt.KeyboardModifier.NoModifier
    QTest.simulateEvent(bench.slider, True, key, none, "", True)
    assert bench.slider.value() == value
    assert not bench.slider.held


def typing_in(qtbot: QtBot, text: str) -> tuple[SpeedEntry, list[int]]:
    entry = SpeedEntry()
    qtbot.addWidget(entry)
    entry.setRange(-127, 127)
    chosen: list[int] = []
    entry.chosen.connect(chosen.append)
    entry.show()
    entry.activateWindow()
    entry.setFocus()
    qtbot.waitUntil(entry.hasFocus)
    entry.show_wish(7)
    entry.selectAll()
    QTest.keyClicks(entry, text)
    return entry, chosen


def test_a_wish_does_not_overwrite_a_number_that_is_typed(qtbot: QtBot) -> None:
    entry, chosen = typing_in(qtbot, "10")
    entry.show_wish(30)
    assert entry.text() == "10"
    QTest.keyClick(entry, Qt.Key.Key_Return)
    assert chosen == [10]
    entry.show_wish(30)
    assert entry.text() == "30"


def test_the_same_number_entered_again_is_asked_for_again(qtbot: QtBot) -> None:
    entry, chosen = typing_in(qtbot, "7")
    QTest.keyClick(entry, Qt.Key.Key_Return)
    QTest.keyClick(entry, Qt.Key.Key_Return)
    assert chosen == [7]


def test_a_step_is_asked_for_at_once(qtbot: QtBot) -> None:
    entry, chosen = typing_in(qtbot, "10")
    QTest.keyClick(entry, Qt.Key.Key_Up)
    assert chosen[-1] == 11


@pytest.mark.parametrize(
    "leave",
    [SpeedEntry.clearFocus, SpeedEntry.hide, SpeedEntry.close],
)
def test_a_number_that_was_not_entered_is_given_up(
    qtbot: QtBot, leave: Callable[[SpeedEntry], object]
) -> None:
    entry, chosen = typing_in(qtbot, "100")
    entry.show_wish(30)
    leave(entry)
    assert not chosen
    assert entry.text() == "30"
