"""Record of a board over connections at several adapters."""

from collections.abc import Mapping
from dataclasses import replace
from datetime import UTC, datetime

import pytest

from tests.devices.trex.settings.samples import factory
from trex_gui.devices.trex.board.memory import BoardMemory
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.settings.board_records import BoardRecord, Known
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_files import BoardIdentity

NOW = datetime(2026, 3, 14, 15, 9, tzinfo=UTC)
RC = InputSource.RC
SHOWN = {key: found for key, found in factory().calibrations.items() if key.source is RC}
NEW = replace(factory(), calibrations=SHOWN)
ONE, OTHER = "0403:6001-A500001", "0403:6001-B700002"


class MemoryHarness:
    """Files in memory, and a board."""

    def __init__(self) -> None:
        self.records: dict[str, BoardRecord] = {}
        self.doubts: list[BoardRecord] = []
        self.notes: Mapping[str, str] | None = None
        self.accepted: list[Mapping[str, int]] = []
        self.memory = BoardMemory(self)
        self.stored = NEW
        self.wanted: BoardIdentity | None = None  # whose record is read slowly
        self.is_slow = False

    def find(self, board: BoardIdentity) -> None:
        if self.is_slow:
            self.wanted = board
            return
        self.memory.handle_record(board, self.records.get(str(board)))

    def find_lost(self, board: BoardIdentity, adapter: str) -> None:
        others = (found for found in self.records.values() if found.applied is not None)
        found = next((one for one in others if one.adapter == adapter), None)
        self.memory.set_lost(board, found)

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
        self.doubts.append(record)

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
    for adapter, count in ((ONE, 0), (ONE, 0), (OTHER, 1), (OTHER, 1), ("", 1), (ONE, 2)):
        harness.connect(NEW, adapter)
        assert len(harness.doubts) == count, adapter
    # The record of the other board remains, whichever board gets a new number.
    harness.write(device_number=8)
    assert sorted(harness.records) == ["trex-1.2-7", "trex-1.2-8"]
    harness.write(device_number=9)
    assert sorted(harness.records) == ["trex-1.2-7", "trex-1.2-9"], "this one is its own"


def test_board_without_its_number_differs_from_applied_settings(harness: MemoryHarness) -> None:
    assert not harness.connect(NEW, ONE), "nothing was applied before"
    harness.write(device_number=12, serial_timeout=15)
    assert not harness.connect(NEW, OTHER), "another adapter"
    assert harness.connect(NEW, ONE) == {"device_number", "serial_timeout"}
    assert harness.memory.applied is not None
    assert harness.memory.applied.parameters["device_number"] == 12
    harness.memory.accept(NOW)
    assert not harness.memory.differing.rows
    assert not harness.connect(NEW, ONE), "the user said so"
    assert harness.connect(with_values(NEW, serial_timeout=3), ONE) == {"serial_timeout"}


@pytest.mark.parametrize(("adapter", "number"), [("", 7), (ONE, 3)])
def test_only_a_board_as_new_at_a_known_adapter_may_have_lost_its_number(
    harness: MemoryHarness, adapter: str, number: int
) -> None:
    harness.connect(NEW, adapter)
    harness.write(device_number=12)
    assert not harness.connect(with_values(NEW, device_number=number), adapter)


def test_board_that_gets_its_number_back_gets_its_notes_back(harness: MemoryHarness) -> None:
    notes = {"serial_timeout": "The radio drops out."}
    harness.connect(NEW, ONE)
    harness.memory.set_notes(notes)
    harness.write(device_number=12)
    assert harness.notes == notes
    assert harness.connect(NEW, ONE) == {"device_number"}
    assert not harness.notes
    harness.write(device_number=12)
    assert harness.notes == notes
    assert list(harness.records) == ["trex-1.2-12"]


def test_values_of_a_write_without_an_end_are_not_expected(harness: MemoryHarness) -> None:
    harness.connect(NEW, ONE)
    harness.write(serial_timeout=15, motor1_current_limit=3)
    harness.memory.start_writing({"serial_timeout"})
    harness.memory.close_board()
    found = with_values(harness.stored, serial_timeout=3, motor1_current_limit=0)
    assert harness.connect(found, ONE) == {"motor1_current_limit"}


@pytest.mark.parametrize("is_simulated", [False, True])
def test_simulated_board_does_not_affect_real_boards(
    harness: MemoryHarness, *, is_simulated: bool
) -> None:
    harness.memory.set_board(NEW, RC, NOW, opened=True, is_simulated=is_simulated)
    kind = Signature(NEW.product, "1.2")
    harness.memory.record_accepted(kind, {"uart_error_shutdown": 2})
    harness.memory.record_accepted(kind, {})
    assert harness.accepted == ([] if is_simulated else [{"uart_error_shutdown": 2}])


def test_changes_before_the_record_is_found_are_recorded(harness: MemoryHarness) -> None:
    memory, harness.is_slow = harness.memory, True
    harness.connect(NEW, "")
    harness.write(serial_timeout=5)
    assert (memory.record, memory.applied) == (None, None)
    assert memory.hidden_calibration(2, RC) == (None, None)
    assert memory.with_hidden(NEW) == (NEW, [])
    assert harness.wanted is not None
    memory.handle_record(harness.wanted, None)
    assert memory.applied is not None
    assert memory.applied.parameters["serial_timeout"] == 5
    calibration, known = memory.hidden_calibration(2, RC)
    assert calibration == DEFAULT_CALIBRATION[RC]
    assert known == Known(NOW, True)
    memory.close_board()
    assert memory.applied is None


@pytest.mark.parametrize("is_reset", [True, False])
def test_number_after_a_reset_is_that_of_the_same_board(
    harness: MemoryHarness, *, is_reset: bool
) -> None:
    harness.connect(with_values(NEW, device_number=12), "")
    harness.memory.set_notes({"serial_timeout": "why"})
    if is_reset:
        harness.memory.record_reset()
    harness.memory.set_board(NEW, RC, NOW, opened=False)
    assert (harness.notes == {"serial_timeout": "why"}) is is_reset
    expected = {"trex-1.2-7"} if is_reset else {"trex-1.2-7", "trex-1.2-12"}
    assert harness.records.keys() == expected
