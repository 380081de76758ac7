"""Channel motor control: sticks, flip, serial override, safe-start.

Ref: Pololu TReX User's Guide 4.a-4.c; TReX Jr User's Guide 4.e (safe-start).
"""

from collections.abc import Sequence

from trex_gui.devices.trex.protocol.flags import CHANNELS, Mode, channels_in
from trex_gui.devices.trex.protocol.parameters import MotorParameter, ParameterKey
from trex_gui.devices.trex.simulator.channels import Channels
from trex_gui.devices.trex.simulator.mapping import ChannelSetup, motor_values
from trex_gui.devices.trex.simulator.memory import Memory
from trex_gui.devices.trex.simulator.motors import AuxiliaryMotor, Motor, MotorDirection

_SIGNAL_REQUIRED_WITHIN = 0.5  # seconds; User's Guide 4.c
_NEARLY_NEUTRAL = 8  # inferred: how far sticks may be from neutral when safe-start ends


class ChannelControl:
    """Motor control by the channels.

    Attributes:
        safe_start: whether the motors stay stopped until signals are valid and sticks centred.
        override: whether channel 5 gives control to the serial port.
    """

    def __init__(self, channels: Channels, memory: Memory, mode: Mode) -> None:
        self.safe_start = not mode.is_serial
        self.override = False
        self._channels = channels
        self._memory = memory
        self._mode = mode

    @property
    def setup(self) -> ChannelSetup:
        """Active calibrations and masks."""
        active = self._memory.active
        return ChannelSetup(
            tuple(self._memory.calibration(self._mode.source, channel) for channel in CHANNELS),
            ignored=active[ParameterKey.IGNORED_CHANNELS],
            reversed_=active[ParameterKey.REVERSED_CHANNELS],
            parabolic=active[ParameterKey.PARABOLIC_CHANNELS],
        )

    def remapped(self, *, mix: bool) -> tuple[int, ...]:
        """Return the reply to 0x87, -127 to 127; 1 and 2 are the values of motors 1 and 2."""
        raw = self._channels.raw
        setup = self.setup
        plain = setup.remapped(raw)
        flip = setup.is_switched(4, raw[3])
        joint = self._memory.is_joint
        return *motor_values(plain, mix=mix, flip=flip, joint=joint), *plain[2:]

    def watch(self) -> bool:
        """Update safe-start and override; return whether the serial port controls the motors."""
        if self._mode.is_serial:
            return True
        if not self._channels.has_settled:
            return False  # inferred: unmeasured channels neither override nor end safe-start
        self.override = self.setup.is_switched(5, self._channels.raw[4])
        if self._has_lost_required_channel():
            self.safe_start = True
        elif self.safe_start:
            self.safe_start = not self._may_leave_safe_start()
        # Inferred: safe-start wins over serial override.
        return self.override and not self.safe_start

    def drive(self, motors: Sequence[Motor], aux: AuxiliaryMotor, *, mix: bool) -> None:
        """Drive the motors by the sticks. Inferred: like accelerate commands."""
        remapped = self.remapped(mix=mix)
        for number, motor in enumerate(motors[: 1 if self._memory.is_joint else 2], 1):
            value = remapped[number - 1]
            if value:
                direction = MotorDirection.FORWARD if value > 0 else MotorDirection.REVERSE
                motor.accelerate(direction, abs(value))
            else:
                brake = self._memory.active[MotorParameter.DEADBAND_BRAKE_PWM.of(number)]
                motor.accelerate(MotorDirection.BRAKE, brake)
        aux.accelerate(abs(remapped[2]))  # inferred: one direction only, the sign is ignored

    def _has_lost_required_channel(self) -> bool:
        return self._mode is Mode.RC and any(
            self._channels.silent_for(channel) > _SIGNAL_REQUIRED_WITHIN
            for channel in self._required
        )

    @property
    def _required(self) -> tuple[int, ...]:
        return channels_in(self._memory.active[ParameterKey.REQUIRED_CHANNELS])

    def _may_leave_safe_start(self) -> bool:
        raw = self._channels.raw
        if self._mode is Mode.RC and any(raw[channel - 1] is None for channel in self._required):
            return False
        if self.override:
            return False
        first, second, third = self.setup.remapped(raw)[:3]
        sticks = (first, third) if self._memory.is_joint else (first, second, third)
        return all(abs(stick) <= _NEARLY_NEUTRAL for stick in sticks)
