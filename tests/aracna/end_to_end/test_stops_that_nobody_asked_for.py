"""What a window with an Aracna says when the program halts it by itself: its link has no stop."""

import re
import sys
from collections.abc import Iterator

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.aracna.end_to_end.person import Person
from tests.support.causes import Causes, watched
from trex_gui.model.connection import Link
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

LOCKED = "The screen was locked"
MISTAKEN = "The program made a mistake (ValueError)"
BOTH = pytest.mark.parametrize(
    ("cause", "reason"), [("make_a_mistake", MISTAKEN), ("lock_the_screen", LOCKED)]
)


@pytest.fixture
def person(program: Program, qtbot: QtBot) -> Person:
    person = Person(program, qtbot)
    person.connect_to_demo()
    return person


@pytest.fixture
def causes(person: Person, qtbot: QtBot, qapp: QApplication) -> Iterator[Causes]:
    with watched(person.program, qtbot, qapp) as causes:
        yield causes


def creep(person: Person) -> None:
    """Send every motor on a way of some minutes, from where it is known to be."""
    person.move_and_wait()
    person.robot.set_speeds((1,) * 8)
    person.robot.move((300,) * 8)
    person.wait(lambda: person.robot.remaining() > 0)


@BOTH
def test_a_motion_that_runs_is_said_to_go_on_and_for_how_long(
    cause: str, reason: str, person: Person, causes: Causes
) -> None:
    creep(person)
    longest = person.robot.remaining()
    getattr(causes, cause)()
    person.wait(lambda: causes.banner.startswith(reason))
    said = re.fullmatch(
        rf"{re.escape(reason)}\. Nothing more is sent; the motion that runs goes on to its goal "
        r"\(about (\d+) s\)\.",
        causes.banner,
    )
    assert said is not None, causes.banner
    assert person.robot.remaining() - 1 <= int(said[1]) <= longest + 1
    assert person.robot.known.moving is not None, "it goes on, and the bar says the same"
    assert "ends by itself in about" in person.text("aracnaMotionLabel")
    assert f"{reason}." in [event.text for event in person.robot.events.all]


@BOTH
def test_of_a_robot_at_rest_only_is_said_that_nothing_is_sent(
    cause: str, reason: str, person: Person, causes: Causes
) -> None:
    person.move_and_wait()
    getattr(causes, cause)()
    person.wait(lambda: causes.banner == f"{reason}. Nothing more is sent to the robot.")


def test_before_its_first_answer_nothing_is_claimed_of_whether_it_moves(
    person: Person, causes: Causes
) -> None:
    causes.lock_the_screen()
    said = f"{LOCKED}. Nothing more is sent; a motion that runs goes on to its goal."
    person.wait(lambda: causes.banner == said)


def test_the_motors_of_a_robot_are_never_said_to_be_stopped(person: Person, causes: Causes) -> None:
    creep(person)
    causes.lock_the_screen()
    causes.make_a_mistake()
    person.wait(lambda: len(causes.told) == 2)
    assert not [text for text in causes.told if "stopped" in text or "confirmed" in text]
    assert person.program.device.motors.stop_reason == "", "nothing of a TReX was stopped either"


def test_a_motion_that_goes_on_without_a_line_is_said_to(person: Person, causes: Causes) -> None:
    creep(person)
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    causes.make_a_mistake()
    person.wait(lambda: bool(causes.told))
    assert re.fullmatch(
        rf"{re.escape(MISTAKEN)}\. No robot is connected; the motion goes on to its goal "
        r"\(about \d+ s\)\.",
        causes.told[0],
    )


def test_once_the_robot_is_left_at_rest_a_locked_screen_is_no_news(
    person: Person, causes: Causes
) -> None:
    person.move_and_wait()
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    causes.lock_the_screen()
    causes.make_a_mistake()
    person.wait(lambda: bool(causes.told))
    assert causes.told == [f"{MISTAKEN}."]
