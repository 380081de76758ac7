"""The text in a box is used, whether it was confirmed or not."""

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QListView, QSpinBox

from tests.support.documents import save_now
from tests.support.pages.robot import POSES_PAGE, RobotWindow
from tests.support.program import aracna
from trex_gui.devices.aracna.poses.ppr import read_ppr


def move_by_key(window: RobotWindow) -> None:
    """Move as Ctrl+M does; the focus stays where it is."""
    count = len(window.goals)
    window.trigger("aracna_move")
    window.wait_for_motion(count)


def click_without_focus(window: RobotWindow, name: str) -> None:
    """Click a button as on a Mac, where a click takes no focus."""
    window.button(name).setFocusPolicy(Qt.FocusPolicy.TabFocus)
    window.click(name)


def test_typed_values_are_used_before_enter(connected_window: RobotWindow, tmp_path: Path) -> None:
    window, path = connected_window, tmp_path / "typed.ppr"
    window.type_unconfirmed("aracnaSpeedAll", "400")
    move_by_key(window)
    assert window.speeds[-1] == (400,) * 8
    assert window.find(QSpinBox, "aracnaSpeedAll").text() == "400 = 268 °/s"
    window.type_unconfirmed("aracnaSpeed3", "300")
    move_by_key(window)
    assert window.speeds[-1] == (400, 400, 400, 300, 400, 400, 400, 400)

    window.click("aracnaLimitsBox")
    for name, text, goal in (
        ("aracnaDegrees0", "88", 300),
        ("aracnaGoal0", "250", 250),
        ("aracnaHigh0", "200", 200),
    ):
        window.type_unconfirmed(name, text)
        move_by_key(window)
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

    # A position of a pose is saved and moved to.
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
    window.trigger("aracna_save")  # else the window asks whether to when it closes
    window.wait_for_files()
