"""Every window fits a small screen and works without a mouse."""

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
        # `test_every_window.py` tries longer texts, in the pseudo-language.
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
    min_size, available = window.minimumSizeHint(), screen.size() - FRAME
    assert min_size == min_size.boundedTo(available), f"{window.objectName()} needs {min_size}"
    if stop is not None:
        assert stop.isVisible(), case
        place = QRect(stop.mapTo(window, QPoint()), stop.size())
        assert window.rect().contains(place), case


def check_pages(window: WindowDriver, screen: QRect, stop: str, panel: str) -> None:
    """Check the main window at each page, beside the simulator panel."""
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
    controls = [
        each
        for each in dock.findChildren(QWidget)
        if isinstance(each, QAbstractButton | QAbstractSlider | QComboBox)
        and each.objectName().startswith(panel.removesuffix("Panel"))
    ]
    assert (
        len({accessible_text(each, QAccessible.Text.Name) for each in controls})
        == len(controls)
        > 20
    )
    assert all(each.toolTip() for each in controls)


def test_trex_windows_fit_the_screen(screen: QRect, window: WindowDriver, tmp_path: Path) -> None:
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
    """Check all created dialogs."""
    GamepadDialog(window.find(GamepadPanel, "gamepadPanel").gamepad, window.window)
    LineSettingsDialog(trex(window.program).controller.settings, window.window)
    window.trigger("new")
    dialogs = window.find_all(QDialog)
    assert len(dialogs) > 8
    for dialog in dialogs:
        dialog.show()
        check_window(dialog, screen, None)
        dialog.close()


def test_aracna_windows_fit_the_screen(screen: QRect, window: WindowDriver) -> None:
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
    """Window that prompts the user before an action.

    Attributes:
        may_store: whether writing may continue with the third setting.
    """

    def __init__(self, window: WindowDriver, simulator: VirtualSimulator) -> None:
        super().__init__(window.program, window.qtbot)
        self.simulator = simulator
        self.may_store = True
        self.program.complete()  # the sizes of all pages matter

    @property
    def question(self) -> InlinePrompt:
        return self.find(InlinePrompt, "question")

    def edit(self) -> None:
        self.device.parameters.edit("serial_timeout", 15)

    def check_that_stop_is_visible(self, case: str) -> None:
        """Check that the stop button is visible in a window of size `LOW`."""
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
        """Start writing a dozen settings. Writing continues when `may_store` is set."""
        self.may_store = False
        requests: set[bytes] = set()

        def wait_before_third_setting(data: bytes) -> None:
            if data[0] == SetParameter(0, 0).opcode:
                requests.add(data)  # counts a retry once
            while len(requests) == 3 and not self.may_store:
                runtime().sleep(0.01)

        self.simulator.on_write = wait_before_third_setting
        stored = self.device.parameters.values.all_stored
        for key in [key for key in stored if key.startswith("motor")][:12]:
            self.device.parameters.edit(key, 1 - min(1, stored[key]))
        count = self.device.draft.pending
        self.device.writer.apply()
        assert self.device.writer.running
        return count


@pytest.fixture
def prompting(
    connected_window: WindowDriver, quick_simulator: VirtualSimulator
) -> Iterator[PromptingWindow]:
    prompting = PromptingWindow(connected_window, quick_simulator)
    yield prompting
    prompting.may_store = True


# --- Low screens ------------------------------------------------------------------------


def test_stop_button_is_visible_on_low_screen(prompting: PromptingWindow) -> None:
    prompting.edit()
    for page in prompting.each_page():
        prompting.window.resize(*HIGH)
        prompting.check_that_stop_is_visible(page.objectName())

    prompting.device.notifier.error.emit(
        "Something went wrong, and it takes a while to say what. " * 6
    )
    prompting.trigger("reload")
    prompting.check_that_stop_is_visible("message and question")


def test_pages_scroll_on_low_screen_and_wheel_moves_no_slider(prompting: PromptingWindow) -> None:
    prompting.window.resize(*LOW)
    prompting.trigger("trex_parameters")
    assert prompting.find(QWidget, "parametersView").height() > 100
    area = prompting.find(QScrollArea, "parametersPageArea")
    assert area.verticalScrollBar().maximum() == 0

    prompting.trigger("trex_motors")
    bar = prompting.find(QScrollArea, "motorsPageArea").verticalScrollBar()
    assert bar.maximum() > 0
    prompting.window.resize(*HIGH)
    assert bar.maximum() == 0

    prompting.window.resize(*LOW)
    prompting.click("runButton")
    slider = prompting.find(QSlider, "motor1Slider")
    prompting.wait(slider.isEnabled)
    slider.setFocus()
    turn = turn_wheel(slider)
    assert slider.value() == 0
    assert not turn.isAccepted() or bar.value() > 0


# --- Reload and close -------------------------------------------------------------------


def test_reload_with_edits_shows_a_prompt(prompting: PromptingWindow) -> None:
    prompting.edit()
    prompting.trigger("reload")
    assert "discard the edits" in prompting.question.text
    assert not prompting.question.isWindow()
    prompting.check_that_stop_works()
    prompting.click("questionCancel")
    assert not prompting.question.isVisible()
    assert prompting.device.draft.pending == 1
    prompting.trigger("reload")
    prompting.click("reloadYes")
    assert prompting.device.draft.pending == 0

    prompting.edit()
    prompting.trigger("reload")
    prompting.trigger("discard")
    assert not prompting.question.isVisible(), "the prompt disappears with the edits"


def test_closing_with_edits_offers_to_save_them(
    prompting: PromptingWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    prompting.edit()
    path = tmp_path / "saved.txt"
    for name in ("", str(tmp_path / "no such folder" / "saved.txt"), str(path)):
        prompting.window.close()
        assert prompting.window.isVisible(), name
        monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_, chosen=name: (chosen, ""))
        prompting.click("saveAndClose")
        prompting.wait_for_files()
        assert prompting.window.isVisible() == (name != str(path)), name
    assert "1.5 s" in path.read_text(encoding="utf-8")


# --- While settings are being written ---------------------------------------------------


def disconnect_in_find_dialog(prompting: PromptingWindow) -> None:
    prompting.trigger("find")
    prompting.dialog("findDialog").click("findDisconnectButton")


def test_disconnecting_during_write_asks_for_confirmation(prompting: PromptingWindow) -> None:
    count = prompting.start_writing()
    gestures: list[Gesture] = [
        lambda: prompting.click("connectButton"),
        lambda: prompting.trigger("disconnect"),
        lambda: prompting.connect_port(prompting.program.ports.demo_of("aracna")),
        partial(disconnect_in_find_dialog, prompting),
    ]
    for disconnect in gestures:
        assert not prompting.question.isVisible()
        disconnect()
        assert prompting.question.isVisible()
        assert "Settings are still being written. Disconnect anyway?" in prompting.question.text
        assert prompting.device.link is ConnectionState.CONNECTED
        prompting.click("questionCancel")
    prompting.trigger("disconnect")
    prompting.click("disconnectYes")
    prompting.may_store = True
    prompting.wait(lambda: prompting.device.link is ConnectionState.DISCONNECTED)
    assert 0 < prompting.device.draft.pending <= count


def test_writing_continues_while_prompt_is_open(prompting: PromptingWindow) -> None:
    prompting.start_writing()
    prompting.click("connectButton")
    prompting.click("questionCancel")
    prompting.may_store = True
    prompting.wait(lambda: not prompting.device.writer.running)
    assert prompting.device.draft.pending == 0
    assert prompting.device.link is ConnectionState.CONNECTED

    prompting.start_writing()
    prompting.click("connectButton")
    prompting.may_store = True
    prompting.wait(lambda: not prompting.device.writer.running)
    prompting.wait(lambda: not prompting.question.isVisible())
    assert prompting.device.link is ConnectionState.CONNECTED

    prompting.start_writing()
    assert not prompting.window.close()
    assert "Settings are still being written. Close anyway?" in prompting.question.text
    assert prompting.window.isVisible()
    prompting.wait(lambda: prompting.find(ConfirmButton, "closeYes").accepts_clicks)
    prompting.may_store = True  # closing waits for the current write
    prompting.click("closeYes")
    assert not prompting.window.isVisible()
