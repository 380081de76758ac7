"""Checks of chosen values against what was measured."""

from collections.abc import Iterator
from dataclasses import dataclass

from trex_gui.devices.trex.calibration.neutral import Neutral
from trex_gui.devices.trex.calibration.problems import Problem, ProblemKind
from trex_gui.devices.trex.calibration.travel import Task, Travel, Way
from trex_gui.devices.trex.model.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, Calibration
from trex_gui.devices.trex.protocol.channel_text import concern
from trex_gui.devices.trex.protocol.flags import InputSource

_ASIDE = {InputSource.RC: 250, InputSource.ANALOG: 102}
"""Counts beyond rest at which is said what a throttle does there: 100 us, 0.5 V."""

_MUCH = FULL_SCALE // 2
"""Output at that place from which on it is a warning."""


@dataclass(frozen=True, slots=True)
class Check:
    """One channel: the curve that would be stored, which the board takes, and what was measured."""

    channel: int
    curve: ChannelCurve
    neutral: Neutral
    travel: Travel

    @property
    def problems(self) -> tuple[Problem, ...]:
        """What is wrong; the board would take it all the same."""
        return tuple(self._all())

    @property
    def remarks(self) -> tuple[str, ...]:
        """What is good to know of what the board would do."""
        return tuple(text for text in (self._switch_text(), self._idle_text()) if text)

    @property
    def _calibration(self) -> Calibration:
        return self.curve.calibration

    @property
    def _source(self) -> InputSource:
        return self.neutral.source

    def _all(self) -> Iterator[Problem]:
        if useless := self._useless():
            yield useless
        if never_full := self._never_full():
            yield never_full
        if self.travel.task is Task.SWITCH:
            yield from self._switching()
            return
        if self._calibration.deadband < self.neutral.noise / 2:
            values = self.neutral.noise_text, self._source.text(self._calibration.deadband)
            yield Problem(ProblemKind.NOISE, "CREEP", values, fatal=False)
        elif elsewhere := self._neutral_moved():
            yield elsewhere
        if (idle := self.travel.idle) is not None and self._aside(idle)[1] > _MUCH:
            place, speed = self._aside(idle)
            values = self._source.text(place), str(speed)
            yield Problem(ProblemKind.SPEEDS_UP, idle.name, (*values, FULL_SCALE), fatal=False)

    def _useless(self) -> Problem | None:
        """Return what makes the sides that are used useless."""
        wanted, idle = self._calibration, self.travel.idle
        if idle is None:
            text = concern(wanted, self._source)
            return Problem(ProblemKind.USELESS, "", (text,), fatal=False) if text else None
        used = wanted.maximum - wanted.neutral
        if idle is Way.UP:
            used = wanted.neutral - wanted.minimum
        if used > wanted.deadband:
            return None
        values = (self._source.text(wanted.deadband),)
        return Problem(ProblemKind.USELESS, idle.name, values, fatal=False)

    def _never_full(self) -> Problem | None:
        """Return which end lies further out than what was reached."""
        low, high, text = self.travel.low, self.travel.high, self._source.text
        names, values = [], []
        if high is not None and self.travel.reached(Way.UP) and self._calibration.maximum > high:
            names.append("MAXIMUM")
            values.append(text(high))
        if low is not None and self.travel.reached(Way.DOWN) and self._calibration.minimum < low:
            names.append("MINIMUM")
            values.append(text(low))
        if not names:
            return None
        variant = names[0] if len(names) == 1 else "BOTH"
        return Problem(ProblemKind.NEVER_FULL, variant, tuple(values), fatal=False)

    def _neutral_moved(self) -> Problem | None:
        rest, sampled, text = self.travel.rest, self.neutral.value, self._source.text
        if abs(rest - self._calibration.neutral) <= self._calibration.deadband:
            return None
        output = f"{self.curve.output(rest):+d}".replace("-", "−")
        if self._calibration.neutral != sampled:
            variant, values = "CHOSEN", (text(rest), output)
            return Problem(ProblemKind.NEUTRAL_MOVED, variant, values, fatal=False)
        places = text(rest), text(sampled), output
        return Problem(ProblemKind.NEUTRAL_MOVED, "MEASURED", places, fatal=False)

    # --- Switches -----------------------------------------------------------------------

    def _switching(self) -> Iterator[Problem]:
        threshold = self.curve.threshold(self.channel)
        if threshold is None:
            return
        if abs(self.neutral.value - threshold) <= self.neutral.deadband:
            values = self._source.text(self.neutral.value), self._source.text(round(threshold))
            yield Problem(ProblemKind.SWITCHES_AT_REST, "", values, fatal=False)
        ends = (self.travel.low, self.travel.high, self.neutral.value)
        active = {self.curve.is_switched(self.channel, end) for end in ends if end is not None}
        if len(active) == 1:
            variant = "ACTIVE" if active.pop() else "INACTIVE"
            place = (self._source.text(round(threshold)),)
            yield Problem(ProblemKind.NEVER_SWITCHES, variant, place, fatal=False)

    def _switch_text(self) -> str:
        threshold = self.curve.threshold(self.channel)
        if threshold is None:
            return ""
        where, end = ("above", "maximum") if self.curve.reversed_ else ("below", "minimum")
        state = "active" if self.curve.is_switched(self.channel, self.neutral.value) else "off"
        return (
            f"Active {where} {self._source.text(round(threshold))}, {state} at rest (inferred: "
            f"it switches halfway between neutral and {end})."
        )

    # --- Beyond the rest of a throttle --------------------------------------------------

    def _aside(self, idle: Way) -> tuple[int, int]:
        """Return a place beyond the rest, on the side it never goes to, and the speed there."""
        source, step = self._source, _ASIDE[self._source]
        place = self.neutral.value + (step if idle is Way.UP else -step)
        place = min(max(place, source.lowest_count), source.highest_count)
        return place, abs(self.curve.output(place))

    def _idle_text(self) -> str:
        idle = self.travel.idle
        if idle is None or self.travel.task is not Task.ONE_WAY:
            return ""
        place, speed = self._aside(idle)
        side = "Above" if idle is Way.UP else "Below"
        return (
            f"{side} its rest the motor speeds up again, whatever the sign: at "
            f"{self._source.text(place)} to {speed} of {FULL_SCALE}."
        )
