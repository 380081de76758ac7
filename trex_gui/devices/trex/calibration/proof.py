"""Whether a calibration does what it should: full output at both ends, none at rest.

What is judged is what the board would make of the inputs with what it stores.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from trex_gui.devices.trex.calibration.travel import TASKS, Task
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, Calibration
from trex_gui.devices.trex.protocol.flags import channels_in

_HELD = 3
"""Samples in a row (60 ms) that make an end reached."""

_REST_SECONDS = 0.5
"""How long a channel has to give 0 to be at rest."""

NEARLY_NEUTRAL = 8
"""Inferred: outputs up to this end safe-start; the guide only says "near neutral"."""


@dataclass(frozen=True, slots=True)
class Tested:
    """What was seen of one channel.

    Attributes:
        output: -127 to 127 now; `None` without a signal.
        forward, reverse: full output was reached on that side.
        is_at_rest: it has given 0 for a while.
        on, off: a switch was seen active, inactive.
        ignored: the board takes no notice of it, so there is nothing to test.
        passed: everything that the channel is there for was seen, and it rests now.
        was_good: it had passed at some time.
    """

    channel: int
    output: int | None = None
    forward: bool = False
    reverse: bool = False
    is_at_rest: bool = False
    on: bool = False
    off: bool = False
    ignored: bool = False
    passed: bool = False
    was_good: bool = False

    @property
    def text(self) -> str:
        """What is still to be done, or that it is good."""
        if self.ignored:
            return "Ignored: the board holds it at neutral. There is nothing to test."
        if self.output is None:
            return "No signal comes in."
        if self.passed:
            return "Good."
        if TASKS[self.channel] is Task.SWITCH:
            if not self.off and not self.on:
                return "Move the switch to all its positions."
            now = "off" if self.off else "on"
            return f"Seen {now} only. Move the switch to its other position."
        if TASKS[self.channel] is Task.ONE_WAY and (self.forward or self.reverse):
            return self._rest_text()
        missing = [
            name
            for seen, name in ((self.forward, "forward (+127)"), (self.reverse, "reverse (−127)"))
            if not seen
        ]
        if not missing:
            return self._rest_text()
        if TASKS[self.channel] is Task.ONE_WAY:
            return "Full output not reached yet. Push it all the way."
        return f"Full output not reached yet: {' and '.join(missing)}."

    def _rest_text(self) -> str:
        if self.is_at_rest:
            return "Full output reached."
        if self.output == 0:
            return "Full output reached. Let it rest for a moment."
        now = f"{self.output:+d}".replace("-", "−")
        return f"Full output reached. Let go: at rest it must give 0, now it gives {now}."


class StickTest:
    """Follows the output of one channel."""

    def __init__(self, channel: int) -> None:
        self.channel = channel
        self._tested = Tested(channel)
        self._forward = self._reverse = 0
        self._seen = {False: 0, True: 0}
        self._full = {False: False, True: False}
        self._zero_since: float | None = None
        self._was_good = False

    def feed(
        self,
        time: float,
        output: int | None,
        *,
        switched: bool = False,
        idle: int = 0,
        ignored: bool = False,
    ) -> None:
        """Take what the channel gives now.

        `switched` says whether a switch is active; `idle` is the sign of the output on the side
        to which a throttle never goes (`idle_side`); `ignored`, whether the board looks at it.
        """
        if TASKS[self.channel] is not Task.ONE_WAY:
            idle = 0
        self._forward = self._forward + 1 if output == FULL_SCALE and idle <= 0 else 0
        self._reverse = self._reverse + 1 if output == -FULL_SCALE and idle >= 0 else 0
        self._full[True] |= self._forward >= _HELD
        self._full[False] |= self._reverse >= _HELD
        if output is not None:
            self._seen[switched] += 1
        if output != 0:
            self._zero_since = None
        elif self._zero_since is None:
            self._zero_since = time
        is_at_rest = self._zero_since is not None and time - self._zero_since >= _REST_SECONDS
        on, off = (self._seen[state] >= _HELD for state in (True, False))
        match TASKS[self.channel]:
            case Task.SWITCH:
                good = on and off and output is not None
            case Task.ONE_WAY:
                good = is_at_rest and any(self._full.values())
            case Task.STICK:
                good = is_at_rest and all(self._full.values())
        self._was_good |= good and not ignored
        self._tested = Tested(
            self.channel,
            output,
            forward=self._full[True],
            reverse=self._full[False],
            is_at_rest=is_at_rest,
            on=on,
            off=off,
            ignored=ignored,
            passed=good and not ignored,
            was_good=self._was_good,
        )

    @property
    def tested(self) -> Tested:
        """What was seen so far."""
        return self._tested


def idle_side(calibration: Calibration, *, reversed_: bool) -> int:
    """Return the sign of the output on the shorter side of rest; 0 when both are as long.

    The end of a throttle that rests at one end of its way lies only just beyond its rest
    there: the trim alone reaches it, and that shows nothing.
    """
    up = calibration.maximum - calibration.neutral
    down = calibration.neutral - calibration.minimum
    if up == down:
        return 0
    return -1 if (up > down) != reversed_ else 1


def what_keeps_safe_start(
    outputs: Mapping[int, int | None], required: int, *, rc: bool, override: bool, joint: bool
) -> tuple[str, ...]:
    """Say why the motors would stay off after power-up with the channels in control.

    Ref: TReX Jr User's Guide 4.e; how near to neutral is near is inferred. `outputs` are those
    of each channel by itself, `required` is the parameter's mask, `override` says whether
    channel 5 is active.
    """
    reasons = [
        f"channel {channel} is required and has no signal"
        for channel in channels_in(required)
        if rc and outputs.get(channel) is None
    ]
    for channel in (1, 3) if joint else (1, 2, 3):
        output = outputs.get(channel)
        if output is not None and abs(output) > NEARLY_NEUTRAL:
            reasons.append(f"channel {channel} gives {output:+d}".replace("-", "−"))
    if override:
        reasons.append("channel 5 overrides")
    return tuple(reasons)
