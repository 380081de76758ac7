"""Battery, two DC motors with their loads, current sensors.

A motor is a resistance and a back-EMF that turn an inertia against dry friction. Its current is
high at a start or a reversal, falls with speed, follows the load, and is highest when stalled.
The battery voltage sags under the sum of both currents.
"""

import math
import random
from collections.abc import Sequence
from dataclasses import dataclass

HIGHEST_READING = 255


@dataclass(frozen=True, slots=True)
class Constants:
    battery: float  # V without load
    battery_resistance: float  # ohm, with cables
    brown_out: float  # V below which the board resets
    resistance: float  # ohm, of a motor with its driver and wires
    back_emf: float  # V s/rad of a motor; its torque constant is the same figure in N m/A
    inertia: float  # kg m2, of rotor and gears as seen from the rotor
    free: float  # A that a motor draws without load, by its own friction and its gears' friction
    light_load: float  # A that a motor draws when it drives a robot on a flat floor

    @property
    def stall(self) -> float:
        """Stall current in A at full battery voltage."""
        return self.battery / self.resistance


CONSTANTS = {
    # Only the drivers' figures are the vendor's. The motors are the largest that they support.
    "trex": Constants(
        battery=12.0,  # six lead cells
        battery_resistance=0.04,  # a 7 Ah lead battery (25 mOhm) and a metre of cable
        brown_out=6.0,  # inferred: a linear regulator for 5 V logic needs a volt more
        resistance=0.4,  # stalls at 30 A; continuous rating 13 A (reference: VNH2SP30 carrier)
        back_emf=7.33e-3,  # 15,000 turns a minute at 12 V, a motor of the 550 size
        inertia=8e-6,  # speeds up with a time constant of 60 ms, usual for that size
        free=1.2,  # 4 % of the stall current, usual with a gearbox
        light_load=3.0,
    ),
    "trexjr": Constants(
        battery=12.0,  # ten NiMH cells
        battery_resistance=0.2,  # ten AA cells of 20 mOhm
        brown_out=5.0,  # sourced: the Jr runs from 5 to 24 V
        resistance=2.4,  # stalls at 5 A; continuous rating 2.5 A (sourced)
        back_emf=1.1e-2,  # 10,000 turns a minute at 12 V, a small gear motor
        inertia=3e-6,  # time constant of 60 ms, too
        free=0.2,
        light_load=0.8,
    ),
}

_NOISE_COUNTS = 0.3
"""Standard deviation of a reading: an average of 64 samples rarely moves by a count."""


class MotorPhysics:
    """One motor with its load, its driver's fault state and its current sensor."""

    def __init__(self, constants: Constants, current_unit: float, seed: int) -> None:
        self.constants = constants
        self.load_at_first = constants.free  # the load after `factory_reset`
        self._unit = current_unit
        self._random = random.Random(seed)  # noqa: S311 - noise, not secrets
        self._charge = 0.0  # A s since the last measurement
        self._time = 0.0  # s
        self.factory_reset()

    def factory_reset(self) -> None:
        self.load = self.load_at_first  # A when running; dry friction, the same at all speeds
        self.forced: float | None = None  # A that the sensor reports; `None` for the real current
        self.fault = False  # whether the driver has shut down
        self.speed = 0.0  # rad/s, positive forward
        self.clear_reading()

    def current_at(self, volts: float) -> float:
        """Return the current in A at a voltage.

        Inferred: between the pulses of the PWM the motor coasts, so that no current flows against
        the voltage.
        """
        current = (volts - self.constants.back_emf * self.speed) / self.constants.resistance
        return current if not self.fault and current * volts > 0 else 0.0

    def advance(self, seconds: float, volts: float, brake: float) -> None:
        """Advance the time at a voltage, or at 0 V with a duty cycle of braking (0-1)."""
        self._time += seconds
        if not volts and not self.speed:
            return
        constants = self.constants
        if volts:
            current = self.current_at(volts)
            self._charge += abs(current) * seconds
        elif self.fault:
            current = 0.0
        else:  # the low side shorts the motor; the sensor does not see this current
            current = -brake * constants.back_emf * self.speed / constants.resistance
        gain = constants.back_emf / constants.inertia * seconds
        friction = gain * max(self.load, constants.free)
        speed = self.speed + gain * current
        self.speed = math.copysign(max(0.0, abs(speed) - friction), speed)

    def measure(self) -> None:
        mean = self._charge / self._time if self._time else 0.0
        self._charge = self._time = 0.0
        if self.forced is not None:
            counts = self.forced / self._unit
        elif mean:
            counts = mean / self._unit + self._random.gauss(0, _NOISE_COUNTS)
        else:
            counts = 0.0
        self.reading = max(0, min(HIGHEST_READING, round(counts)))  # last reading, counts of 0x8D

    def clear_reading(self) -> None:
        """Discard the measurement: no power, or no current sensing."""
        self.reading = 0
        self._charge = self._time = 0.0

    @property
    def current(self) -> float:
        return self.reading * self._unit

    @property
    def rpm(self) -> float:
        """Turns a minute of the rotor, positive forward."""
        return self.speed * 30 / math.pi


@dataclass(frozen=True, slots=True)
class DriverOutput:
    """Share of the supply voltage at a motor (-1 to 1), or duty cycle of braking (0-1)."""

    share: float = 0.0
    brake: float = 0.0


class Machine:
    """A battery (V without load, ohm with cables) and two motors. `volts` are at the board."""

    def __init__(self, model: str, current_unit: float, seed: int) -> None:
        self.constants = CONSTANTS[model]
        self.motors = tuple(
            MotorPhysics(self.constants, current_unit, seed * 2 + index) for index in range(2)
        )
        self.factory_reset()

    def factory_reset(self) -> None:
        self.battery = self.constants.battery
        self.resistance = self.constants.battery_resistance
        self.volts = self.battery
        for motor in self.motors:
            motor.factory_reset()

    @property
    def is_too_low(self) -> bool:
        return self.volts < self.constants.brown_out

    def advance(self, seconds: float, drives: Sequence[DriverOutput]) -> None:
        self.volts = self._volts(drives)
        for motor, drive in zip(self.motors, drives, strict=True):
            motor.advance(seconds, drive.share * self.volts, drive.brake)

    def _volts(self, drives: Sequence[DriverOutput]) -> float:
        """Return the voltage at the board under the currents of its motors.

        Motor current is (share * volts - emf) / R, and the battery supplies `share` of it. The
        equation is linear in the voltage as long as no current would flow back.
        """
        taking = [
            (motor, drive.share)
            for motor, drive in zip(self.motors, drives, strict=True)
            if drive.share and not motor.fault
        ]
        while taking:
            conductance = sum(share * share / motor.constants.resistance for motor, share in taking)
            opposing = sum(
                share * motor.constants.back_emf * motor.speed / motor.constants.resistance
                for motor, share in taking
            )
            volts = (self.battery + self.resistance * opposing) / (
                1 + self.resistance * conductance
            )
            still = [(motor, share) for motor, share in taking if motor.current_at(share * volts)]
            if len(still) == len(taking):
                return volts
            taking = still
        return self.battery
