"""Backup of unapplied edits for the next start."""

import itertools
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.trex.model.device_setup import DeviceSetup
from tests.support.matrix import sampled
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_devices import VirtualSimulator
from tests.support.virtual_time import VirtualRuntime
from trex_gui.core.files import SettingsError, data_folder
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.edit_backup import EditBackup
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.settings.document import factory_settings
from trex_gui.devices.trex.settings.edit_files import BoardIdentity, EditFiles

STICK = Calibration(2400, 3700, 5100, 80)
RC_2 = CalibrationKey.of(InputSource.RC, 2)
TREX = BoardIdentity(device_table().model("trex"), "1.2", 7)


class Run(DeviceSetup):
    """Run of the program, which ends with a crash."""

    def __init__(self, qtbot: QtBot, simulator: SimulatedDevice) -> None:
        super().__init__(qtbot, simulator)
        self.backup = self.device.edit_backup
        self.draft = self.device.draft
        self.connect()

    def connect(self, url: str = "") -> None:
        super().connect(url)
        self.settle()

    def edit(self, **values: int) -> None:
        for key, wire in values.items():
            self.device.parameters.edit(key, wire)
        self.settle()

    def edit_calibration(self) -> None:
        self.device.calibrations.edit(2, STICK)
        self.settle()

    def settle(self) -> None:
        """Wait until all files are read and saved."""
        backup = self.backup
        self.until(lambda: backup.files.is_idle and backup._is_read)

    def crash(self) -> None:
        """End without discarding the backup."""
        self.draft.pending_changed.disconnect(self.backup._on_changed)
        self.shut_down()

    @property
    def offered(self) -> dict[str, object]:
        offer = self.backup.offer
        return {} if offer is None else {row.key: row.after for row in offer.rows}

    @property
    def edits(self) -> dict[str, object]:
        parameters: dict[str, object] = dict(self.device.parameters.values.pending)
        return parameters | dict(self.device.calibrations.edited)


@pytest.fixture
def run(qtbot: QtBot, quick_simulator: SimulatedDevice) -> Iterator[Callable[..., Run]]:
    """Return a function that crashes the last run and starts the program again."""
    runs: list[Run] = []

    def start(simulator: SimulatedDevice = quick_simulator) -> Run:
        if runs:
            runs.pop().crash()
        runs.append(Run(qtbot, simulator))
        return runs[-1]

    yield start
    runs.pop().crash()


Start = Callable[..., Run]


def files() -> list[Path]:
    folder = EditFiles().folder
    return sorted(folder.iterdir()) if folder.exists() else []


def test_edits_are_offered_after_a_crash(run: Start) -> None:
    first = run()
    assert first.backup.offer is None
    first.edit(serial_timeout=15, motor1_acceleration=3)
    first.edit_calibration()

    second = run()
    edits = {"serial_timeout": 15, "motor1_acceleration": 3, RC_2: STICK}
    assert second.offered == edits
    assert second.draft.pending == 0, "edits are restored only on request"
    second.backup.restore()
    assert second.edits == edits
    second.settle()
    assert run().offered == edits, "restored edits are pending"


def test_edits_that_are_already_stored_are_not_offered(
    run: Start, quick_simulator: SimulatedDevice
) -> None:
    run().edit(serial_timeout=15, motor1_acceleration=3)
    quick_simulator.do("eeprom serial_timeout 15")
    second = run()
    assert second.offered == {"motor1_acceleration": 3}
    quick_simulator.do("eeprom motor1_acceleration 3")
    assert run().offered == {}
    assert files() == []


def test_discarded_edits_are_not_offered_again(run: Start) -> None:
    run().edit(serial_timeout=15)
    second = run()
    second.backup.discard_offer()
    second.settle()
    assert files() == []
    assert run().offered == {}


def test_applied_discarded_or_undone_edits_leave_no_file(run: Start) -> None:
    first = run()
    ends: tuple[Callable[[], None], ...] = (
        first.device.writer.apply,
        first.draft.discard_edits,
        first.draft.undo.undo,
    )
    for wire, end in enumerate(ends, 15):
        first.edit(serial_timeout=wire)
        assert len(files()) == 1
        end()
        first.until(lambda: not first.device.writer.running)
        first.settle()
        assert files() == []


def test_undecided_edits_stay_saved_with_new_edits(run: Start) -> None:
    run().edit(serial_timeout=15, motor1_acceleration=3)
    run().edit(motor1_acceleration=4, motor2_acceleration=5)
    third = run()
    edits = {"serial_timeout": 15, "motor1_acceleration": 4, "motor2_acceleration": 5}
    assert third.offered == edits
    third.edit(serial_timeout=20)
    third.backup.restore()
    assert third.edits == {**edits, "serial_timeout": 20}, "the newer edit wins"


def test_edits_of_a_board_are_offered_when_it_is_connected_again(
    run: Start, quick_simulator: SimulatedDevice, start_simulator: StartSimulator
) -> None:
    second_board = start_simulator("--unpaced", "--model", "trexjr")
    first = run()
    first.edit(serial_timeout=15)
    first.connect(second_board.url)
    assert first.draft.pending == 0
    assert first.backup.offer is None
    first.edit(serial_timeout=9)
    first.connect()
    assert first.offered == {"serial_timeout": 15}
    first.backup.restore()
    first.settle()
    first.connect(second_board.url)
    assert first.offered == {"serial_timeout": 9}


@pytest.mark.parametrize("packets", sampled([*range(0, 36, 6), *range(36, 52)], every=4))
def test_no_edit_is_lost_if_another_model_replies_during_apply(
    run: Start,
    quick_simulator: VirtualSimulator,
    start_simulator: StartSimulator,
    packets: int,
) -> None:
    second_board = start_simulator("--unpaced", "--model", "trexjr")
    assert isinstance(second_board, VirtualSimulator)
    first = run()
    edits = {"serial_timeout": 15, "motor1_acceleration": 3, "motor2_acceleration": 4}
    first.edit(**edits)
    sent = itertools.count()

    def exchange_boards(_data: bytes) -> None:
        if next(sent) == packets:
            quick_simulator.on_write = lambda _data: None
            quick_simulator.move_cable_to(second_board)

    first.device.writer.apply()
    quick_simulator.on_write = exchange_boards
    first.until(lambda: not first.device.writer.running)
    first.settle()
    stored = quick_simulator.show()["parameters"]
    first.connect()
    missing = {key: wire for key, wire in edits.items() if stored[key] != wire}
    assert first.offered == missing


def test_failed_factory_reset_discards_no_edit(
    run: Start, quick_simulator: VirtualSimulator
) -> None:
    first = run()
    first.edit(serial_timeout=15)
    quick_simulator.do("eeprom motor1_acceleration 9")  # as in another board
    first.device.writer.reset_to_factory()
    first.until(lambda: not first.device.writer.running)
    assert dict(first.device.draft.parameters.values.pending) == {"serial_timeout": 15}
    first.device.writer.reset_to_factory()
    first.until(lambda: not first.device.writer.running)
    assert not first.device.draft.pending


def test_edits_are_not_offered_to_a_board_with_another_number(
    run: Start, start_simulator: StartSimulator
) -> None:
    run().edit(serial_timeout=15)
    second_board = start_simulator("--unpaced", "--device", "9")
    assert run(second_board).offered == {}
    assert run().offered == {"serial_timeout": 15}


def test_edits_follow_the_new_number_of_a_board(run: Start) -> None:
    first = run()
    first.edit(device_number=9, serial_timeout=15)
    (path,) = files()
    path.with_name("trex-1.2-9.txt").write_text("edits of another board", encoding="utf-8")
    record = data_folder() / "boards" / "trex-1.2-9.txt"
    record.write_text("notes of another board", encoding="utf-8")
    messages = list[str]()
    first.device.notifier.info.connect(messages.append)
    first.device.writer.apply({"device_number"})
    first.until(lambda: len(messages) == 2)
    first.settle()
    moved, replaced = sorted(files(), key=lambda file: len(file.name))
    assert moved.name == "trex-1.2-9.txt"
    assert replaced.read_text(encoding="utf-8") == "edits of another board"
    replaced_record = record.with_name("trex-1.2-9.replaced-1.txt")
    assert all(str(file) in messages[-1] for file in (replaced, replaced_record))
    assert run().offered == {"serial_timeout": 15}


def test_calibrations_of_the_other_source_stay_saved(
    run: Start, quick_simulator: SimulatedDevice
) -> None:
    first = run()
    first.edit_calibration()
    quick_simulator.do("eeprom channel_input_source 1", "power cycle")
    second = run()
    assert second.offered == {}
    second.edit(serial_timeout=15)
    quick_simulator.do("eeprom channel_input_source 0", "power cycle")
    assert run().offered == {"serial_timeout": 15, RC_2: STICK}


def test_edit_of_an_unread_setting_is_offered_later(run: Start) -> None:
    first = run()
    first.edit(serial_timeout=15, motor1_acceleration=3)
    state = first.device.state
    assert state is not None
    parameters = {
        key: state.parameters[key] for key in state.parameters.keys() - {"serial_timeout"}
    }
    for reading in (replace(state, parameters=parameters), state):
        first.backup.close_board()
        first.draft.set_state(reading, first.device.settings, power_cycled=False)
        first.backup.set_board(opened=False)
        first.settle()
        if reading is not state:
            assert first.edits == {"motor1_acceleration": 3}
            assert first.offered == {}
    assert first.offered == {"serial_timeout": 15}
    first.backup.restore()
    assert first.edits == {"serial_timeout": 15, "motor1_acceleration": 3}


def test_discarded_calibration_of_the_other_source_is_deleted(
    run: Start, quick_simulator: SimulatedDevice
) -> None:
    first = run()
    first.edit_calibration()
    quick_simulator.do("eeprom channel_input_source 1", "power cycle")
    first.connect()
    assert first.draft.pending == 1
    first.draft.discard_edits()
    first.settle()
    assert files() == []


def test_damaged_file_is_ignored(run: Start) -> None:
    run().edit(serial_timeout=15)
    (path,) = files()
    path.write_bytes(b"\0\0")
    second = run()
    assert second.offered == {}
    assert path.exists()
    second.edit(serial_timeout=20)
    assert run().offered == {"serial_timeout": 20}


def test_failing_disk_is_reported_once(run: Start, monkeypatch: pytest.MonkeyPatch) -> None:
    first = run()
    errors: list[str] = []
    first.device.notifier.error.connect(errors.append)
    folder = EditFiles().folder
    folder.write_text("")
    first.edit(serial_timeout=15)
    first.edit(serial_timeout=16)
    (error,) = errors
    assert error.startswith("Unapplied edits cannot be saved for the next start.")
    folder.unlink()
    first.edit(serial_timeout=17)
    assert len(files()) == 1


def test_edits_in_an_unusable_folder_cannot_be_removed(tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.touch()
    with pytest.raises(SettingsError):
        EditFiles(file).save(TREX, None)


def test_edits_are_saved_at_shutdown_if_saving_failed_before(run: Start) -> None:
    first = run()
    folder = EditFiles().folder
    folder.write_text("")
    first.edit(serial_timeout=15)
    folder.unlink()
    assert first.backup.files.shut_down()
    saved = EditFiles().load(TREX)
    assert saved is not None
    assert saved.settings.parameters["serial_timeout"] == 15


def test_edits_of_a_simulated_board_are_saved_separately() -> None:
    stored = factory_settings(device_table().model("trex"), "1.2")
    real, simulated = BoardIdentity.of(stored), BoardIdentity.of(stored, is_simulated=True)
    assert EditFiles().path(real) != EditFiles().path(simulated)


def test_edits_are_saved_every_second_while_more_are_made(
    run: Start, virtual_time: VirtualRuntime
) -> None:
    first = run()
    for wire in range(1, 40):
        first.device.parameters.edit("serial_timeout", wire)
        virtual_time.advance(0.05)
    saved = EditFiles().load(TREX)
    assert saved is not None
    assert saved.settings.parameters["serial_timeout"] >= 20


def test_backup_needs_no_board(qtbot: QtBot) -> None:
    device = Device()
    backup = EditBackup(device.draft)
    backup.close_board()
    backup.set_board(opened=True)
    backup.restore()
    backup.discard()
    assert backup.files.shut_down()
