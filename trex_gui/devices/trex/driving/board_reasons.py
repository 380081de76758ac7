"""Reasons why a board's motors do not run, and the board's LED patterns."""

from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from trex_gui.core.translation import tr_noop
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.driving.blockers import DriveBlocker, Reason, worst_first
from trex_gui.devices.trex.protocol.calibration import NEARLY_NEUTRAL
from trex_gui.devices.trex.protocol.flags import (
    CHANNELS,
    InputSource,
    Mode,
    UartError,
    bit_names,
    channels_in,
)

NOISE_COUNTS = 1  # highest current reading that may be noise while a motor draws no current

_OVERRIDE_CHANNEL = 5
_NO_ERROR = UartError(0)


@dataclass(frozen=True, slots=True, kw_only=True)
class BoardInputs:
    """Inputs of `board_reasons`, as last reported by the board."""

    mode: Mode = Mode.SERIAL_RC
    by_serial: bool = True  # True if serial commands reach the motors
    joint: bool = False  # True if both drivers work as one motor
    safe_start: tuple[Reason, ...] = ()  # see `safe_start_reasons`
    is_held: bool = False  # True if safe-start may hold the motors; no command reports this
    faults: tuple[int, ...] = ()  # motors whose driver recently shut down
    doubtful: tuple[int, ...] = ()  # motors in `faults` whose report may have been corrupted
    over_limit: tuple[int, ...] = ()  # motors whose current recently exceeded its limit
    uart: UartError = _NO_ERROR  # recent UART errors
    error_shutdown: bool = False  # True if the board stops its motors at a UART error
    timeout: str = "off"  # text of the board's serial timeout

    @property
    def shut_down(self) -> frozenset[int]:
        """Motors that are certainly off."""
        return frozenset(self.faults) - frozenset(self.doubtful)

    @property
    def lacks_signal(self) -> bool:
        """True if a required channel has no signal, which starts safe-start."""
        return any(reason.blocker is DriveBlocker.CHANNEL_SILENT for reason in self.safe_start)


def board_reasons(inputs: BoardInputs) -> tuple[Reason, ...]:
    """Return all reasons why the motors do not follow serial commands, worst first."""
    reasons = [Reason(DriveBlocker.FAULT, (motor,)) for motor in inputs.faults]
    reasons += [Reason(DriveBlocker.OVER_LIMIT, (motor,)) for motor in inputs.over_limit]
    if inputs.uart & UartError.TIMEOUT:
        reasons.append(Reason(DriveBlocker.TIMEOUT, (inputs.timeout,)))
    if inputs.error_shutdown and (errors := inputs.uart & ~UartError.TIMEOUT):
        reasons.append(Reason(DriveBlocker.LINE_ERROR, (tuple(bit_names(errors)),)))
    if inputs.joint:
        reasons.append(Reason(DriveBlocker.JOINT))
    if inputs.by_serial:
        if not inputs.mode.is_serial:
            reasons.append(Reason(DriveBlocker.OVERRIDE))
    elif inputs.mode.is_serial:
        reasons.append(Reason(DriveBlocker.NOT_SERIAL))
    else:
        is_rc = inputs.mode is Mode.RC
        reasons.append(Reason(DriveBlocker.RC_CHANNELS if is_rc else DriveBlocker.ANALOG_CHANNELS))
        reasons += held_by_safe_start(inputs)
    return worst_first(reasons)


def held_by_safe_start(inputs: BoardInputs) -> tuple[Reason, ...]:
    """Return the reasons why safe-start may hold the motors.

    Call this only while channels control the motors.
    """
    # Each of these reasons certainly holds the motors. Inferred for OVERRIDE_AT_START.
    certain = {DriveBlocker.CHANNEL_SILENT, DriveBlocker.OVERRIDE_AT_START}
    if not inputs.is_held and not any(reason.blocker in certain for reason in inputs.safe_start):
        return ()
    return inputs.safe_start or (Reason(DriveBlocker.SAFE_START),)


def safe_start_reasons(
    curves: Mapping[int, ChannelCurve],
    raw: Sequence[int | None],
    required: int,
    *,
    source: InputSource,
    joint: bool,
) -> tuple[Reason, ...]:
    """Return the reasons why safe-start would not end.

    The result assumes that channels control the motors. Safe-start ends when all required channels
    have a signal (RC), all driving channels are near neutral, and channel 5 does not override.
    Ref: TReX Jr User's Guide 4.e. The distance from neutral and the threshold of channel 5 are
    inferred.

    `curves`: channel → stored curve. `raw`: counts of channels 1-5. `required`: channel mask.
    """
    counts = dict(zip(CHANNELS, raw, strict=True))
    reasons = [
        Reason(DriveBlocker.CHANNEL_SILENT, (channel,))
        for channel in channels_in(required)
        if source is InputSource.RC and counts[channel] is None
    ]
    for channel in (1, 3) if joint else (1, 2, 3):
        count, curve = counts[channel], curves.get(channel)
        if count is None or curve is None or abs(curve.output(count)) <= NEARLY_NEUTRAL:
            continue
        offset = count - curve.calibration.neutral
        is_above = offset > 0
        limit = _near_limit(curve, is_above=is_above)
        fields = (channel, source.text(abs(offset)), source.text(limit))
        blocker = DriveBlocker.CHANNEL_ABOVE if is_above else DriveBlocker.CHANNEL_BELOW
        reasons.append(Reason(blocker, fields))
    switch = curves.get(_OVERRIDE_CHANNEL)
    if switch is not None and switch.is_switched(_OVERRIDE_CHANNEL, counts[_OVERRIDE_CHANNEL]):
        reasons.append(Reason(DriveBlocker.OVERRIDE_AT_START))
    return tuple(reasons)


def _near_limit(curve: ChannelCurve, *, is_above: bool) -> int:
    """Return the largest distance from neutral that counts as near neutral, in counts."""
    neutral, sign = curve.calibration.neutral, 1 if is_above else -1
    reach = max(curve.calibration.maximum - neutral, neutral - curve.calibration.minimum)

    def output(distance: int) -> int:
        return abs(curve.output(neutral + sign * distance))

    return max(0, bisect_right(range(reach), NEARLY_NEUTRAL, key=output) - 1)


# --- LEDs -------------------------------------------------------------------------------

PACKETS = "with packets"  # lit during each packet; the simulator reports "on" or "off" instead

SAFE_START_FLASH = "fast flash"

LED_TEXTS = {
    "on": tr_noop("on", "LED"),
    "off": tr_noop("off", "LED"),
    PACKETS: tr_noop("flickers with each packet", "LED"),
    SAFE_START_FLASH: tr_noop("flashes fast", "LED"),
}
"""Texts for the user. Their translation comment is `LED`."""


SAFE_START_NOTE = tr_noop("If the green LED is steady instead, safe-start is over.")
"""Note for `SAFE_START_FLASH`. Safe-start is inferred, since no command reports it."""


def led_patterns(inputs: BoardInputs) -> tuple[str, str]:
    """Return the patterns of the red and the green LED.

    Ref: TReX Jr User's Guide 4.e: a fast green flash shows safe-start. Manuals: the red LED is on
    if serial commands control the motors, the green LED if channels do. The other LED is lit from
    the first to the last byte of a packet. Inferred: the red LED also shows packets during
    safe-start.
    """
    if inputs.by_serial:
        return "on", PACKETS
    return PACKETS, SAFE_START_FLASH if held_by_safe_start(inputs) else "on"
