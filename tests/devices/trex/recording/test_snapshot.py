"""State of a board at a time of a recording."""

from copy import copy

from trex_gui.core.recording.kinds import Marker
from trex_gui.devices.trex.client.telemetry import Control, Currents
from trex_gui.devices.trex.protocol.driving import Direction, Drive
from trex_gui.devices.trex.recording import (
    STOP,
    AuxiliarySetpointRecord,
    BoardSnapshot,
    SetpointRecord,
    SettingsSnapshot,
)

FORWARD = Drive(Direction.FORWARD, 40)


def test_stop_removes_only_the_setpoints() -> None:
    state = BoardSnapshot()
    records = (
        Currents(1.0, (1, 2)),
        Currents(2.0, (3, 4)),
        Control(2.0, True),
        SetpointRecord(2.0, 1, FORWARD),
        AuxiliarySetpointRecord(2.0, 30),
        SettingsSnapshot(2.0, "product: TReX\n"),
        Marker(2.0, "apply", ""),
    )
    for record in records:
        state.update(record)
    before = copy(state)
    assert (before.setpoints, before.auxiliary) == ({1: FORWARD}, 30)
    state.update(Marker(3.0, STOP, ""))
    assert (state.setpoints, state.auxiliary) == ({}, None)
    assert (before.setpoints, before.auxiliary) == ({1: FORWARD}, 30)
    for snapshot in (before, state):
        assert snapshot[Currents].counts == (3, 4)
        assert snapshot[Control].by_serial
        assert snapshot.settings == "product: TReX\n"
