"""Files that are dropped on the window or given as arguments."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtWidgets import QMessageBox

from tests.support.pages.robot import POSES_PAGE, RobotWindow
from tests.support.pages.settings import answer_questions
from tests.support.program import aracna, trex
from trex_gui.ui.devices.connection import ConnectionState

POSES = "Test:8:1024:1024:1024:1024:1024:1024:1024:1024\nPose=low:100,100,100,100,100,100,100,100\n"
OTHER_POSES = POSES.replace("low", "other")
SETTINGS = "product: TReX\nserial_timeout: 5\n"

WriteFile = Callable[[str, str], Path]


@pytest.fixture
def write_file(tmp_path: Path) -> WriteFile:
    def write_file(name: str, text: str) -> Path:
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return write_file


def shows_robot(window: RobotWindow) -> bool:
    return aracna(window.program).workspace.isVisible()


def poses(window: RobotWindow) -> list[str]:
    return [pose.name for pose in aracna(window.program).library.project.poses]


def banner(window: RobotWindow) -> str:
    return window.text("bannerText")


def test_dropped_files_open_in_their_workspace(
    window: RobotWindow, write_file: WriteFile, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("photo.png", "noname"):
        assert window.drop(write_file(name, "what"))
        reason = f"{name} was not opened: its type is not supported."
        window.wait_for_text("bannerText", reason)
        assert "a settings file of a TReX (.txt, .yaml, .yml)" in banner(window)
        assert "an Aracna pose file (.ppr)" in banner(window)

    assert window.drop(write_file("a.ppr", POSES), write_file("b.ppr", POSES))
    reason = "None of the 2 dropped files was opened. Drop one file at a time."
    window.wait_for_text("bannerText", reason)

    questions = answer_questions(monkeypatch, QMessageBox.StandardButton.Cancel)
    aracna(window.program).library.add_pose([200] * 8, "mine")
    window.drop(write_file("walk.ppr", POSES))
    window.wait(lambda: questions)
    assert "changes that are not saved" in questions[0]
    assert "mine" in poses(window)
    aracna(window.program).library.undo.undo()

    assert window.drop(write_file("walk.ppr", POSES))
    window.wait(lambda: poses(window) == ["low"])
    assert len(questions) == 1
    assert shows_robot(window)
    assert aracna(window.program).workspace.pages.currentIndex() == POSES_PAGE
    assert banner(window) == "walk.ppr was opened."

    assert window.drop(write_file("rover.yaml", SETTINGS))
    window.wait(lambda: len(trex(window.program).workspace.files.editors) == 1)
    assert not shows_robot(window)
    trex(window.program).workspace.files.close_all()


def test_dropped_file_of_other_device_is_rejected(
    window: RobotWindow, write_file: WriteFile
) -> None:
    window.select_demo()
    assert window.drop(write_file("walk.PPR", POSES))
    window.wait(lambda: poses(window) == ["low"])
    assert window.robot.link is ConnectionState.CONNECTED

    assert window.drop(write_file("rover.txt", SETTINGS))
    window.wait_for_text("bannerText", "rover.txt is a settings file of a TReX.")
    assert window.robot.link is ConnectionState.CONNECTED
    assert shows_robot(window)
    assert trex(window.program).workspace.files.editors == []

    window.select_demo("trex")
    assert window.drop(write_file("other.ppr", OTHER_POSES))
    window.wait_for_text("bannerText", "other.ppr is an Aracna pose file.")
    assert "connected to TReX: disconnect, then open it again" in banner(window)
    assert window.device.link is ConnectionState.CONNECTED
    assert not shows_robot(window)
    assert poses(window) == ["low"]


def test_file_arguments_open_while_robot_connects(
    window: RobotWindow, write_file: WriteFile
) -> None:
    program = window.program
    program.connect_to_demo("aracna")
    program.open_file(write_file("walk.ppr", POSES), connecting=True)
    program.open_file(write_file("rover.txt", SETTINGS), connecting=True)
    window.wait_for_files()
    assert len(trex(program).workspace.files.editors) == 1
    window.wait_until_up()
    window.wait_for_files()
    assert poses(window) == ["low"]
    trex(program).workspace.files.close_all()


def test_pose_file_argument_opens_only_without_trex(
    window: RobotWindow, write_file: WriteFile
) -> None:
    program, before = window.program, poses(window)
    program.connect_to_demo("trex")
    program.open_file(write_file("walk.ppr", POSES), connecting=True)
    window.wait_until_up("trex")
    window.wait_for_text("bannerText", "walk.ppr is an Aracna pose file.")
    assert poses(window) == before

    window.press_disconnect()
    assert not shows_robot(window)
    program.open_file(write_file("walk.ppr", POSES), connecting=False)
    window.wait_for_files()
    assert poses(window) == ["low"]
    assert shows_robot(window)
