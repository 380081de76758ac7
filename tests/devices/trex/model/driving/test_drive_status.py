"""Why the motors do not follow the setpoints, in one line."""

import itertools
from collections.abc import Iterator, Sequence
from typing import Any

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import (
    DriveBlocker,
    DriveInputs,
    drive_inputs,
    drive_status,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.flags import Mode, UartError
from trex_gui.ui.devices.connection import ConnectionState

pytestmark = pytest.mark.usefixtures("qapp")  # plural forms


@pytest.mark.parametrize(
    ("situation", "kind", "said"),
    [
        (DriveInputs(link=ConnectionState.DISCONNECTED), DriveBlocker.NO_BOARD, "No board"),
        (
            DriveInputs(link=ConnectionState.DISCONNECTED, may_move=True),
            DriveBlocker.LOST,
            "Cut their power.",
        ),
        (
            DriveInputs(link=ConnectionState.DISCONNECTED, may_move=True, timeout="0.5 s"),
            DriveBlocker.LOST,
            "stops them 0.5 s after the last byte",
        ),
        (
            DriveInputs(link=ConnectionState.DISCONNECTED, lost_board="It got no stop."),
            DriveBlocker.LOST,
            "It got no stop.",
        ),
        (
            DriveInputs(link=ConnectionState.NOT_RESPONDING, may_move=True, timeout="0.5 s"),
            DriveBlocker.SILENT,
            "stops them 0.5 s after the last byte",
        ),
        (DriveInputs(link=ConnectionState.CONNECTING), DriveBlocker.OPENING, "being read"),
        (DriveInputs(link=ConnectionState.DISCONNECTING), DriveBlocker.CLOSING, "closed"),
        (DriveInputs(link=ConnectionState.NOT_RESPONDING), DriveBlocker.SILENT, "does not respond"),
        (DriveInputs(mode=None), DriveBlocker.UNKNOWN, "not reported yet"),
        (DriveInputs(by_serial=None), DriveBlocker.UNKNOWN, "not reported yet"),
        (DriveInputs(by_serial=False), DriveBlocker.NOT_SERIAL, "serial commands do not"),
        (DriveInputs(mode=Mode.RC, by_serial=False), DriveBlocker.CHANNELS, "The RC channels"),
        (
            DriveInputs(mode=Mode.ANALOG, by_serial=False),
            DriveBlocker.CHANNELS,
            "The analog channels",
        ),
        (
            DriveInputs(mode=Mode.RC, by_serial=False, missing=(1,)),
            DriveBlocker.SAFE_START,
            "channel 1 is required but has no signal",
        ),
        (
            DriveInputs(mode=Mode.RC, by_serial=False, missing=(1, 2, 4)),
            DriveBlocker.SAFE_START,
            "channels 1, 2, 4 are required but have no signal",
        ),
        (
            DriveInputs(mode=Mode.RC, by_serial=False, perhaps_held=True),
            DriveBlocker.CHANNELS,
            "Safe-start may be holding",
        ),
        (DriveInputs(locked_for=2.2), DriveBlocker.LOCKED, "locked for 3 s"),
        (DriveInputs(faults=(1,)), DriveBlocker.FAULT, "Motor 1"),
        (DriveInputs(faults=(1, 2), armed=True), DriveBlocker.FAULT, "Both motors"),
        (
            DriveInputs(uart=UartError.TIMEOUT, timeout="0.5 s"),
            DriveBlocker.TIMEOUT,
            "nothing for 0.5 s",
        ),
        (
            DriveInputs(uart=UartError.PARITY, error_shutdown=True),
            DriveBlocker.LINE_ERROR,
            "corrupted",
        ),
        (DriveInputs(uart=UartError.PARITY), DriveBlocker.NOT_ARMED, "Not armed"),
        (DriveInputs(is_available=False), DriveBlocker.NOT_ALLOWED, "cannot be armed"),
        (DriveInputs(), DriveBlocker.NOT_ARMED, "nothing is sent yet"),
        (
            DriveInputs(stop_reason="The gamepad is gone."),
            DriveBlocker.STOPPED,
            "The gamepad is gone.",
        ),
        (
            DriveInputs(armed=True, over_limit=(2,)),
            DriveBlocker.OVER_LIMIT,
            "Motor 2 is slowed down",
        ),
        (DriveInputs(over_limit=(2,)), DriveBlocker.NOT_ARMED, "Not armed"),
        (DriveInputs(armed=True), DriveBlocker.RUNNING, "armed"),
        (DriveInputs(armed=True, joint=True), DriveBlocker.RUNNING, "Joint mode"),
        (DriveInputs(mode=Mode.RC, armed=True), DriveBlocker.RUNNING, "Channel 5 overrides"),
    ],
)
def test_reason_explains_the_situation(
    situation: DriveInputs, kind: DriveBlocker, said: str
) -> None:
    status = drive_status(situation)
    assert status.blocker is kind
    assert said in f"{status.text} {status.remedy}"


_VALUES: dict[str, Sequence[Any]] = {
    "link": tuple(ConnectionState),
    "may_move": (False, True),
    "mode": (None, *Mode),
    "by_serial": (None, False, True),
    "joint": (False, True),
    "missing": ((), (1,)),
    "faults": ((), (2,)),
    "over_limit": ((), (1,)),
    "uart": (UartError(0), UartError.TIMEOUT, UartError.CRC),
    "locked_for": (0.0, 1.5),
    "is_available": (False, True),
    "armed": (False, True),
}


def everything() -> Iterator[DriveInputs]:
    for values in itertools.product(*_VALUES.values()):
        yield DriveInputs(error_shutdown=True, **dict(zip(_VALUES, values, strict=True)))
    yield DriveInputs(stop_reason="The gamepad is gone.")
    yield DriveInputs(mode=Mode.RC, by_serial=False, perhaps_held=True)


def test_every_situation_has_sentences_and_is_obeyed_rightly() -> None:
    met = set()
    for now in everything():
        status = drive_status(now)
        assert status.text.endswith("."), now
        assert not status.remedy or status.remedy.endswith("."), now
        obeyed = (
            now.link is ConnectionState.CONNECTED
            and now.mode is not None
            and now.by_serial is True
            and now.armed
            and not now.faults
            and not now.uart
        )
        assert status.blocker.is_obeyed is obeyed, now
        met.add(status.blocker)
    assert met == set(DriveBlocker)


# --- What the models know ---------------------------------------------------------------


def test_situation_follows_the_override_switch(
    rc_device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    assert drive_inputs(rc_device).by_serial is False
    assert "may be holding" not in drive_status(drive_inputs(rc_device)).text
    rc_board.do("channel 5 1000us")
    qtbot.waitUntil(lambda: drive_inputs(rc_device).by_serial is True)
    assert drive_status(drive_inputs(rc_device)).blocker is DriveBlocker.NOT_ARMED


def test_channel_is_missing_only_after_it_was_read(
    rc_device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    assert rc_device.telemetry.raw is None
    assert drive_inputs(rc_device).missing == ()
    for channel in (1, 2):  # the board requires the first of them
        rc_board.do(f"channel {channel} silent")
    qtbot.waitUntil(lambda: drive_inputs(rc_device).missing == (1,))


def test_fault_names_the_motor_that_has_it(
    rc_device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    rc_board.do("fault 2 on")
    qtbot.waitUntil(lambda: drive_inputs(rc_device).faults == (2,))


def test_situation_includes_the_serial_timeout_of_the_board(
    device: Device, quick_simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    assert drive_inputs(device).timeout == ""
    quick_simulator.do("eeprom serial_timeout 5")
    quick_simulator.do("power cycle")
    device.connect_to(ConnectionSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: drive_inputs(device).timeout == "0.5 s")
