"""The poses of the panel: captured, named, put in order."""

from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QTextDocumentFragment
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from tests.devices.aracna.views.poses_stage import EIGHT, StagedPageDriver


def test_present_positions_are_captured_and_named(driver: StagedPageDriver) -> None:
    assert not driver.button("aracnaCapture").isEnabled()
    driver.show_present(*EIGHT)
    driver.click("aracnaCapture")
    driver.type_name("aracnaPoses", "mine")
    assert driver.library.project.poses[-1].name == "mine"
    assert driver.library.project.poses[-1].positions == EIGHT


def test_capture_is_disabled_while_position_is_unknown(driver: StagedPageDriver) -> None:
    driver.show_present(None, *EIGHT[1:])
    assert not driver.button("aracnaCapture").isEnabled()
    assert "after its first move" in driver.button("aracnaCapture").toolTip()


def test_f2_renames_pose_and_reports_duplicate_name(driver: StagedPageDriver, qtbot: QtBot) -> None:
    driver.choose_row("aracnaPoses", "flat")
    view = driver.names("aracnaPoses")
    QTest.keyClick(view, Qt.Key.Key_F2)
    driver.type_name("aracnaPoses", "stand")
    assert driver.pose_names()[0] == "flat"
    assert "stand is taken" in driver.messages[-1]
    QTest.keyClick(view, Qt.Key.Key_F2)
    driver.type_name("aracnaPoses", "low")
    assert driver.pose_names()[0] == "low"


def test_delete_removes_pose_and_undo_restores_it(driver: StagedPageDriver, qtbot: QtBot) -> None:
    assert not driver.button("aracnaUndo").isEnabled()
    driver.choose_row("aracnaPoses", "flat")
    QTest.keyClick(driver.names("aracnaPoses"), Qt.Key.Key_Delete)
    assert "flat" not in driver.pose_names()
    driver.click("aracnaUndo")
    assert driver.pose_names()[0] == "flat"
    driver.click("aracnaRedo")
    assert "flat" not in driver.pose_names()


def test_tip_of_undo_shows_the_name_of_a_pose_as_it_is(driver: StagedPageDriver) -> None:
    driver.library.add_pose(EIGHT, "a<img src='x.png'>")
    tip = driver.button("aracnaUndo").toolTip()
    assert QTextDocumentFragment.fromHtml(tip).toPlainText() == "Undo Add pose a<img src='x.png'>"


def test_alt_arrow_keys_move_selected_pose(driver: StagedPageDriver, qtbot: QtBot) -> None:
    driver.choose_row("aracnaPoses", "flat")
    view = driver.names("aracnaPoses")
    for _ in range(2):
        QTest.keyClick(view, Qt.Key.Key_Down, Qt.KeyboardModifier.AltModifier)
    assert driver.pose_names()[:3] == ["half-stand", "stand", "flat"]
    assert view.currentIndex().data() == "flat"
    QTest.keyClick(view, Qt.Key.Key_Up, Qt.KeyboardModifier.AltModifier)
    assert driver.pose_names()[:3] == ["half-stand", "flat", "stand"]


def test_dragged_pose_moves_to_drop_position(driver: StagedPageDriver) -> None:
    driver.choose_row("aracnaPoses", "flat")
    view = driver.names("aracnaPoses")
    below = view.visualRect(driver.index_of(view, "stand")).bottomLeft() + QPoint(5, 0)
    view.drop_at(below)
    assert driver.pose_names()[:3] == ["half-stand", "stand", "flat"]
    view.drop_at(QPoint(5, 2))
    assert driver.pose_names()[0] == "flat"
    view.drop_at(QPoint(5, view.height() - 5))
    assert driver.pose_names()[-1] == "flat"


def test_go_to_requests_positions_when_robot_is_connected(driver: StagedPageDriver) -> None:
    driver.choose_row("aracnaPoses", "stand")
    assert not driver.button("aracnaGoTo").isEnabled()
    driver.connect()
    driver.click("aracnaGoTo")
    assert driver.robot.goals == [(512, 550) * 4]


def test_position_field_edits_pose_and_shows_clamped_value(driver: StagedPageDriver) -> None:
    driver.library.set_positions("stand", (512, 680) * 4)
    driver.choose_row("aracnaPoses", "stand")
    field = driver.spin("aracnaPosition3")
    assert field.value() == 680
    assert "sent as 550" in field.toolTip()
    field.setValue(400)
    pose = driver.library.project.pose("stand")
    assert pose is not None
    assert pose.positions == (512, 680, 512, 400, 512, 680, 512, 680)
    assert "sent as" not in field.toolTip()


def test_next_pose_is_selected_after_deletion(driver: StagedPageDriver) -> None:
    driver.choose_row("aracnaPoses", "half-stand")
    view = driver.names("aracnaPoses")
    QTest.keyClick(view, Qt.Key.Key_Delete)
    assert view.currentIndex().data() == "stand"
    driver.choose_row("aracnaPoses", "self-test b")
    QTest.keyClick(view, Qt.Key.Key_Delete)
    assert view.currentIndex().data() == "self-test a"
