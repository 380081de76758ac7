"""What the motors and the current sensors do: a plain DC motor behind each output."""

import random
from dataclasses import dataclass

HIGHEST_READING = 255


@dataclass(frozen=True, slots=True)
class MotorConstants:
    """The motor that hangs on an output.

    Attributes:
        stall: current in A at full voltage and standstill.
        free: current in A at full speed without load.
        time_constant: seconds in which a motor without load reaches 63 % of its speed.
        light_load: current in A at full speed of a robot that rolls on a floor.
    """

    stall: float
    free: float
    time_constant: float
    light_load: float


MOTORS = {
    # The driver peaks at 30 A and carries 13 A: a motor that a careful builder would take.
    "trex": MotorConstants(stall=30.0, free=0.6, time_constant=0.15, light_load=3.0),
    # The driver limits itself from 5.2 A on and carries 2.5 A.
    "trexjr": MotorConstants(stall=5.0, free=0.2, time_constant=0.1, light_load=0.8),
}

_NOISE_COUNTS = 0.3
"""Standard deviation of a reading: an average of 64 samples rarely moves by a count."""

_CRAWL = 0.02
"""Speed at full voltage, of the free one, of a motor whose load nearly stalls it."""


class MotorPhysics:
    """One motor with its load, its driver's fault state and its current sensor.

    Speed is a fraction of the free speed, voltage of the supply. The current is what the
    voltage that the motor's own does not oppose drives through it; it accelerates the motor
    as far as the load does not need it. The load grows with the speed.

    Attributes:
        load: current in A that the motor draws at full voltage once it runs.
        forced: current in A that the sensor shows instead of the real one; `None` for none.
        fault: whether the driver has shut itself down.
        speed: -1 to 1.
        reading: the last measurement in counts of 0x8D, 0-255.
    """

    def __init__(self, constants: MotorConstants, current_unit: float, seed: int) -> None:
        self.load = constants.free
        self.forced: float | None = None
        self.fault = False
        self.speed = 0.0
        self.reading = 0
        self._constants = constants
        self._unit = current_unit
        self._random = random.Random(seed)  # noqa: S311 - noise, not secrets
        self._charge = 0.0
        self._time = 0.0

    def advance(self, seconds: float, voltage: float, brake: float) -> None:
        """Let time pass with a voltage (-1 to 1), or without one and a duty of braking."""
        stall = self._constants.stall
        if voltage and not self.fault:
            current = stall * (voltage - self.speed)
            self._charge += abs(current) * seconds
        else:
            # A braked motor drives its current through the low side, past the sensor.
            current = 0.0 if self.fault else -stall * brake * self.speed
        self._time += seconds
        load = min(self.load, stall)
        against = load * self.speed / max(1 - load / stall, _CRAWL)
        self.speed += (current - against) / (stall * self._constants.time_constant) * seconds
        if abs(self.speed) < 1e-4:
            self.speed = 0.0

    def measure(self) -> None:
        """Take a reading: the average current since the last one."""
        mean = self._charge / self._time if self._time else 0.0
        self._charge = self._time = 0.0
        if self.forced is not None:
            counts = self.forced / self._unit
        elif mean:
            counts = mean / self._unit + self._random.gauss(0, _NOISE_COUNTS)
        else:
            counts = 0.0
        self.reading = max(0, min(HIGHEST_READING, round(counts)))

    def clear_reading(self) -> None:
        """Forget the measurement, as when the power goes or there is no sensing."""
        self.reading = 0
        self._charge = self._time = 0.0

    @property
    def current(self) -> float:
        """The last reading in A."""
        return self.reading * self._unit
