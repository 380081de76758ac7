"""Robot page with the Demo Aracna, used by mouse and keyboard."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractSpinBox, QCheckBox, QListView, QSlider, QSpinBox, QTabWidget

from tests.support.documents import save_now
from tests.support.pages.robot import POSES_PAGE, PROBLEMS_PAGE, RobotWindow
from tests.support.program import aracna
from tests.support.window import LEFT
from trex_gui.devices.aracna.poses.ppr import read_ppr
from trex_gui.devices.aracna.session.messages import Play, Step
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.diagnostics.problems import ProblemCard


def spin_box(window: RobotWindow, name: str) -> QSpinBox:
    return window.find(QSpinBox, name)


def is_dragging(window: RobotWindow) -> bool:
    return window.robot.dragging


def test_move_sends_goals_and_speeds(connected_window: RobotWindow) -> None:
    window = connected_window
    assert "are unknown" in window.text("aracnaTitle")
    assert "speed 100 (67 °/s)" in window.page_text("aracnaRobotPage", "pageState")
    assert window.text("aracnaPresent0") == "–"
    window.drag("aracnaSlider0", 300)
    assert not window.goals, "a slider alone sends nothing"
    window.move()
    assert window.goals == [(window.goal_box(0).value(), *(512,) * 7)]
    assert abs(window.goals[0][0] - 300) < 8, "one pixel is several units"
    assert window.text("aracnaPresent0").endswith("°")
    assert "has reached its goal" in window.text("aracnaTitle")

    spin_box(window, "aracnaSpeedAll").setValue(300)
    last_speed = spin_box(window, "aracnaSpeed7")
    assert last_speed.text() == "300 = 201 °/s"
    last_speed.setValue(0)
    assert last_speed.text() == "0 = unlimited"
    window.move()
    speeds = window.robot.state.speeds
    assert speeds is not None
    assert speeds.held == (*(300,) * 7, 0)


def test_debug_led_is_switched_from_the_menu(connected_window: RobotWindow) -> None:
    window = connected_window
    action = window.action("aracna_led")

    def switches_to(*, on: bool) -> None:
        window.trigger("aracna_led")
        window.wait(lambda: window.robot.state.led is on)
        assert window.simulated()["led"] == on
        assert action.isChecked() == on

    for on in (True, False, True):
        switches_to(on=on)
    window.control("reset")
    window.wait(lambda: window.robot.state.led is None)
    assert not action.isChecked()
    window.wait(action.isEnabled)
    window.control("line mute on")
    window.trigger("aracna_led")
    window.wait_for_text("bannerText", "LED not switched")
    assert not action.isChecked()


def test_goals_stay_within_limits(connected_window: RobotWindow) -> None:
    window = connected_window
    assert window.drag("aracnaSlider1", 1000).value() == 550
    assert window.drag("aracnaSlider0", 0).value() == 50
    window.type_into("aracnaGoal2", "1023")
    assert window.goal_box(2).value() == 600
    assert window.find(QSlider, "aracnaSlider2").value() == 600
    degrees = window.find(QAbstractSpinBox, "aracnaDegrees4")
    window.type_into("aracnaDegrees4", degrees.locale().toString(90.0, "f", 1))
    assert window.goal_box(4).value() == 307

    assert not window.has("aracnaLow3")
    window.click("aracnaLimitsBox")
    low, high = spin_box(window, "aracnaLow3"), spin_box(window, "aracnaHigh3")
    high.setValue(450)
    assert window.goal_box(3).value() == 450
    low.setValue(500)
    assert high.value() == 500, "one limit moves the other"
    window.click("aracnaFactoryLimitsButton")
    assert (low.value(), high.value()) == (0, 550)


def test_common_speed_is_shown_only_if_all_speeds_are_equal(connected_window: RobotWindow) -> None:
    window, robot = connected_window, connected_window.robot
    common, own = spin_box(window, "aracnaSpeedAll"), spin_box(window, "aracnaSpeed7")
    own.setValue(0)
    assert common.text() == "differ"
    assert set(robot.speeds) == {0, 100}, "showing “differ” does not change the speeds"
    QTest.keyClick(common, Qt.Key.Key_Down)
    assert common.text() == "differ"
    QTest.keyClick(common, Qt.Key.Key_Up)
    assert robot.speeds == (10,) * 8
    assert common.text() == "10 = 7 °/s"
    own.setValue(20)
    window.window.activateWindow()
    common.setFocus()
    window.wait(lambda: common.lineEdit().selectedText() == "differ")
    QTest.keyClicks(common, "300")
    QTest.keyClick(common, Qt.Key.Key_Return)
    assert robot.speeds == (300,) * 8
    assert common.text() == "300 = 201 °/s"
    common.setValue(-1)
    assert common.value() == 0, "“differ” cannot be selected"


def test_live_goals_are_sent_until_release_or_stop(connected_window: RobotWindow) -> None:
    window, robot = connected_window, connected_window.robot
    window.move()
    window.find(QCheckBox, "aracnaLiveBox").setChecked(True)
    first_slider = window.find(QSlider, "aracnaSlider0")
    first_slider.setFocus()
    QTest.keyClick(first_slider, Qt.Key.Key_Left)
    window.wait(lambda: window.goals[-1][0] == 508)

    slider = window.drag("aracnaSlider6", 400, release=False)
    window.wait(lambda: window.goals[-1][6] == slider.value())
    assert is_dragging(window)
    window.release_slider("aracnaSlider6")
    assert not is_dragging(window)

    window.drag("aracnaSlider6", 300, release=False)
    window.wait(lambda: window.goals[-1][6] == slider.value())
    assert is_dragging(window)
    window.press_escape()
    window.wait(lambda: robot.state.moving is None)
    count = len(window.goals)
    window.move_slider("aracnaSlider6", 200)
    assert not is_dragging(window)
    window.release_slider("aracnaSlider6")
    window.move()
    assert len(window.goals) == count + 1
    expected = pytest.approx(window.goals[-2][6], abs=8)
    assert window.goals[-1][6] == expected, "the slider is at the present position"


def test_bar_shows_playback_until_it_is_stopped(connected_window: RobotWindow) -> None:
    window, robot = connected_window, connected_window.robot
    assert "This link has no stop" in window.text("aracnaNoStopLabel")
    window.move()
    steps = (Step((400,) * 8, 0.6, "down"), Step((500,) * 8, 0.6, "up"))
    robot.play(Play(0, steps, rounds=0))
    window.wait_for_text("aracnaMotionLabel", "Playing step 2 of 2 “up”")
    window.wait_for_text("aracnaMotionLabel", "ends by itself in about 0.")
    assert not window.is_enabled("aracnaMoveButton")
    stop = window.button("aracnaStopButton")
    QTest.mousePress(stop, LEFT)  # the button acts when it is pressed
    window.wait(lambda: robot.state.play is None and robot.state.moving is None)
    QTest.mouseRelease(stop, LEFT)
    assert window.text("aracnaMotionLabel") == "At rest: nothing is sent."
    assert window.is_enabled("aracnaMoveButton")

    robot.play(Play(0, steps, rounds=0))
    window.wait_for_text("aracnaMotionLabel", "step 1")
    window.click("aracnaEndButton")
    window.wait(lambda: robot.state.play is None)
    assert robot.link is ConnectionState.CONNECTED


def test_problems_page_shows_replies_and_problems(connected_window: RobotWindow) -> None:
    window = connected_window
    window.show_page(PROBLEMS_PAGE)
    window.wait(lambda: window.text("aracnaErrorsReading1") == "100.0 %")
    assert window.text("aracnaErrorsNote").startswith("Nothing has gone wrong since ")
    assert window.robot.state.stats.replies > 0

    window.control("line mute on")
    window.wait(lambda: window.robot.link is ConnectionState.NOT_RESPONDING)
    card = window.find_all(ProblemCard)[0]
    assert card.problem.title == "The robot is not responding"
    assert card.problem.page == "robot"
    tabs = window.find(QTabWidget, "aracnaDiagnosticsTabs")
    assert tabs.tabText(0) == "Problems (1)"
    window.click(f"{card.problem.key}Clear")
    assert tabs.tabText(0) == "Problems"
    window.control("line mute off")
    window.wait_until_up()

    window.press_disconnect()
    assert window.text("aracnaErrorsReading1") == "–"
    assert window.robot.state.stats.replies == 0, "each connection has its own counts"


def trigger_move(window: RobotWindow) -> None:
    """Trigger the action of Ctrl+M, which does not change the focus."""
    count = len(window.goals)
    window.trigger("aracna_move")
    window.wait_for_motion(count)


def click_without_focus(window: RobotWindow, name: str) -> None:
    """Click a button without giving it the focus, as on macOS."""
    window.button(name).setFocusPolicy(Qt.FocusPolicy.TabFocus)
    window.click(name)


def test_typed_values_are_used_before_enter(connected_window: RobotWindow, tmp_path: Path) -> None:
    window, path = connected_window, tmp_path / "typed.ppr"
    window.type_unconfirmed("aracnaSpeedAll", "400")
    trigger_move(window)
    assert window.speeds[-1] == (400,) * 8
    assert window.find(QSpinBox, "aracnaSpeedAll").text() == "400 = 268 °/s"
    window.type_unconfirmed("aracnaSpeed3", "300")
    trigger_move(window)
    assert window.speeds[-1] == (400, 400, 400, 300, 400, 400, 400, 400)

    window.click("aracnaLimitsBox")
    for name, text, goal in (
        ("aracnaDegrees0", "88", 300),
        ("aracnaGoal0", "250", 250),
        ("aracnaHigh0", "200", 200),
    ):
        window.type_unconfirmed(name, text)
        trigger_move(window)
        assert window.goals[-1] == (goal, *(512,) * 7), name

    window.click("aracnaFactoryLimitsButton")
    window.type_unconfirmed("aracnaGoal0", "300")
    count = len(window.goals)
    click_without_focus(window, "aracnaMoveButton")
    window.wait_for_motion(count)
    assert window.goals[count:] == [(300, *(512,) * 7)]
    window.type_unconfirmed("aracnaGoal0", "100")
    click_without_focus(window, "aracnaCentreButton")
    assert window.goal_box(0).text() == "512"

    # A typed position of a pose is saved, and the robot moves to the typed position.
    library = aracna(window.program).library
    save_now(library, library.content, path)
    window.show_page(POSES_PAGE)
    poses = window.find(QListView, "aracnaPoses")
    poses.setCurrentIndex(poses.model().index(0, 0))
    window.type_unconfirmed("aracnaPosition0", "300")
    window.trigger("aracna_save")
    window.wait_for_files()
    project, _ = read_ppr(path.read_text(encoding="utf-8"))
    assert project.poses[0].positions[0] == 300
    assert window.find(QSpinBox, "aracnaPosition0").value() == 300

    window.type_unconfirmed("aracnaPosition0", "400")
    count = len(window.goals)
    click_without_focus(window, "aracnaGoTo")
    window.wait_for_motion(count)
    assert window.goals[count][0] == 400
    window.trigger("aracna_save")  # otherwise the window would prompt when it closes
    window.wait_for_files()
