"""Records of boards."""

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
from trex_gui.devices.trex.settings.board_records import BoardRecord, BoardRecords, Known
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_files import BoardIdentity
from trex_gui.devices.trex.settings.reader import read_settings

RC, ANALOG = InputSource.RC, InputSource.ANALOG
NOW, LATER = datetime(2026, 3, 14, 15, 9, tzinfo=UTC), datetime(2026, 3, 15, tzinfo=UTC)
BOTH = factory()
BOARD = BoardIdentity.of(BOTH)
EMPTY = BoardRecord(Settings(BOTH.product, BOTH.firmware))
LEARNED = Calibration(2400, 3700, 5100, 80)


def stored(source: InputSource = RC, **values: int) -> Settings:
    """Return the stored settings of a board, with the visible calibrations."""
    shown = {k: c for k, c in BOTH.calibrations.items() if k.source is source}
    return replace(BOTH, parameters={**BOTH.parameters, **values}, calibrations=shown)


def differing(record: BoardRecord, now: Settings) -> dict[str, tuple[object, object]]:
    return {row.key: (row.before, row.after) for row in record.differences(now).rows}


def test_lost_settings_differ_until_they_are_applied_again_or_accepted() -> None:
    seen = EMPTY.after_reading(stored(), RC, NOW)
    assert not differing(seen, stored(serial_timeout=5)), "never applied to"

    board = stored(serial_timeout=5, motor_mode=1)
    record = seen.before_writing({"serial_timeout", "motor_mode"})
    record = record.after_writing(board, RC, (), NOW)
    assert record.applied == NOW
    assert not differing(record, board)
    lost = {"serial_timeout": (0, 5), "motor_mode": (0, 1)}
    assert differing(record, stored()) == lost

    board = stored(motor1_acceleration=9)
    record = record.before_writing({"motor1_acceleration"}).after_writing(board, RC, (), LATER)
    assert differing(record, board) == lost, "writing another value accepts nothing"
    assert not differing(record.accepting(board, RC, LATER), board)
    assert not differing(record.after_reset(), stored())


@pytest.mark.parametrize("stopped", [True, False])
@pytest.mark.parametrize("shutdown", [True, False])
def test_trial_of_the_timeout_is_in_the_file_and_survives_writing(
    tmp_path: Path, *, stopped: bool, shutdown: bool
) -> None:
    trial = TimeoutTrial(stopped, shutdown)
    records = BoardRecords(tmp_path)
    records.save(BOARD, replace(EMPTY, trial=trial).after_writing(stored(), RC, (), LATER))
    loaded = records.load(BOARD)
    assert loaded is not None
    assert loaded.trial == trial
    file = records.path(BOARD)
    text = file.read_text(encoding="utf-8")
    line = next(line for line in text.splitlines() if line.startswith("# serial timeout"))
    file.write_text(text.replace(line, f"{line}, tried 2026-11-28T10:00:00+00:00"), "utf-8")
    loaded = records.load(BOARD)
    assert loaded is not None
    assert loaded.trial == trial, "an earlier version wrote the time, too"


def test_uncertain_values_are_expected_neither_old_nor_new() -> None:
    record = EMPTY.after_writing(stored(serial_timeout=5), RC, (), NOW)
    record = record.before_writing({"serial_timeout"})
    assert not differing(record, stored(serial_timeout=7)), "the program died while it wrote"
    record = record.after_writing(stored(serial_timeout=7), RC, {"serial_timeout"}, NOW)
    assert not differing(record, stored(serial_timeout=9))


def test_calibrations_of_both_sources_are_kept_with_their_age() -> None:
    key = CalibrationKey.RC_CHANNEL_1
    learned = replace(stored(), calibrations={**stored().calibrations, key: LEARNED})
    record = EMPTY.after_reading(learned, RC, NOW).after_reading(stored(ANALOG), ANALOG, LATER)
    assert record.known == {RC: Known(NOW, False), ANALOG: Known(LATER, False)}
    whole, remarks = record.with_hidden(stored(ANALOG), ANALOG)
    assert whole.calibrations == {**BOTH.calibrations, key: LEARNED}
    assert remarks == ["rc calibrations: read 2026-03-14T15:09:00+00:00"]

    assert record.after_reading(stored(), RC, LATER).settings.calibrations[key] != LEARNED
    applied = record.after_writing(learned, RC, (), NOW)
    assert applied.after_reading(learned, RC, LATER).known[RC] == Known(LATER, True)
    record = applied.after_reading(stored(), RC, LATER)
    assert record.known[RC] == Known(NOW, True)
    assert record.settings.calibrations[key] == LEARNED, "what was applied stays known"
    assert differing(record, stored()) == {key: (stored().calibrations[key], LEARNED)}
    assert not differing(record, stored(ANALOG))


def test_records_are_settings_files(tmp_path: Path) -> None:
    assert BoardRecords(tmp_path / ("x" * 300)).load(BOARD) is None
    records = BoardRecords(tmp_path / "boards")
    assert records.load(BOARD) is None
    record = replace(EMPTY, adapter=Adapter("0403:6001", "My adapter/1").key)
    record = record.after_writing(stored(serial_timeout=5), RC, (), NOW)
    record = record.after_reading(stored(ANALOG), ANALOG, LATER)
    assert (EMPTY.time, record.time) == (None, LATER)
    records.save(BOARD, record)
    assert records.load(BOARD) == record
    text = records.path(BOARD).read_text()
    assert read_settings(text)[0] == record.settings

    line = f"# parameters: applied {NOW.isoformat()}"
    for time in ("x", "9999-12-31T23:00:00+00:00"):  # not in every time zone
        records.path(BOARD).write_text(text.replace(line, f"# parameters: applied {time}"))
        damaged = records.load(BOARD)
        assert damaged is not None
        assert (damaged.applied, damaged.settings.parameters) == (None, {})
    records.path(BOARD).write_text("product: TReX\n!")
    with pytest.raises(SettingsError):
        records.load(BOARD)
    assert (tmp_path / "boards" / "trex-1.2-7.txt.damaged").exists(), "its notes are not lost"
    records.save(BOARD, record)
    records.save(BOARD, None)
    assert records.load(BOARD) is None


def test_last_record_at_the_adapter_is_of_the_board_that_lost_its_number(tmp_path: Path) -> None:
    records = BoardRecords(tmp_path)
    kept = {3: ("here", 2), 7: ("here", 4), 9: ("here", 3), 12: ("there", 5), 13: ("new", None)}
    for number, (adapter, day) in kept.items():
        applied = None if day is None else NOW.replace(day=day)
        record = replace(EMPTY, applied=applied, adapter=adapter)
        records.save(replace(BOARD, device_number=number), record)
    found = records.of_other_number(replace(BOARD, device_number=7), "here")
    assert found is not None
    assert found.applied == NOW.replace(day=3)
    assert records.of_other_number(BOARD, "new") is None, "nothing was applied to it"
