"""Question with its answers in a row of the window."""

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


def test_answer_runs_its_action_and_can_open_a_new_question(
    question: InlinePrompt, driver: WidgetDriver
) -> None:
    done: list[str] = []
    save = Answer("save", "Save", lambda: done.append("save"))
    discard = Answer("discard", "Discard", lambda: question.prompt("Sure?", confirm))
    confirm = Answer("confirm", "Confirm", lambda: done.append("confirm"))
    question.prompt("Close?", save, discard)
    driver.click("discard")
    assert question.text == "Sure?"
    assert question.isVisible()
    driver.click("confirm")
    assert done == ["confirm"]
    assert not question.isVisible()


@pytest.mark.parametrize("key", [None, Qt.Key.Key_Escape, Qt.Key.Key_Space])
def test_cancel_runs_only_the_action_for_no_answer(
    question: InlinePrompt, driver: WidgetDriver, key: Qt.Key | None
) -> None:
    done: list[str] = []
    question.prompt(
        "Sure?",
        Answer("yes", "Yes", lambda: done.append("yes")),
        on_withdrawn=lambda: done.append("otherwise"),
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
        "A?", Answer("a", "A", lambda: done.append("a")), on_withdrawn=lambda: done.append("no")
    )
    question.prompt("B?", Answer("b", "B", lambda: done.append("b")))
    assert question.text == "B?"
    assert done == ["no"]
    assert "a" not in [button.objectName() for button in driver.find_all(QPushButton)]
    driver.click("b")
    assert done == ["no", "b"]


def test_outdated_answer_is_not_run(question: InlinePrompt, driver: WidgetDriver) -> None:
    done: list[str] = []
    is_valid = True
    yes = Answer("yes", "Yes", lambda: done.append("yes"))
    question.prompt("Sure?", yes, is_valid=lambda: is_valid)
    question.reconsider()
    assert question.isVisible()
    is_valid = False
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
