"""A question across a window, answered whenever its reader likes."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton
from pytestqt.qtbot import QtBot

from trex_gui.views.widgets.question import Answer, Question


@pytest.fixture
def question(qtbot: QtBot) -> Question:
    question = Question()
    qtbot.addWidget(question)
    return question


def press(question: Question, name: str) -> None:
    button = question.findChild(QPushButton, name)
    assert button is not None
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)


def test_an_answer_does_what_it_says_and_the_question_goes(question: Question) -> None:
    done: list[str] = []
    question.ask(
        "How?",
        Answer("one", "One", lambda: done.append("one")),
        Answer("two", "Two", lambda: done.append("two")),
    )
    press(question, "two")
    assert done == ["two"]
    assert not question.isVisible()


@pytest.mark.parametrize("key", [None, Qt.Key.Key_Escape, Qt.Key.Key_Space])
def test_cancel_and_esc_do_nothing_of_it(question: Question, key: Qt.Key | None) -> None:
    done: list[str] = []
    question.ask(
        "Sure?",
        Answer("yes", "Yes", lambda: done.append("yes")),
        otherwise=lambda: done.append("otherwise"),
    )
    cancel = question.findChild(QPushButton, "questionCancel")
    assert cancel is not None
    if key is None:
        press(question, "questionCancel")
    else:
        QTest.keyClick(cancel, key)
    assert done == ["otherwise"]
    assert not question.isVisible()


def test_another_question_takes_the_place_of_the_first(question: Question) -> None:
    done: list[str] = []
    question.ask(
        "A?", Answer("a", "A", lambda: done.append("a")), otherwise=lambda: done.append("no")
    )
    question.ask("B?", Answer("b", "B", lambda: done.append("b")))
    assert question.text == "B?"
    assert done == ["no"]
    assert question.findChild(QPushButton, "a") is None
    press(question, "b")
    assert done == ["no", "b"]


def test_an_answer_may_ask_again(question: Question) -> None:
    again = Answer("again", "Again", lambda: question.ask("Again?"))
    question.ask("First?", again)
    press(question, "again")
    assert question.text == "Again?"
    assert question.isVisible()


def test_what_makes_no_sense_any_more_is_not_done(question: Question) -> None:
    done: list[str] = []
    sense = [True]
    yes = Answer("yes", "Yes", lambda: done.append("yes"))
    question.ask("Sure?", yes, still=lambda: sense[0])
    question.reconsider()
    assert question.isVisible()
    sense[0] = False
    press(question, "yes")
    assert done == []
    assert not question.isVisible()
