"""Automatic messages move no control and receive no typed keys."""

from PySide6.QtCore import QPoint
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QComboBox,
    QLabel,
    QLineEdit,
    QScrollBar,
    QTabBar,
    QWidget,
)

from tests.support.window import WidgetDriver, WindowDriver
from trex_gui.ui.widgets.messages import InlinePrompt

_CONTROLS = (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QComboBox,
    QLineEdit,
    QTabBar,
)
_LONG = "Something went wrong, and it takes a while to say what. " * 4


def places(root: QWidget) -> dict[QWidget, tuple[QPoint, QPoint]]:
    """Return the corners of the visible controls in a window."""
    return {
        each: (each.mapTo(root, QPoint()), each.mapTo(root, each.rect().bottomRight()))
        for each in root.findChildren(QWidget)
        if isinstance(each, _CONTROLS)
        and not isinstance(each, QScrollBar)
        and each.isVisible()
        and each.window() is root
    }


def moved(window: WidgetDriver, before: dict[QWidget, tuple[QPoint, QPoint]]) -> list[str]:
    QTest.qWait(50)
    after = places(window.root)
    both = before.keys() & after.keys()
    return [each.objectName() for each in both if before[each] != after[each]]


def is_in_sight(window: WidgetDriver, name: str) -> bool:
    message = window.find(QWidget, name)
    top = message.mapTo(window.root, QPoint()).y()
    return message.isVisible() and message.height() > 20 and top >= 0


def test_messages_are_in_sight_and_move_no_control(connected_window: WindowDriver) -> None:
    window = connected_window
    window.window.resize(1024, 700)
    for page in ("motorsPage", "channelsPage", "parametersPage"):
        window.open_page(page)
        QTest.qWait(300)
        window.device.notifier.cleared.emit()
        before = places(window.window)
        window.device.notifier.error.emit(_LONG)
        assert moved(window, before) == [], page
        assert is_in_sight(window, "banner")
        window.window.question.prompt(_LONG)
        assert moved(window, before) == [], page
        assert is_in_sight(window, "question")
        window.window.question.withdraw()
        window.device.notifier.cleared.emit()
        assert moved(window, before) == [], page
        window.device.writer.set_serial_timeout(0.5)
        window.wait(lambda: not window.device.writer.running)
        assert moved(window, before) == [], page
        window.device.writer.set_serial_timeout(0)
        window.wait(lambda: not window.device.writer.running)
        window.device.parameters.edit("serial_timeout", 9)
        assert moved(window, before) == [], page
        if page != "parametersPage":
            window.trigger("discard")

    window.trigger("apply")
    review = window.dialog("reviewDialog")
    QTest.qWait(300)
    before = places(review.root)
    review.find(InlinePrompt, "reviewQuestion").prompt(_LONG)
    assert moved(review, before) == []


def test_short_message_covers_no_control(connected_window: WindowDriver) -> None:
    window = connected_window
    window.window.resize(1366, 768)
    window.device.notifier.error.emit("Short.")
    message = window.find(QWidget, "banner")
    for page in ("boardPage", "motorsPage", "channelsPage", "currentsPage", "parametersPage"):
        window.open_page(page)
        QTest.qWait(300)
        top = message.mapTo(window.window, QPoint()).y()
        area, bar = window.find(QWidget, page), window.find(QWidget, "stopButton").parentWidget()
        assert bar is not None
        assert top < bar.mapTo(window.window, QPoint()).y()
        below = [
            each.objectName()
            for each, (_, corner) in places(window.window).items()
            if area.isAncestorOf(each) and corner.y() >= top
        ]
        assert below == [], page


def test_bar_leaves_out_what_the_head_of_a_page_says(connected_window: WindowDriver) -> None:
    window = connected_window
    state, word = window.find(QLabel, "motorStateLabel"), window.find(QLabel, "armedLabel")
    for page, is_said in (("motorsPage", True), ("parametersPage", False), ("boardPage", True)):
        window.open_page(page)
        assert state.isVisible() is not is_said, page
    assert not word.isVisible()
    window.motors.arm()
    assert word.isVisible()


def test_question_takes_no_keys_from_what_is_typed(connected_window: WindowDriver) -> None:
    window = connected_window
    window.open_page("parametersPage")
    window.window.activateWindow()
    search = window.find(QLineEdit, "parameterSearch")
    search.setFocus()
    window.wait(search.hasFocus)
    window.window.question.prompt("Restore?")
    assert search.hasFocus()
    window.button("stopButton").setFocus()
    window.window.question.prompt("Discard?")
    assert window.button("questionCancel").hasFocus()
