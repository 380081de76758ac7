"""Current limits and ramps for kinds of robots, from the sample settings."""

from collections.abc import Mapping
from enum import Enum
from functools import cache

from trex_gui.core.resource_files import resource
from trex_gui.devices.trex.protocol.parameters import MotorParameter
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.reader import read_settings

LIMITS = tuple(MotorParameter.CURRENT_LIMIT.of(motor) for motor in (1, 2))

_RAMPS = (
    MotorParameter.ACCELERATION,
    MotorParameter.BRAKE_DURATION,
    MotorParameter.CURRENT_LIMIT_P,
)


class Preset(Enum):
    """Kinds of robots. The value is the file name of a sample."""

    TANK = "tank_with_mix.txt"
    ROVER = "rover_with_serial_override.txt"
    AUTONOMOUS = "autonomous_robot.txt"

    @property
    def product(self) -> str:
        """Key of the board model of the sample."""
        return _sample(self.value).product.key

    def values(self, model: str) -> Mapping[str, int]:
        """Return wire values by key for a model.

        Current limits are left out if the sample is for another model, because their units and
        the ratings of the motor drivers differ.
        """
        sample = _sample(self.value).parameters
        keys = [parameter.of(motor) for motor in (1, 2) for parameter in _RAMPS]
        return {key: sample[key] for key in (*keys, *(LIMITS if model == self.product else ()))}


@cache
def _sample(name: str) -> Settings:
    settings, _ = read_settings((resource("samples") / name).read_bytes(), name)
    return settings
