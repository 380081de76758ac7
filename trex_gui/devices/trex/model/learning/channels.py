"""Channels that are being learned: measurements and derived values."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.texts import signed_text
from trex_gui.core.translation import tr
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.calibration.neutral import ChannelSample, Neutral, no_signal
from trex_gui.devices.trex.calibration.problems import CalibrationProblem, ProblemKind, has_fatal
from trex_gui.devices.trex.calibration.proposal import Proposal, propose
from trex_gui.devices.trex.calibration.travel import TASKS, Task, Travel, Way
from trex_gui.devices.trex.model.channel_text import calibration_warning, deadband_problem
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.telemetry import Telemetry
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, Calibration
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, channels_in
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.ui.runtime import new_timer, now

_CHECK_OFFSETS = {InputSource.RC: 250, InputSource.ANALOG: 102}
"""Offset from rest, in counts (100 µs, 0.5 V), at which a throttle's speed is checked."""

_FAST = FULL_SCALE // 2  # highest output at `_CHECK_OFFSETS` without a warning


_Finding = tuple[ProblemKind, str, tuple[object, ...]]  # kind, variant and values of a problem


@dataclass(frozen=True, slots=True)
class Check:
    """Valid curve of a channel, checked against its measurements."""

    channel: int
    curve: ChannelCurve
    neutral: Neutral
    travel: Travel

    @property
    def problems(self) -> tuple[CalibrationProblem, ...]:
        return tuple(
            CalibrationProblem(kind, variant, values, fatal=False)
            for kind, variant, values in self._findings()
        )

    def _findings(self) -> Iterator[_Finding]:
        text, calibration = self.neutral.source.text, self.curve.calibration
        yield from self._unusable()
        for way, end, name in (
            (Way.UP, calibration.maximum, tr("Maximum")),
            (Way.DOWN, calibration.minimum, tr("Minimum")),
        ):
            reached = self.travel.end(way)
            if self.travel.has_reached(way) and way.value * (end - reached) > 0:
                yield ProblemKind.NEVER_FULL, "", (name, text(reached))
        if self.travel.task is Task.SWITCH:
            yield from self._switching()
            return
        if calibration.deadband < self.neutral.noise / 2:
            yield ProblemKind.NOISE, "CREEP", (self.neutral.noise_text, text(calibration.deadband))
        else:
            yield from self._neutral_moved()
        if (idle := self.travel.idle) is not None:
            source = self.neutral.source
            position = self.neutral.value + idle.value * _CHECK_OFFSETS[source]
            position = min(max(position, source.lowest_count), source.highest_count)
            if (speed := abs(self.curve.output(position))) > _FAST:
                yield ProblemKind.SPEEDS_UP, "", (text(position), str(speed), FULL_SCALE)

    def _unusable(self) -> Iterator[_Finding]:
        calibration, source, idle = self.curve.calibration, self.neutral.source, self.travel.idle
        if idle is None:
            text = calibration_warning(calibration, source)
        else:
            text = deadband_problem(calibration, source, "minimum" if idle is Way.UP else "maximum")
        if text:
            yield ProblemKind.USELESS, "", (text,)

    def _neutral_moved(self) -> Iterator[_Finding]:
        text, sampled = self.neutral.source.text, self.neutral.value
        calibration, rest = self.curve.calibration, self.travel.rest
        if abs(rest - calibration.neutral) <= calibration.deadband:
            return
        output = signed_text(self.curve.output(rest))
        if calibration.neutral != sampled:
            yield ProblemKind.NEUTRAL_MOVED, "CHOSEN", (text(rest), output)
        else:
            yield ProblemKind.NEUTRAL_MOVED, "MEASURED", (text(rest), text(sampled), output)

    def _switching(self) -> Iterator[_Finding]:
        threshold = self.curve.threshold(self.channel)
        if threshold is None:
            return
        rest, text = self.neutral.value, self.neutral.source.text
        threshold_text = text(round(threshold))
        if abs(rest - threshold) <= self.neutral.deadband:
            yield ProblemKind.SWITCHES_AT_REST, "", (text(rest), threshold_text)
        positions = rest, *(self.travel.end(way) for way in Way)
        active = {self.curve.is_switched(self.channel, position) for position in positions}
        if len(active) == 1:
            variant = "ACTIVE" if active.pop() else "INACTIVE"
            yield ProblemKind.NEVER_SWITCHES, variant, (threshold_text,)

    @property
    def remark(self) -> str:
        """Sentences about the switching point. Empty for a stick."""
        threshold = self.curve.threshold(self.channel)
        if threshold is None:
            return ""
        if self.curve.reversed_:
            text = tr("Active above {0}, halfway between neutral and maximum (inferred).")
        else:
            text = tr("Active below {0}, halfway between neutral and minimum (inferred).")
        if self.curve.is_switched(self.channel, self.neutral.value):
            rest = tr("At rest the switch is active.")
        else:
            rest = tr("At rest the switch is off.")
        return f"{text.format(self.neutral.source.text(round(threshold)))} {rest}"


Counts = tuple[int | None, ...]  # raw counts of channels 1-5; `None` without a valid signal

_STALLED_AFTER = 1.0  # s without a measurement
_TICK_MS = 200

_MIN_INTERVAL = 0.012
"""Minimum time between two samples, in seconds.

The board updates its inputs every 20 ms. After a delay, one stray pulse may be read several times
in a burst. Such a burst must not look like a held stick.
"""

_SILENT_AFTER = 0.5  # s without a valid sample


class MeasuredInputs(QObject):
    """Reports each measurement once, between `start` and `end`."""

    arrived = Signal(object)  # new measurements, a list of (seconds, `Counts`)
    stalled_changed = Signal()  # `stalled`; true while no measurements arrive

    def __init__(self, telemetry: Telemetry, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.stalled = False
        self._telemetry = telemetry
        self._last_time = -math.inf
        self._received_at = 0.0
        self._ticked_at = 0.0
        self._timer = new_timer(self, _TICK_MS, self._on_tick)

        telemetry.updated.connect(self._on_updated)

    def start(self) -> None:
        times = self._telemetry.inputs.times
        self._last_time = float(times[-1]) if len(times) else -math.inf
        self._received_at = self._ticked_at = now()
        self.stalled = False
        self._timer.start()

    def end(self) -> None:
        self.stalled = False
        self._timer.stop()

    @Slot()
    def _on_updated(self) -> None:
        if not self._timer.isActive():
            return
        inputs = self._telemetry.inputs
        first = int(inputs.times.searchsorted(self._last_time, side="right"))
        measurements: list[tuple[float, Counts]] = []
        for index, moment in enumerate(inputs.times[first:].tolist(), first):
            self._received_at = now()
            if moment - self._last_time < _MIN_INTERVAL:
                continue
            self._last_time = moment
            row = [inputs.values(column)[index] for column in range(len(CHANNELS))]
            measurements.append((moment, tuple(None if math.isnan(v) else int(v) for v in row)))
        if measurements:
            self.arrived.emit(measurements)

    @Slot()
    def _on_tick(self) -> None:
        moment = now()
        was_busy = moment - self._ticked_at > 3 * _TICK_MS / 1000
        self._ticked_at = moment
        if was_busy:  # the window was busy: measurements may still be queued
            return
        stalled = moment - self._received_at > _STALLED_AFTER
        if stalled != self.stalled:
            self.stalled = stalled
            self.stalled_changed.emit()


@dataclass(frozen=True, slots=True)
class Choice:
    """Values chosen for a channel, by default the proposal."""

    calibration: Calibration
    reversed_: bool
    included: bool = True


class LearnedChannel:
    """Measurements and derived values of a channel."""

    def __init__(self, device: Device, number: int, source: InputSource) -> None:
        parameters = device.parameters

        def is_in(mask: int | None) -> bool:
            return number in channels_in(mask or 0)

        self.number = number
        self.source = source
        self.curve_before = device.draft.stored_curve(number)  # stored curve, without edits
        self.reversed_now = is_in(parameters.values.stored.get(ParameterKey.REVERSED_CHANNELS))
        self._parabolic = is_in(parameters.values.value_of(ParameterKey.PARABOLIC_CHANNELS))
        self._ignored = is_in(parameters.values.value_of(ParameterKey.IGNORED_CHANNELS))
        self.raw: int | None = None  # the newest count; `None` without a signal
        self.samples: list[ChannelSample] = []  # samples at rest, from which `neutral` is computed
        self.neutral: Neutral | None = None
        self.travel: Travel | None = None  # measures the ends; `None` without a rest position
        self.proposal: Proposal | None = None
        self.choice: Choice | None = None
        # Time of the last valid sample, or of the first sample if no sample was valid
        self._received_at: float | None = None
        self.time = 0.0  # time of the newest sample

    def feed(self, sample: ChannelSample) -> None:
        self.raw = sample.count
        self.time = sample.time
        if sample.count is not None or self._received_at is None:
            self._received_at = sample.time

    def start_sampling(self) -> None:
        self.samples = []
        self.neutral = None

    @property
    def is_at_rest(self) -> bool:
        return self.neutral is not None and not has_fatal(self.neutral.problems)

    def start_travel(self) -> None:
        self.travel = None
        if self.neutral is not None and self.is_at_rest:
            self.travel = Travel(self.neutral, TASKS[self.number])

    def propose(self) -> None:
        self.proposal = self.choice = None
        if self.neutral is None or self.travel is None:
            return
        self.proposal = propose(self.neutral, self.travel, reversed_now=self.reversed_now)
        if self.proposal.calibration is not None:
            self.choice = Choice(self.proposal.calibration, self.proposal.reversed_)

    # --- The chosen values --------------------------------------------------------------

    @property
    def is_included(self) -> bool:
        return self.choice is not None and self.choice.included

    @property
    def can_be_used(self) -> bool:
        return self.is_included and self.curve_after is not None

    @property
    def curve_after(self) -> ChannelCurve | None:
        """Curve of the chosen values. `None` if they are invalid."""
        if self.choice is None or self.choice.calibration.problem() is not None:
            return None
        calibration, reversed_ = self.choice.calibration, self.choice.reversed_
        return ChannelCurve(calibration, reversed_, self._parabolic, self._ignored)

    @property
    def new_rest(self) -> int | None:
        """Rest position to which neutral should move, or `None`."""
        if self.travel is None or self.choice is None or self.travel.task is Task.SWITCH:
            return None
        rest, calibration = self.travel.rest, self.choice.calibration
        if abs(rest - calibration.neutral) <= calibration.deadband or rest == self.travel.neutral:
            return None
        return rest

    @property
    def remark(self) -> str:
        return "" if self._check is None else self._check.remark

    @property
    def _check(self) -> Check | None:
        if self.curve_after is None or self.neutral is None or self.travel is None:
            return None
        return Check(self.number, self.curve_after, self.neutral, self.travel)

    # --- Problems -----------------------------------------------------------------------

    @property
    def is_silent(self) -> bool:
        return (
            self.raw is None
            and self._received_at is not None
            and self.time - self._received_at > _SILENT_AFTER
        )

    @property
    def rest_problems(self) -> tuple[CalibrationProblem, ...]:
        if self.neutral is not None:
            return self.neutral.problems
        return (no_signal(self.source),) if self.is_silent else ()

    @property
    def result_problems(self) -> tuple[CalibrationProblem, ...]:
        if self.proposal is None:
            return self.rest_problems
        if self.choice is None:
            return self.proposal.problems
        if (check := self._check) is not None:
            return self.proposal.problems + check.problems
        values = (self.choice.calibration.problem(),)
        refused = CalibrationProblem(ProblemKind.REFUSED, "CHOSEN", values)
        return (*self.proposal.problems, refused)
