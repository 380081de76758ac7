"""What the board would make of the sticks with what it stores, while they are pushed about."""

from collections.abc import Sequence

from trex_gui.learning.proof import StickTest, Tested, what_keeps_safe_start
from trex_gui.model.channel_curve import ChannelCurve
from trex_gui.model.device import Device
from trex_gui.protocol.flags import CHANNELS, InputSource, channels_in


class StickTests:
    """Tests some channels; the others only count for safe-start.

    The outputs are worked out here, each channel by itself: what the board answers is mixed
    and flipped already.
    """

    def __init__(self, device: Device, numbers: Sequence[int]) -> None:
        self._device = device
        self._tests = {number: StickTest(number) for number in numbers}
        self._outputs: dict[int, int | None] = {}
        self._override = False
        self._heard = False

    @property
    def tested(self) -> tuple[Tested, ...]:
        """What was seen of each channel."""
        return tuple(test.tested for test in self._tests.values())

    @property
    def passed(self) -> bool:
        """Whether everything that is tested is good."""
        return all(tested.passed for tested in self.tested)

    def feed(self, moment: float, counts: Sequence[int | None]) -> None:
        """Take the raw counts of all channels."""
        self._heard = True
        for channel in CHANNELS:
            raw, curve = counts[CHANNELS.index(channel)], self._curve(channel)
            output = None if raw is None or curve is None else curve.output(raw)
            switched = curve is not None and curve.is_switched(channel, raw)
            self._outputs[channel] = output
            if channel == 5:
                self._override = switched
            if channel in self._tests:
                self._tests[channel].feed(moment, output, switched=switched)

    @property
    def safe_start_text(self) -> str:
        """Whether safe-start would end now if the channels were in control."""
        if not self._heard:
            return ""
        rc = self._device.calibrations.source is InputSource.RC
        mode = "RC" if rc else "analog"
        reasons = what_keeps_safe_start(
            self._outputs,
            self._device.parameters.stored_of("required_channels") or 0,
            rc=rc,
            override=self._override,
            joint=self._device.parameters.stored_of("motor_mode") == 1,
        )
        if reasons:
            because = "; ".join(reasons)
            return f"In {mode} mode safe-start would hold the motors now: {because}."
        return f"In {mode} mode safe-start would let the motors go now."

    def _curve(self, channel: int) -> ChannelCurve | None:
        calibration = self._device.calibrations.stored(channel)
        if calibration is None:
            return None
        return ChannelCurve(
            calibration,
            reversed_=self._has("reversed_channels", channel),
            parabolic=self._has("parabolic_channels", channel),
            ignored=self._has("ignored_channels", channel),
        )

    def _has(self, key: str, channel: int) -> bool:
        return channel in channels_in(self._device.parameters.stored_of(key) or 0)
