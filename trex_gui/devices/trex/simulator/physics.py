"""Battery, two DC motors with loads, and current sensors.

A motor has a resistance, a back-EMF, an inertia and dry friction. The current is high when the
motor starts or reverses, falls as the speed rises, and rises with the load up to the stall current.
The battery voltage sags under the currents of both motors.
"""

import math
import random
from collections.abc import Sequence
from dataclasses import dataclass

HIGHEST_READING = 255


@dataclass(frozen=True, slots=True)
class Constants:
    battery: float  # V without load
    battery_resistance: float  # ohm, including cables
    brown_out: float  # V below which the board resets
    resistance: float  # ohm, of motor, driver and wires
    back_emf: float  # V s/rad; the torque constant in N m/A has the same value
    inertia: float  # kg m2, of rotor and gears, referred to the rotor
    free_current: float  # A without load, due to friction of motor and gears
    light_load: float  # A for a robot on a flat floor

    @property
    def stall_current(self) -> float:
        return self.battery / self.resistance


CONSTANTS = {
    # The vendor specifies only the drivers. These motors are the largest that the drivers support.
    "trex": Constants(
        battery=12.0,  # six lead cells
        battery_resistance=0.04,  # a 7 Ah lead battery (25 mOhm) and a metre of cable
        brown_out=6.0,  # inferred: a linear regulator needs 1 V more than the 5 V of the logic
        resistance=0.4,  # stalls at 30 A; continuous rating 13 A (sourced: VNH2SP30 carrier)
        back_emf=7.33e-3,  # 15,000 rpm at 12 V, for a motor of size 550
        inertia=8e-6,  # time constant of 60 ms, which is typical for this size
        free_current=1.2,  # 4 % of the stall current, which is typical with a gearbox
        light_load=3.0,
    ),
    "trexjr": Constants(
        battery=12.0,  # ten NiMH cells
        battery_resistance=0.2,  # ten AA cells of 20 mOhm
        brown_out=5.0,  # sourced: the Jr runs from 5 to 24 V
        resistance=2.4,  # stalls at 5 A; continuous rating 2.5 A (sourced)
        back_emf=1.1e-2,  # 10,000 rpm at 12 V, for a small gear motor
        inertia=3e-6,  # time constant of 60 ms
        free_current=0.2,
        light_load=0.8,
    ),
}

_NOISE_COUNTS = 0.3  # standard deviation of a reading, which is an average of 64 samples


class MotorPhysics:
    def __init__(self, constants: Constants, current_unit: float, seed: int) -> None:
        self.constants = constants
        self.initial_load = constants.free_current  # A; initial value of `load`
        self._unit = current_unit
        self._random = random.Random(seed)  # noqa: S311 - noise, not secrets
        self._charge = 0.0  # A s since the last measurement
        self._time = 0.0  # s since the last measurement
        self.factory_reset()

    def factory_reset(self) -> None:
        self.load = self.initial_load  # A; dry friction, which does not depend on the speed
        self.forced: float | None = None  # reported current in A; `None` for the real current
        self.fault = False  # True if the driver has shut down
        self.speed = 0.0  # rad/s, positive forward
        self.clear_reading()

    def current_at(self, volts: float) -> float:
        """Return the current in A at a voltage.

        Inferred: the motor coasts between PWM pulses, so no current flows against the voltage.
        """
        current = (volts - self.constants.back_emf * self.speed) / self.constants.resistance
        return current if not self.fault and current * volts > 0 else 0.0

    def advance(self, seconds: float, volts: float, brake: float) -> None:
        """Advance the time. At 0 V, the motor brakes with the duty cycle `brake` (0-1)."""
        self._time += seconds
        if not volts and not self.speed:
            return
        constants = self.constants
        if volts:
            current = self.current_at(volts)
            self._charge += abs(current) * seconds
        elif self.fault:
            current = 0.0
        else:  # the driver shorts the motor on the low side, where the sensor sees no current
            current = -brake * constants.back_emf * self.speed / constants.resistance
        gain = constants.back_emf / constants.inertia * seconds
        friction = gain * max(self.load, constants.free_current)
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
        self.reading = max(0, min(HIGHEST_READING, round(counts)))  # counts in replies to 0x8D

    def clear_reading(self) -> None:
        self.reading = 0
        self._charge = self._time = 0.0

    @property
    def current(self) -> float:
        return self.reading * self._unit

    @property
    def rpm(self) -> float:
        """Rotor speed in revolutions per minute. Positive forward."""
        return self.speed * 30 / math.pi


@dataclass(frozen=True, slots=True)
class DriverOutput:
    duty: float = 0.0  # duty cycle of driving, -1 to 1; negative in reverse
    brake: float = 0.0  # duty cycle of braking, 0-1


class Machine:
    """Battery and two motors. `volts` is the supply voltage at the board."""

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
    def is_browned_out(self) -> bool:
        return self.volts < self.constants.brown_out

    def advance(self, seconds: float, drives: Sequence[DriverOutput]) -> None:
        self.volts = self._volts(drives)
        for motor, drive in zip(self.motors, drives, strict=True):
            motor.advance(seconds, drive.duty * self.volts, drive.brake)

    def _volts(self, drives: Sequence[DriverOutput]) -> float:
        """Return the voltage at the board under load.

        The motor current is (duty * volts - emf) / R, and the battery current is duty times the
        motor current. The equation is linear in the voltage while no current flows back.
        """
        loads = [
            (motor, drive.duty)
            for motor, drive in zip(self.motors, drives, strict=True)
            if drive.duty and not motor.fault
        ]
        while loads:
            conductance = sum(duty * duty / motor.constants.resistance for motor, duty in loads)
            opposing = sum(
                duty * motor.constants.back_emf * motor.speed / motor.constants.resistance
                for motor, duty in loads
            )
            volts = (self.battery + self.resistance * opposing) / (
                1 + self.resistance * conductance
            )
            remaining = [(motor, duty) for motor, duty in loads if motor.current_at(duty * volts)]
            if len(remaining) == len(loads):
                return volts
            loads = remaining
        return self.battery
