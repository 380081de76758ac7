"""What the board would make of the sticks with what it stores, while they are pushed about."""

from collections.abc import Sequence

from trex_gui.devices.trex.calibration.proof import (
    StickTest,
    Tested,
    idle_side,
    what_keeps_safe_start,
)
from trex_gui.devices.trex.calibration.samples import LIMITS
from trex_gui.devices.trex.model.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, channels_in
from trex_gui.devices.trex.protocol.parameters import ParameterKey


class StickTests:
    """Tests some channels; the others only count for safe-start.

    The outputs are worked out here, each channel by itself: what the board answers is mixed
    and flipped already.
    """

    def __init__(self, device: Device, numbers: Sequence[int]) -> None:
        self._device = device
        self._tests = {number: StickTest(number) for number in numbers}
        self._outputs: dict[int, int | None] = {}
        self._reached: dict[int, tuple[int, int]] = {}
        self._override = False
        self._heard = False

    @property
    def tested(self) -> tuple[Tested, ...]:
        """What was seen of each channel."""
        return tuple(test.tested for test in self._tests.values())

    @property
    def passed(self) -> bool:
        """Whether everything that is tested is good now, and safe-start would let go."""
        return self.channels_passed and not self.safe_start_reasons

    @property
    def channels_passed(self) -> bool:
        """Whether every channel that is tested is good now, whatever the others do."""
        tested = [tested for tested in self.tested if not tested.ignored]
        return bool(tested) and all(tested.passed for tested in tested)

    @property
    def all_ignored(self) -> bool:
        """Whether the board takes no notice of any of them."""
        return all(tested.ignored for tested in self.tested)

    @property
    def to_learn_again(self) -> tuple[int, ...]:
        """The channels that were moved and are not good so far: to learn them may help."""
        return tuple(
            tested.channel
            for tested in self.tested
            if tested.output is not None
            and not (tested.was_good or tested.ignored)
            and self._has_moved(tested.channel)
        )

    def feed(self, moment: float, counts: Sequence[int | None]) -> None:
        """Take the raw counts of all channels."""
        self._heard = True
        for channel in CHANNELS:
            raw, curve = counts[CHANNELS.index(channel)], self._curve(channel)
            output = None if raw is None or curve is None else curve.output(raw)
            switched = curve is not None and curve.is_switched(channel, raw)
            self._outputs[channel] = output
            if raw is not None:
                low, high = self._reached.get(channel, (raw, raw))
                self._reached[channel] = min(low, raw), max(high, raw)
            if channel == 5:
                self._override = switched
            if channel in self._tests and curve is not None:
                self._tests[channel].feed(
                    moment,
                    output,
                    switched=switched,
                    idle=idle_side(curve.calibration, reversed_=curve.reversed_),
                    ignored=curve.ignored,
                )

    @property
    def heard(self) -> bool:
        """Whether anything was measured so far."""
        return self._heard

    @property
    def mode(self) -> str:
        """The mode in which the channels would be in control: `RC` or `analog`."""
        return "RC" if self._is_rc else "analog"

    @property
    def safe_start_reasons(self) -> tuple[str, ...]:
        """Why safe-start would hold the motors now if the channels were in control."""
        if not self._heard:
            return ()
        return what_keeps_safe_start(
            self._outputs,
            self._device.parameters.stored_of(ParameterKey.REQUIRED_CHANNELS) or 0,
            rc=self._is_rc,
            override=self._override,
            joint=self._device.parameters.stored_of(ParameterKey.MOTOR_MODE) == 1,
        )

    @property
    def safe_start_text(self) -> str:
        """Whether safe-start would end now if the channels were in control."""
        if not self._heard:
            return ""
        if reasons := self.safe_start_reasons:
            because = "; ".join(reasons)
            return f"In {self.mode} mode safe-start would hold the motors now: {because}."
        return f"In {self.mode} mode safe-start would release the motors now."

    @property
    def _is_rc(self) -> bool:
        return self._device.calibrations.source is InputSource.RC

    def _has_moved(self, channel: int) -> bool:
        low, high = self._reached.get(channel, (0, 0))
        return high - low > LIMITS[self._device.calibrations.source].moved

    def _curve(self, channel: int) -> ChannelCurve | None:
        calibration = self._device.calibrations.stored(channel)
        if calibration is None:
            return None
        return ChannelCurve(
            calibration,
            reversed_=self._has(ParameterKey.REVERSED_CHANNELS, channel),
            parabolic=self._has(ParameterKey.PARABOLIC_CHANNELS, channel),
            ignored=self._has(ParameterKey.IGNORED_CHANNELS, channel),
        )

    def _has(self, key: str, channel: int) -> bool:
        return channel in channels_in(self._device.parameters.stored_of(key) or 0)
