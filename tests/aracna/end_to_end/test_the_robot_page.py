"""A person without hardware drives the Demo Aracna with the mouse."""

import sys

import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QPushButton, QSlider, QSpinBox, QWidget
from pytestqt.qtbot import QtBot

from tests.aracna.end_to_end.person import Person
from trex_gui.aracna.link.messages import Moving, Play, Step
from trex_gui.aracna.views.page.drawing import RobotDrawing
from trex_gui.model.connection import Link
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")


@pytest.fixture
def person(program: Program, qtbot: QtBot) -> Person:
    person = Person(program, qtbot)
    person.connect_to_demo()
    return person


@pytest.fixture
def sent(person: Person) -> list[tuple[int, ...]]:
    """The goals of every motion that goes out."""
    goals: list[tuple[int, ...]] = []

    def note(report: object) -> None:
        if isinstance(report, Moving):
            goals.append(report.goals)

    person.robot.reported.connect(note)
    return goals


def control(person: Person, line: str) -> None:
    """Do something to the simulated robot."""
    answers: list[str] = []
    person.simulator.send(line, answers.append)
    person.wait(lambda: bool(answers))
    assert answers[0].startswith("ok"), answers


def test_nothing_is_known_nor_sent_before_the_first_move(
    person: Person, sent: list[tuple[int, ...]]
) -> None:
    assert "not known before the first move" in person.text("aracnaReport")
    assert "speed 100 (67 °/s)" in person.text("aracnaReport")
    assert person.text("aracnaPresent0") == "–"
    person.drag("aracnaSlider0", 300)
    assert not sent, "a slider by itself moves nothing"
    person.move_and_wait()
    assert sent == [(person.find(QSpinBox, "aracnaGoal0").value(), *(512,) * 7)]
    assert abs(sent[0][0] - 300) < 8, "a pixel is some units"
    assert person.text("aracnaPresent0").endswith("°")
    assert "where it was sent" in person.text("aracnaReport")


def test_a_slider_stops_at_its_limit(person: Person) -> None:
    slider = person.drag("aracnaSlider1", 1000)
    assert slider.value() == 550
    slider = person.drag("aracnaSlider0", 0)
    assert slider.value() == 50


def test_what_is_typed_beyond_a_limit_is_cut_to_it(person: Person) -> None:
    box = person.find(QSpinBox, "aracnaGoal2")
    box.setFocus()
    box.selectAll()
    QTest.keyClicks(box, "1023")
    QTest.keyClick(box, Qt.Key.Key_Return)
    assert box.value() == 600
    assert person.find(QSlider, "aracnaSlider2").value() == 600


def test_degrees_and_units_say_the_same(person: Person) -> None:
    degrees = person.find(QWidget, "aracnaDegrees4")
    degrees.setFocus()
    QTest.keySequence(degrees, "Ctrl+A")
    QTest.keyClicks(degrees, degrees.locale().toString(90.0, "f", 1))
    QTest.keyClick(degrees, Qt.Key.Key_Return)
    assert person.find(QSpinBox, "aracnaGoal4").value() == 307


def test_goals_are_sent_while_they_are_dragged(person: Person, sent: list[tuple[int, ...]]) -> None:
    person.move_and_wait()
    person.click("aracnaLiveBox")
    slider = person.drag("aracnaSlider6", 400, release=False)
    person.wait(lambda: bool(sent) and sent[-1][6] == slider.value())
    assert person.robot.dragging
    for goal in (410, 405) * 25:  # after a pause of a second the rate is reckoned anew
        count = len(sent)
        QTest.mouseMove(slider, person._handle_at(slider, goal))
        QTest.mouseMove(slider, person._handle_at(slider, goal + 20))
        person.wait_for_motion(count, sent)
        if "commands a second" in person.text("aracnaRateLabel"):
            break
    assert "commands a second" in person.text("aracnaRateLabel")
    QTest.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=person.handle(slider))
    assert not person.robot.dragging


def test_a_hand_on_a_slider_is_let_go_by_a_stop(
    person: Person, sent: list[tuple[int, ...]]
) -> None:
    person.move_and_wait()
    person.click("aracnaLiveBox")
    slider = person.drag("aracnaSlider6", 400, release=False)
    person.wait(lambda: bool(sent) and sent[-1][6] == slider.value())
    QTest.keyClick(person.program.window, Qt.Key.Key_Escape)
    person.wait(lambda: person.robot.known.moving is None)
    count = len(sent)
    QTest.mouseMove(slider, person._handle_at(slider, 200))
    assert not person.robot.dragging
    QTest.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=person.handle(slider))
    person.move_and_wait()
    assert len(sent) == count + 1
    assert sent[-1][6] == pytest.approx(sent[-2][6], abs=8), "it begins where the robot stands"


def test_speeds_are_set_together_and_one_by_one(person: Person) -> None:
    everyone = person.find(QSpinBox, "aracnaSpeedAll")
    everyone.setValue(300)
    one = person.find(QSpinBox, "aracnaSpeed7")
    assert one.text() == "300 = 201 °/s"
    one.setValue(0)
    assert one.text() == "0 = fastest"
    person.wait(lambda: person.robot.known.speeds is not None)
    person.move_and_wait()
    speeds = person.robot.known.speeds
    assert speeds is not None
    assert speeds.held == (*(300,) * 7, 0)


def test_speeds_that_differ_are_shown_as_such_until_one_is_chosen_for_all(person: Person) -> None:
    everyone = person.find(QSpinBox, "aracnaSpeedAll")
    one = person.find(QSpinBox, "aracnaSpeed7")
    one.setValue(0)
    assert everyone.text() == "differ"
    assert set(person.robot.speeds.wanted) == {0, 100}, "to show it chooses nothing"
    QTest.keyClick(everyone, Qt.Key.Key_Down)
    assert everyone.text() == "differ"
    QTest.keyClick(everyone, Qt.Key.Key_Up)
    assert person.robot.speeds.wanted == (10,) * 8
    assert everyone.text() == "10 = 7 °/s"
    one.setValue(20)
    person.program.window.activateWindow()
    everyone.setFocus()
    person.wait(lambda: everyone.lineEdit().selectedText() == "differ")
    QTest.keyClicks(everyone, "300")
    QTest.keyClick(everyone, Qt.Key.Key_Return)
    assert person.robot.speeds.wanted == (300,) * 8
    assert everyone.text() == "300 = 201 °/s"
    everyone.setValue(-1)
    assert everyone.value() == 0, "that they differ cannot be chosen"


def test_limits_are_changed_and_reset_on_the_page(person: Person) -> None:
    assert not person.find(QSpinBox, "aracnaLow3").isVisible()
    person.click("aracnaLimitsBox")
    person.find(QSpinBox, "aracnaHigh3").setValue(450)
    assert person.find(QSpinBox, "aracnaGoal3").value() == 450
    person.find(QSpinBox, "aracnaLow3").setValue(500)
    assert person.find(QSpinBox, "aracnaHigh3").value() == 500, "one pushes the other"
    person.click("aracnaFactoryLimitsButton")
    assert person.find(QSpinBox, "aracnaHigh3").value() == 550
    assert person.find(QSpinBox, "aracnaLow3").value() == 0


def test_drawing_and_rows_point_at_the_same_joint(person: Person) -> None:
    drawing = person.find(RobotDrawing, "aracnaDrawing")
    name = person.find(QWidget, "aracnaName5")
    QTest.mouseMove(drawing, drawing.joint_place(5).toPoint())
    assert name.autoFillBackground()
    before = drawing.grab().toImage()
    QTest.mouseMove(drawing, QPointF(2, 2).toPoint())
    assert not name.autoFillBackground()
    person.find(QSlider, "aracnaSlider5").setFocus()
    assert name.autoFillBackground()
    assert drawing.grab().toImage() == before
    place = drawing.joint_place(2).toPoint()
    QTest.mouseClick(drawing, Qt.MouseButton.LeftButton, pos=place)
    assert person.find(QSlider, "aracnaSlider2").hasFocus()


def test_the_bar_says_what_plays_and_how_long_it_lasts_and_stop_ends_it(
    person: Person, sent: list[tuple[int, ...]]
) -> None:
    assert "This link has no stop" in person.text("aracnaHonestLabel")
    person.move_and_wait()
    steps = (Step((400,) * 8, 0.6, "down"), Step((500,) * 8, 0.6, "up"))
    person.robot.play(Play(0, steps, rounds=0))
    person.wait(lambda: "Playing step 2 of 2 “up”" in person.text("aracnaMotionLabel"))
    person.wait(lambda: "ends by itself in about 0." in person.text("aracnaMotionLabel"))
    assert not person.find(QPushButton, "aracnaMoveButton").isEnabled()
    stop = person.find(QPushButton, "aracnaStopButton")
    QTest.mousePress(stop, Qt.MouseButton.LeftButton)  # at the press, not at its end
    person.wait(lambda: person.robot.playing is None and person.robot.known.moving is None)
    QTest.mouseRelease(stop, Qt.MouseButton.LeftButton)
    assert person.text("aracnaMotionLabel") == "At rest: nothing is sent."
    assert person.find(QPushButton, "aracnaMoveButton").isEnabled()
    assert sent[-1][0] == pytest.approx(person.robot.targets.goals[0], abs=8)


def test_a_sequence_ends_after_its_step(person: Person) -> None:
    person.move_and_wait()
    steps = (Step((400,) * 8, 0.4, "down"), Step((500,) * 8, 0.4, "up"))
    person.robot.play(Play(0, steps, rounds=0))
    person.wait(lambda: "step 1" in person.text("aracnaMotionLabel"))
    person.click("aracnaEndButton")
    person.wait(lambda: person.robot.playing is None)
    assert person.robot.link is Link.UP


def test_a_servo_that_dies_is_named_with_what_to_do(person: Person) -> None:
    person.move_and_wait()
    control(person, "servo 3 block")  # on its way until it dies: a dead one takes no speed either
    person.drag("aracnaSlider3", 480)
    person.click("aracnaMoveButton")
    person.wait(lambda: person.robot.known.moving is not None)
    control(person, "servo 3 dead")
    control(person, "servo 3 free")
    person.wait(lambda: "waits for motor 3" in person.text("aracnaReport"))
    assert "servo power" in person.text("aracnaReport")
    assert "does not stop the servos" in person.text("aracnaReport")
    assert "motor 3" in person.text("aracnaMotionLabel")
    assert person.text("aracnaState3") == "stuck here"
    control(person, "servo 3 alive")
    person.wait(lambda: "where it was sent" in person.text("aracnaReport"))


def test_a_board_that_restarts_is_told_and_goes_on(person: Person) -> None:
    person.move_and_wait()
    said: list[str] = []

    def note() -> None:
        said.append(person.text("statusLabel"))

    person.robot.changed.connect(note)
    control(person, "reset")
    person.wait(lambda: any("restarted" in text for text in said))
    person.robot.changed.disconnect(note)
    person.wait(lambda: "Connected to Aracna" in person.text("statusLabel"))
    person.move_and_wait()


def test_a_pulled_plug_is_told_and_connect_takes_the_robot_up_again(person: Person) -> None:
    control(person, "line unplug")
    person.wait(lambda: person.robot.link is Link.NONE)
    assert person.find(QWidget, "banner").isVisible()
    assert person.text("statusLabel") == "Not connected."
    control(person, "line plug")
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.UP)


def test_a_key_on_a_slider_is_sent_at_once_where_that_is_wished(
    person: Person, sent: list[tuple[int, ...]]
) -> None:
    person.move_and_wait()
    person.find(QCheckBox, "aracnaLiveBox").setChecked(True)
    slider = person.find(QSlider, "aracnaSlider0")
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_Left)
    person.wait(lambda: bool(sent) and sent[-1][0] == 508)
