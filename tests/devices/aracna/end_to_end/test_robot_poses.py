"""Poses are captured and gone to, and gaits are played, with a robot connected."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication, QPushButton
from pytestqt.qtbot import QtBot

from tests.support.causes import watched
from tests.support.documents import save_now
from tests.support.pages.robot import POSES_PAGE, ROBOT_PAGE, RobotWindow
from tests.support.program import aracna
from trex_gui.devices.aracna.session.messages import Moving
from trex_gui.ui.runtime import now


@pytest.fixture
def window(connected_window: RobotWindow) -> Iterator[RobotWindow]:
    yield connected_window
    aracna(
        connected_window.program
    ).library.new()  # else the window asks whether to save when it closes


def test_pose_is_captured_renamed_and_moved_to(window: RobotWindow, tmp_path: Path) -> None:
    library, robot = aracna(window.program).library, window.robot
    window.show_page(POSES_PAGE)
    assert not window.is_enabled("aracnaCapture"), "positions are not known yet"
    window.show_page(ROBOT_PAGE)
    window.drag("aracnaSlider0", 300)
    window.move()
    there = robot.state.present

    window.trigger("aracna_capture")
    window.type_into_row("aracnaPoses", "wave")
    window.wait(lambda: library.project.pose("wave") is not None)
    pose = library.project.pose("wave")
    assert pose is not None
    assert pose.positions == there

    window.show_page(ROBOT_PAGE)
    window.click("aracnaCentreButton")
    window.move()
    assert robot.state.present != there
    window.show_page(POSES_PAGE)
    window.choose_row("aracnaPoses", "wave")
    window.click("aracnaGoTo")
    window.wait(lambda: robot.state.moved is not None and robot.state.goals == there)
    save_now(library, library.content, tmp_path / "mine.ppr")
    assert "Pose=wave:" in (tmp_path / "mine.ppr").read_text(encoding="utf-8")

    library.set_positions("stand", (512, 680) * 4)
    window.choose_row("aracnaPoses", "stand")
    window.click("aracnaGoTo")
    window.wait(lambda: robot.state.goals == (512, 550) * 4)
    assert "instead of 680" in window.text("bannerText"), "it goes as far as the limits allow"


def test_gait_plays_until_stopped(window: RobotWindow, qapp: QApplication, qtbot: QtBot) -> None:
    robot = window.robot
    window.show_page(POSES_PAGE)
    assert window.is_enabled("aracnaPlay"), "a gait is chosen"
    assert window.text("aracnaPosesFootnote").startswith("* Which leg is which")
    buttons = window.find_all(QPushButton)
    ends = [
        each.objectName() for each in buttons if each.isVisible() and each.text().startswith("End")
    ]
    assert ends == ["aracnaEndButton"]
    window.show_page(ROBOT_PAGE)
    window.move()
    window.show_page(POSES_PAGE)
    window.choose_row("aracnaMotions", "push-ups")
    window.click("aracnaLoop")
    window.trigger("aracna_play")
    window.wait(lambda: robot.state.step is not None and robot.state.step.index == 1)
    assert "Playing" in window.text("aracnaMotionLabel")
    assert not window.is_enabled("aracnaPlay")
    reports: list[object] = []
    robot.reported.connect(reports.append)
    window.press_escape()
    stopped = now()  # what was sent before may be reported later
    window.wait(lambda: robot.state.play is None and robot.state.moving is None)
    motions = [report for report in reports if isinstance(report, Moving)]
    assert len([motion for motion in motions if motion.time > stopped]) <= 1
    assert window.is_enabled("aracnaPlay")

    with watched(window.program, qtbot, qapp) as causes:
        window.click("aracnaPlay")
        window.wait(lambda: robot.state.step is not None and robot.state.step.index == 1)
        causes.lock_the_screen()
        window.wait(lambda: robot.state.play is None)
        window.wait_for_text("bannerText", "The screen was locked.")
