"""F1 opens the help on the page or dialog in front. Messages link to their help."""

import re
from pathlib import Path

import pytest
from PySide6.QtCore import Qt, QUrl
from PySide6.QtGui import QDesktopServices, QTextCursor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog, QMenu, QPlainTextEdit, QTextBrowser, QWidget

import trex_gui
from tests.support.pages.every_window import WINDOWS_WITH_STOP
from tests.support.window import WindowDriver
from trex_gui.devices.aracna.session.errors import ErrorCode as RobotErrorCode
from trex_gui.devices.aracna.views import help as aracna
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexError
from trex_gui.devices.trex.views import help as trex
from trex_gui.ui.frame.main_window import HELP_TOPICS
from trex_gui.ui.help.pages import pages
from trex_gui.ui.translations import error_sentence


def shown_topic(window: WindowDriver) -> str:
    source = window.help.findChildren(QTextBrowser)[0].source()
    return f"{source.fileName()}#{source.fragment()}".removesuffix("#")


def press_f1(window: WindowDriver, widget: QWidget) -> str:
    """Press F1 in a window and close the help again. Return the topic of the help."""
    widget.activateWindow()
    window.wait(widget.window().isActiveWindow)
    QTest.keyClick(widget.window().windowHandle(), Qt.Key.Key_F1)
    dialog = window.help
    window.wait(dialog.isVisible)
    topic = shown_topic(window)
    dialog.close()
    return topic


def test_each_help_topic_exists() -> None:
    anchors = {section.topic for page in pages() for section in page.sections}
    names = {page.name for page in pages()}
    for topic in (*trex.TOPICS.values(), *aracna.TOPICS.values(), *HELP_TOPICS.values()):
        assert topic in names | anchors, topic


def test_f1_opens_help_on_each_page(window: WindowDriver) -> None:
    assert window.action("help").shortcut().toString() == "F1"
    for key, topics in (("trex", trex.TOPICS), ("aracna", aracna.TOPICS)):
        window.program.device_manager.switch_to(key, lambda: None)
        window.program.workspaces[key].create_pages()
        for page in window.each_page():
            name = page.objectName().removesuffix("Area")
            assert press_f1(window, window.window) == topics[name], name


def test_f1_opens_help_on_the_window_in_front(
    connected_window: WindowDriver, tmp_path: Path
) -> None:
    window = connected_window
    for open_window in WINDOWS_WITH_STOP:
        opened = open_window(window, tmp_path)
        window.wait(opened.isVisible)
        assert press_f1(window, opened) == trex.TOPICS[opened.objectName()], opened.objectName()
        opened.close()
    for key, name in (("preferences", "preferencesDialog"), ("report", "reportDialog")):
        window.trigger(key)
        dialog = window.find(QDialog, name)
        window.wait(dialog.isVisible)
        assert press_f1(window, dialog) == HELP_TOPICS[name]
        dialog.close()
    window.trigger("check_board")
    assert press_f1(window, window.find(QDialog, "checkDialog")) == "lost_settings.md"


def test_every_dialog_has_a_help_topic() -> None:
    sources = [
        path.read_text(encoding="utf-8") for path in Path(trex_gui.__file__).parent.rglob("*.py")
    ]
    named = re.compile(r'\.setObjectName\("(\w+(?:Dialog|Window|sEditor))"\)')
    names = {name for source in sources for name in named.findall(source)}
    assert {"mainWindow", "newSettingsDialog", "settingsEditor"} < names
    assert names - {"mainWindow"} <= trex.TOPICS.keys() | HELP_TOPICS.keys()


def test_message_with_a_code_offers_its_help(connected_window: WindowDriver) -> None:
    window = connected_window
    window.device.notifier.error.emit("The file was not saved.")
    assert window.has("banner")
    assert not window.has("bannerHelp")
    window.device.notifier.error.emit(error_sentence(TrexError(ErrorCode.STOP_UNCONFIRMED)))
    window.click("bannerHelp")
    dialog = window.help
    window.wait(dialog.isVisible)
    section = "the-stop-was-sent-but-the-board-does-not-confirm-it"
    assert shown_topic(window) == f"messages.md#{section}"


@pytest.mark.parametrize(
    ("key", "code", "topic"),
    [
        (
            "trex",
            ErrorCode.OVERTAKEN_BY_STOP,
            "messages.md#nothing-was-sent-because-a-stop-was-requested-first",
        ),
        ("aracna", RobotErrorCode.STUCK, "messages.md#the-robot-is-stuck"),
    ],
)
def test_logged_message_with_a_code_offers_its_help(
    window: WindowDriver, key: str, code: ErrorCode | RobotErrorCode, topic: str
) -> None:
    window.program.device_manager.switch_to(key, lambda: None)
    log = window.program.workspaces[key].log
    window.program.workspaces[key].show_page("log")
    text = window.find(QPlainTextEdit, f"{key}Log")
    window.wait(text.isVisible)
    assert not window.is_enabled(f"{key}LogHelp")
    log.add("Saved.")
    log.add(str(code.value), is_problem=True)
    text.moveCursor(QTextCursor.MoveOperation.End)
    window.click(f"{key}LogHelp")
    assert shown_topic(window) == topic
    text.moveCursor(QTextCursor.MoveOperation.Up)
    assert not window.is_enabled(f"{key}LogHelp")


def test_help_opens_without_a_board(window: WindowDriver) -> None:
    window.find(QWidget, "startFind").setFocus()
    assert press_f1(window, window.window) == "first_steps.md"
    window.trigger("line")
    dialog = window.find(QDialog, "lineSettingsDialog")
    assert press_f1(window, dialog) == trex.TOPICS["lineSettingsDialog"]


def test_guide_opens_only_for_a_trex(window: WindowDriver, monkeypatch: pytest.MonkeyPatch) -> None:
    opened: list[str] = []

    def open_url(url: QUrl) -> bool:
        opened.append(url.toString())
        return True

    monkeypatch.setattr(QDesktopServices, "openUrl", open_url)
    window.trigger("guide")
    assert opened == [trex.GUIDE]
    window.program.device_manager.switch_to("aracna", lambda: None)
    assert not window.action("guide").isVisible()


def test_help_window_closes_with_the_main_window(window: WindowDriver) -> None:
    window.trigger("help")
    window.wait(window.help.isVisible)
    # Windows keeps a child window in front of its parent
    assert window.help.windowHandle().transientParent() is None
    window.window.close()
    assert not window.help.isVisible()


def test_keys_page_lists_every_shortcut(window: WindowDriver) -> None:
    window.program.workspaces  # noqa: B018 - creates the menus of both devices
    (page,) = (page for page in pages() if page.name == "window.md")
    count = 0
    for menu in window.window.menuBar().findChildren(QMenu):
        for action in menu.actions():
            keys = action.shortcut().toString()
            if keys:
                count += 1
                title = action.text().replace("&", "").removesuffix("…")
                assert keys in page.text, keys
                assert title in page.text, title
    assert count > 30
