"""What stands in a box is what is used, whether it was confirmed or not."""

import sys
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractSpinBox, QListView, QPushButton, QSpinBox
from pytestqt.qtbot import QtBot

from tests.aracna.end_to_end.person import Person
from trex_gui.aracna.link.messages import Moving, SpeedsHeld
from trex_gui.aracna.poses.ppr import read_ppr
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")


class Typist(Person):
    """Types into boxes and never confirms it."""

    def __init__(self, program: Program, qtbot: QtBot) -> None:
        super().__init__(program, qtbot)
        self.goals: list[tuple[int, ...]] = []
        self.speeds: list[tuple[int, ...]] = []
        self.robot.reported.connect(self._note)

    def _note(self, report: object) -> None:
        if isinstance(report, Moving):
            self.goals.append(report.goals)
        elif isinstance(report, SpeedsHeld):
            self.speeds.append(report.held)

    def type_into(self, name: str, text: str) -> QAbstractSpinBox:
        box = self.find(QAbstractSpinBox, name)
        self.wait(box.isVisible)
        self.program.window.activateWindow()
        box.setFocus()
        self.wait(box.hasFocus)
        box.selectAll()
        QTest.keyClicks(box, text)
        return box

    def move_by_key(self) -> None:
        """Move as Ctrl+M does; the focus stays where it is."""
        count = len(self.goals)
        self.action("aracna_move").trigger()
        self.wait_for_motion(count, self.goals)

    def take_no_focus(self, name: str) -> QPushButton:
        """Let a button be as on a Mac, where a click takes no focus."""
        button = self.find(QPushButton, name)
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        return button


@pytest.fixture
def typist(program: Program, qtbot: QtBot) -> Typist:
    typist = Typist(program, qtbot)
    typist.connect_to_demo()
    return typist


def test_a_speed_that_was_typed_is_the_speed_of_the_motion(typist: Typist) -> None:
    box = typist.type_into("aracnaSpeedAll", "400")
    typist.move_by_key()
    assert typist.speeds[-1] == (400,) * 8
    assert box.text() == "400 = 268 °/s"
    typist.type_into("aracnaSpeed3", "300")
    typist.move_by_key()
    assert typist.speeds[-1] == (400, 400, 400, 300, 400, 400, 400, 400)


@pytest.mark.parametrize(("name", "text"), [("aracnaGoal0", "300"), ("aracnaDegrees0", "88")])
def test_a_goal_that_was_typed_is_the_goal_of_the_motion(
    typist: Typist, name: str, text: str
) -> None:
    typist.type_into(name, text)
    typist.move_by_key()
    assert typist.goals == [(300, *(512,) * 7)]


def test_a_limit_that_was_typed_is_kept_to(typist: Typist) -> None:
    typist.click("aracnaLimitsBox")
    typist.type_into("aracnaHigh0", "300")
    typist.move_by_key()
    assert typist.goals == [(300, *(512,) * 7)]


def test_a_button_that_takes_no_focus_takes_what_was_typed(typist: Typist) -> None:
    box = typist.type_into("aracnaGoal0", "300")
    typist.take_no_focus("aracnaMoveButton")
    typist.click("aracnaMoveButton")
    typist.wait_for_motion(0, typist.goals)
    assert typist.goals == [(300, *(512,) * 7)]
    typist.type_into("aracnaGoal0", "200")
    typist.take_no_focus("aracnaCentreButton")
    typist.click("aracnaCentreButton")
    assert box.text() == "512"


def test_a_pose_is_saved_and_gone_to_as_it_was_typed(typist: Typist, tmp_path: Path) -> None:
    path = tmp_path / "typed.ppr"
    typist.program.library.save(path)
    typist.action("aracna_page1").trigger()
    poses = typist.find(QListView, "aracnaPoses")
    poses.setCurrentIndex(poses.model().index(0, 0))
    box = typist.type_into("aracnaPosition0", "300")
    assert isinstance(box, QSpinBox)
    typist.action("aracna_save").trigger()
    project, _ = read_ppr(path.read_text(encoding="utf-8"))
    assert project.poses[0].positions[0] == 300
    assert box.value() == 300

    typist.type_into("aracnaPosition0", "400")
    typist.take_no_focus("aracnaGoTo")
    typist.click("aracnaGoTo")
    typist.wait_for_motion(0, typist.goals)
    assert typist.goals[0][0] == 400
    typist.action("aracna_save").trigger()  # else the window asks whether to when it closes
