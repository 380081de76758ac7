"""Reasons why the motors do not follow the setpoints."""

import itertools
from collections.abc import Iterator
from dataclasses import replace

import pytest

from trex_gui.devices.trex.board.drive_status import (
    AUXILIARY,
    DriveInputs,
    MotorSetpoint,
    SetpointSource,
    drive_statuses,
    motor_setpoint,
)
from trex_gui.devices.trex.client.telemetry import Newest, Remapped
from trex_gui.devices.trex.driving.blockers import DriveBlocker, Effect
from trex_gui.devices.trex.driving.board_reasons import BoardInputs
from trex_gui.devices.trex.protocol.flags import Mode, UartError

SERIAL = BoardInputs()
LINKS = (
    None,
    DriveBlocker.NO_BOARD,
    DriveBlocker.OPENING,
    DriveBlocker.CLOSING,
    DriveBlocker.SILENT,
)
RC = BoardInputs(mode=Mode.RC, by_serial=False)
OTHER_DRIVER_RUNS = DriveInputs(board=SERIAL, other_driver="alice", other_speeds=(5, -8, 0))


@pytest.mark.parametrize(
    ("inputs", "blockers", "text"),
    [
        (DriveInputs(link=DriveBlocker.NO_BOARD), [DriveBlocker.NO_BOARD], "No board"),
        (
            DriveInputs(link=DriveBlocker.NO_BOARD, may_move=True, driven=frozenset({1})),
            [DriveBlocker.LOST],
            "Motor 1 may still be turning.",
        ),
        (
            DriveInputs(link=DriveBlocker.NO_BOARD, may_move=True, silence_remedy="Cut the power."),
            [DriveBlocker.LOST],
            "Cut the power.",
        ),
        (
            DriveInputs(link=DriveBlocker.NO_BOARD, lost_board="It got no stop."),
            [DriveBlocker.LOST],
            "It got no stop.",
        ),
        (
            DriveInputs(link=DriveBlocker.SILENT, may_move=True, silence_remedy="Cut the power."),
            [DriveBlocker.SILENT],
            "Cut the power.",
        ),
        (DriveInputs(link=DriveBlocker.OPENING), [DriveBlocker.OPENING], "is connecting"),
        (DriveInputs(link=DriveBlocker.CLOSING), [DriveBlocker.CLOSING], "closed"),
        (
            DriveInputs(link=DriveBlocker.SILENT, may_move=True),
            [DriveBlocker.SILENT],
            "the stop is being repeated",
        ),
        (
            DriveInputs(link=DriveBlocker.SILENT, board=SERIAL),
            [DriveBlocker.SILENT],
            "does not respond. Check its power and the cable.",  # no motor was driven
        ),
        (DriveInputs(), [DriveBlocker.UNKNOWN], "not yet reported"),
        (
            DriveInputs(board=replace(SERIAL, by_serial=False), is_available=False),
            [DriveBlocker.NOT_SERIAL],
            "serial commands do not",
        ),
        (
            DriveInputs(board=RC, is_available=False, stop_reason="The gamepad is gone."),
            [DriveBlocker.RC_CHANNELS],
            "The RC channels",
        ),
        (
            DriveInputs(board=RC, is_available=False, locked_for=2.2),  # sticks may still drive
            [DriveBlocker.RC_CHANNELS],
            "The RC channels",
        ),
        (DriveInputs(board=SERIAL, locked_for=2.2), [DriveBlocker.LOCKED], "locked for 3 s"),
        (
            DriveInputs(board=SERIAL, may_move=True, locked_for=2.2),
            [DriveBlocker.STOPPING],
            "Motors may still be turning",
        ),
        (
            DriveInputs(board=replace(SERIAL, faults=(1,)), locked_for=2.2),
            [DriveBlocker.FAULT, DriveBlocker.LOCKED],
            "Motor 1",
        ),
        (
            DriveInputs(board=replace(SERIAL, faults=(1, 2), doubtful=(1,))),
            [DriveBlocker.FAULT, DriveBlocker.FAULT, DriveBlocker.NOT_ARMED],
            "Doubtful: the line is noisy",
        ),
        (
            DriveInputs(board=replace(SERIAL, faults=(1, 2), doubtful=(2,))),
            [DriveBlocker.FAULT, DriveBlocker.FAULT, DriveBlocker.NOT_ARMED],
            "low voltage. Reduce",  # the fault of motor 1 is not doubtful
        ),
        (
            DriveInputs(board=replace(SERIAL, faults=(2,)), armed=True),
            [DriveBlocker.FAULT, DriveBlocker.RUNNING],
            "Motor 2",
        ),
        (
            DriveInputs(board=SERIAL, is_available=False),
            [DriveBlocker.NOT_ALLOWED],
            "cannot be armed",
        ),
        (
            DriveInputs(board=SERIAL, is_available=False, reaches_several=True),
            [DriveBlocker.SEVERAL_BOARDS],
            "would reach several boards",
        ),
        (DriveInputs(board=SERIAL), [DriveBlocker.NOT_ARMED], "no motor is driven"),
        (
            DriveInputs(board=SERIAL, stop_reason="The gamepad is gone."),
            [DriveBlocker.STOPPED],
            "The gamepad is gone.",
        ),
        (
            DriveInputs(board=replace(SERIAL, over_limit=(2,)), armed=True),
            [DriveBlocker.OVER_LIMIT, DriveBlocker.RUNNING],
            "Motor 2 is slowed down",
        ),
        (
            DriveInputs(board=replace(SERIAL, over_limit=(2,))),
            [DriveBlocker.NOT_ARMED, DriveBlocker.OVER_LIMIT],
            "Not armed",
        ),
        (
            DriveInputs(board=BoardInputs(mode=Mode.RC, joint=True), armed=True),
            [DriveBlocker.RUNNING, DriveBlocker.OVERRIDE, DriveBlocker.JOINT],
            "The motors are armed",
        ),
    ],
)
def test_drive_status_names_blocker_and_remedy(
    inputs: DriveInputs, blockers: list[DriveBlocker], text: str
) -> None:
    statuses = drive_statuses(inputs)
    assert [status.blocker for status in statuses] == blockers
    assert text in f"{statuses[0].text} {statuses[0].remedy}"


def all_inputs() -> Iterator[DriveInputs]:
    boards = [
        BoardInputs(mode=mode, by_serial=by_serial, faults=faults, uart=uart, error_shutdown=True)
        for mode, by_serial, faults, uart in itertools.product(
            Mode, (False, True), ((), (2,)), (UartError(0), UartError.TIMEOUT, UartError.CRC)
        )
    ]
    for board, link, armed, may_move in itertools.product(
        (None, *boards), LINKS, (False, True), (False, True)
    ):
        yield DriveInputs(board=board, link=link, armed=armed, may_move=may_move)


def test_motors_follow_setpoints_only_without_blockers() -> None:
    for inputs in all_inputs():
        status = drive_statuses(inputs)[0]
        assert status.text.endswith("."), inputs
        assert not status.remedy or status.remedy.endswith("."), inputs
        follows = (
            inputs.link is None
            and inputs.board is not None
            and inputs.board.by_serial
            and inputs.armed
            and not inputs.board.faults
            and not inputs.board.uart
        )
        assert (status.blocker.effect in {Effect.LIMITS, Effect.NOTE}) is follows, inputs


@pytest.mark.parametrize(
    ("inputs", "motor", "expected"),
    [
        (DriveInputs(link=DriveBlocker.SILENT, board=SERIAL), 1, (SetpointSource.UNKNOWN,)),
        (DriveInputs(), 1, (SetpointSource.UNKNOWN,)),
        (DriveInputs(board=SERIAL), 1, (SetpointSource.NOT_ARMED,)),
        (DriveInputs(board=SERIAL, may_move=True), 1, (SetpointSource.NOT_ARMED, 0, True)),
        (DriveInputs(board=SERIAL, armed=True, may_move=True), 1, (SetpointSource.SERIAL, 20)),
        (OTHER_DRIVER_RUNS, 2, (SetpointSource.OTHER_DRIVER, -8)),
        (DriveInputs(board=replace(SERIAL, joint=True)), 2, (SetpointSource.JOINT,)),
        (DriveInputs(board=RC), 2, (SetpointSource.CHANNEL, -90)),
        (DriveInputs(board=RC), AUXILIARY, (SetpointSource.CHANNEL, 30)),  # one direction only
        (DriveInputs(board=replace(RC, is_held=True)), 2, (SetpointSource.SAFE_START,)),
    ],
)
def test_setpoint_has_speed_and_source(
    inputs: DriveInputs, motor: int, expected: tuple[SetpointSource, int, bool]
) -> None:
    newest = Newest()
    newest.update(Remapped(0.0, (50, -90, -30, 0, 0)))
    assert motor_setpoint(motor, inputs, newest, 20) == MotorSetpoint(*expected)
    if expected[0] is SetpointSource.CHANNEL:
        assert motor_setpoint(motor, inputs, Newest(), 20) == MotorSetpoint(SetpointSource.UNKNOWN)
