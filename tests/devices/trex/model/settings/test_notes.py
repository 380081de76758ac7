"""Notes on settings, with undo."""

from PySide6.QtGui import QUndoStack
from pytestqt.qtbot import QtBot

from trex_gui.devices.trex.model.settings.draft import Notes
from trex_gui.devices.trex.settings.notes import LONGEST_NOTE


def test_notes_are_cleaned_limited_and_undone(qtbot: QtBot) -> None:
    undo = QUndoStack()
    notes = Notes(undo=undo)
    notes.edit("motor_mode", "too early")
    assert not notes.all
    notes.load({"motor_mode": "two motors"}, owner=7)
    notes.edit("motor_mode", "two motors \n")
    assert undo.count() == 0
    notes.edit("motor_mode", " one\t\n\n\x07motor ")
    assert notes.of("motor_mode") == "one\n?motor"
    notes.edit("serial_timeout", "x" * 2 * LONGEST_NOTE)
    assert len(notes.of("serial_timeout")) == LONGEST_NOTE
    notes.edit("motor_mode", "")
    assert set(notes.all) == {"serial_timeout"}
    for _ in range(3):
        undo.undo()
    assert notes.all == {"motor_mode": "two motors"}


def test_undo_does_not_change_notes_of_another_board(qtbot: QtBot) -> None:
    undo = QUndoStack()
    notes = Notes(undo=undo)
    notes.load({}, owner=7)
    notes.edit("motor_mode", "two motors")
    notes.load({"motor_mode": "of another board"}, owner=9)
    undo.undo()
    assert notes.all == {"motor_mode": "of another board"}
