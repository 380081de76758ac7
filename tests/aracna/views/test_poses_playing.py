"""Sequences in the panel: their steps, and what is asked for to play them."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSpinBox,
    QComboBox,
    QSpinBox,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.aracna.views.poses_stage import EIGHT, Stage
from trex_gui.aracna.link.messages import Play, Step
from trex_gui.aracna.model.known import Playing
from trex_gui.aracna.poses.sequence import SequenceStep
from trex_gui.aracna.protocol.joints import Limits


@pytest.fixture
def stage(qtbot: QtBot) -> Iterator[Stage]:
    stage = Stage(qtbot)
    yield stage
    stage.panel.close()
    stage.panel.deleteLater()


def test_a_new_sequence_gets_steps_of_the_pose_that_is_chosen(stage: Stage) -> None:
    stage.click("aracnaNewSequence")
    stage.type_name(stage.names("aracnaMotions"), "bob")
    stage.choose("aracnaPoses", "stand")
    stage.click("aracnaAddStep")
    stage.choose("aracnaPoses", "half-stand")
    stage.click("aracnaAddStep")
    sequence = stage.library.sequence("bob")
    assert sequence is not None
    assert sequence.steps == (SequenceStep("stand", 500), SequenceStep("half-stand", 500))
    stage.click("aracnaStepUp")
    assert stage.library.sequences[0].steps[0].pose_name == "half-stand"
    stage.click("aracnaRemoveStep")
    assert [step.pose_name for step in stage.library.sequences[0].steps] == ["stand"]


def test_pose_and_milliseconds_of_a_step_are_edited_in_the_table(
    stage: Stage, qtbot: QtBot
) -> None:
    stage.library.add_sequence("bob", [SequenceStep("gone", 500)])
    stage.choose("aracnaMotions", "bob")
    view = stage.steps
    view.setCurrentIndex(view.model().index(0, 1))
    view.edit(view.currentIndex())
    combo = view.findChild(QComboBox, "aracnaStepPose")
    assert combo is not None
    assert combo.currentText() == "gone"
    combo.setCurrentText("stand")
    combo.activated.emit(combo.currentIndex())
    assert stage.library.sequences[0].steps == (SequenceStep("stand", 500),)
    view.setCurrentIndex(view.model().index(0, 2))
    view.edit(view.currentIndex())
    spin = view.findChild(QSpinBox, "aracnaStepTime")
    assert spin is not None
    spin.setValue(5000)
    QTest.keyClick(spin, Qt.Key.Key_Return)
    changed = (SequenceStep("stand", 5000),)
    qtbot.waitUntil(lambda: stage.library.sequences[0].steps == changed)


def test_play_asks_for_the_steps_within_the_limits_as_they_were_chosen(stage: Stage) -> None:
    stage.library.add_sequence("up", [SequenceStep("flat", 3000), SequenceStep("stand", 2000)])
    stage.panel.show_link(True)
    stage.panel.show_present((300,) * 8)
    stage.choose("aracnaMotions", "up")
    stage.spin("aracnaRounds").setValue(3)
    stage.spin("aracnaSpeedScale").setValue(50)
    stage.check("aracnaBlendOut", True)
    stage.click("aracnaPlay")
    flat, stand = (600, 40) * 4, (512, 550) * 4
    assert stage.plays == [
        Play(
            0,
            (Step(flat, 3.0, "flat"), Step(stand, 2.0, "stand")),
            rounds=3,
            blend_in=(Step(flat, 3.0, "flat"),),
            blend_out=(Step(stand, 3.0, "stand"),),
            time_scale=2.0,
        )
    ]
    assert stage.summary.startswith("2 steps, 10.0 s a round, 30.0 s in all.")
    assert "cropped" in stage.summary


def test_loop_plays_for_ever_and_without_blending_there_are_only_the_steps(stage: Stage) -> None:
    stage.panel.show_link(True)
    stage.choose("aracnaMotions", "push-ups (built in)")
    stage.check("aracnaLoop", True)
    stage.check("aracnaBlendIn", False)
    assert not stage.spin("aracnaRounds").isEnabled()
    stage.click("aracnaPlay")
    assert stage.plays[0].rounds == 0
    assert stage.plays[0].blend_in == stage.plays[0].blend_out == ()


def test_other_limits_crop_what_is_played(stage: Stage) -> None:
    stage.panel.show_link(True)
    stage.panel.show_limits((Limits(290, 310),) * 8)
    stage.choose("aracnaMotions", "push-ups (built in)")
    stage.click("aracnaPlay")
    assert stage.plays[0].steps[0].goals == (310, 290) * 4


def test_motors_that_cannot_make_it_in_time_are_named_at_their_step(stage: Stage) -> None:
    stage.library.add_sequence("hasty", [SequenceStep("flat", 3000), SequenceStep("stand", 100)])
    stage.choose("aracnaMotions", "hasty")
    assert "cannot make it in time" in stage.summary
    remark = stage.steps.model().index(1, 3).data()
    assert remark.startswith("needs 0.26 s: motor 1, 3, 5, 7")
    stage.spin("aracnaSpeedScale").setValue(30)
    assert "cannot make it" not in stage.summary


def test_a_sequence_with_poses_nobody_defined_cannot_be_played_until_they_are(
    stage: Stage,
) -> None:
    stage.panel.show_link(True)
    stage.library.add_sequence("gait", [SequenceStep("p1", 500)])
    stage.choose("aracnaMotions", "gait")
    assert not stage.button("aracnaPlay").isEnabled()
    assert "p1" in stage.summary
    assert stage.steps.model().index(0, 3).data() == "not defined"
    stage.library.add_pose(EIGHT, "p1")
    assert stage.button("aracnaPlay").isEnabled()


def test_while_something_plays_it_can_be_slowed_and_the_step_is_marked(
    stage: Stage, qtbot: QtBot
) -> None:
    stage.panel.show_link(True)
    stage.choose("aracnaMotions", "push-ups (built in)")
    stage.click("aracnaPlay")
    stage.panel.show_playing(Playing(2, 0, "steps", 1))
    assert not stage.button("aracnaPlay").isEnabled()
    assert not stage.button("aracnaGoTo").isEnabled()
    assert stage.steps.model().index(1, 0).data() == "▶ 2"
    with qtbot.waitSignal(stage.panel.scale_changed) as scale:
        stage.spin("aracnaSpeedScale").setValue(200)
    assert scale.args == [0.5]
    assert "being played" in stage.button("aracnaGoTo").toolTip()
    stage.panel.show_playing(None)
    assert stage.steps.model().index(1, 0).data() == "2"
    assert stage.button("aracnaPlay").isEnabled()


def test_something_can_be_played_as_soon_as_there_is_a_robot(stage: Stage) -> None:
    assert not stage.button("aracnaPlay").isEnabled()
    stage.panel.show_link(True)
    stage.click("aracnaPlay")
    assert stage.plays


def test_why_nothing_can_be_moved_is_said_at_the_buttons(stage: Stage) -> None:
    stage.choose("aracnaPoses", "stand")
    stage.panel.show_link(False, "The robot waits for motor 3.")
    for name in ("aracnaPlay", "aracnaGoTo"):
        assert not stage.button(name).isEnabled()
        assert stage.button(name).toolTip() == "The robot waits for motor 3."


def test_a_gait_that_is_duplicated_becomes_a_sequence_that_can_be_changed(stage: Stage) -> None:
    stage.choose("aracnaMotions", "star 6 (built in)")
    assert not stage.button("aracnaDeleteSequence").isEnabled()
    stage.click("aracnaDuplicateSequence")
    [sequence] = stage.library.sequences
    assert [step.milliseconds for step in sequence.steps] == [500, 200, 500, 200]
    assert {step.pose_name for step in sequence.steps} <= set(stage.pose_names())
    assert stage.button("aracnaAddStep").isEnabled()
    stage.click("aracnaUndo")
    assert not stage.library.modified


def test_every_control_has_a_name_for_tests_and_one_for_screen_readers(stage: Stage) -> None:
    kinds = (QAbstractButton, QAbstractSpinBox, QAbstractItemView)
    for widget in stage.panel.findChildren(QWidget):
        if isinstance(widget, kinds) and not widget.objectName().startswith("qt_"):
            parent = widget.parent()
            if type(widget).__module__.startswith("PySide6") and isinstance(
                parent, QAbstractItemView
            ):
                continue  # of the table itself
            assert widget.objectName().startswith("aracna"), widget
            text = widget.text() if isinstance(widget, QAbstractButton) else ""
            assert widget.accessibleName() or text, widget.objectName()
            assert widget.focusPolicy() & Qt.FocusPolicy.TabFocus, widget.objectName()


def test_the_library_may_go_before_the_panel(stage: Stage, qtbot: QtBot) -> None:
    stage.library.add_pose(EIGHT)
    with qtbot.waitSignal(stage.library.destroyed):
        stage.library.deleteLater()
    assert stage.panel.isVisible()


def test_what_a_menu_asks_for_is_played_only_where_the_button_could_be_pressed(
    stage: Stage,
) -> None:
    stage.library.add_sequence("bob", [SequenceStep("stand", 500)])
    stage.choose("aracnaMotions", "bob")
    stage.panel.play()
    assert stage.plays == [], "there is no robot"
    stage.panel.show_link(True)
    stage.panel.show_present((512,) * 8)
    stage.panel.play()
    assert len(stage.plays) == 1
    stage.panel.show_playing(Playing(1, 1))
    stage.panel.play()
    assert len(stage.plays) == 1


def test_what_a_menu_captures_is_a_pose_whose_name_can_be_typed(stage: Stage) -> None:
    before = stage.pose_names()
    stage.panel.capture()
    assert stage.pose_names() == before
    assert "where the robot is, is not known" in stage.said[-1]
    stage.panel.show_present(EIGHT)
    stage.panel.capture()
    stage.type_name(stage.names("aracnaPoses"), "here")
    assert stage.pose_names() == [*before, "here"]


def test_what_is_typed_and_not_confirmed_is_played(stage: Stage, qtbot: QtBot) -> None:
    stage.library.add_sequence("bob", [SequenceStep("stand", 500)])
    stage.choose("aracnaMotions", "bob")
    stage.panel.show_link(True)
    stage.panel.show_present((512,) * 8)
    stage.check("aracnaBlendIn", False)
    stage.panel.activateWindow()
    view = stage.steps
    view.setCurrentIndex(view.model().index(0, 2))
    view.edit(view.currentIndex())
    time = stage.spin("aracnaStepTime")
    qtbot.waitUntil(time.hasFocus, timeout=15_000)
    time.selectAll()
    QTest.keyClicks(time, "1200")
    stage.panel.play()
    assert stage.plays[-1].steps[0].seconds == 1.2

    rounds = stage.spin("aracnaRounds")
    rounds.setFocus()
    qtbot.waitUntil(rounds.hasFocus, timeout=15_000)
    rounds.selectAll()
    QTest.keyClicks(rounds, "7")
    stage.panel.play()
    assert stage.plays[-1].rounds == 7
