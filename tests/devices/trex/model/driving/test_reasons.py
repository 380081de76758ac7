"""The one line that says why motors do not do what is asked."""

import itertools

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.model.connection import Link
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.driving.drive_status import (
    Kind,
    Situation,
    reason_for,
    situation_of,
)
from trex_gui.devices.trex.protocol.connection_settings import LinkSettings
from trex_gui.devices.trex.protocol.flags import Mode, UartError


@pytest.mark.parametrize(
    ("situation", "kind", "said"),
    [
        (Situation(link=Link.NONE), Kind.NO_BOARD, "No board"),
        (Situation(link=Link.OPENING), Kind.OPENING, "being read"),
        (Situation(link=Link.CLOSING), Kind.CLOSING, "closed"),
        (Situation(link=Link.SILENT), Kind.SILENT, "does not answer"),
        (Situation(mode=None), Kind.UNKNOWN, "not said yet"),
        (Situation(by_serial=None), Kind.UNKNOWN, "not said yet"),
        (Situation(by_serial=False), Kind.NOT_SERIAL, "serial commands do not"),
        (Situation(mode=Mode.RC, by_serial=False), Kind.CHANNELS, "The RC channels"),
        (Situation(mode=Mode.ANALOG, by_serial=False), Kind.CHANNELS, "The analog channels"),
        (
            Situation(mode=Mode.RC, by_serial=False, missing=(1,)),
            Kind.SAFE_START,
            "channel 1 is required and has no signal",
        ),
        (
            Situation(mode=Mode.RC, by_serial=False, missing=(1, 2, 4)),
            Kind.SAFE_START,
            "channels 1, 2 and 4 are required and have no signal",
        ),
        (
            Situation(mode=Mode.RC, by_serial=False, perhaps_held=True),
            Kind.CHANNELS,
            "perhaps held by safe-start",
        ),
        (Situation(locked_for=2.2), Kind.LOCKED, "locked for 3 s"),
        (Situation(faults=(1,)), Kind.FAULT, "Motor 1"),
        (Situation(faults=(1, 2), armed=True), Kind.FAULT, "Motors 1 and 2"),
        (Situation(uart=UartError.TIMEOUT, timeout="0.5 s"), Kind.TIMEOUT, "nothing for 0.5 s"),
        (Situation(uart=UartError.PARITY, error_shutdown=True), Kind.LINE_ERROR, "damaged"),
        (Situation(uart=UartError.PARITY), Kind.NOT_ARMED, "Not armed"),
        (Situation(can_arm=False), Kind.NOT_ALLOWED, "cannot be armed"),
        (Situation(), Kind.NOT_ARMED, "nothing is sent yet"),
        (Situation(stop_reason="The gamepad is gone."), Kind.NOT_ARMED, "The gamepad is gone."),
        (Situation(armed=True, over_limit=(2,)), Kind.OVER_LIMIT, "Motor 2 is slowed down"),
        (Situation(over_limit=(2,)), Kind.NOT_ARMED, "Not armed"),
        (Situation(armed=True), Kind.RUNNING, "armed"),
        (Situation(armed=True, joint=True), Kind.RUNNING, "Joint mode"),
        (Situation(mode=Mode.RC, armed=True), Kind.RUNNING, "Channel 5 overrides"),
    ],
)
def test_reason_explains_the_situation(situation: Situation, kind: Kind, said: str) -> None:
    reason = reason_for(situation)
    assert reason.kind is kind
    assert said in reason.text


_EVERYTHING = [
    Situation(
        link=link,
        mode=mode,
        by_serial=by_serial,
        joint=joint,
        missing=missing,
        faults=faults,
        over_limit=over_limit,
        uart=uart,
        error_shutdown=True,
        locked_for=locked,
        can_arm=can_arm,
        armed=armed,
    )
    for link, mode, by_serial, joint, missing, faults, over_limit, uart, locked, can_arm, armed in (
        itertools.product(
            Link,
            (None, *Mode),
            (None, False, True),
            (False, True),
            ((), (1,)),
            ((), (2,)),
            ((), (1,)),
            (UartError(0), UartError.TIMEOUT, UartError.CRC),
            (0.0, 1.5),
            (False, True),
            (False, True),
        )
    )
]


def test_every_situation_gives_a_sentence() -> None:
    for situation in _EVERYTHING:
        reason = reason_for(situation)
        assert reason.text.endswith("."), situation
        assert not reason.remedy or reason.remedy.endswith("."), situation


def test_obeyed_is_set_only_when_serial_commands_act() -> None:
    for now in _EVERYTHING:
        obeyed = (
            now.link is Link.UP
            and now.mode is not None
            and now.by_serial is True
            and now.armed
            and not now.faults
            and not now.uart
        )
        assert reason_for(now).obeyed is obeyed, now


def test_every_kind_of_reason_can_occur() -> None:
    met = {reason_for(situation).kind for situation in _EVERYTHING}
    assert met == set(Kind)


# --- What the models know ---------------------------------------------------------------


def test_situation_follows_the_override_switch(
    rc_device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    assert situation_of(rc_device).by_serial is False
    assert "perhaps held" not in reason_for(situation_of(rc_device)).text
    rc_board.do("channel 5 1000us")
    qtbot.waitUntil(lambda: situation_of(rc_device).by_serial is True)
    assert reason_for(situation_of(rc_device)).kind is Kind.NOT_ARMED


def test_channel_is_missing_only_after_it_was_read(
    rc_device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    assert rc_device.telemetry.raw is None
    assert situation_of(rc_device).missing == ()
    for channel in (1, 2):  # the board requires the first of them
        rc_board.do(f"channel {channel} silent")
    qtbot.waitUntil(lambda: situation_of(rc_device).missing == (1,))


def test_fault_names_the_motor_that_has_it(
    rc_device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    rc_board.do("fault 2 on")
    qtbot.waitUntil(lambda: situation_of(rc_device).faults == (2,))


def test_situation_includes_the_serial_timeout_of_the_board(
    device: Device, quick_simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    assert situation_of(device).timeout == ""
    quick_simulator.do("eeprom serial_timeout 5")
    quick_simulator.do("power cycle")
    device.connect_to(LinkSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: situation_of(device).timeout == "0.5 s")
