"""Library of poses and sequences: undo steps and files."""

from collections.abc import Callable
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.support.documents import save_now
from trex_gui.core.errors import BadRequest
from trex_gui.core.files import Finding, SettingsError
from trex_gui.devices.aracna.model.library import ItemKind, Library
from trex_gui.devices.aracna.poses.gaits import BUILT_IN_POSES, GAITS, STAND_UP
from trex_gui.devices.aracna.poses.ppr import read_file
from trex_gui.devices.aracna.poses.project import SequenceStep

POSITIONS = (1, 2, 3, 4, 5, 6, 7, 8)


@pytest.fixture
def library() -> Library:
    return Library()


def open_file(library: Library, path: Path) -> tuple[Finding, ...]:
    """Open a pose file. Return its findings."""
    file = read_file(path)
    library.set_file(path, file)
    return file.findings


def names(library: Library) -> list[str]:
    return [pose.name for pose in library.project.poses]


def test_new_library_has_built_in_poses_and_is_unmodified(library: Library) -> None:
    assert library.project.poses == BUILT_IN_POSES
    assert not library.modified
    assert library.path is None


def test_new_pose_is_appended(library: Library, qtbot: QtBot) -> None:
    with qtbot.waitSignal(library.changed):
        name = library.add_pose(POSITIONS)
    assert library.project.poses[-1].name == name == "pose"
    assert library.project.poses[-1].positions == POSITIONS
    assert library.add_pose(POSITIONS) == "pose 2"
    assert library.add_pose(POSITIONS, " mine ") == "mine"
    assert library.modified


def test_renamed_pose_is_renamed_in_sequences(library: Library) -> None:
    library.add_sequence("up", [SequenceStep("flat", 100), SequenceStep("stand", 200)])
    library.rename(ItemKind.POSE, "stand", "upright")
    sequence = library.project.sequence("up")
    assert sequence is not None
    assert sequence.steps == (SequenceStep("flat", 100), SequenceStep("upright", 200))
    library.undo.undo()
    assert library.project.sequences[0].steps[1].pose_name == "stand"


@pytest.mark.parametrize("name", ["flat", "", "   ", "a:b", "a,b", "a|b", "a\nb", "x" * 101])
def test_invalid_pose_name_is_rejected(library: Library, name: str) -> None:
    with pytest.raises(BadRequest):
        library.rename(ItemKind.POSE, "stand", name)
    assert library.project.poses == BUILT_IN_POSES
    assert not library.undo.canUndo()


def test_deleted_pose_stays_in_sequences(library: Library) -> None:
    library.add_sequence("up", [SequenceStep("flat")])
    library.delete(ItemKind.POSE, "flat")
    assert library.project.pose("flat") is None
    assert library.project.sequences[0].steps[0].pose_name == "flat"


def test_pose_can_be_reordered(library: Library) -> None:
    library.move(ItemKind.POSE, "flat", 2)
    assert names(library)[:3] == ["half-stand", "stand", "flat"]
    library.move(ItemKind.POSE, "flat", 99)
    assert names(library)[-1] == "flat"
    library.move(ItemKind.POSE, "flat", -1)
    assert library.project.poses == BUILT_IN_POSES


def test_copy_follows_its_original(library: Library) -> None:
    assert library.duplicate(ItemKind.POSE, "flat") == "flat 2"
    assert names(library)[:2] == ["flat", "flat 2"]
    library.add_sequence("up", [SequenceStep("flat")])
    assert library.duplicate(ItemKind.SEQUENCE, "up") == "up 2"
    assert library.project.sequences[1].steps == library.project.sequences[0].steps


def test_successive_edits_of_pose_are_one_undo_step(library: Library) -> None:
    for position in range(10):
        library.set_positions("flat", (position,) * 8, run=("flat", 1))
    assert library.undo.count() == 1
    library.undo.undo()
    assert library.project.poses == BUILT_IN_POSES
    assert not library.modified


def test_position_out_of_range_is_rejected(library: Library) -> None:
    with pytest.raises(BadRequest, match="1024"):
        library.set_positions("flat", (1024,) * 8)
    assert library.project.poses == BUILT_IN_POSES


def test_unknown_name_cannot_be_edited(library: Library) -> None:
    for edit in (library.delete, library.duplicate):
        for kind in ItemKind:
            with pytest.raises(BadRequest, match="name ghost is unknown"):
                edit(kind, "ghost")


def test_every_edit_can_be_undone_and_redone_in_one_step(library: Library) -> None:
    edits: list[Callable[[], object]] = [
        lambda: library.add_pose(POSITIONS, "new"),
        lambda: library.set_positions("new", (9,) * 8),
        lambda: library.rename(ItemKind.POSE, "new", "newer"),
        lambda: library.duplicate(ItemKind.POSE, "newer"),
        lambda: library.move(ItemKind.POSE, "newer", 0),
        lambda: library.delete(ItemKind.POSE, "newer 2"),
        lambda: library.add_sequence("s"),
        lambda: library.set_steps("s", [SequenceStep("newer", 20)]),
        lambda: library.rename(ItemKind.SEQUENCE, "s", "t"),
        lambda: library.duplicate(ItemKind.SEQUENCE, "t"),
        lambda: library.move(ItemKind.SEQUENCE, "t 2", 0),
        lambda: library.delete(ItemKind.SEQUENCE, "t"),
    ]
    states = [library.project]
    for count, edit in enumerate(edits, 1):
        edit()
        assert library.undo.count() == count
        assert library.project not in states
        states.append(library.project)
    for state in reversed(states[:-1]):
        library.undo.undo()
        assert library.project == state
    assert not library.modified
    for state in states[1:]:
        library.undo.redo()
        assert library.project == state


def test_unchanged_edit_adds_no_undo_step(library: Library) -> None:
    library.rename(ItemKind.POSE, "flat", "flat")
    library.move(ItemKind.POSE, "flat", 0)
    assert library.undo.count() == 0


def test_saved_library_is_read_back_equal(library: Library, tmp_path: Path) -> None:
    path = tmp_path / "mine.ppr"
    library.add_pose(POSITIONS, "mine")
    library.add_sequence("s", [SequenceStep("mine", 700)])
    save_now(library, library.content, path)
    assert not library.modified
    assert (library.path, library.name) == (path, "mine.ppr")
    other = Library()
    assert open_file(other, path) == ()
    assert other.project == library.project
    assert not other.undo.canUndo()


def test_unreadable_lines_are_reported_and_saved_again(library: Library, tmp_path: Path) -> None:
    path = tmp_path / "odd.ppr"
    path.write_text("Aracna:8\nPose=a:1, x\nsomething else\n", encoding="utf-8")
    assert [finding.line for finding in open_file(library, path)] == [1, 2, 3]
    library.add_pose(POSITIONS, "b")
    save_now(library, library.content)
    text = path.read_text(encoding="utf-8")
    assert "Pose=a:1, x\nsomething else\n" in text
    assert "Pose=b:1, 2, 3, 4, 5, 6, 7, 8\n" in text


@pytest.mark.parametrize("data", [b"\0" * 100, b"\x7fELF\x01", b"a" * 2_000_000])
def test_invalid_pose_file_is_rejected(tmp_path: Path, data: bytes) -> None:
    path = tmp_path / "binary.ppr"
    path.write_bytes(data)
    with pytest.raises(SettingsError):
        read_file(path)


def test_edits_during_save_stay_unsaved(library: Library, tmp_path: Path) -> None:
    content = library.content()
    library.add_pose(POSITIONS)
    content.record_saved(tmp_path / "mine.ppr")
    modified = [library.modified]
    library.undo.undo()
    modified.append(library.modified)
    assert modified == [True, False]
    assert library.on_disk == content.text.encode()


def test_late_save_of_previous_file_does_not_affect_next_file(
    library: Library, tmp_path: Path
) -> None:
    content = library.content()
    library.new()
    content.record_saved(tmp_path / "mine.ppr")
    assert library.path is None


def test_gait_becomes_sequence_and_adds_its_poses_once(library: Library) -> None:
    star = next(gait for gait in GAITS if gait.name == "star 6")
    assert library.add_gait(star) == "star 6"
    assert library.add_gait(star) == "star 6 2"
    assert library.undo.count() == 2
    assert len(library.project.poses) == len(BUILT_IN_POSES) + len(star.poses)
    first, second = library.project.sequences
    assert first.steps == second.steps
    for step, star_step, star_pose in zip(first.steps, star.steps, star.poses, strict=True):
        pose = library.project.pose(step.pose_name)
        assert pose is not None
        assert pose.positions == star_pose.positions
        assert step.milliseconds == star_step.milliseconds


def test_gait_with_built_in_poses_adds_no_poses(library: Library) -> None:
    library.add_gait(STAND_UP)
    assert library.project.poses == BUILT_IN_POSES
    assert library.project.sequences[0].steps == (
        SequenceStep("flat", 3000),
        SequenceStep("stand", 3000),
    )


def test_gait_ignores_changed_pose_of_same_name(library: Library) -> None:
    library.set_positions("flat", POSITIONS)
    library.add_gait(STAND_UP)
    step = library.project.sequences[0].steps[0]
    assert step.pose_name == "stand up flat"
    pose = library.project.pose("stand up flat")
    assert pose is not None
    assert pose.positions == (600, 40) * 4
