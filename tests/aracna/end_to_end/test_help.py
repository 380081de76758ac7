"""F1: the maker's guide of a TReX, and what is known of an Aracna."""

import sys

import pytest
from PySide6.QtCore import QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QDialog, QTextBrowser
from pytestqt.qtbot import QtBot

from tests.aracna.end_to_end.person import DEMO_TREX, Person
from trex_gui.model.device import Link as BoardLink
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    urls: list[str] = []

    def open_url(url: QUrl) -> bool:
        urls.append(url.toString())
        return True

    monkeypatch.setattr(QDesktopServices, "openUrl", open_url)
    return urls


@pytest.fixture
def person(opened: list[str], program: Program, qtbot: QtBot) -> Person:
    return Person(program, qtbot)


def test_on_the_desk_of_a_board_the_makers_guide_opens(person: Person, opened: list[str]) -> None:
    assert person.action("guide").text() == "Online &documentation…"
    assert person.action("guide").shortcut().toString() == "F1"
    person.action("guide").trigger()
    assert opened == ["https://www.pololu.com/docs/0J1"]


def test_on_the_desk_of_the_robot_its_own_help_opens(person: Person, opened: list[str]) -> None:
    person.connect_to_demo()
    assert person.action("guide").text() == "&Help on the Aracna…"
    person.action("guide").trigger()
    dialog = person.find(QDialog, "helpDialog")
    person.wait(dialog.isVisible)
    assert opened == []
    assert dialog.windowTitle() == "Help on the Aracna"
    text = person.find(QTextBrowser, "helpText").toPlainText()
    assert "no stop and no relax" in text
    assert "38400 baud" in text
    for info in ("aracna_move", "aracna_play", "aracna_capture", "find"):
        action = person.action(info)
        assert action.text().replace("&", "").removesuffix("…") in text
        assert action.shortcut().toString() in text
    person.click("helpClose")
    person.wait(lambda: not dialog.isVisible())


def test_help_on_the_robot_goes_with_its_desk(person: Person, opened: list[str]) -> None:
    person.connect_to_demo()
    person.action("guide").trigger()
    dialog = person.find(QDialog, "helpDialog")
    person.wait(dialog.isVisible)
    person.choose_port(DEMO_TREX)
    person.wait(lambda: person.program.device.link is BoardLink.UP)
    assert not dialog.isVisible()
    person.action("guide").trigger()
    assert len(opened) == 1
