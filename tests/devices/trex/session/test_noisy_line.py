"""Writes over a line without CRC that corrupts one byte in a hundred."""

import pytest

from tests.support.matrix import sampled
from tests.support.virtual import SessionHarness
from trex_gui.core.errors import BadReply, NoReply, StudioError
from trex_gui.core.session import Close, Closed, Outcome
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.session.messages import Connected, Reload, Report, Write, Written
from trex_gui.devices.trex.session.session import TrexSession
from trex_gui.devices.trex.simulator.firmware import Board

_LEARNED = Calibration(2400, 3700, 5100, 60)
_PARAMETERS = (("motor1_acceleration", 3), ("serial_timeout", 15))
_CALIBRATIONS = ((CalibrationKey.RC_CHANNEL_3, _LEARNED),)


@pytest.mark.parametrize("seed", sampled(range(100), every=20))
def test_reported_settings_equal_settings_of_the_board(harness: SessionHarness, seed: int) -> None:
    board = harness.board
    board.eeprom.write("motor1_current_limit", 20)
    board.eeprom.write_calibration(InputSource.RC, 2, _LEARNED)
    harness.line.faults._random.seed(seed)
    harness.line.faults.noise = 0.01
    harness.script.at(1.0, Write(1, _PARAMETERS, _CALIBRATIONS)).at(2.5, Reload(2))
    harness.script.at(4.0, Close())
    requested: dict[str, object] = {**dict(_PARAMETERS), **dict(_CALIBRATIONS)}
    written: dict[str, object] = {}
    reported: list[DeviceState] = []
    stored: list[tuple[dict[str, int], dict[int, Calibration]]] = []
    closed: list[StudioError | None] = []

    def record(report: Report) -> None:
        match report:
            case Connected(state=state):
                reported.append(state)
                stored.append(stored_settings(board))
            case Outcome(value=Written(state=state, results=results)):
                reported.append(state)
                stored.append(stored_settings(board))
                written.update(
                    {result.key: result.stored for result in results if result.error is None}
                )
            case Closed(error=error):
                closed.append(error)

    settings = ConnectionSettings("virtual")
    TrexSession(settings, harness.script, record, lambda _settings: harness.transport).run()
    assert written.items() <= requested.items()
    for state, (parameters, calibrations) in zip(reported, stored, strict=True):
        assert state.parameters.items() <= parameters.items()
        assert state.calibrations == calibrations
    assert closed == [None] or isinstance(closed[0], BadReply | NoReply)


def stored_settings(board: Board) -> tuple[dict[str, int], dict[int, Calibration]]:
    return board.memory.stored(), {channel: board.calibration(channel) for channel in CHANNELS}
