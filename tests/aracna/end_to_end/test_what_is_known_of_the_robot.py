"""The window says no more of the robot than is known, and lets nothing be asked in vain."""

import json
import sys

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QListWidget, QPushButton
from pytestqt.qtbot import QtBot

from tests.aracna.end_to_end.person import DEMO_ARACNA, DEMO_TREX, Person
from trex_gui.aracna.link import session
from trex_gui.model.connection import Link
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

UNSURE = "Not known: what was sent last goes on to its goal."
AT_REST = "At rest: nothing is sent."
UNSEEN = "Nothing is sent. Whether it moves is known after its first move."


@pytest.fixture
def person(program: Program, qtbot: QtBot) -> Person:
    person = Person(program, qtbot)
    person.connect_to_demo()
    return person


def control(person: Person, line: str) -> None:
    """Do something to the simulated robot."""
    answers: list[str] = []
    person.simulator.send(line, answers.append)
    person.wait(lambda: bool(answers))
    assert answers[0].startswith("ok"), answers


def moves(person: Person) -> bool:
    """Whether a servo of the simulated robot turns."""
    answers: list[str] = []
    person.simulator.send("show", answers.append)
    person.wait(lambda: bool(answers))
    shown = json.loads(answers[0].removeprefix("ok "))
    return any(servo["moving"] for servo in shown["servos"])


def lose_motor_3(person: Person) -> None:
    """Let a motor die on its way: one that is dead before does not even take its speed."""
    control(person, "servo 3 block")  # it is on its way for as long as that
    person.drag("aracnaSlider3", 480)
    person.click("aracnaMoveButton")
    person.wait(lambda: person.robot.known.moving is not None)
    control(person, "servo 3 dead")
    control(person, "servo 3 free")
    person.wait(lambda: person.robot.known.stuck is not None)


def begin_long_motion(person: Person) -> None:
    """Let every motor go far and slowly: for about 90 s."""
    person.robot.set_speeds((5,) * 8)
    person.robot.move((200,) * 8)
    person.wait(lambda: person.robot.known.moving is not None and moves(person))


def logged(person: Person) -> list[str]:
    """What stands in the log, without times, the newest first."""
    log = person.find(QListWidget, "aracnaLog")
    return [log.item(row).text().partition("  ")[2] for row in range(log.count())]


def button(person: Person, name: str) -> QPushButton:
    return person.find(QPushButton, name)


@pytest.mark.parametrize(
    ("before", "after"), [("reset", ""), ("line mute on", "line mute off")], ids=["reset", "mute"]
)
def test_after_a_restart_or_a_silence_positions_are_not_known_until_the_next_answer(
    person: Person, before: str, after: str
) -> None:
    person.move_and_wait()
    assert button(person, "aracnaCapture").isEnabled()
    assert person.text("aracnaMotionLabel") == AT_REST
    person.see_silence(lambda: control(person, before))
    if after:
        control(person, after)
    person.wait(lambda: person.robot.link is Link.UP)
    assert person.robot.present == (None,) * 8
    assert person.text("aracnaPresent0") == "–"
    assert person.text("aracnaMotionLabel") == UNSURE
    assert "not known any more" in person.text("aracnaReport")
    assert not button(person, "aracnaCapture").isEnabled()
    assert not person.action("aracna_capture").isEnabled()
    person.move_and_wait()
    assert person.text("aracnaMotionLabel") == AT_REST
    assert button(person, "aracnaCapture").isEnabled()


def test_while_the_robot_waits_for_a_motor_nothing_can_be_sent_and_why_is_said(
    person: Person,
) -> None:
    person.move_and_wait()
    lose_motor_3(person)
    person.program.window.pages.setCurrentIndex(1)
    for name in ("aracnaMoveButton", "aracnaPlay", "aracnaGoTo"):
        assert not button(person, name).isEnabled(), name
    for name in ("aracnaMoveButton", "aracnaPlay"):
        assert "waits for motor 3" in button(person, name).toolTip(), name
    assert not person.action("aracna_move").isEnabled()
    assert not person.action("aracna_play").isEnabled()
    person.program.window.pages.setCurrentIndex(0)
    person.click("aracnaLiveBox")
    slider = person.drag("aracnaSlider0", 300, release=False)
    assert not person.robot.dragging
    QTest.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=person.handle(slider))
    control(person, "servo 3 alive")
    person.wait(lambda: button(person, "aracnaMoveButton").isEnabled())
    assert "limits" in button(person, "aracnaMoveButton").toolTip()


def test_who_disconnects_is_told_how_long_the_motion_goes_on(person: Person) -> None:
    person.move_and_wait()
    person.robot.set_speeds((25,) * 8)  # 7 s: long enough to be seen, whatever else goes on
    person.drag("aracnaSlider0", 100)
    person.click("aracnaMoveButton")
    person.wait(lambda: person.robot.remaining() > 1)
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    assert "The motion goes on for about" in person.text("aracnaMotionLabel")
    assert "by itself" in person.text("aracnaMotionLabel")
    person.wait(lambda: person.text("aracnaMotionLabel") == "No robot is connected.")


def test_before_the_first_answer_of_a_motion_it_is_not_known_whether_the_robot_moves(
    person: Person,
) -> None:
    assert person.text("aracnaMotionLabel") == UNSEEN
    person.robot.set_speeds((300,) * 8)
    person.wait(lambda: person.robot.known.speeds is not None)
    assert person.text("aracnaMotionLabel") == UNSEEN, "speeds say nothing of positions"
    person.move_and_wait()
    assert person.text("aracnaMotionLabel") == AT_REST


def test_a_motion_that_goes_on_while_the_port_is_opened_anew_is_told(person: Person) -> None:
    begin_long_motion(person)
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    person.choose_port(DEMO_ARACNA)
    control(person, "reset")  # as boards do when their port is opened; their servos go on
    person.wait(lambda: person.robot.link is Link.UP)
    assert moves(person)
    assert person.text("aracnaMotionLabel").startswith("Not known: what was left running may go on")


def test_a_motion_that_goes_on_after_a_restart_is_told_until_its_time_is_over(
    person: Person,
) -> None:
    begin_long_motion(person)
    said: list[tuple[Link, str]] = []

    def note() -> None:
        said.append((person.robot.link, person.text("aracnaMotionLabel")))

    person.robot.changed.connect(note)
    person.see_silence(lambda: control(person, "reset"))
    person.wait(lambda: person.robot.link is Link.UP)
    person.robot.changed.disconnect(note)
    *_, last = [text for link, text in said if link is Link.SILENT]
    assert last.startswith("Not known: what was sent last may go on")
    assert moves(person)
    assert person.text("aracnaMotionLabel").startswith("Not known: what was sent last may go on")
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    assert "The motion goes on for about" in person.text("aracnaMotionLabel")
    assert person.robot.remaining() > 5


def test_a_lost_answer_is_told_once(person: Person, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(session, "FRESH", 60.0)  # else the answer of its speeds may be lost first
    person.move_and_wait()
    control(person, "line mute on")
    person.drag("aracnaSlider0", 500)
    person.click("aracnaMoveButton")
    person.wait(lambda: any("answer was lost" in text for text in logged(person)))
    told = [text for text in logged(person) if "−1" in text or "answer was lost" in text]
    assert told == ["The answer was lost (or no motor answers): positions are not known."]
    control(person, "line mute off")
    person.wait(lambda: person.robot.link is Link.UP)


def test_servos_without_power_are_told_of_once(person: Person) -> None:
    control(person, "servo power off")
    person.robot.set_speeds((300,) * 8)
    person.wait(lambda: person.robot.known.no_servo_answers)
    assert person.text("aracnaReport") == "No motor answers (−1): is the servo power on?"
    assert logged(person)[0] == "No motor answers (−1): is the servo power on?"


def test_a_stop_at_rest_leaves_the_sliders_where_they_are(person: Person) -> None:
    person.move_and_wait()
    person.drag("aracnaSlider0", 300)
    wanted = person.robot.targets.goals
    assert wanted[0] != person.robot.present[0]
    QTest.keyClick(person.program.window, Qt.Key.Key_Escape)
    assert person.robot.targets.goals == wanted
    person.click("aracnaStopButton")
    assert person.robot.targets.goals == wanted
    person.move_and_wait()
    assert person.robot.known.goals == wanted


def test_a_move_is_one_line_of_the_log_and_a_drag_is_none(person: Person) -> None:
    person.drag("aracnaSlider0", 400)
    person.move_and_wait()
    goals = person.robot.known.goals
    assert goals is not None
    line = f"Move to {', '.join(map(str, goals))}."
    assert logged(person).count(line) == 1
    count = len(logged(person))
    person.click("aracnaLiveBox")
    person.drag("aracnaSlider0", 420)
    person.wait(lambda: person.robot.known.goals != goals and person.robot.known.moving is None)
    assert len(logged(person)) == count


def test_the_menu_names_what_escape_does(person: Person) -> None:
    assert person.action("stop").text() == "&Stop sequence"
    person.choose_port(DEMO_TREX)
    person.wait(lambda: person.robot.link is Link.NONE)
    assert person.action("stop").text() == "&Stop motor"


def test_what_connecting_in_vain_may_come_from_is_said_with_a_way_out(person: Person) -> None:
    person.move_and_wait()
    lose_motor_3(person)
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    person.choose_port(DEMO_ARACNA)
    person.wait(lambda: "No Aracna answers" in person.text("bannerText"))
    said = person.text("bannerText")
    assert "may still be moving and hears nothing meanwhile; wait until it stands" in said
    assert "Find a board (Ctrl+Shift+F)" in said


def test_a_gait_is_chosen_and_the_drawing_says_what_it_assumes(person: Person) -> None:
    person.program.window.pages.setCurrentIndex(1)
    assert button(person, "aracnaPlay").isEnabled()
    assert person.find(QLabel, "aracnaPosesFootnote").text().startswith("* Which leg is which")
    ends = [
        each.objectName()
        for each in person.program.window.findChildren(QPushButton)
        if each.isVisible() and "after this" in each.text()
    ]
    assert ends == ["aracnaEndButton"]
