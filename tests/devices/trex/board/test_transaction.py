"""Write of settings, with its files on a disk."""

from pathlib import Path

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

KIND = Signature(device_table().model("trex"), "1.2")
STATE = DeviceState(
    KIND,
    Mode.SERIAL_RC,
    True,
    {"device_number": 7, "serial_timeout": 0, "uart_error_shutdown": 1, "motor_mode": 0},
    dict.fromkeys(range(1, 6), DEFAULT_CALIBRATION[InputSource.RC]),
    calibrated=0,
)
LINK = ConnectionSettings("/dev/ttyUSB0")


class RecordingKeeper(Keeper):
    """A keeper with a list of its messages."""

    def __init__(self, state: DeviceState = STATE) -> None:
        self.said: list[str] = []
        self.warned: list[str] = []
        super().__init__(self.said.append, self.warned.append)
        self.memory.set_board(settings_of(state), state.source, utc_now(), opened=True)
        self.load()

    def finish(self, results: list[WriteResult]) -> None:
        keys = [(result.key, 0) for result in results]
        write = self.prepare(STATE, LINK, "a test", keys)
        write.finish(results, after_writing(STATE, results), utc_now())


def record_of(name: str) -> str:
    return (BoardRecords().folder / f"{name}.txt").read_text("utf-8")


def test_snapshot_has_reason_and_adapter() -> None:
    kept = RecordingKeeper()
    kept.prepare(STATE, LINK, "a test", [("serial_timeout", 5)])
    (snapshot,) = (data_folder() / "snapshots").glob("*.txt")
    assert {"# reason: a test", "# adapter: /dev/ttyUSB0"} <= {*snapshot.read_text().splitlines()}
    assert str(snapshot) in kept.said[0]


def test_only_verified_values_are_expected_and_accepted() -> None:
    results = [
        WriteResult("serial_timeout", error=NoReply("silent")),
        WriteResult("uart_error_shutdown", 2),  # beyond its limit
        WriteResult("motor_mode", 1),
    ]
    kept = RecordingKeeper()
    kept.finish(results)
    record = kept.memory.record
    assert record is not None
    assert dict(record.settings.parameters) == {
        "device_number": 7, "uart_error_shutdown": 2, "motor_mode": 1
    }  # fmt: skip
    assert AcceptedValues().of(KIND) == {"uart_error_shutdown": {2}}
    assert kept.said[1:] == ["Recorded as accepted by a TReX 1.2: uart_error_shutdown 2."]


def test_reset_expects_nothing_of_the_parameters() -> None:
    kept = RecordingKeeper()
    kept.finish([WriteResult("serial_timeout", 5)])
    kept.finish([WriteResult(ParameterKey.FACTORY_RESET, 1)])
    assert kept.memory.record is not None
    assert not kept.memory.record.settings.parameters


def test_record_of_another_board_with_the_number_is_put_aside() -> None:
    kept = RecordingKeeper()
    other = BoardRecords().folder / "trex-1.2-9.txt"
    other.write_text("of another board", "utf-8")
    kept.finish([WriteResult("device_number", 9)])
    aside = other.with_name("trex-1.2-9.replaced-1.txt")
    assert aside.read_text("utf-8") == "of another board"
    assert f"is in {aside}." in kept.said[-1]
    assert "device_number: 9" in record_of("trex-1.2-9")
    assert not (BoardRecords().folder / "trex-1.2-7.txt").exists()


def test_failed_save_is_reported_once(tmp_path: Path) -> None:
    del tmp_path
    folder = BoardRecords().folder
    folder.parent.mkdir(parents=True, exist_ok=True)
    folder.write_text("not a folder")
    kept = RecordingKeeper()
    kept.finish([WriteResult("serial_timeout", 5)])
    assert [text.partition(".")[0] for text in kept.warned] == [
        "The applied settings were not saved"
    ]


@pytest.mark.parametrize("tried", [3, 4])
def test_board_with_many_differences_is_not_restored(tried: int) -> None:
    harness, settings = create_harness()
    client = harness.client(settings)
    state = read_everything(client.request)
    kept, is_restored = RecordingKeeper(state), tried < 4
    before = kept.memory.record
    keys = ("serial_timeout", "motor_mode", "motor1_acceleration", "motor2_acceleration")
    with kept.restored_afterwards(client, state, "a trial") as store:
        for key in keys[:tried]:
            store(state.specs[key], 1)
    assert (read_everything(client.request) == state) is is_restored
    assert (kept.memory.record == before) is is_restored
    assert ("The settings in the board may have changed" in " ".join(kept.said)) is not is_restored


@pytest.mark.parametrize("text", ["product: TReX\n!", "product: TReX Jr\n"])
def test_damaged_record_is_not_used(text: str) -> None:
    path = BoardRecords().folder / "trex-1.2-7.txt"
    path.parent.mkdir(parents=True)
    path.write_text(text, "utf-8")
    kept = RecordingKeeper()
    assert kept.warned[0].startswith("The settings last applied to this board are unknown. ")
    assert kept.memory.record is not None
