"""Enter presses the button that has the focus, in every window."""

from collections.abc import Iterator

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QDialog, QWidget

from tests.end_to_end.test_reopened_dialogs import openers
from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver

ENTER = Qt.Key.Key_Return


def deaf_to_enter(root: QWidget) -> Iterator[str]:
    """Yield the usable buttons below a widget that Enter does not press."""
    root.window().activateWindow()
    for button in root.findChildren(QAbstractButton):
        if button.window() is not root.window() or not button.isVisible():
            continue
        with QSignalBlocker(button):
            button.setFocus()
            if button.hasFocus():
                QTest.keyPress(button, ENTER)
                if not button.isDown():
                    yield f"{root.objectName()}: {button.objectName()}"
                button.setDown(False)
                QTest.keyRelease(button, ENTER)


def test_enter_presses_every_button_with_the_focus(connected_window: WindowDriver) -> None:
    window = connected_window
    window.open_page("motorsPage")
    window.device.parameters.edit("serial_timeout", 9)
    found: list[str] = []
    for index in range(window.window.pages.count()):
        window.window.pages.setCurrentIndex(index)
        found += deaf_to_enter(window.window)
    for name, open_dialog in openers(window).items():
        open_dialog()
        dialog = window.help if name == "helpDialog" else window.find(QDialog, name)
        window.wait(dialog.isVisible)
        found += deaf_to_enter(dialog)
        dialog.close()
    assert found == []


def test_enter_on_stop_in_review_stops_and_writes_nothing(
    connected_window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    window = connected_window
    window.click("runButton")
    window.wait(lambda: window.motors.armed)
    window.motors.set_speed(1, 25)
    window.wait(lambda: quick_simulator.show()["motors"][0]["speed"] == 25)
    window.device.parameters.edit("serial_timeout", 9)
    window.trigger("apply")
    review = window.dialog("reviewDialog")
    assert review.root.focusWidget() is review.button("writeButton")
    stop = review.button("reviewStopButton")
    review.root.activateWindow()
    QTest.qWait(0)
    stop.setFocus()
    QTest.keyClick(review.root.windowHandle(), ENTER)
    window.wait(lambda: quick_simulator.show()["motors"][0]["direction"] == "brake")
    assert window.device.draft.pending == 1


def test_enter_on_found_board_connects(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    window.program.ports.add_typed(quick_simulator.url)
    window.trigger("find")
    dialog = window.dialog("findDialog")
    dialog.root.activateWindow()
    QTest.keyClick(dialog.root.windowHandle(), ENTER)  # on Start
    window.wait(lambda: dialog.has("connectFound0"))
    window.wait(lambda: dialog.root.focusWidget() is dialog.button("connectFound0"))
    QTest.keyClick(dialog.root.windowHandle(), ENTER)
    window.wait(lambda: window.device.is_connected)


def test_board_reset_needs_a_press_of_its_own(connected_window: WindowDriver) -> None:
    connected_window.trigger("defaults")
    dialog = connected_window.dialog("defaultsDialog")
    dialog.root.activateWindow()
    dialog.button("boardResetButton").setFocus()
    for _ in range(2):
        QTest.keyClick(dialog.root.windowHandle(), ENTER)
    assert not dialog.root.isVisible()
    assert not connected_window.device.applying
    assert not connected_window.device.draft.reset_pending


def test_buttons_of_a_message_take_enter(window: WindowDriver) -> None:
    window.device.notifier.error.emit("Something went wrong.")
    dismiss = window.button("bannerDismiss")
    window.window.activateWindow()
    dismiss.setFocus()
    QTest.keyClick(window.window.windowHandle(), ENTER)
    assert not window.has("banner")
