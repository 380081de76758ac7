"""A reopened dialog has the same default button and focus as a new dialog."""

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QDialog, QLineEdit, QPushButton, QSpinBox

from tests.support.program import trex
from tests.support.window import WindowDriver
from trex_gui.devices.trex.views.pages.motors.gamepad_panel import GamepadPanel
from trex_gui.ui.widgets.behaviour import ReusedDialog


def openers(window: WindowDriver) -> dict[str, Callable[[], object]]:
    """Return the functions that open the reused dialogs, by dialog name."""
    return {
        "benchDialog": lambda: window.trigger("bench"),
        "findDialog": lambda: window.click("findButton"),
        "gamepadDialog": window.find_only(GamepadPanel)._on_set_up_clicked,
        "helpDialog": lambda: window.window.show_help("safety.md"),
        "historyDialog": lambda: window.trigger("history"),
        "learnDialog": lambda: window.trigger("learn"),
        "powerCycleDialog": trex(window.program).workspace._settings.show_power_cycle,
        "reviewDialog": lambda: window.trigger("apply"),
    }


def enter_and_focus(dialog: QDialog) -> tuple[list[str], str]:
    """Return the names of the default buttons and of the focused widget."""
    defaults = [each.objectName() for each in dialog.findChildren(QPushButton) if each.isDefault()]
    focused = dialog.focusWidget()
    return defaults, focused.objectName() if focused is not None else ""


def test_reopened_dialog_has_the_same_default_and_focus(connected_window: WindowDriver) -> None:
    window = connected_window
    window.open_page("motorsPage")
    window.device.parameters.edit("serial_timeout", 9)
    functions = openers(window)
    for name, open_dialog in functions.items():
        open_dialog()
        dialog = window.help if name == "helpDialog" else window.find(QDialog, name)
        assert isinstance(dialog, ReusedDialog), name
        window.wait(dialog.isVisible)
        dialog.activateWindow()
        QTest.qWait(0)
        first = enter_and_focus(dialog)
        buttons = [each for each in dialog.findChildren(QPushButton) if each.isVisible()]
        for button in (buttons[0], buttons[-1]):
            button.setFocus()
            dialog.close()
            assert not dialog.isVisible(), name
            open_dialog()
            window.wait(dialog.isVisible)
            QTest.qWait(0)
            assert enter_and_focus(dialog) == first, (name, button.objectName())
        dialog.close()
    dialogs = {each.objectName() for each in window.find_all(QDialog)}
    assert dialogs == functions.keys() - {"helpDialog"}


def test_line_settings_apply_once_they_are_accepted(window: WindowDriver) -> None:
    controller = trex(window.program).controller
    for accepted in (False, True):
        window.trigger("line")
        window.trigger("line")  # brings the dialog to the front
        (root,) = (
            each for each in window.find_all(QDialog) if each.objectName() == "lineSettingsDialog"
        )
        dialog = window.dialog("lineSettingsDialog")
        assert not root.isModal()
        dialog.click("addressedBox")
        QTest.keyClick(root, Qt.Key.Key_Return if accepted else Qt.Key.Key_Escape)
        window.wait(lambda: not window.has("lineSettingsDialog"))
        assert controller.settings.device_number == (7 if accepted else None)


def test_other_devices_on_the_line_require_an_address(window: WindowDriver) -> None:
    controller = trex(window.program).controller
    window.trigger("line")
    dialog = window.dialog("lineSettingsDialog")
    field = dialog.find(QLineEdit, "reservedField")
    QTest.keyClicks(field, "0, 300x")
    assert field.text() == "0, 30"
    assert dialog.find(QCheckBox, "addressedBox").isChecked()
    assert not dialog.is_enabled("addressedBox")
    dialog.find(QSpinBox, "deviceNumberField").setValue(30)
    QTest.keyClick(dialog.root, Qt.Key.Key_Return)
    clash = "The board needs a device number that no other device on the line has."
    assert dialog.text("lineClash") == clash
    assert not controller.settings.reserved
    dialog.find(QSpinBox, "deviceNumberField").setValue(7)
    QTest.keyClick(dialog.root, Qt.Key.Key_Return)
    window.wait(lambda: not window.has("lineSettingsDialog"))
    assert controller.settings.reserved == {0, 30}
    assert controller.settings.device_number == 7


def test_open_line_dialog_shows_newly_stored_values(window: WindowDriver) -> None:
    controller = trex(window.program).controller
    window.trigger("line")
    changed = replace(controller.settings, device_number=9, polynomial=0x85)
    controller.set_settings(changed)
    QTest.keyClick(window.dialog("lineSettingsDialog").root, Qt.Key.Key_Return)
    window.wait(lambda: not window.has("lineSettingsDialog"))
    assert controller.settings == changed
