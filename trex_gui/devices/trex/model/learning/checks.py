"""What there is to say of values that a person is about to take, against what was measured."""

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
            yield Problem(ProblemKind.USELESS, useless, fatal=False)
        if never_full := self._never_full():
            yield Problem(ProblemKind.NEVER_FULL, never_full, fatal=False)
        if self.travel.task is Task.SWITCH:
            yield from self._switching()
            return
        if self._calibration.deadband < self.neutral.noise / 2:
            text = (
                f"At rest the noise is {self.neutral.noise_text}, more than the deadband "
                f"({self._source.text(self._calibration.deadband)}): the motor would creep."
            )
            yield Problem(ProblemKind.NOISE, text, fatal=False)
        elif elsewhere := self._rests_elsewhere():
            yield Problem(ProblemKind.RESTS_ELSEWHERE, elsewhere, fatal=False)
        if (idle := self.travel.idle) is not None and self._aside(idle)[1] > _MUCH:
            text = f"{self._idle_text()} Look that no trim and no broken wire brings it there."
            yield Problem(ProblemKind.SPEEDS_UP, text, fatal=False)

    def _useless(self) -> str:
        """Say what nobody would want of the sides that are used."""
        wanted, idle = self._calibration, self.travel.idle
        if idle is None:
            return concern(wanted, self._source)
        used, end = wanted.maximum - wanted.neutral, "maximum"
        if idle is Way.UP:
            used, end = wanted.neutral - wanted.minimum, "minimum"
        if used > wanted.deadband:
            return ""
        return (
            f"The deadband ({self._source.text(wanted.deadband)} to each side of neutral) reaches "
            f"{end}: there is nothing between 0 and full output."
        )

    def _never_full(self) -> str:
        """Say which end lies further out than what was reached."""
        low, high, text = self.travel.low, self.travel.high, self._source.text
        found = []
        if high is not None and self.travel.reached(Way.UP) and self._calibration.maximum > high:
            found.append(f"Maximum is beyond the {text(high)} that was reached")
        if low is not None and self.travel.reached(Way.DOWN) and self._calibration.minimum < low:
            found.append(f"Minimum is beyond the {text(low)} that was reached")
        return f"{'; '.join(found)}: there is no full output." if found else ""

    def _rests_elsewhere(self) -> str:
        rest, sampled, text = self.travel.rest, self.neutral.value, self._source.text
        if abs(rest - self._calibration.neutral) <= self._calibration.deadband:
            return ""
        output = f"{self.curve.output(rest):+d}".replace("-", "−")
        if self._calibration.neutral != sampled:
            return f"It rests at {text(rest)}: with this neutral it would give {output} there."
        return (
            f"After letting go it rests at {text(rest)}, not at {text(sampled)}, and would give "
            f"{output} there. Was a hand on it while it was sampled, or was a trim moved? Go back "
            "and sample it again, or take the new rest."
        )

    # --- Switches -----------------------------------------------------------------------

    def _switching(self) -> Iterator[Problem]:
        threshold = self.curve.threshold(self.channel)
        if threshold is None:
            return
        if abs(self.neutral.value - threshold) <= self.neutral.deadband:
            text = (
                f"Its rest ({self._source.text(self.neutral.value)}) is too near to where it "
                f"switches ({self._source.text(round(threshold))}): it may switch by itself."
            )
            yield Problem(ProblemKind.SWITCHES_AT_REST, text, fatal=False)
        ends = (self.travel.low, self.travel.high, self.neutral.value)
        active = {self.curve.is_switched(self.channel, end) for end in ends if end is not None}
        if len(active) == 1:
            state = "active" if active.pop() else "inactive"
            where = self._source.text(round(threshold))
            text = (
                f"It is {state} in all its positions: none lies beyond {where}, where it switches. "
                "Should it be reversed, or not?"
            )
            yield Problem(ProblemKind.NEVER_SWITCHES, text, fatal=False)

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
