"""Every window fits a small screen and is usable by keyboard alone."""

from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QLocale, QPoint, QRect, QSize
from PySide6.QtGui import QAccessible, QScreen
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSlider,
    QApplication,
    QComboBox,
    QDialog,
    QDockWidget,
    QFileDialog,
    QScrollArea,
    QSlider,
    QTabWidget,
    QWidget,
)

from tests.support.accessible_names import accessible_text
from tests.support.catalogs import in_language
from tests.support.keyboard import check_keyboard
from tests.support.mouse import turn_wheel
from tests.support.pages.every_window import WINDOWS_WITH_STOP, stop_button
from tests.support.pages.motors import Gesture
from tests.support.program import trex
from tests.support.pseudo_language import cut_texts
from tests.support.virtual_devices import VirtualSimulator
from tests.support.window import WindowDriver
from trex_gui.devices.trex.protocol.commands import SetParameter
from trex_gui.devices.trex.views.line_settings_dialog import LineSettingsDialog
from trex_gui.devices.trex.views.pages.motors.gamepad_dialog import GamepadDialog
from trex_gui.devices.trex.views.pages.motors.gamepad_panel import GamepadPanel
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import runtime
from trex_gui.ui.widgets.behaviour import ConfirmButton
from trex_gui.ui.widgets.messages import InlinePrompt
from trex_gui.ui.widgets.scroll_box import ScrollBox

FRAME = QSize(16, 48)


@pytest.fixture(
    params=[
        ("en", 1024, 600),
        # `test_every_window.py` uses a longer language.
        pytest.param(("de", 1366, 728), marks=pytest.mark.slow),
        pytest.param(("fr", 1366, 728), marks=pytest.mark.slow),
    ],
    ids="{0[0]} {0[1]}×{0[2]}".format,
)
def screen(
    request: pytest.FixtureRequest, qapp: QApplication, monkeypatch: pytest.MonkeyPatch
) -> Iterator[QRect]:
    """Available part of the screen, set before the first window is created."""
    language, width, height = request.param
    available = QRect(0, 0, width, height)
    monkeypatch.setattr(QScreen, "availableGeometry", lambda _: available)
    with in_language(qapp, QLocale(language)):
        yield available


def check_window(window: QWidget, screen: QRect, stop: QAbstractButton | None) -> None:
    """Check size, stop button and keyboard of a visible window."""
    check_keyboard(window)
    for _ in range(3):  # a layout may request another layout
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
    """Check the main window with each page, with and without the simulator panel."""
    dock = window.find(QDockWidget, panel)
    for page in window.each_page():
        runtime().sleep(0.3)
        assert dock.isVisible()
        check_window(window.window, screen, window.button(stop))
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
    assert (
        len({accessible_text(each, QAccessible.Text.Name) for each in handled}) == len(handled) > 20
    )
    assert all(each.toolTip() for each in handled)


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
        "check_board": "checkDialog",
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
    """Check all dialogs that exist."""
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
    window.wait_for_files()
    check_window(window.window, screen, window.button("aracnaStopButton"))
    window.connect_to_demo("aracna")
    check_pages(window, screen, "aracnaStopButton", "aracnaDemoPanel")
    window.open_page("aracnaRobotPage")
    window.click("aracnaLimitsBox")
    check_keyboard(window.window)
    window.trigger("help")
    check_window(window.help, screen, None)


LOW = (960, 500)
HIGH = (960, 800)


class PromptingWindow(WindowDriver):
    """Window with a prompt and a stop button.

    Attributes:
        may_store: False blocks the third setting of a write on the board's line.
    """

    def __init__(self, window: WindowDriver, simulator: VirtualSimulator) -> None:
        super().__init__(window.program, window.qtbot)
        self.simulator = simulator
        self.may_store = True
        self.program.complete()  # the sizes of all pages matter

    @property
    def question(self) -> InlinePrompt:
        return self.find(InlinePrompt, "question")

    def is_shown(self) -> bool:
        return self.window.isVisible()

    def has_question(self) -> bool:
        return self.question.isVisible()

    def link(self) -> ConnectionState:
        return self.device.link

    def edit(self) -> None:
        self.device.parameters.edit("serial_timeout", 15)

    def check_that_stop_is_in_sight(self, case: str) -> None:
        """Check that the stop button is visible in a window of height `LOW`."""
        self.window.resize(*LOW)
        assert self.window.minimumSizeHint().height() <= 480, case
        assert self.window.height() == LOW[1], case
        stop = self.button("stopButton")
        place = QRect(stop.mapTo(self.window, QPoint(0, 0)), stop.size())
        assert stop.isVisible(), case
        assert self.window.rect().contains(place), case

    def check_that_stop_works(self) -> None:
        with self.qtbot.waitSignal(self.motors.stop_requested):
            self.click("stopButton")

    def start_writing(self) -> int:
        """Start to write a dozen settings. Writing ends after `may_store` is set."""
        self.may_store = False
        seen: set[bytes] = set()

        def wait_before_the_third(data: bytes) -> None:
            if data[0] == SetParameter(0, 0).opcode:
                seen.add(data)  # a request that is repeated after a late reply counts once
            while len(seen) == 3 and not self.may_store:
                runtime().sleep(0.01)

        self.simulator.on_write = wait_before_the_third
        stored = self.device.parameters.values.all_stored
        for key in [key for key in stored if key.startswith("motor")][:12]:
            self.device.parameters.edit(key, 1 - min(1, stored[key]))
        count = self.device.draft.pending
        self.device.writer.apply()
        assert self.device.writer.running
        return count


@pytest.fixture
def asking(
    connected_window: WindowDriver, quick_simulator: VirtualSimulator
) -> Iterator[PromptingWindow]:
    asking = PromptingWindow(connected_window, quick_simulator)
    yield asking
    asking.may_store = True


# --- Low screens ------------------------------------------------------------------------


def test_stop_button_is_visible_on_low_screen(asking: PromptingWindow) -> None:
    asking.edit()
    for page in asking.each_page():
        asking.window.resize(*HIGH)
        asking.check_that_stop_is_in_sight(page.objectName())

    asking.device.notifier.error.emit(
        "Something went wrong, and it takes a while to say what. " * 6
    )
    asking.trigger("reload")
    asking.check_that_stop_is_in_sight("message and question")


def test_pages_scroll_on_low_screen_and_wheel_moves_no_slider(asking: PromptingWindow) -> None:
    asking.window.resize(*LOW)
    asking.trigger("trex_parameters")
    assert asking.find(QWidget, "parametersView").height() > 100
    area = asking.find(QScrollArea, "parametersPageArea")
    assert area.verticalScrollBar().maximum() == 0

    asking.trigger("trex_motors")
    bar = asking.find(QScrollArea, "motorsPageArea").verticalScrollBar()
    assert bar.maximum() > 0
    asking.window.resize(*HIGH)
    assert bar.maximum() == 0

    asking.window.resize(*LOW)
    asking.click("runButton")
    slider = asking.find(QSlider, "motor1Slider")
    asking.wait(slider.isEnabled)
    slider.setFocus()
    turn = turn_wheel(slider)
    assert slider.value() == 0
    assert not turn.isAccepted() or bar.value() > 0


# --- Reload and close -------------------------------------------------------------------


def test_reload_and_close_with_edits_show_a_prompt(asking: PromptingWindow) -> None:
    asking.edit()
    asking.trigger("reload")
    assert "discard the edits" in asking.question.text
    assert not asking.question.isWindow()
    asking.check_that_stop_works()
    asking.click("questionCancel")
    assert not asking.has_question()
    assert asking.device.draft.pending == 1
    asking.trigger("reload")
    asking.click("reloadYes")
    assert asking.device.draft.pending == 0

    asking.edit()
    asking.trigger("reload")
    asking.trigger("discard")
    assert not asking.has_question(), "it goes with the edits"

    asking.edit()
    assert not asking.window.close()
    assert "unapplied changes" in asking.question.text
    asking.check_that_stop_works()
    asking.click("questionCancel")
    assert asking.is_shown()
    assert asking.link() is ConnectionState.CONNECTED
    assert not asking.window.close()
    asking.click("closeYes")
    assert not asking.is_shown()


def test_closing_with_edits_offers_to_save_them(
    asking: PromptingWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asking.edit()
    path = tmp_path / "kept.txt"
    for chosen in ("", str(tmp_path / "no such folder" / "kept.txt"), str(path)):
        asking.window.close()
        assert asking.is_shown(), chosen
        monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_, name=chosen: (name, ""))
        asking.click("saveAndClose")
        asking.wait_for_files()
        assert asking.is_shown() == (chosen != str(path)), chosen
    assert "1.5 s" in path.read_text(encoding="utf-8")


# --- While settings are being written ---------------------------------------------------


def disconnect_in_find_dialog(asking: PromptingWindow) -> None:
    asking.trigger("find")
    asking.dialog("findDialog").click("findDisconnectButton")


def test_disconnecting_during_write_asks_for_confirmation(asking: PromptingWindow) -> None:
    count = asking.start_writing()
    ways: list[Gesture] = [
        lambda: asking.click("connectButton"),
        lambda: asking.trigger("disconnect"),
        lambda: asking.connect_port(asking.program.ports.demo_of("aracna")),
        partial(disconnect_in_find_dialog, asking),
    ]
    for disconnect in ways:
        assert not asking.has_question()
        disconnect()
        assert asking.has_question()
        assert "Settings are still being written. Disconnect anyway?" in asking.question.text
        assert asking.link() is ConnectionState.CONNECTED
        asking.click("questionCancel")
    asking.trigger("disconnect")
    asking.click("disconnectYes")
    asking.may_store = True
    asking.wait(lambda: asking.link() is ConnectionState.DISCONNECTED)
    assert 0 < asking.device.draft.pending <= count


def test_writing_continues_while_prompt_is_open(asking: PromptingWindow) -> None:
    asking.start_writing()
    asking.click("connectButton")
    asking.click("questionCancel")
    asking.may_store = True
    asking.wait(lambda: not asking.device.writer.running)
    assert asking.device.draft.pending == 0
    assert asking.link() is ConnectionState.CONNECTED

    asking.start_writing()
    asking.click("connectButton")
    asking.may_store = True
    asking.wait(lambda: not asking.device.writer.running)
    asking.wait(lambda: not asking.has_question())
    assert asking.link() is ConnectionState.CONNECTED

    asking.start_writing()
    assert not asking.window.close()
    assert "Settings are still being written. Close anyway?" in asking.question.text
    assert asking.is_shown()
    asking.wait(lambda: asking.find(ConfirmButton, "closeYes").accepts_clicks)
    asking.may_store = True  # closing waits for the current write
    asking.click("closeYes")
    assert not asking.is_shown()
