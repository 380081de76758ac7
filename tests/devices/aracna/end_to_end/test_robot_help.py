"""F1: the maker's guide of a TReX, and help on an Aracna."""

import pytest
from PySide6.QtCore import QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QDialog, QTextBrowser

from tests.support.pages.robot import RobotWindow

GUIDE = "https://www.pololu.com/docs/0J1"


def test_help_matches_connected_device(
    window: RobotWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[str] = []

    def open_url(url: QUrl) -> bool:
        opened.append(url.toString())
        return True

    monkeypatch.setattr(QDesktopServices, "openUrl", open_url)
    assert window.action("guide").text() == "Online &documentation…"
    assert window.action("guide").shortcut().toString() == "F1"
    window.trigger("guide")
    assert opened == [GUIDE]

    window.choose_demo()
    assert window.action("guide").text() == "&Help on the Aracna…"
    window.trigger("guide")
    dialog = window.find(QDialog, "helpDialog")
    window.wait(dialog.isVisible)
    assert opened == [GUIDE]
    assert dialog.windowTitle() == "Help on the Aracna"
    text = window.find(QTextBrowser, "helpText").toPlainText()
    assert "no stop and no relax" in text
    assert "38400 baud" in text
    for key in ("aracna_move", "aracna_play", "aracna_capture", "find"):
        action = window.action(key)
        assert action.text().replace("&", "").removesuffix("…") in text
        assert action.shortcut().toString() in text
    window.click("helpClose")
    window.wait(lambda: not dialog.isVisible())

    window.trigger("guide")
    window.wait(dialog.isVisible)
    window.choose_demo("trex")
    assert not dialog.isVisible(), "it closes with the workspace of the robot"
    window.trigger("guide")
    assert opened == [GUIDE, GUIDE]
