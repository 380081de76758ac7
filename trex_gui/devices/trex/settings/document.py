"""The settings of a board, as read, as written in a file, or as shipped."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.device_table import Model
from trex_gui.devices.trex.protocol.parameters import ParameterKey, ParameterSet, parameters_of

REACH = (
    ParameterKey.DEVICE_NUMBER,
    ParameterKey.UART_RESPONSE_DELAY,
    ParameterKey.CRC7_POLYNOMIAL,
    ParameterKey.UART_SETTINGS,
)
"""The parameters that decide how a board is reached."""


@dataclass(frozen=True, slots=True)
class Settings:
    """The settings of one board, as far as they are known.

    Attributes:
        firmware: the version that the settings are for; `None`: unknown.
        parameters: wire values by key.
    """

    product: Model
    firmware: str | None = None
    parameters: Mapping[str, int] = field(default_factory=dict)
    calibrations: Mapping[CalibrationKey, Calibration] = field(default_factory=dict)

    @property
    def specs(self) -> ParameterSet:
        """The parameters that these settings may have."""
        return specs_for(self.product, self.firmware)


def specs_for(product: Model, firmware: str | None) -> ParameterSet:
    """Return the parameters of a model with a firmware, by default the newest one known."""
    return parameters_of(product.key, firmware or product.firmware[-1])


def settings_of(state: DeviceState) -> Settings:
    """Return what the board stores, including values that it would not accept.

    The calibrations are those of the input source in force; the board hides the others.
    """
    stored = state.parameters
    return Settings(
        product=state.signature.model,
        firmware=state.signature.firmware,
        parameters={s.key: stored[s.key] for s in state.specs.readable if s.key in stored},
        calibrations={
            CalibrationKey.of(state.source, channel): calibration
            for channel, calibration in sorted(state.calibrations.items())
        },
    )


def factory_settings(product: Model, firmware: str | None) -> Settings:
    """Return the default parameters; a reset does not change the calibrations.

    `ParameterSpec.default_confirmed` says which defaults no source confirms.
    """
    specs = specs_for(product, firmware).readable
    return Settings(product, firmware, {spec.key: spec.default for spec in specs})


def serial_defaults(product: Model, firmware: str | None) -> Settings:
    """Return the defaults of the parameters that decide how a new board is reached."""
    defaults = factory_settings(product, firmware).parameters
    return Settings(product, firmware, {key: defaults[key] for key in REACH if key in defaults})
