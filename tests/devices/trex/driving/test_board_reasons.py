"""Reasons why the motors of a board do not run, and its LED patterns."""

import pytest

from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.driving.blockers import DriveBlocker
from trex_gui.devices.trex.driving.board_reasons import (
    LED_TEXTS,
    BoardInputs,
    board_reasons,
    led_patterns,
    safe_start_reasons,
)
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION, NEARLY_NEUTRAL
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, Mode, UartError

AT_REST = {
    InputSource.RC: dict.fromkeys(CHANNELS, 3750),
    InputSource.ANALOG: dict.fromkeys(CHANNELS, 512),
}

SHUT_DOWN = "its driver shut down because of overheating, a short circuit or low voltage."


def reason_texts(
    counts: dict[int, int | None],
    *,
    source: InputSource = InputSource.RC,
    joint: bool = False,
    curve: ChannelCurve | None = None,
) -> tuple[str, ...]:
    """Return the safe-start reasons for these counts, with other channels at neutral."""
    curve = curve or ChannelCurve(DEFAULT_CALIBRATION[source])
    raw = {**AT_REST[source], **counts}
    reasons = safe_start_reasons(
        dict.fromkeys(CHANNELS, curve), list(raw.values()), 0b1, source=source, joint=joint
    )
    return tuple(reason.text() for reason in reasons)


def test_sticks_at_rest_end_safe_start() -> None:
    assert reason_texts({}) == ()
    assert reason_texts({4: 5000}) == (), "channel 4 may be a switch"
    assert reason_texts({2: None}) == (), "only channel 1 is required"


@pytest.mark.parametrize("channel", [1, 2, 3])
def test_channel_off_neutral_is_named_with_its_distance(channel: int) -> None:
    assert reason_texts({channel: 3750 + 450}) == (f"Channel {channel} is 180 µs above neutral.",)
    assert reason_texts({channel: 3750 - 450}) == (f"Channel {channel} is 180 µs below neutral.",)
    analog_texts = reason_texts({channel: 512 + 256}, source=InputSource.ANALOG)
    assert analog_texts == (f"Channel {channel} is 1.25 V above neutral.",)


@pytest.mark.parametrize("parabolic", [False, True])
@pytest.mark.parametrize("side", [1, -1])
def test_remedy_names_largest_distance_near_neutral(side: int, *, parabolic: bool) -> None:
    curve = ChannelCurve(DEFAULT_CALIBRATION[InputSource.RC], parabolic=parabolic)
    near = max(d for d in range(1250) if abs(curve.output(3750 + side * d)) <= NEARLY_NEUTRAL)
    assert reason_texts({2: 3750 + side * near}, curve=curve) == ()
    raw = [3750, 3750 + side * (near + 1), 3750, 3750, 3750]
    (reason,) = safe_start_reasons({2: curve}, raw, 0, source=InputSource.RC, joint=False)
    assert f"within about {near / 2.5:.0f} µs" in reason.remedy()


def test_safe_start_ignores_second_channel_in_joint_mode() -> None:
    texts = reason_texts({2: 5000, 3: 4000}, joint=True)
    assert texts == ("Channel 3 is 100 µs above neutral.",)


def test_missing_signal_and_override_prolong_safe_start() -> None:
    assert reason_texts({1: None, 5: 2500}) == (
        "Channel 1 is required but has no signal.",
        "Channel 5 requests serial override.",
    )
    assert reason_texts({1: None}, source=InputSource.ANALOG) == ()


HELD = safe_start_reasons(
    {2: ChannelCurve(DEFAULT_CALIBRATION[InputSource.RC])},
    [None, 4200, 3750, 3750, 3750],
    0b1,
    source=InputSource.RC,
    joint=False,
)
"""Channel 1 has no signal and channel 2 is off neutral."""


def test_reasons_that_stop_motors_come_first() -> None:
    board = BoardInputs(
        mode=Mode.RC,
        by_serial=False,
        joint=True,
        safe_start=HELD,
        faults=(1, 2),
        over_limit=(2,),
        uart=UartError.TIMEOUT | UartError.PARITY,
        error_shutdown=True,
        timeout="0.5 s",
    )
    assert [reason.text() for reason in board_reasons(board)] == [
        "Channel 1 is required but has no signal.",
        "Channel 2 is 180 µs above neutral.",
        f"Motor 1 is off: {SHUT_DOWN}",
        f"Motor 2 is off: {SHUT_DOWN}",
        "Serial timeout: the board received nothing for 0.5 s.",
        "Serial errors (Parity error): the board stops the motors when bytes arrive corrupted.",
        "The RC channels control the motors, not serial commands.",
        "Motor 2 is slowed down: its current exceeds the limit.",
        "Joint mode: both drivers work as one motor.",
    ]


@pytest.mark.parametrize(
    ("board", "blockers"),
    [
        (BoardInputs(), []),
        (BoardInputs(uart=UartError.PARITY), []),
        (BoardInputs(by_serial=False), [DriveBlocker.NOT_SERIAL]),
        (BoardInputs(mode=Mode.RC), [DriveBlocker.OVERRIDE]),
        (BoardInputs(mode=Mode.ANALOG, by_serial=False), [DriveBlocker.ANALOG_CHANNELS]),
        (
            BoardInputs(mode=Mode.RC, by_serial=False, safe_start=HELD[1:]),
            [DriveBlocker.RC_CHANNELS],  # the motors already run
        ),
        (
            BoardInputs(mode=Mode.RC, by_serial=False, safe_start=HELD[1:], is_held=True),
            [DriveBlocker.CHANNEL_ABOVE, DriveBlocker.RC_CHANNELS],
        ),
        (
            BoardInputs(mode=Mode.RC, by_serial=False, is_held=True),
            [DriveBlocker.SAFE_START, DriveBlocker.RC_CHANNELS],
        ),
    ],
)
def test_reported_state_determines_the_reasons(
    board: BoardInputs, blockers: list[DriveBlocker]
) -> None:
    assert [reason.blocker for reason in board_reasons(board)] == blockers


@pytest.mark.parametrize(
    ("board", "red", "green"),
    [
        (BoardInputs(), "on", "with packets"),
        (BoardInputs(mode=Mode.RC), "on", "with packets"),
        (BoardInputs(mode=Mode.RC, by_serial=False), "with packets", "on"),
        (BoardInputs(mode=Mode.RC, by_serial=False, safe_start=HELD), "with packets", "fast flash"),
    ],
)
def test_leds_show_control_source_and_safe_start(board: BoardInputs, red: str, green: str) -> None:
    assert led_patterns(board) == (red, green)
    assert {red, green} <= set(LED_TEXTS)
