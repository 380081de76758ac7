"""What a settings file says, and the keys that it says it with."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.device_table import Model
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.protocol.parameters import ParameterSet, parameters_of


def calibration_key(source: InputSource, channel: int) -> str:
    """Return the key of the calibration of a channel: `rc_channel_1`."""
    return f"{source.value.lower()}_channel_{channel}"


CALIBRATION_KEYS: Mapping[str, tuple[InputSource, int]] = {
    calibration_key(source, channel): (source, channel)
    for source in InputSource
    for channel in CHANNELS
}
"""`rc_channel_1` to `analog_channel_5`, and what each calibrates."""

CALIBRATION_FIELDS = ("minimum", "neutral", "maximum", "deadband")


@dataclass(frozen=True, slots=True)
class Settings:
    """What a board keeps, or is to keep; as much of it as is known.

    Attributes:
        firmware: the version these settings are for; `None`: not said.
        parameters: wire values by key.
        calibrations: by input source and channel.
    """

    product: Model
    firmware: str | None = None
    parameters: Mapping[str, int] = field(default_factory=dict)
    calibrations: Mapping[tuple[InputSource, int], Calibration] = field(default_factory=dict)

    @property
    def specs(self) -> ParameterSet:
        """The parameters that these settings may have."""
        return specs_for(self.product, self.firmware)


def specs_for(product: Model, firmware: str | None) -> ParameterSet:
    """Return the parameters of a model with a firmware, or with the newest one known."""
    return parameters_of(product.key, firmware or product.firmware[-1])
