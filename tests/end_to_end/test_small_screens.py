"""Every window, page and dialog fits a small screen and can be used with the keyboard alone."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QLocale, QPoint, QRect, QSettings, QSize
from PySide6.QtGui import QAccessible, QScreen
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSlider,
    QApplication,
    QComboBox,
    QDialog,
    QDockWidget,
    QTabWidget,
    QWidget,
)

from tests.support.accessible_names import said_of
from tests.support.catalogs import in_language
from tests.support.keyboard import check_keyboard
from tests.support.pages.every_window import WINDOWS_WITH_STOP, stop_button
from tests.support.program import trex
from tests.support.pseudo_language import cut_texts
from tests.support.window import WindowDriver
from trex_gui.devices.trex.views.line_settings_dialog import LineSettingsDialog
from trex_gui.devices.trex.views.pages.motors.gamepad_dialog import GamepadDialog
from trex_gui.devices.trex.views.pages.motors.gamepad_panel import GamepadPanel
from trex_gui.ui.runtime import runtime
from trex_gui.ui.widgets.scroll_box import ScrollBox

FRAME = QSize(16, 48)


@pytest.fixture(
    params=[
        ("en", 1024, 600),
        # In a still longer language: `test_every_window.py`.
        pytest.param(("de", 1366, 728), marks=pytest.mark.slow),
        pytest.param(("fr", 1366, 728), marks=pytest.mark.slow),
    ],
    ids="{0[0]} {0[1]}×{0[2]}".format,
)
def screen(
    request: pytest.FixtureRequest, qapp: QApplication, monkeypatch: pytest.MonkeyPatch
) -> Iterator[QRect]:
    """The part of the screen that windows may cover, from before the first window is made."""
    language, width, height = request.param
    available = QRect(0, 0, width, height)
    monkeypatch.setattr(QScreen, "availableGeometry", lambda _: available)
    with in_language(qapp, QLocale(language)):
        yield available


def check_window(window: QWidget, screen: QRect, stop: QAbstractButton | None) -> None:
    """Check size, stop button and keyboard of a window as it is shown."""
    check_keyboard(window)
    for _ in range(3):  # a layout may ask for another one
        QCoreApplication.processEvents()
    assert not list(cut_texts(window))
    case = f"{window.objectName()}: {window.frameGeometry()}"
    assert screen.contains(window.frameGeometry()), case
    least, room = window.minimumSizeHint(), screen.size() - FRAME
    assert least == least.boundedTo(room), f"{window.objectName()} needs {least}"
    if stop is not None:
        assert stop.isVisible(), case
        place = QRect(stop.mapTo(window, QPoint()), stop.size())
        assert window.rect().contains(place), case


def check_pages(window: WindowDriver, screen: QRect, stop: str, panel: str) -> None:
    """Check the main window with each page, with the panel of the simulated device and without."""
    dock = window.find(QDockWidget, panel)
    tabs = window.window.pages
    for index in filter(tabs.isTabVisible, range(tabs.count())):
        tabs.setCurrentIndex(index)
        runtime().sleep(0.3)
        assert dock.isVisible()
        check_window(window.window, screen, window.button(stop))
        page = tabs.widget(index)
        assert page is not None
        for box in (page, *page.findChildren(ScrollBox), dock.widget()):
            assert isinstance(box, ScrollBox)
            content = box.widget()
            assert content is not None
            needed = content.minimumSizeHint().width()
            assert box.viewport().width() >= needed, (content.objectName(), needed)
    handled = [
        each
        for each in dock.findChildren(QWidget)
        if isinstance(each, QAbstractButton | QAbstractSlider | QComboBox)
        and each.objectName().startswith(panel.removesuffix("Panel"))
    ]
    assert len({said_of(each, QAccessible.Text.Name) for each in handled}) == len(handled) > 20
    assert all(each.toolTip() for each in handled)


def test_first_start_fits(screen: QRect, request: pytest.FixtureRequest) -> None:
    QSettings().setValue("start/welcomed", False)
    window: WindowDriver = request.getfixturevalue("window")
    assert window.has("welcome")
    window.program.complete()  # each page counts
    check_window(window.window, screen, window.button("stopButton"))


def test_windows_of_trex_fit(screen: QRect, window: WindowDriver, tmp_path: Path) -> None:
    tabs = window.window.pages
    for index in range(tabs.count()):
        tabs.setCurrentIndex(index)
        check_window(window.window, screen, window.button("stopButton"))
    window.connect_to_demo()
    window.device.parameters.edit("serial_timeout", 15)
    check_pages(window, screen, "stopButton", "demoPanel")

    for open_window in WINDOWS_WITH_STOP:
        shown = open_window(window, tmp_path)
        window.wait(shown.isVisible)
        for tabs in shown.findChildren(QTabWidget):
            for index in range(tabs.count()):
                tabs.setCurrentIndex(index)
                check_keyboard(shown)
        check_window(shown, screen, stop_button(shown))
        shown.close()

    window.device.draft.discard_edits()
    for key, name in {
        "learn": "learnDialog",
        "test_sticks": "learnDialog",
        "find": "findDialog",
        "check_board": "checkBoardDialog",
        "preferences": "preferencesDialog",
    }.items():
        window.trigger(key)
        dialog = window.find(QDialog, name)
        window.wait(dialog.isVisible)
        check_window(dialog, screen, None)
        for tabs in dialog.findChildren(QTabWidget):
            tabs.setCurrentIndex(tabs.count() - 1)
            check_window(dialog, screen, None)
        dialog.close()
    check_other_dialogs(window, screen)


def check_other_dialogs(window: WindowDriver, screen: QRect) -> None:
    """Check all that were made by now."""
    GamepadDialog(window.find(GamepadPanel, "gamepadPanel").gamepad, window.window)
    LineSettingsDialog(trex(window.program).controller.settings, window.window)
    window.trigger("new")
    dialogs = window.find_all(QDialog)
    assert len(dialogs) > 8
    for dialog in dialogs:
        dialog.show()
        check_window(dialog, screen, None)
        dialog.close()


def test_windows_of_aracna_fit(screen: QRect, window: WindowDriver) -> None:
    window.program.device_manager.switch_to("aracna", lambda: None)
    window.window.files.recent.note("aracna", "poses", Path("/robot/walk.ppr"))
    window.wait(lambda: window.has("aracna_startRecent"))
    check_window(window.window, screen, window.button("aracnaStopButton"))
    window.connect_to_demo("aracna")
    check_pages(window, screen, "aracnaStopButton", "aracnaDemoPanel")
    window.open_page("aracnaRobotPage")
    window.click("aracnaLimitsBox")
    check_keyboard(window.window)
    window.trigger("help")
    check_window(window.help, screen, None)
