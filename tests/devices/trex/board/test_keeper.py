"""Files that a keeper saves when settings are written."""

import pytest

from tests.devices.trex.session.helpers import create_harness
from trex_gui.core.errors import NoReply
from trex_gui.core.files import data_folder
from trex_gui.devices.trex.board.keeper import Keeper
from trex_gui.devices.trex.client.reading import DeviceState, read_everything
from trex_gui.devices.trex.client.writing import WriteResult, after_writing
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import InputSource, Mode
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.accepted import AcceptedValues
from trex_gui.devices.trex.settings.board_records import BoardRecords, utc_now
from trex_gui.devices.trex.settings.document import settings_of
from trex_gui.devices.trex.settings.edit_files import BoardIdentity

SIGNATURE = Signature(device_table().model("trex"), "1.2")
STATE = DeviceState(
    SIGNATURE,
    Mode.SERIAL_RC,
    True,
    {"device_number": 7, "serial_timeout": 0, "uart_error_shutdown": 1, "motor_mode": 0},
    dict.fromkeys(range(1, 6), DEFAULT_CALIBRATION[InputSource.RC]),
    calibrated=0,
)
BOARD = BoardIdentity.of(settings_of(STATE))
CONNECTION = ConnectionSettings("/dev/ttyUSB0")


class RecordingKeeper(Keeper):
    """Keeper with lists of its messages and warnings."""

    def __init__(self, state: DeviceState = STATE) -> None:
        self.messages: list[str] = []
        self.warnings: list[str] = []
        super().__init__(self.messages.append, self.warnings.append)
        self.memory.set_board(settings_of(state), state.source, utc_now(), opened=True)
        self.load()

    def finish(self, results: list[WriteResult]) -> None:
        keys = [(result.key, 0) for result in results]
        write = self.prepare(STATE, CONNECTION, "a test", keys)
        write.finish(results, after_writing(STATE, results), utc_now())


def test_snapshot_has_reason_and_adapter() -> None:
    keeper = RecordingKeeper()
    keeper.prepare(STATE, CONNECTION, "a test", [("serial_timeout", 5)])
    (snapshot,) = (data_folder() / "snapshots").glob("*.txt")
    assert {"# reason: a test", "# adapter: /dev/ttyUSB0"} <= {*snapshot.read_text().splitlines()}
    assert str(snapshot) in keeper.messages[0]


def test_only_verified_values_are_expected_and_accepted() -> None:
    results = [
        WriteResult("serial_timeout", error=NoReply("silent")),
        WriteResult("uart_error_shutdown", 2),  # outside its limits
        WriteResult("motor_mode", 1),
    ]
    keeper = RecordingKeeper()
    keeper.finish(results)
    record = keeper.memory.record
    assert record is not None
    assert dict(record.settings.parameters) == {
        "device_number": 7, "uart_error_shutdown": 2, "motor_mode": 1
    }  # fmt: skip
    assert AcceptedValues().of(SIGNATURE) == {"uart_error_shutdown": {2}}
    assert keeper.messages[1:] == ["Recorded as accepted by a TReX 1.2: uart_error_shutdown 2."]


def test_factory_reset_clears_the_expected_parameters() -> None:
    keeper = RecordingKeeper()
    keeper.finish([WriteResult("serial_timeout", 5)])
    keeper.finish([WriteResult(ParameterKey.FACTORY_RESET, 1)])
    assert keeper.memory.record is not None
    assert not keeper.memory.record.settings.parameters


def test_record_of_another_board_with_the_number_is_set_aside() -> None:
    keeper = RecordingKeeper()
    record = BoardRecords().folder / "trex-1.2-9.txt"
    record.write_text("of another board", "utf-8")
    keeper.finish([WriteResult("device_number", 9)])
    replaced = record.with_name("trex-1.2-9.replaced-1.txt")
    assert replaced.read_text("utf-8") == "of another board"
    assert f"is in {replaced}." in keeper.messages[-1]
    assert "device_number: 9" in record.read_text("utf-8")
    assert not (BoardRecords().folder / "trex-1.2-7.txt").exists()


def test_keepers_of_one_board_retain_the_notes_of_each_other() -> None:
    keepers = RecordingKeeper(), RecordingKeeper()
    for keeper, key in zip(keepers, ("serial_timeout", "motor_mode"), strict=True):
        keeper.memory.set_notes({key: "a note"})
    record = BoardRecords().load(BOARD)
    assert record is not None
    assert record.settings.notes.keys() == {"serial_timeout", "motor_mode"}
    RecordingKeeper().memory.set_notes({})
    record = BoardRecords().load(BOARD)
    assert record is not None
    assert not record.settings.notes, "the notes were removed"


def test_failed_save_is_reported_once() -> None:
    folder = BoardRecords().folder
    folder.parent.mkdir(parents=True, exist_ok=True)
    folder.write_text("not a folder")
    keeper = RecordingKeeper()
    keeper.finish([WriteResult("serial_timeout", 5)])
    assert [text.partition(".")[0] for text in keeper.warnings] == [
        "The applied settings were not saved"
    ]


@pytest.mark.parametrize("changes", [3, 4])
def test_board_with_many_differences_is_not_restored(changes: int) -> None:
    harness, settings = create_harness()
    client = harness.client(settings)
    state = read_everything(client.request)
    keeper, is_restored = RecordingKeeper(state), changes < 4
    before = keeper.memory.record
    keys = ("serial_timeout", "motor_mode", "motor1_acceleration", "motor2_acceleration")
    with keeper.restored_afterwards(client, state, "a trial") as store:
        for key in keys[:changes]:
            store(state.specs[key], 1)
    assert (read_everything(client.request) == state) is is_restored
    assert (keeper.memory.record == before) is is_restored
    is_reported = "The settings in the board may have changed" in " ".join(keeper.messages)
    assert is_reported is not is_restored


@pytest.mark.parametrize("text", ["product: TReX\n!", "product: TReX Jr\n"])
def test_damaged_record_is_not_used(text: str) -> None:
    path = BoardRecords().folder / "trex-1.2-7.txt"
    path.parent.mkdir(parents=True)
    path.write_text(text, "utf-8")
    keeper = RecordingKeeper()
    assert keeper.warnings[0].startswith("The settings last applied to this board are unknown. ")
    assert keeper.memory.record is not None
