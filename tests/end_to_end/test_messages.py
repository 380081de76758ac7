"""Messages of the program move no control and receive no typed keys."""

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


def corners_of(root: QWidget) -> dict[QWidget, tuple[QPoint, QPoint]]:
    """Return the corners of the visible controls in a window."""
    return {
        each: (each.mapTo(root, QPoint()), each.mapTo(root, each.rect().bottomRight()))
        for each in root.findChildren(QWidget)
        if isinstance(each, _CONTROLS)
        and not isinstance(each, QScrollBar)
        and each.isVisible()
        and each.window() is root
    }


def moved_controls(window: WidgetDriver, before: dict[QWidget, tuple[QPoint, QPoint]]) -> list[str]:
    QTest.qWait(50)
    after = corners_of(window.root)
    common = before.keys() & after.keys()
    return [each.objectName() for each in common if before[each] != after[each]]


def is_fully_visible(window: WidgetDriver, name: str) -> bool:
    message = window.find(QWidget, name)
    top = message.mapTo(window.root, QPoint()).y()
    return message.isVisible() and message.height() > 20 and top >= 0


def test_messages_are_visible_and_move_no_control(connected_window: WindowDriver) -> None:
    window = connected_window
    window.window.resize(1024, 700)
    for page in ("motorsPage", "channelsPage", "parametersPage"):
        window.open_page(page)
        QTest.qWait(300)
        window.device.notifier.cleared.emit()
        before = corners_of(window.window)
        window.device.notifier.error.emit(_LONG)
        assert moved_controls(window, before) == [], page
        assert is_fully_visible(window, "banner")
        window.window.question.prompt(_LONG)
        assert moved_controls(window, before) == [], page
        assert is_fully_visible(window, "question")
        window.window.question.withdraw()
        window.device.notifier.cleared.emit()
        assert moved_controls(window, before) == [], page
        window.device.writer.set_serial_timeout(0.5)
        window.wait(lambda: not window.device.writer.running)
        assert moved_controls(window, before) == [], page
        window.device.writer.set_serial_timeout(0)
        window.wait(lambda: not window.device.writer.running)
        window.device.parameters.edit("serial_timeout", 9)
        assert moved_controls(window, before) == [], page
        if page != "parametersPage":
            window.trigger("discard")

    window.trigger("apply")
    review = window.dialog("reviewDialog")
    QTest.qWait(300)
    before = corners_of(review.root)
    review.find(InlinePrompt, "reviewQuestion").prompt(_LONG)
    assert moved_controls(review, before) == []


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
            for each, (_, corner) in corners_of(window.window).items()
            if area.isAncestorOf(each) and corner.y() >= top
        ]
        assert below == [], page


def test_bar_omits_the_motor_state_that_the_page_shows(connected_window: WindowDriver) -> None:
    window = connected_window
    state, armed = window.find(QLabel, "motorStateLabel"), window.find(QLabel, "armedLabel")
    for page, is_on_page in (("motorsPage", True), ("parametersPage", False), ("boardPage", True)):
        window.open_page(page)
        assert state.isVisible() is not is_on_page, page
    assert not armed.isVisible()
    window.motors.arm()
    assert armed.isVisible()


def test_question_does_not_take_the_focus_from_an_editor(connected_window: WindowDriver) -> None:
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
