"""State of a board after its replies and later writes."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.core.errors import NoReply
from trex_gui.core.session import Outcome
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.writing import WriteResult, after_writing
from trex_gui.devices.trex.model.connection import Connection
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.calibration import (
    DEFAULT_CALIBRATION,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import InputSource, Mode, channel_mask
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.session.messages import Connected, ReadReason, Written
from trex_gui.ui.runtime import runtime

FACTORY = DEFAULT_CALIBRATION[InputSource.RC]
LEARNED = Calibration(2400, 3700, 5100, 80)
STATE = DeviceState(
    Signature(device_table().model("trex"), "1.2"),
    Mode.SERIAL_RC,
    True,
    {"motor_mode": 0, "serial_timeout": 0},
    dict.fromkeys(range(1, 6), FACTORY),
    calibrated=0,
)


def test_verified_writes_update_the_board_state() -> None:
    after = after_writing(
        STATE, [WriteResult("motor_mode", 1), WriteResult(CalibrationKey.RC_CHANNEL_2, LEARNED)]
    )
    assert after.parameters == {"motor_mode": 1, "serial_timeout": 0}
    assert after.calibrations[2] == LEARNED
    assert after.calibrations[1] == FACTORY
    assert after.calibrated == channel_mask({2})
    assert STATE.parameters["motor_mode"] == 0


def test_factory_calibration_counts_as_uncalibrated() -> None:
    learned = after_writing(STATE, [WriteResult(CalibrationKey.RC_CHANNEL_2, LEARNED)])
    assert (
        after_writing(learned, [WriteResult(CalibrationKey.RC_CHANNEL_2, FACTORY)]).calibrated == 0
    )


@pytest.mark.parametrize(
    "result",
    [
        WriteResult("motor_mode", error=NoReply("x")),
        WriteResult(CalibrationKey.RC_CHANNEL_2, error=NoReply("x")),
        WriteResult("factory_reset", 1),  # not a readable parameter
    ],
)
def test_unverified_result_does_not_change_the_state(result: WriteResult) -> None:
    assert after_writing(STATE, [result]) == STATE


@pytest.mark.parametrize(("key", "channel"), [("rc_channel_3", 3), ("channel_input_source", None)])
def test_write_result_gives_its_channel(key: str, channel: int | None) -> None:
    assert WriteResult(key).channel == channel


def test_active_values_come_from_the_line_settings() -> None:
    line = LineSettings(57600, Detection.CRC7)
    shown = STATE.active_parameters(ConnectionSettings("virtual", line, polynomial=0x91))
    assert shown == {
        "uart_settings": line.to_wire(),
        "crc7_polynomial": 0x11,
        "channel_input_source": 0,
    }
    assert "crc7_polynomial" not in STATE.active_parameters(ConnectionSettings("virtual"))
    assert replace(STATE, mode=Mode.ANALOG).active_parameters(None) == {}


@pytest.mark.usefixtures("qapp")
def test_current_unit_follows_another_model_on_the_same_line() -> None:
    device, link = Device(), ConnectionSettings("virtual", name="virtual")
    device.connection.device_read.emit(Connected(STATE, False, ReadReason.OPENED, link))
    assert device.telemetry.ampere == pytest.approx(0.15)
    jr = replace(STATE, signature=Signature(device_table().model("trexjr"), "1.2"))
    device.connection.device_read.emit(Connected(jr, False, ReadReason.RESTARTED, link))
    assert device.telemetry.ampere == pytest.approx(0.04)
    runtime().sleep(1.0)  # reading the files of the board ends


# --- Pending factory reset --------------------------------------------------------------

DraftAfter = Callable[[WriteResult], SettingsDraft]


@pytest.fixture
def draft_after(qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> DraftAfter:
    """Return a function that writes with this result and returns the draft."""
    devices = []

    def write(result: WriteResult) -> SettingsDraft:
        link = ConnectionSettings("virtual", name="virtual")
        outcome = Outcome(1, Written((result,), STATE, link))
        monkeypatch.setattr(Connection, "is_open", True)
        monkeypatch.setattr(Connection, "request", lambda _self, _make, then: then(outcome) or True)
        devices.append(device := Device())
        device.connection.device_read.emit(Connected(STATE, False, ReadReason.OPENED, link))
        with qtbot.waitSignal(device.applied):
            device.writer.write("test", (("motor_mode", 1),))
        return device.draft

    return write


def test_accepted_reset_is_pending_until_the_next_start(draft_after: DraftAfter) -> None:
    assert not draft_after(WriteResult("factory_reset", error=NoReply("x"))).reset_pending
    assert not draft_after(WriteResult("motor_mode", 1)).reset_pending
    changed = replace(STATE, parameters={**STATE.parameters, "motor_mode": 1})
    for state, power_cycled in ((STATE, True), (changed, False)):
        draft = draft_after(WriteResult("factory_reset", 1))
        draft.set_state(STATE, None, power_cycled=False)
        assert draft.reset_pending
        draft.set_state(state, None, power_cycled=power_cycled)
        assert not draft.reset_pending
