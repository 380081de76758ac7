"""Checks of chosen calibration values against measurements."""

from collections.abc import Iterator
from dataclasses import dataclass

from trex_gui.core.texts import signed_text
from trex_gui.core.translation import tr
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.calibration.neutral import Neutral
from trex_gui.devices.trex.calibration.problems import CalibrationProblem, ProblemKind
from trex_gui.devices.trex.calibration.travel import Task, Travel, Way
from trex_gui.devices.trex.model.channel_text import concern, deadband_problem
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.flags import InputSource

_ASIDE = {InputSource.RC: 250, InputSource.ANALOG: 102}
"""Counts beyond rest at which the speed of a throttle is checked: 100 us, 0.5 V."""

_MUCH = FULL_SCALE // 2  # output there that causes a warning if exceeded


_Found = tuple[ProblemKind, str, tuple[object, ...]]  # kind, variant and values of a problem


@dataclass(frozen=True, slots=True)
class Check:
    """Curve to be stored for a channel, and measurements. The board accepts the curve."""

    channel: int
    curve: ChannelCurve
    neutral: Neutral
    travel: Travel

    @property
    def problems(self) -> tuple[CalibrationProblem, ...]:
        """Warnings, none of them fatal."""
        return tuple(
            CalibrationProblem(kind, variant, values, fatal=False)
            for kind, variant, values in self._found()
        )

    @property
    def remarks(self) -> tuple[str, ...]:
        return tuple(filter(None, (self._switch_text(), self._idle_text())))

    def _found(self) -> Iterator[_Found]:
        text, wanted = self.neutral.source.text, self.curve.calibration
        yield from self._useless()
        for way, end, name in (
            (Way.UP, wanted.maximum, tr("Maximum")),
            (Way.DOWN, wanted.minimum, tr("Minimum")),
        ):
            reached = self.travel.end(way)
            if self.travel.reached(way) and way.value * (end - reached) > 0:
                yield ProblemKind.NEVER_FULL, "", (name, text(reached))
        if self.travel.task is Task.SWITCH:
            yield from self._switching()
            return
        if wanted.deadband < self.neutral.noise / 2:
            yield ProblemKind.NOISE, "CREEP", (self.neutral.noise_text, text(wanted.deadband))
        else:
            yield from self._neutral_moved()
        if (idle := self.travel.idle) is not None:
            place, speed = self._aside(idle)
            if speed > _MUCH:
                values = text(place), str(speed), FULL_SCALE
                yield ProblemKind.SPEEDS_UP, "", values

    def _useless(self) -> Iterator[_Found]:
        wanted, source, idle = self.curve.calibration, self.neutral.source, self.travel.idle
        if idle is None:
            text = concern(wanted, source)
        else:
            text = deadband_problem(wanted, source, "minimum" if idle is Way.UP else "maximum")
        if text:
            yield ProblemKind.USELESS, "", (text,)

    def _neutral_moved(self) -> Iterator[_Found]:
        text, wanted, sampled = self.neutral.source.text, self.curve.calibration, self.neutral.value
        rest = self.travel.rest
        if abs(rest - wanted.neutral) <= wanted.deadband:
            return
        output = signed_text(self.curve.output(rest))
        if wanted.neutral != sampled:
            yield ProblemKind.NEUTRAL_MOVED, "CHOSEN", (text(rest), output)
        else:
            yield ProblemKind.NEUTRAL_MOVED, "MEASURED", (text(rest), text(sampled), output)

    def _switching(self) -> Iterator[_Found]:
        threshold = self.curve.threshold(self.channel)
        if threshold is None:
            return
        rest, text = self.neutral.value, self.neutral.source.text
        place = text(round(threshold))
        if abs(rest - threshold) <= self.neutral.deadband:
            yield ProblemKind.SWITCHES_AT_REST, "", (text(rest), place)
        positions = rest, *(self.travel.end(way) for way in Way)
        active = {self.curve.is_switched(self.channel, position) for position in positions}
        if len(active) == 1:
            variant = "ACTIVE" if active.pop() else "INACTIVE"
            yield ProblemKind.NEVER_SWITCHES, variant, (place,)

    def _switch_text(self) -> str:
        threshold = self.curve.threshold(self.channel)
        if threshold is None:
            return ""
        if self.curve.reversed_:
            text = tr("Active above {0}, halfway between neutral and maximum (inferred).")
        else:
            text = tr("Active below {0}, halfway between neutral and minimum (inferred).")
        if self.curve.is_switched(self.channel, self.neutral.value):
            rest = tr("At rest it is active.")
        else:
            rest = tr("At rest it is off.")
        return f"{text.format(self.neutral.source.text(round(threshold)))} {rest}"

    def _aside(self, idle: Way) -> tuple[int, int]:
        """Return a count beyond rest, on the unused side, and the speed there."""
        source = self.neutral.source
        place = self.neutral.value + idle.value * _ASIDE[source]
        place = min(max(place, source.lowest_count), source.highest_count)
        return place, abs(self.curve.output(place))

    def _idle_text(self) -> str:
        idle = self.travel.idle
        if idle is None or self.travel.task is not Task.ONE_WAY:
            return ""
        place, speed = self._aside(idle)
        text = tr(
            "Beyond its rest position the motor speeds up again, whatever the sign: at {0} to {1} "
            "of {2}."
        )
        return text.format(self.neutral.source.text(place), speed, FULL_SCALE)
