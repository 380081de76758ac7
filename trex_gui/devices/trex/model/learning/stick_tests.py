"""Test of stored calibrations with the sticks.

Outputs are computed here, because the outputs that the board reports are mixed and flipped.
"""

from collections.abc import Sequence

from trex_gui.core.texts import signed_text
from trex_gui.core.translation import tr
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.calibration.travel import TASKS, Task
from trex_gui.devices.trex.driving.board_reasons import safe_start_reasons
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_texts import direction_text
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, Calibration
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.protocol.parameters import ParameterKey

_HELD = 3  # consecutive samples (60 ms) that count as a reached position
_REST_SECONDS = 0.5  # duration of zero output after which a stick is at rest


class StickTest:
    def __init__(self, number: int, source: InputSource = InputSource.RC) -> None:
        self.number = number
        self.source = source
        self.calibration: Calibration | None = None  # stored by the board
        self.raw: int | None = None  # the newest count; `None` without a signal
        self.time = 0.0  # time of the newest sample
        self.output: int | None = None  # -127 to 127 now; `None` without a signal
        self.forward = self.reverse = False  # full output was reached in this direction
        self.is_at_rest = False  # the output was 0 for `_REST_SECONDS`
        self.on = self.off = False  # the switch was in this position
        self.ignored = False  # the board ignores the channel
        self.passed = False  # all positions were reached; a stick is also at rest
        self._full = {1: 0, -1: 0}  # consecutive samples with full output, by sign
        self._switched = {False: 0, True: 0}
        self._zero_since: float | None = None

    def feed(self, time: float, raw: int | None, curve: ChannelCurve) -> None:
        task = TASKS[self.number]
        output = None if raw is None else curve.output(raw)
        switched, idle = curve.is_switched(self.number, raw), idle_side(curve)
        self.time, self.raw, self.calibration = time, raw, curve.calibration
        self.output, self.ignored = output, curve.ignored
        for sign in self._full:
            is_full = output == sign * FULL_SCALE and (task is not Task.ONE_WAY or sign != idle)
            self._full[sign] = self._full[sign] + 1 if is_full else 0
        self.forward |= self._full[1] >= _HELD
        self.reverse |= self._full[-1] >= _HELD
        if output is not None:
            self._switched = {switched: self._switched[switched] + 1, not switched: 0}
        self.on |= self._switched[True] >= _HELD
        self.off |= self._switched[False] >= _HELD
        if output != 0:
            self._zero_since = None
        elif self._zero_since is None:
            self._zero_since = time
        self.is_at_rest = self._zero_since is not None and time - self._zero_since >= _REST_SECONDS
        match task:
            case Task.SWITCH:
                good = self.on and self.off and output is not None
            case Task.ONE_WAY:
                good = self.is_at_rest and (self.forward or self.reverse)
            case Task.STICK:
                good = self.is_at_rest and self.forward and self.reverse
        self.passed = good and not curve.ignored

    @property
    def text(self) -> str:
        """Next task for the user, or the result."""
        if self.ignored:
            return tr("Ignored: the board holds this channel at neutral. There is nothing to test.")
        if self.output is None:
            return tr("No signal.")
        if self.passed:
            return tr("Good.")
        task = TASKS[self.number]
        if task is Task.SWITCH:
            if not self.off and not self.on:
                return tr("Move the switch to all its positions.")
            text = tr("Only {0} was detected. Move the switch to its other position.")
            return text.format(tr("off") if self.off else tr("on"))
        if task is Task.ONE_WAY and not (self.forward or self.reverse):
            return tr("Full output not reached yet. Push the stick all the way.")
        if task is Task.STICK and not (self.forward and self.reverse):
            text = tr("Full output not reached yet: {0}.")
            missing = [FULL_SCALE] * (not self.forward) + [-FULL_SCALE] * (not self.reverse)
            return text.format(", ".join(map(direction_text, missing)))
        if self.output == 0:
            return tr("Full output reached. Let the stick rest for a moment.")
        output = signed_text(self.output)
        return tr(
            "Full output reached. Release the stick: at rest the output must be 0, but it is {0}."
        ).format(output)


def idle_side(curve: ChannelCurve) -> int:
    """Return the sign of the output on the shorter side of neutral. 0 for equal sides."""
    up = curve.calibration.maximum - curve.calibration.neutral
    down = curve.calibration.neutral - curve.calibration.minimum
    if up == down:
        return 0
    return -1 if (up > down) != curve.reversed_ else 1


class StickTests:
    """Tests of some channels. Other channels matter only for safe-start."""

    def __init__(self, device: Device, numbers: Sequence[int]) -> None:
        self.tests = tuple(StickTest(number, device.calibrations.source) for number in numbers)
        self._device = device
        self._counts: Sequence[int | None] = ()
        self._curves: dict[int, ChannelCurve] = {}

    def feed(self, moment: float, counts: Sequence[int | None]) -> None:
        tests = {test.number: test for test in self.tests}
        self._counts = tuple(counts)
        self._curves.clear()
        for channel, raw in zip(CHANNELS, counts, strict=True):
            if (curve := self._device.draft.stored_curve(channel)) is not None:
                self._curves[channel] = curve
                if channel in tests:
                    tests[channel].feed(moment, raw, curve)

    @property
    def has_samples(self) -> bool:
        return bool(self._counts)

    @property
    def passed(self) -> bool:
        """True if the channels passed, and safe-start would release the motors."""
        return self.channels_passed and not self.safe_start_reasons

    @property
    def channels_passed(self) -> bool:
        """True if every tested channel passed or is ignored, but not all are ignored."""
        return not self.all_ignored and all(test.passed or test.ignored for test in self.tests)

    @property
    def all_ignored(self) -> bool:
        return all(test.ignored for test in self.tests)

    @property
    def safe_start_reasons(self) -> str:
        if not self.has_samples:
            return ""
        stored_of = self._device.parameters.values.stored.get
        reasons = safe_start_reasons(
            self._curves,
            self._counts,
            stored_of(ParameterKey.REQUIRED_CHANNELS) or 0,
            source=self._device.calibrations.source,
            joint=stored_of(ParameterKey.MOTOR_MODE) == 1,
        )
        return " ".join(reason.text() for reason in reasons)

    @property
    def safe_start_text(self) -> str:
        """Sentence about safe-start, as if the channels were in control."""
        if not self.has_samples:
            return ""
        text = tr("In {0} mode safe-start would release the motors now.")
        if reasons := self.safe_start_reasons:
            text = tr("In {0} mode safe-start would hold the motors now. {1}")
        return text.format(self._device.calibrations.source.word, reasons)
