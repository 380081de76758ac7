"""Help window: pages, links, history and pictures."""

import pytest
from PySide6.QtCore import QUrl
from PySide6.QtGui import QColor, QDesktopServices, QTextDocument
from PySide6.QtWidgets import QListWidget, QTextBrowser
from pytestqt.qtbot import QtBot

from tests.support.keyboard import check_keyboard
from tests.support.window import WidgetDriver
from trex_gui.core.resource_files import resource
from trex_gui.ui.help.dialog import HelpDialog
from trex_gui.ui.help.pages import pages
from trex_gui.ui.theme.theme import theme


class HelpDriver(WidgetDriver):
    def __init__(self, qtbot: QtBot) -> None:
        self.dialog = HelpDialog()
        qtbot.addWidget(self.dialog)
        super().__init__(self.dialog, qtbot)
        self.text_browser = self.find(QTextBrowser, "helpText")
        self.list = self.find(QListWidget, "helpPages")

    @property
    def shown(self) -> str:
        source = self.text_browser.source()
        return f"{source.fileName()}#{source.fragment()}".removesuffix("#")

    @property
    def top_line(self) -> str:
        """Return the first visible line."""
        cursor = self.text_browser.cursorForPosition(self.text_browser.viewport().rect().topLeft())
        return cursor.block().text()

    @property
    def entries(self) -> list[str]:
        return [self.list.item(row).text() for row in range(self.list.count())]

    def follow(self, target: str) -> None:
        self.text_browser.setSource(QUrl(target))  # like a click on a link


@pytest.fixture
def help_window(qtbot: QtBot, light_scheme: None) -> HelpDriver:
    return HelpDriver(qtbot)


def test_every_page_is_listed_and_shown(help_window: HelpDriver) -> None:
    help_window.dialog.show_topic("README.md")
    assert help_window.entries == [page.title for page in pages()]
    for row, page in enumerate(pages()):
        help_window.list.setCurrentRow(row)
        assert help_window.shown == page.name
        document = help_window.text_browser.document()
        assert document.firstBlock().text() == page.title
        assert document.firstBlock().blockFormat().headingLevel() == 1


def test_links_and_history_lead_through_pages(help_window: HelpDriver) -> None:
    help_window.dialog.show_topic("first_steps.md")
    assert not help_window.is_enabled("helpBack")
    help_window.follow("messages.md#no-reply-to-")
    assert help_window.top_line == "No reply to …"
    assert help_window.list.currentItem().text() == "Messages"
    help_window.follow("#stopping")
    assert help_window.top_line == "Stopping"
    help_window.click("helpBack")
    assert help_window.shown == "messages.md#no-reply-to-"
    help_window.click("helpBack")
    assert help_window.shown == "first_steps.md"
    assert help_window.list.currentItem().text() == "First steps with a board"
    help_window.click("helpForward")
    assert help_window.shown == "messages.md#no-reply-to-"
    help_window.dialog.show_topic("messages.md#stopping")
    assert help_window.top_line == "Stopping"


def test_external_link_opens_on_the_desktop(
    help_window: HelpDriver, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[str] = []

    def open_url(url: QUrl) -> bool:
        opened.append(url.toString())
        return True

    monkeypatch.setattr(QDesktopServices, "openUrl", open_url)
    help_window.dialog.show_topic("library.md")
    help_window.follow("https://example.org/")
    assert opened == ["https://example.org/"]
    assert help_window.shown == "library.md"


def test_example_is_shown_but_not_run(
    help_window: HelpDriver, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda url: pytest.fail(url.toString()))
    help_window.dialog.show_topic("library.md")
    help_window.follow("../examples/drive.py")
    text = (resource("examples") / "drive.py").read_text(encoding="utf-8")
    assert help_window.text_browser.toPlainText().strip() == text.strip()
    help_window.click("helpBack")
    assert help_window.shown == "library.md"


def corner_color(browser: QTextBrowser, name: str) -> QColor:
    """Return the colour near the corner of a picture."""
    url = browser.source().resolved(QUrl(f"pictures/{name}-light.png"))
    image = browser.loadResource(QTextDocument.ResourceType.ImageResource.value, url)
    assert 0 < image.width() <= browser.viewport().width()
    return QColor(image.pixelColor(2, 2))


def test_pictures_and_text_follow_theme_and_font(help_window: HelpDriver) -> None:
    dialog, browser = help_window.dialog, help_window.text_browser
    dialog.show_topic("status.md")
    assert corner_color(browser, "board").lightness() > 200
    theme().set_scheme("dark")
    assert corner_color(browser, "board").lightness() < 60
    assert help_window.shown == "status.md"
    theme().set_scheme("light")
    before = browser.document().size().height()
    theme().set_font_size(150)
    assert browser.document().size().height() > before


def test_every_control_can_be_reached_by_keyboard(help_window: HelpDriver) -> None:
    help_window.dialog.show_topic("safety.md")
    check_keyboard(help_window.dialog)
