"""The lists and the table of the poses panel, as Qt's own tester sees them."""

import pytest
from PySide6.QtCore import QObject, Qt
from pytestqt.modeltest import ModelTester
from pytestqt.qtbot import QtBot

from trex_gui.devices.aracna.model.library import ItemKey, ItemKind, Library
from trex_gui.devices.aracna.model.pose_models import NameModel, StepColumn, StepTable
from trex_gui.devices.aracna.poses.gaits import GAITS
from trex_gui.devices.aracna.poses.project import SequenceStep
from trex_gui.ui.notifier import Notifier

POSE, SEQUENCE = ItemKind.POSE, ItemKind.SEQUENCE


def names_of(library: Library, kind: ItemKind) -> NameModel:
    return NameModel(library, kind, Notifier(library))


@pytest.fixture
def library(qapp: QObject) -> Library:
    del qapp
    library = Library()
    library.add_sequence("mine", [SequenceStep("flat", 100), SequenceStep("gone", 200)])
    return library


def test_models_keep_qt_model_rules_through_edits(
    library: Library, qtmodeltester: ModelTester, qtbot: QtBot
) -> None:
    del qtbot
    poses, motions, steps = names_of(library, POSE), names_of(library, SEQUENCE), StepTable(library)
    steps.show_item(ItemKey("mine"))
    for model in (poses, motions, steps):
        qtmodeltester.check(model)  # type: ignore[no-untyped-call] # of pytest-qt
    library.add_pose((1,) * 8)
    library.delete(ItemKind.POSE, "flat")
    library.add_sequence()
    steps.add(0, SequenceStep("stand"))
    steps.show_running(1)
    steps.remove(2)
    library.delete(ItemKind.SEQUENCE, "mine")
    assert steps.rowCount() == 0
    assert not steps.editable


def test_pose_name_is_editable_and_duplicate_is_rejected(library: Library, qtbot: QtBot) -> None:
    notifier = Notifier()
    names = NameModel(library, POSE, notifier)
    assert names.setData(names.index(0), "low")
    assert library.project.poses[0].name == "low"
    assert library.project.sequences[0].steps[0].pose_name == "low"
    with qtbot.waitSignal(notifier.error) as refused:
        assert not names.setData(names.index(0), "stand")
    assert "stand is taken" in refused.args[0]


def test_gaits_follow_sequences_and_cannot_be_renamed(library: Library) -> None:
    names = names_of(library, SEQUENCE)
    assert names.rowCount() == 1 + len(GAITS)
    assert names.index(1).data() == "stand up (built in)"
    assert not names.setData(names.index(1), "mine too")
    assert not names.flags(names.index(1)) & Qt.ItemFlag.ItemIsEditable


def test_sequence_tooltip_names_undefined_poses(library: Library) -> None:
    names = names_of(library, SEQUENCE)
    assert "gone" in names.index(0).data(Qt.ItemDataRole.ToolTipRole)


def test_step_pose_and_time_are_editable(library: Library) -> None:
    table = StepTable(library)
    table.show_item(ItemKey("mine"))
    assert table.setData(table.index(1, StepColumn.POSE), "stand")
    assert table.setData(table.index(0, StepColumn.TIME), 750)
    assert not table.setData(table.index(0, StepColumn.NUMBER), 3)
    assert library.project.sequences[0].steps == (
        SequenceStep("flat", 750),
        SequenceStep("stand", 200),
    )


def test_gait_steps_are_read_only(library: Library) -> None:
    table = StepTable(library)
    table.show_item(ItemKey("star 6", built_in=True))
    shown = [table.index(row, StepColumn.TIME).data() for row in range(table.rowCount())]
    assert shown == ["500 ms", "200 ms", "500 ms", "200 ms"]
    assert not table.setData(table.index(0, StepColumn.TIME), 750)
