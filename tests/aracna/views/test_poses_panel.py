"""The poses of the panel: captured, named, put in order."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from tests.aracna.views.poses_stage import EIGHT, Stage


@pytest.fixture
def stage(qtbot: QtBot) -> Iterator[Stage]:
    stage = Stage(qtbot)
    yield stage
    stage.panel.close()
    stage.panel.deleteLater()


def test_what_the_robot_shows_is_captured_and_named_at_once(stage: Stage) -> None:
    assert not stage.button("aracnaCapture").isEnabled()
    stage.panel.show_present(EIGHT)
    stage.click("aracnaCapture")
    stage.type_name(stage.names("aracnaPoses"), "mine")
    assert stage.library.poses[-1].name == "mine"
    assert stage.library.poses[-1].positions == EIGHT


def test_nothing_can_be_captured_while_a_motor_s_place_is_unknown(stage: Stage) -> None:
    stage.panel.show_present((None, *EIGHT[1:]))
    assert not stage.button("aracnaCapture").isEnabled()
    assert "after its first move" in stage.button("aracnaCapture").toolTip()


def test_f2_renames_and_a_name_that_is_taken_is_said(stage: Stage, qtbot: QtBot) -> None:
    stage.choose("aracnaPoses", "flat")
    view = stage.names("aracnaPoses")
    QTest.keyClick(view, Qt.Key.Key_F2)
    stage.type_name(view, "stand")
    assert stage.pose_names()[0] == "flat"
    assert "stand is taken" in stage.said[-1]
    QTest.keyClick(view, Qt.Key.Key_F2)
    stage.type_name(view, "low")
    assert stage.pose_names()[0] == "low"


def test_delete_deletes_without_a_question_and_undo_brings_it_back(
    stage: Stage, qtbot: QtBot
) -> None:
    assert not stage.button("aracnaUndo").isEnabled()
    stage.choose("aracnaPoses", "flat")
    QTest.keyClick(stage.names("aracnaPoses"), Qt.Key.Key_Delete)
    assert "flat" not in stage.pose_names()
    stage.click("aracnaUndo")
    assert stage.pose_names()[0] == "flat"
    stage.click("aracnaRedo")
    assert "flat" not in stage.pose_names()


def test_alt_and_arrows_put_poses_in_order_and_what_is_chosen_stays_so(
    stage: Stage, qtbot: QtBot
) -> None:
    stage.choose("aracnaPoses", "flat")
    view = stage.names("aracnaPoses")
    for _ in range(2):
        QTest.keyClick(view, Qt.Key.Key_Down, Qt.KeyboardModifier.AltModifier)
    assert stage.pose_names()[:3] == ["half-stand", "stand", "flat"]
    assert view.currentIndex().data() == "flat"
    QTest.keyClick(view, Qt.Key.Key_Up, Qt.KeyboardModifier.AltModifier)
    assert stage.pose_names()[:3] == ["half-stand", "flat", "stand"]


def test_a_pose_that_is_dropped_elsewhere_stands_there(stage: Stage) -> None:
    stage.choose("aracnaPoses", "flat")
    view = stage.names("aracnaPoses")
    below = view.visualRect(stage.find(view, "stand")).bottomLeft() + QPoint(5, 0)
    view.drop_at(below)
    assert stage.pose_names()[:3] == ["half-stand", "stand", "flat"]
    view.drop_at(QPoint(5, 2))
    assert stage.pose_names()[0] == "flat"
    view.drop_at(QPoint(5, view.height() - 5))
    assert stage.pose_names()[-1] == "flat"


def test_go_to_asks_for_the_positions_of_the_pose_where_there_is_a_robot(stage: Stage) -> None:
    stage.choose("aracnaPoses", "stand")
    assert not stage.button("aracnaGoTo").isEnabled()
    stage.panel.show_link(True)
    stage.click("aracnaGoTo")
    assert stage.gone_to == [(512, 680) * 4]


def test_a_position_is_edited_in_its_field_and_said_to_be_outside_the_limits(
    stage: Stage,
) -> None:
    stage.choose("aracnaPoses", "stand")
    field = stage.spin("aracnaPosition3")
    assert field.value() == 680
    assert "sent as 550" in field.toolTip()
    field.setValue(400)
    pose = stage.library.pose("stand")
    assert pose is not None
    assert pose.positions == (512, 680, 512, 400, 512, 680, 512, 680)
    assert "sent as" not in field.toolTip()


def test_after_a_pose_is_deleted_the_next_one_is_chosen(stage: Stage) -> None:
    stage.choose("aracnaPoses", "half-stand")
    view = stage.names("aracnaPoses")
    QTest.keyClick(view, Qt.Key.Key_Delete)
    assert view.currentIndex().data() == "stand"
    stage.choose("aracnaPoses", "self-test b")
    QTest.keyClick(view, Qt.Key.Key_Delete)
    assert view.currentIndex().data() == "self-test a"
