"""Texts can be read in every theme, on every page and in every dialog, disabled ones, too."""

from pathlib import Path

import pytest
from PySide6.QtWidgets import QDialog, QTabWidget, QWidget

from tests.support.colours import weak_texts
from tests.support.matrix import sampled
from tests.support.pages.every_window import WINDOWS_WITH_STOP
from tests.support.program import trex
from tests.support.window import WindowDriver
from trex_gui.devices.trex.views.line_settings_dialog import LineSettingsDialog
from trex_gui.devices.trex.views.pages.motors.gamepad_dialog import GamepadDialog
from trex_gui.devices.trex.views.pages.motors.gamepad_panel import GamepadPanel
from trex_gui.ui.theme.theme import Scheme, theme

each_scheme = pytest.mark.parametrize(
    "scheme", sampled(("dark", "light", "high_contrast"), every=3)
)
"""One finds colours that do not follow the scheme; `tests/ui/theme` measures those of each."""


def check(driver: WindowDriver, window: QWidget, case: str = "") -> None:
    wanted = theme().color("window_text")
    driver.wait(lambda: window.palette().windowText().color() == wanted)
    driver.wait_for_files()  # and until the window has settled
    assert weak_texts(window) == {}, f"{window.objectName()} {case}"


def check_pages(window: WindowDriver) -> None:
    tabs = window.window.pages
    for index in filter(tabs.isTabVisible, range(tabs.count())):
        tabs.setCurrentIndex(index)
        check(window, window.window, tabs.tabText(index))


@each_scheme
def test_texts_of_trex_have_enough_contrast(
    scheme: Scheme, window: WindowDriver, tmp_path: Path
) -> None:
    theme().set_scheme(scheme)
    check_pages(window)
    window.connect_to_demo()
    window.device.parameters.edit("serial_timeout", 15)
    check_pages(window)
    for open_window in WINDOWS_WITH_STOP:
        shown = open_window(window, tmp_path)
        window.wait(shown.isVisible)
        check(window, shown)
        for tabs in shown.findChildren(QTabWidget):
            for index in range(tabs.count()):
                tabs.setCurrentIndex(index)
                check(window, shown, tabs.tabText(index))
        shown.close()
    window.device.draft.discard_edits()
    GamepadDialog(window.find(GamepadPanel, "gamepadPanel").gamepad, window.window)
    LineSettingsDialog(trex(window.program).controller.settings, window.window)
    for key in ("learn", "find", "check_board", "preferences", "new"):
        window.trigger(key)
    dialogs = window.find_all(QDialog)
    assert len(dialogs) > 10
    for dialog in dialogs:
        dialog.show()
        check(window, dialog)
        dialog.close()


@each_scheme
def test_texts_of_aracna_have_enough_contrast(scheme: Scheme, window: WindowDriver) -> None:
    theme().set_scheme(scheme)
    window.program.device_manager.switch_to("aracna", lambda: None)
    check_pages(window)
    window.connect_to_demo("aracna")
    check_pages(window)
