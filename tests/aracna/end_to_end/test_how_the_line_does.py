"""The Log page says how the line to the robot does."""

import sys

import pytest
from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from tests.aracna.end_to_end.person import Person
from trex_gui.model.connection import Link
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

_LOG = 2


@pytest.fixture
def person(program: Program, qtbot: QtBot) -> Person:
    return Person(program, qtbot)


def test_requests_and_failures_are_shown_and_go_with_the_line(person: Person) -> None:
    person.connect_to_demo()
    person.program.aracna.pages.setCurrentIndex(_LOG)
    person.wait(lambda: person.text("aracnaTrafficValue").endswith("answered (100.00 %)"))
    assert person.text("aracnaQualityValue").startswith("0 silent, 0 damaged, 0 strange lines")
    assert person.find(QLabel, "aracnaTrafficValue").isEnabled()
    person.simulator.send("line mute on")
    person.wait(lambda: person.robot.link is Link.SILENT)
    person.wait(lambda: not person.text("aracnaQualityValue").startswith("0 silent"))
    person.simulator.send("line mute off")
    person.wait(lambda: person.robot.link is Link.UP)
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    assert person.text("aracnaTrafficValue") == "N/A"
    assert not person.find(QLabel, "aracnaTrafficValue").isEnabled()


def test_a_new_line_begins_to_count_anew(person: Person) -> None:
    person.connect_to_demo()
    person.wait(lambda: person.robot.counters.answers > 0)
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    assert person.robot.counters.answers == 0
