"""What goes over the line to a robot, on the same page as that of a board."""

import sys

import pytest
from pytestqt.qtbot import QtBot

from tests.aracna.end_to_end.person import DEMO_TREX, Person
from trex_gui.model.connection import Link
from trex_gui.views.transcript.table import RECEIVED, SENT, WORDS
from trex_gui.views.transcript.table_view import TranscriptView
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")


@pytest.fixture
def person(program: Program, qtbot: QtBot) -> Person:
    person = Person(program, qtbot)
    person.connect_to_demo()
    pages = program.aracna.pages
    pages.setCurrentIndex(pages.count() - 1)
    return person


def column(person: Person, column: int) -> list[str]:
    model = person.find(TranscriptView, "aracnaTranscriptView").model()
    return [str(model.index(row, column).data()) for row in range(model.rowCount())]


def waits_for(person: Person, text: str) -> None:
    person.wait(lambda: any(text in words for words in column(person, WORDS)))


def test_a_motion_stands_there_with_its_answer(person: Person) -> None:
    assert person.robot.move((300,) * 8)
    waits_for(person, "go to 300, 300, 300, 300, 300, 300, 300, 300 → at ")
    row = column(person, SENT).index(".c300,300,300,300,300,300,300,300\\n")
    assert column(person, RECEIVED)[row].startswith(".c")
    assert any(text.startswith("set speeds") for text in column(person, WORDS)[:row])


def test_a_restart_voids_what_was_asked(person: Person) -> None:
    assert person.robot.move((300,) * 8)
    waits_for(person, "go to 300")
    person.simulator.send("reset")
    waits_for(person, "the robot has started, and is deaf for a second")
    person.wait(lambda: person.robot.link is Link.UP)


def test_a_servo_that_does_not_answer_is_a_fault(person: Person) -> None:
    done: list[str] = []
    person.simulator.send("servo 3 dead", done.append)
    person.wait(lambda: bool(done))
    person.robot.set_speeds((50,) * 8)
    waits_for(person, "no answer")
    # It counts once it is over: with the next question.
    person.wait(lambda: "faults: 0" not in person.text("aracnaTranscriptSummary"))


def test_neither_device_stands_in_the_transcript_of_the_other(person: Person) -> None:
    board = person.program.device.transcript
    assert board.everything.count == 0
    waits_for(person, "Opened the simulated robot")
    person.choose_port(DEMO_TREX)
    person.wait(lambda: person.program.device.link is Link.UP)
    board.pull()
    assert any(row.sent == b"\x81" for row in board.everything.rows)
    person.robot.transcript.pull()
    rows = person.robot.transcript.everything.rows
    assert rows[-1].note == "Closed."
    assert {row.sent for row in rows} <= {b"", b".q\n", b"\n"}
