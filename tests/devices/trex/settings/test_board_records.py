"""Saved records of the settings of boards."""

from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest

from tests.devices.trex.settings.samples import factory
from trex_gui.core.files import SettingsError
from trex_gui.core.transport.adapters import Adapter
from trex_gui.devices.trex.driving.timeout_stop import TimeoutTrial
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.settings.board_records import BoardRecord, BoardRecords, Provenance
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_files import BoardIdentity
from trex_gui.devices.trex.settings.reader import read_settings

RC, ANALOG = InputSource.RC, InputSource.ANALOG
FIRST, SECOND = datetime(2026, 3, 14, 15, 9, tzinfo=UTC), datetime(2026, 3, 15, tzinfo=UTC)
FACTORY = factory()
BOARD = BoardIdentity.of(FACTORY)
EMPTY = BoardRecord(Settings(FACTORY.product, FACTORY.firmware))
LEARNED = Calibration(2400, 3700, 5100, 80)


def stored(source: InputSource = RC, **values: int) -> Settings:
    """Return the stored settings of a board with the calibrations of one input source."""
    shown = {key: value for key, value in FACTORY.calibrations.items() if key.source is source}
    return replace(FACTORY, parameters={**FACTORY.parameters, **values}, calibrations=shown)


def differences(record: BoardRecord, settings: Settings) -> dict[str, tuple[object, object]]:
    return {row.key: (row.before, row.after) for row in record.differences(settings).rows}


def test_lost_settings_differ_until_they_are_accepted_or_reset() -> None:
    record = EMPTY.after_reading(stored(), RC, FIRST)
    assert not differences(record, stored(serial_timeout=5)), "no settings were applied"

    board = stored(serial_timeout=5, motor_mode=1)
    record = record.before_writing({"serial_timeout", "motor_mode"})
    record = record.after_writing(board, RC, (), FIRST)
    assert record.applied == FIRST
    assert not differences(record, board)
    lost = {"serial_timeout": (0, 5), "motor_mode": (0, 1)}
    assert differences(record, stored()) == lost

    board = stored(motor1_acceleration=9)
    record = record.before_writing({"motor1_acceleration"}).after_writing(board, RC, (), SECOND)
    assert differences(record, board) == lost, "a write of another setting accepts no difference"
    assert not differences(record.accepting(board, RC, SECOND), board)
    assert not differences(record.after_reset(), stored())


@pytest.mark.parametrize("stopped", [True, False])
@pytest.mark.parametrize("shutdown", [True, False])
def test_trial_of_timeout_is_saved_with_the_record(
    tmp_path: Path, *, stopped: bool, shutdown: bool
) -> None:
    trial = TimeoutTrial(stopped, shutdown)
    records = BoardRecords(tmp_path)
    records.save(BOARD, replace(EMPTY, trial=trial).after_writing(stored(), RC, (), SECOND))
    loaded = records.load(BOARD)
    assert loaded is not None
    assert loaded.trial == trial
    file = records.path(BOARD)
    text = file.read_text(encoding="utf-8")
    line = next(line for line in text.splitlines() if line.startswith("# serial timeout"))
    file.write_text(text.replace(line, f"{line}, tried 2026-11-28T10:00:00+00:00"), "utf-8")
    loaded = records.load(BOARD)
    assert loaded is not None
    assert loaded.trial == trial, "earlier versions also wrote the time"


def test_unconfirmed_values_are_not_compared() -> None:
    record = EMPTY.after_writing(stored(serial_timeout=5), RC, (), FIRST)
    record = record.before_writing({"serial_timeout"})
    assert not differences(record, stored(serial_timeout=7)), "the program ended during the write"
    record = record.after_writing(stored(serial_timeout=7), RC, {"serial_timeout"}, FIRST)
    assert not differences(record, stored(serial_timeout=9))


def test_record_has_calibrations_of_both_sources_and_their_age() -> None:
    key = CalibrationKey.RC_CHANNEL_1
    learned = replace(stored(), calibrations={**stored().calibrations, key: LEARNED})
    record = EMPTY.after_reading(learned, RC, FIRST).after_reading(stored(ANALOG), ANALOG, SECOND)
    assert record.provenance == {RC: Provenance(FIRST, False), ANALOG: Provenance(SECOND, False)}
    settings, comments = record.with_hidden(stored(ANALOG), ANALOG)
    assert settings.calibrations == {**FACTORY.calibrations, key: LEARNED}
    assert comments == ["rc calibrations: read 2026-03-14T15:09:00+00:00"]

    assert record.after_reading(stored(), RC, SECOND).settings.calibrations[key] != LEARNED
    applied = record.after_writing(learned, RC, (), FIRST)
    assert applied.after_reading(learned, RC, SECOND).provenance[RC] == Provenance(SECOND, True)
    record = applied.after_reading(stored(), RC, SECOND)
    assert record.provenance[RC] == Provenance(FIRST, True)
    assert record.settings.calibrations[key] == LEARNED, "the applied calibration is retained"
    assert differences(record, stored()) == {key: (stored().calibrations[key], LEARNED)}
    assert not differences(record, stored(ANALOG))


def test_records_are_settings_files(tmp_path: Path) -> None:
    assert BoardRecords(tmp_path / ("x" * 300)).load(BOARD) is None
    records = BoardRecords(tmp_path / "boards")
    assert records.load(BOARD) is None
    record = replace(EMPTY, adapter=Adapter("0403:6001", "My adapter/1").key)
    record = record.after_writing(stored(serial_timeout=5), RC, (), FIRST)
    record = record.after_reading(stored(ANALOG), ANALOG, SECOND)
    assert (EMPTY.time, record.time) == (None, SECOND)
    records.save(BOARD, record)
    assert records.load(BOARD) == record
    text = records.path(BOARD).read_text()
    assert read_settings(text)[0] == record.settings

    line = f"# parameters: applied {FIRST.isoformat()}"
    for time in ("x", "9999-12-31T23:00:00+00:00"):  # out of range in some time zones
        records.path(BOARD).write_text(text.replace(line, f"# parameters: applied {time}"))
        damaged = records.load(BOARD)
        assert damaged is not None
        assert (damaged.applied, damaged.settings.parameters) == (None, {})
    records.path(BOARD).write_text("product: TReX\n!")
    with pytest.raises(SettingsError):
        records.load(BOARD)
    assert (tmp_path / "boards" / "trex-1.2-7.txt.damaged").exists(), "the damaged file is retained"
    records.save(BOARD, record)
    records.save(BOARD, None)
    assert records.load(BOARD) is None


def test_programs_retain_the_changes_of_each_other(tmp_path: Path) -> None:
    mine, other = BoardRecords(tmp_path), BoardRecords(tmp_path)
    mine.load(BOARD)
    read = EMPTY.after_reading(stored(), RC, FIRST).with_notes({"motor_mode": "old"})
    mine.save(BOARD, read)
    other.load(BOARD)
    learned = {**stored().calibrations, CalibrationKey.RC_CHANNEL_1: LEARNED}
    written = read.after_writing(
        replace(stored(serial_timeout=9), calibrations=learned), RC, (), FIRST
    )
    other.save(BOARD, written.with_notes({"serial_timeout": "other"}))

    trial = TimeoutTrial(True, True)
    changed = replace(read.after_reading(stored(), RC, SECOND), trial=trial)
    mine.save(BOARD, changed.with_notes({"motor_mode": "old", "motor1_acceleration": "mine"}))
    notes = {"serial_timeout": "other", "motor1_acceleration": "mine"}
    assert mine.load(BOARD) == replace(written, trial=trial).with_notes(notes)
    other.save(BOARD, written.before_writing({"serial_timeout"}).with_notes({}))
    loaded = mine.load(BOARD)
    assert loaded is not None
    assert "serial_timeout" not in loaded.settings.parameters
    assert loaded.settings.notes == {"motor1_acceleration": "mine"}, "the other note was removed"
    assert loaded.trial == trial


def test_board_that_lost_its_number_is_found_by_its_adapter(tmp_path: Path) -> None:
    records = BoardRecords(tmp_path)
    days = {3: ("old", 2), 7: ("old", 4), 9: ("old", 3), 12: ("other", 5), 13: ("new", None)}
    for number, (adapter, day) in days.items():
        applied = None if day is None else FIRST.replace(day=day)
        record = replace(EMPTY, applied=applied, adapter=adapter)
        records.save(replace(BOARD, device_number=number), record)
    found = records.of_other_number(replace(BOARD, device_number=7), "old")
    assert found is not None
    assert found.applied == FIRST.replace(day=3)
    assert records.of_other_number(BOARD, "new") is None, "no settings were applied to this board"
