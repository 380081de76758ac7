"""Motor control by channels: remapping, mixing, switches and safe-start.

Ref: Pololu TReX User's Guide 4.a-4.c; TReX Jr User's Guide 4.e (safe-start); TReX 1.0 command
documentation 0x87.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, Calibration, remap
from trex_gui.devices.trex.protocol.flags import CHANNELS, Mode, channels_in
from trex_gui.devices.trex.protocol.parameters import MotorParameter, ParameterKey
from trex_gui.devices.trex.simulator.channels import Channels
from trex_gui.devices.trex.simulator.memory import Memory
from trex_gui.devices.trex.simulator.motors import AuxiliaryMotor, Motor, MotorDirection


@dataclass(frozen=True, slots=True)
class ChannelSetup:
    """Calibrations and the channel masks in parameters 0x02-0x04."""

    calibrations: Sequence[Calibration]
    ignored: int = 0
    reversed_: int = 0
    parabolic: int = 0

    def remapped(self, raw: Sequence[int | None]) -> tuple[int, ...]:
        """Return the output of each channel before mixing and flip, -127 to 127."""
        return tuple(
            remap(
                raw[index],
                self.calibrations[index],
                parabolic=_has(self.parabolic, index),
                reversed_=_has(self.reversed_, index),
                ignored=_has(self.ignored, index),
            )
            for index in range(len(CHANNELS))
        )

    def is_switched(self, channel: int, raw: int | None) -> bool:
        """True if a switch channel (4: flip, 5: override) is active.

        A switch is active below a threshold (sourced, User's Guide 4.a), and an ignored channel is
        held at neutral (sourced, User's Guide 4.c). Inferred: the threshold is halfway between
        neutral and minimum, a reversed channel is active above a threshold halfway between neutral
        and maximum, and a channel without a signal is inactive.
        """
        index = channel - 1
        if raw is None or _has(self.ignored, index):
            return False
        calibration = self.calibrations[index]
        if _has(self.reversed_, index):
            return raw > (calibration.maximum + calibration.neutral) / 2
        return raw < (calibration.minimum + calibration.neutral) / 2


def motor_values(remapped: Sequence[int], *, mix: bool, flip: bool, joint: bool) -> tuple[int, int]:
    """Return the values of motors 1 and 2, -127 to 127.

    With mixing, channel 2 controls the forward speed and channel 1 the turn (User's Guide 4.a). The
    sums and their clipping are inferred. Flip swaps the motors and reverses both (User's Guide
    4.a). Joint mode has no mixing (TReX Jr manual page 6). Inferred: in joint mode, flip reverses
    motor 1.
    """
    turn, forward = remapped[0], remapped[1]
    if joint:
        return (-turn if flip else turn), forward
    first, second = turn, forward
    if mix:
        first, second = _clip(forward + turn), _clip(forward - turn)
    return (-second, -first) if flip else (first, second)


def _has(mask: int, index: int) -> bool:
    return bool(mask >> index & 1)


def _clip(value: int) -> int:
    return max(-FULL_SCALE, min(FULL_SCALE, value))


_SIGNAL_TIMEOUT = 0.5  # seconds without a required signal until safe-start; User's Guide 4.c
_NEARLY_NEUTRAL = 8  # maximum stick output at which safe-start ends, inferred


class ChannelControl:
    """Control of the motors by the channels, with serial override and safe-start."""

    def __init__(self, channels: Channels, memory: Memory, mode: Mode) -> None:
        self.safe_start = not mode.is_serial  # True until signals are valid and sticks are centred
        self.override = False  # True if channel 5 selects serial control
        self._channels = channels
        self._memory = memory
        self._mode = mode

    @property
    def setup(self) -> ChannelSetup:
        active, eeprom = self._memory.active, self._memory.eeprom
        return ChannelSetup(
            tuple(eeprom.calibration(self._mode.source, channel) for channel in CHANNELS),
            ignored=active[ParameterKey.IGNORED_CHANNELS],
            reversed_=active[ParameterKey.REVERSED_CHANNELS],
            parabolic=active[ParameterKey.PARABOLIC_CHANNELS],
        )

    def remapped(self, *, mix: bool) -> tuple[int, ...]:
        """Return the reply to 0x87, -127 to 127. The first two values are for motors 1 and 2."""
        raw, setup = self._channels.raw, self.setup
        values, flip = setup.remapped(raw), setup.is_switched(4, raw[3])
        joint = self._memory.is_joint
        return *motor_values(values, mix=mix, flip=flip, joint=joint), *values[2:]

    def update(self) -> bool:
        """Update safe-start and override. Return whether the serial port controls the motors."""
        if self._mode.is_serial:
            return True
        if not self._channels.has_settled:
            return False  # inferred: unmeasured channels neither override nor end safe-start
        self.override = self.setup.is_switched(5, self._channels.raw[4])
        if self._mode is Mode.RC and any(
            self._channels.silence(channel) >= _SIGNAL_TIMEOUT for channel in self._required
        ):
            self.safe_start = True
        elif self.safe_start:
            self.safe_start = not self._may_end_safe_start()
        # Inferred: safe-start has priority over serial override.
        return self.override and not self.safe_start

    def drive(self, motors: Sequence[Motor], aux: AuxiliaryMotor, *, mix: bool) -> None:
        """Drive the motors with the sticks. Inferred: the acceleration parameters apply."""
        remapped = self.remapped(mix=mix)
        for number, motor in enumerate(motors[: 1 if self._memory.is_joint else 2], 1):
            value = remapped[number - 1]
            if value:
                direction = MotorDirection.FORWARD if value > 0 else MotorDirection.REVERSE
                motor.accelerate(direction, abs(value))
            else:
                brake = self._memory.active[MotorParameter.DEADBAND_BRAKE_PWM.of(number)]
                motor.accelerate(MotorDirection.BRAKE, brake)
        aux.accelerate(abs(remapped[2]))  # inferred: the sign is ignored

    @property
    def _required(self) -> tuple[int, ...]:
        return channels_in(self._memory.active[ParameterKey.REQUIRED_CHANNELS])

    def _may_end_safe_start(self) -> bool:
        raw = self._channels.raw
        if self._mode is Mode.RC and any(raw[channel - 1] is None for channel in self._required):
            return False
        if self.override:
            return False
        first, second, third = self.setup.remapped(raw)[:3]
        sticks = (first, third) if self._memory.is_joint else (first, second, third)
        return all(abs(stick) <= _NEARLY_NEUTRAL for stick in sticks)
