"""A letter with Alt, or a shortcut, does one thing in a menu and in the menu bar."""

from collections import Counter

from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QLabel, QMenu

from tests.support.window import WindowDriver


def repeated(texts: list[str]) -> list[str]:
    keys = Counter(QKeySequence.mnemonic(text).toString() for text in texts)
    return [key for key, count in keys.items() if key and count > 1]


def assert_unique(window: WindowDriver) -> None:
    bar = window.window.menuBar()
    menus = {"menu bar": bar.actions()}
    for menu in bar.findChildren(QMenu):
        menus[menu.title()] = menu.actions()
    found = {
        title: repeated([action.text() for action in actions if action.isVisible()])
        for title, actions in menus.items()
    }
    assert len(menus) > 4
    assert {title: keys for title, keys in found.items() if keys} == {}


def test_mnemonics_are_unique_in_each_menu(window: WindowDriver) -> None:
    assert_unique(window)
    window.connect_to_demo("aracna")
    assert_unique(window)


def test_shortcuts_of_the_main_window_are_unique(window: WindowDriver) -> None:
    window.connect_to_demo()
    keys = Counter(
        action.shortcut().toString()
        for menu in window.window.menuBar().findChildren(QMenu)
        for action in menu.actions()
        if action.isVisible()
    )
    assert len(keys) > 10
    assert [key for key, count in keys.items() if key and count > 1] == []


def test_letter_of_a_character_entity_is_no_mnemonic(window: WindowDriver) -> None:
    window.connect_to_demo()
    labels = [label for label in window.find_all(QLabel) if label.buddy() is not None]
    assert labels
    assert [label.text() for label in labels if "&" in label.text() and ";" in label.text()] == []
