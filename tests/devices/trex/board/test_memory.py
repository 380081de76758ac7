"""Record of a board across connections at several adapters."""

from collections.abc import Mapping
from dataclasses import replace
from datetime import UTC, datetime

import pytest

from tests.devices.trex.settings.samples import factory
from trex_gui.devices.trex.board.memory import BoardMemory
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.settings.board_records import BoardRecord, Provenance
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_files import BoardIdentity

NOW = datetime(2026, 3, 14, 15, 9, tzinfo=UTC)
RC = InputSource.RC
RC_CALIBRATIONS = {key: value for key, value in factory().calibrations.items() if key.source is RC}
NEW_BOARD = replace(factory(), calibrations=RC_CALIBRATIONS)
ADAPTER, OTHER_ADAPTER = "0403:6001-A500001", "0403:6001-B700002"


class MemoryHarness:
    """Record files in memory, and a board."""

    def __init__(self) -> None:
        self.records: dict[str, BoardRecord] = {}
        self.doubted: list[BoardRecord] = []
        self.notes: Mapping[str, str] | None = None
        self.accepted: list[Mapping[str, int]] = []
        self.memory = BoardMemory(self)
        self.stored = NEW_BOARD
        self.requested: BoardIdentity | None = None  # its record is not delivered yet
        self.delays_records = False

    def find(self, board: BoardIdentity) -> None:
        if self.delays_records:
            self.requested = board
            return
        self.memory.handle_record(board, self.records.get(str(board)))

    def find_lost(self, board: BoardIdentity, adapter: str) -> None:
        applied = (record for record in self.records.values() if record.applied is not None)
        lost = next((record for record in applied if record.adapter == adapter), None)
        self.memory.set_lost(board, lost)

    def save(self, board: BoardIdentity, record: BoardRecord | None) -> None:
        self.records.pop(str(board), None)
        if record is not None:
            self.records[str(board)] = record

    def move(
        self, old: BoardIdentity, new: BoardIdentity, record: BoardRecord, *, keeps_old: bool
    ) -> None:
        self.save(new, record)
        if not keeps_old:
            self.save(old, None)

    def add_accepted(self, kind: Signature, values: Mapping[str, int]) -> None:
        self.accepted.append(values)

    def warn_doubtful(self, record: BoardRecord) -> None:
        self.doubted.append(record)

    def show_notes(self, notes: Mapping[str, str] | None, board: BoardIdentity) -> None:
        self.notes = notes

    def record_change(self) -> None:
        pass

    # --- The board ----------------------------------------------------------------------

    def connect(self, stored: Settings, adapter: str) -> set[str]:
        """Connect to a board. Return the differences from the applied settings."""
        self.stored = stored
        self.memory.set_board(stored, RC, NOW, opened=True, adapter=adapter)
        return {row.key for row in self.memory.differing.rows}

    def write(self, **values: int) -> None:
        self.memory.start_writing(values.keys())
        self.stored = with_values(self.stored, **values)
        self.memory.record_written(self.stored, RC, (), NOW)


def with_values(stored: Settings, **values: int) -> Settings:
    return replace(stored, parameters={**stored.parameters, **values})


@pytest.fixture
def harness() -> MemoryHarness:
    return MemoryHarness()


def test_record_of_a_board_at_another_adapter_is_doubted(harness: MemoryHarness) -> None:
    """Two new boards share a record."""
    counts = []
    for adapter in (ADAPTER, ADAPTER, OTHER_ADAPTER, OTHER_ADAPTER, "", ADAPTER):
        harness.connect(NEW_BOARD, adapter)
        counts.append(len(harness.doubted))
    assert counts == [0, 0, 1, 1, 1, 2]
    # The record of the other board remains, whichever board gets a new number.
    harness.write(device_number=8)
    assert sorted(harness.records) == ["trex-1.2-7", "trex-1.2-8"]
    harness.write(device_number=9)
    assert sorted(harness.records) == ["trex-1.2-7", "trex-1.2-9"], "record 8 was moved"


def test_board_that_lost_its_number_differs_from_its_record(harness: MemoryHarness) -> None:
    assert not harness.connect(NEW_BOARD, ADAPTER), "nothing was applied before"
    harness.write(device_number=12, serial_timeout=15)
    assert not harness.connect(NEW_BOARD, OTHER_ADAPTER), "another adapter has no record"
    assert harness.connect(NEW_BOARD, ADAPTER) == {"device_number", "serial_timeout"}
    assert harness.memory.applied is not None
    assert harness.memory.applied.parameters["device_number"] == 12
    harness.memory.accept(NOW)
    assert not harness.memory.differing.rows
    assert not harness.connect(NEW_BOARD, ADAPTER), "the user accepted these values"
    assert harness.connect(with_values(NEW_BOARD, serial_timeout=3), ADAPTER) == {"serial_timeout"}


@pytest.mark.parametrize(("adapter", "number"), [("", 7), (ADAPTER, 3)])
def test_only_new_board_at_known_adapter_may_have_lost_number(
    harness: MemoryHarness, adapter: str, number: int
) -> None:
    harness.connect(NEW_BOARD, adapter)
    harness.write(device_number=12)
    assert not harness.connect(with_values(NEW_BOARD, device_number=number), adapter)


def test_record_of_a_lost_board_counts_only_for_its_request(harness: MemoryHarness) -> None:
    harness.connect(NEW_BOARD, ADAPTER)
    harness.write(device_number=12, serial_timeout=15)
    (lost,) = harness.records.values()
    harness.connect(NEW_BOARD, OTHER_ADAPTER)
    harness.memory.set_lost(BoardIdentity.of(lost.settings), lost)
    assert not harness.memory.differing.rows, "the request was for another board"
    assert harness.connect(NEW_BOARD, ADAPTER)
    harness.memory.record_reset()
    assert not harness.memory.differing.rows


def test_restored_number_restores_the_notes(harness: MemoryHarness) -> None:
    notes = {"serial_timeout": "The radio drops out."}
    harness.connect(NEW_BOARD, ADAPTER)
    harness.memory.set_notes(notes)
    harness.write(device_number=12)
    assert harness.notes == notes
    assert harness.connect(NEW_BOARD, ADAPTER) == {"device_number"}
    assert not harness.notes
    harness.write(device_number=12)
    assert harness.notes == notes
    assert list(harness.records) == ["trex-1.2-12"]


def test_values_of_an_unfinished_write_are_not_expected(harness: MemoryHarness) -> None:
    harness.connect(NEW_BOARD, ADAPTER)
    harness.write(serial_timeout=15, motor1_current_limit=3)
    harness.memory.start_writing({"serial_timeout"})
    harness.memory.close_board()
    stored = with_values(harness.stored, serial_timeout=3, motor1_current_limit=0)
    assert harness.connect(stored, ADAPTER) == {"motor1_current_limit"}


@pytest.mark.parametrize("is_simulated", [False, True])
def test_values_accepted_by_a_simulated_board_are_not_recorded(
    harness: MemoryHarness, *, is_simulated: bool
) -> None:
    harness.memory.set_board(NEW_BOARD, RC, NOW, opened=True, is_simulated=is_simulated)
    signature = Signature(NEW_BOARD.product, "1.2")
    harness.memory.record_accepted(signature, {"uart_error_shutdown": 2})
    harness.memory.record_accepted(signature, {})
    assert harness.accepted == ([] if is_simulated else [{"uart_error_shutdown": 2}])


def test_changes_before_the_record_is_loaded_are_recorded(harness: MemoryHarness) -> None:
    memory, harness.delays_records = harness.memory, True
    harness.connect(NEW_BOARD, "")
    harness.write(serial_timeout=5)
    assert (memory.record, memory.applied) == (None, None)
    assert memory.hidden_calibration(2, RC) == (None, None)
    assert memory.with_hidden(NEW_BOARD) == (NEW_BOARD, [])
    assert harness.requested is not None
    memory.handle_record(harness.requested, None)
    assert memory.applied is not None
    assert memory.applied.parameters["serial_timeout"] == 5
    calibration, known = memory.hidden_calibration(2, RC)
    assert calibration == DEFAULT_CALIBRATION[RC]
    assert known == Provenance(NOW, True)
    memory.close_board()
    assert memory.applied is None


@pytest.mark.parametrize(
    ("is_reset", "opened", "is_same"),
    [(True, False, True), (True, True, False), (False, False, False)],
)
def test_board_with_another_number_is_the_same_only_after_reset(
    harness: MemoryHarness, *, is_reset: bool, opened: bool, is_same: bool
) -> None:
    harness.connect(with_values(NEW_BOARD, device_number=12), "")
    harness.memory.set_notes({"serial_timeout": "why"})
    if is_reset:
        harness.memory.record_reset()
    harness.memory.set_board(NEW_BOARD, RC, NOW, opened=opened)
    assert (harness.notes == {"serial_timeout": "why"}) is is_same
    expected = {"trex-1.2-7"} if is_same else {"trex-1.2-7", "trex-1.2-12"}
    assert harness.records.keys() == expected
    harness.memory.set_board(with_values(NEW_BOARD, device_number=9), RC, NOW, opened=False)
    assert not harness.notes, "only the first number after the reset belongs to this board"
