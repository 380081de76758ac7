"""Question across a window."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QPushButton
from pytestqt.qtbot import QtBot

from tests.support.window import LEFT, WidgetDriver
from trex_gui.ui.notifier import Answer
from trex_gui.ui.runtime import runtime
from trex_gui.ui.widgets.messages import InlinePrompt


@pytest.fixture
def question(qtbot: QtBot) -> InlinePrompt:
    question = InlinePrompt()
    qtbot.addWidget(question)
    return question


@pytest.fixture
def driver(question: InlinePrompt, qtbot: QtBot) -> WidgetDriver:
    return WidgetDriver(question, qtbot)


def test_answer_runs_its_action_and_may_ask_another_question(
    question: InlinePrompt, driver: WidgetDriver
) -> None:
    done: list[str] = []
    again = Answer("again", "Again", lambda: question.prompt("Again?", other))
    other = Answer("other", "Other", lambda: done.append("other"))
    question.prompt("How?", Answer("one", "One", lambda: done.append("one")), again)
    driver.click("again")
    assert question.text == "Again?"
    assert question.isVisible()
    driver.click("other")
    assert done == ["other"]
    assert not question.isVisible()


@pytest.mark.parametrize("key", [None, Qt.Key.Key_Escape, Qt.Key.Key_Space])
def test_cancel_runs_only_the_otherwise_action(
    question: InlinePrompt, driver: WidgetDriver, key: Qt.Key | None
) -> None:
    done: list[str] = []
    question.prompt(
        "Sure?",
        Answer("yes", "Yes", lambda: done.append("yes")),
        otherwise=lambda: done.append("otherwise"),
    )
    if key is None:
        driver.click("questionCancel")
    else:
        QTest.keyClick(driver.button("questionCancel"), key)
    assert done == ["otherwise"]
    assert not question.isVisible()


def test_new_question_cancels_the_previous_one(
    question: InlinePrompt, driver: WidgetDriver
) -> None:
    done: list[str] = []
    question.prompt(
        "A?", Answer("a", "A", lambda: done.append("a")), otherwise=lambda: done.append("no")
    )
    question.prompt("B?", Answer("b", "B", lambda: done.append("b")))
    assert question.text == "B?"
    assert done == ["no"]
    assert "a" not in [button.objectName() for button in driver.find_all(QPushButton)]
    driver.click("b")
    assert done == ["no", "b"]


def test_outdated_answer_is_not_run(question: InlinePrompt, driver: WidgetDriver) -> None:
    done: list[str] = []
    sense = [True]
    yes = Answer("yes", "Yes", lambda: done.append("yes"))
    question.prompt("Sure?", yes, still=lambda: sense[0])
    question.reconsider()
    assert question.isVisible()
    sense[0] = False
    driver.click("yes")
    assert done == []
    assert not question.isVisible()


def test_double_click_does_not_answer_its_own_question(
    question: InlinePrompt, driver: WidgetDriver
) -> None:
    done: list[str] = []
    double_click = QApplication.doubleClickInterval() / 1000
    question.prompt("Sure?", Answer("yes", "Yes", lambda: done.append("yes")))
    yes = driver.button("yes")
    QTest.mouseClick(yes, LEFT)
    runtime().sleep(0.75 * double_click)
    QTest.mouseClick(yes, LEFT)
    assert done == []
    runtime().sleep(0.5 * double_click)
    QTest.mouseClick(yes, LEFT)
    assert done == ["yes"]
