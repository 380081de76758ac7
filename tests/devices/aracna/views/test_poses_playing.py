"""Sequences in the panel: their steps, and the requests to play them."""

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QAbstractItemView, QAbstractSpinBox, QWidget
from pytestqt.qtbot import QtBot

from tests.devices.aracna.views.poses_stage import EIGHT, StagedPageDriver
from trex_gui.devices.aracna.poses.project import SequenceStep
from trex_gui.devices.aracna.session.messages import Play, Step, StepBegun, Stuck


def test_add_step_appends_selected_pose_to_new_sequence(driver: StagedPageDriver) -> None:
    driver.click("aracnaNewSequence")
    driver.type_name("aracnaMotions", "bob")
    driver.choose_row("aracnaPoses", "stand")
    driver.click("aracnaAddStep")
    driver.choose_row("aracnaPoses", "half-stand")
    driver.click("aracnaAddStep")
    sequence = driver.library.project.sequence("bob")
    assert sequence is not None
    assert sequence.steps == (SequenceStep("stand", 500), SequenceStep("half-stand", 500))
    driver.click("aracnaStepUp")
    assert driver.library.project.sequences[0].steps[0].pose_name == "half-stand"
    driver.click("aracnaRemoveStep")
    assert [step.pose_name for step in driver.library.project.sequences[0].steps] == ["stand"]


def test_step_pose_and_time_are_edited_in_table(driver: StagedPageDriver, qtbot: QtBot) -> None:
    driver.library.add_sequence("bob", [SequenceStep("gone", 500)])
    driver.choose_row("aracnaMotions", "bob")
    view = driver.steps
    view.setCurrentIndex(view.model().index(0, 1))
    view.edit(view.currentIndex())
    combo = driver.combo("aracnaStepPose")
    assert combo.currentText() == "gone"
    combo.setCurrentText("stand")
    combo.activated.emit(combo.currentIndex())
    assert driver.library.project.sequences[0].steps == (SequenceStep("stand", 500),)
    view.setCurrentIndex(view.model().index(0, 2))
    view.edit(view.currentIndex())
    spin = driver.spin("aracnaStepTime")
    spin.setValue(5000)
    QTest.keyClick(spin, Qt.Key.Key_Return)
    changed = (SequenceStep("stand", 5000),)
    qtbot.waitUntil(lambda: driver.library.project.sequences[0].steps == changed)


def test_play_requests_clamped_steps_with_chosen_options(driver: StagedPageDriver) -> None:
    driver.library.set_positions("flat", (770, 40) * 4)
    driver.library.add_sequence("up", [SequenceStep("flat", 3000), SequenceStep("stand", 2000)])
    driver.connect()
    driver.show_present(*(300,) * 8)
    driver.choose_row("aracnaMotions", "up")
    driver.spin("aracnaRounds").setValue(3)
    driver.spin("aracnaSpeedScale").setValue(50)
    driver.check("aracnaBlendOut", True)
    driver.click("aracnaPlay")
    flat, stand = (600, 40) * 4, (512, 550) * 4
    assert driver.plays == [
        Play(
            0,
            (Step(flat, 3.0, "flat"), Step(stand, 2.0, "stand")),
            rounds=3,
            blend_in=(Step(flat, 3.0, "flat"),),
            blend_out=(Step(stand, 3.0, "stand"),),
            time_scale=2.0,
        )
    ]
    assert driver.summary.startswith("2 steps, 10.0 s per round, 30.0 s in total.")
    assert "cropped" in driver.summary


def test_loop_without_blending_plays_only_steps_endlessly(driver: StagedPageDriver) -> None:
    driver.connect()
    driver.choose_row("aracnaMotions", "push-ups (built in)")
    driver.check("aracnaLoop", True)
    driver.check("aracnaBlendIn", False)
    assert not driver.spin("aracnaRounds").isEnabled()
    driver.click("aracnaPlay")
    assert driver.plays[0].rounds == 0
    assert driver.plays[0].blend_in == driver.plays[0].blend_out == ()


def test_late_motors_are_named_at_their_step(driver: StagedPageDriver) -> None:
    driver.library.add_sequence("hasty", [SequenceStep("flat", 3000), SequenceStep("stand", 100)])
    driver.choose_row("aracnaMotions", "hasty")
    assert "too slow" in driver.summary
    remark = driver.steps.model().index(1, 3).data()
    assert remark.startswith("needs 0.26 s: motor 1, 3, 5, 7")
    driver.spin("aracnaSpeedScale").setValue(30)
    assert "cannot make it" not in driver.summary


def test_sequence_is_playable_only_with_all_poses_defined(driver: StagedPageDriver) -> None:
    driver.connect()
    driver.library.add_sequence("gait", [SequenceStep("p1", 500)])
    driver.choose_row("aracnaMotions", "gait")
    assert not driver.button("aracnaPlay").isEnabled()
    assert "p1" in driver.summary
    assert driver.steps.model().index(0, 3).data() == "not defined"
    driver.library.add_pose(EIGHT, "p1")
    assert driver.button("aracnaPlay").isEnabled()


def test_speed_can_change_and_step_is_marked_during_playback(
    driver: StagedPageDriver, qtbot: QtBot
) -> None:
    driver.connect()
    driver.choose_row("aracnaMotions", "push-ups (built in)")
    driver.click("aracnaPlay")
    driver.show_playing(driver.plays[0], StepBegun(0.0, "steps", 1, 0, 0.0))
    assert not driver.button("aracnaPlay").isEnabled()
    assert not driver.button("aracnaGoTo").isEnabled()
    assert driver.steps.model().index(1, 0).data() == "▶ 2"
    driver.spin("aracnaSpeedScale").setValue(200)
    assert driver.robot.scales == [0.5]
    assert "is playing" in driver.button("aracnaGoTo").toolTip()
    driver.show_playing(None)
    assert driver.steps.model().index(1, 0).data() == "2"
    assert driver.button("aracnaPlay").isEnabled()


def test_disabled_buttons_show_reason_in_tooltip(driver: StagedPageDriver) -> None:
    driver.choose_row("aracnaPoses", "stand")
    driver.robot.state.stuck = Stuck(0.0, 3)
    driver.connect()
    for name in ("aracnaPlay", "aracnaGoTo"):
        assert not driver.button(name).isEnabled()
        assert driver.button(name).toolTip().startswith("The robot is waiting for motor 3")


def test_duplicated_gait_becomes_editable_sequence(driver: StagedPageDriver) -> None:
    driver.choose_row("aracnaMotions", "star 6 (built in)")
    assert not driver.button("aracnaDeleteSequence").isEnabled()
    driver.click("aracnaDuplicateSequence")
    [sequence] = driver.library.project.sequences
    assert [step.milliseconds for step in sequence.steps] == [500, 200, 500, 200]
    assert {step.pose_name for step in sequence.steps} <= set(driver.pose_names())
    assert driver.button("aracnaAddStep").isEnabled()
    driver.click("aracnaUndo")
    assert not driver.library.modified


def test_every_control_has_object_and_accessible_name(driver: StagedPageDriver) -> None:
    kinds = (QAbstractButton, QAbstractSpinBox, QAbstractItemView)
    for widget in driver.find_all(QWidget):
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


def test_panel_survives_deletion_of_library(driver: StagedPageDriver, qtbot: QtBot) -> None:
    driver.library.add_pose(EIGHT)
    with qtbot.waitSignal(driver.library.destroyed):
        driver.library.deleteLater()
    assert driver.page.isVisible()


def test_menu_plays_only_while_play_is_possible(driver: StagedPageDriver) -> None:
    driver.library.add_sequence("bob", [SequenceStep("stand", 500)])
    driver.choose_row("aracnaMotions", "bob")
    driver.page.play()
    assert driver.plays == [], "there is no robot"
    driver.connect()
    driver.show_present(*(512,) * 8)
    driver.page.play()
    assert len(driver.plays) == 1
    driver.show_playing(driver.plays[0])
    driver.page.play()
    assert len(driver.plays) == 1


def test_menu_capture_adds_pose_and_edits_its_name(driver: StagedPageDriver) -> None:
    before = driver.pose_names()
    driver.page.capture()
    assert driver.pose_names() == before
    assert "the position is unknown" in driver.messages[-1]
    driver.show_present(*EIGHT)
    driver.page.capture()
    driver.type_name("aracnaPoses", "here")
    assert driver.pose_names() == [*before, "here"]


def test_play_uses_typed_values_before_enter(driver: StagedPageDriver, qtbot: QtBot) -> None:
    driver.library.add_sequence("bob", [SequenceStep("stand", 500)])
    driver.choose_row("aracnaMotions", "bob")
    driver.connect()
    driver.show_present(*(512,) * 8)
    driver.check("aracnaBlendIn", False)
    driver.page.activateWindow()
    view = driver.steps
    view.setCurrentIndex(view.model().index(0, 2))
    view.edit(view.currentIndex())
    time = driver.spin("aracnaStepTime")
    qtbot.waitUntil(time.hasFocus, timeout=15_000)
    time.selectAll()
    QTest.keyClicks(time, "1200")
    driver.page.play()
    assert driver.plays[-1].steps[0].seconds == 1.2

    rounds = driver.spin("aracnaRounds")
    rounds.setFocus()
    qtbot.waitUntil(rounds.hasFocus, timeout=15_000)
    rounds.selectAll()
    QTest.keyClicks(rounds, "7")
    driver.page.play()
    assert driver.plays[-1].rounds == 7
