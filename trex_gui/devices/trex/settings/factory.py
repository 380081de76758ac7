"""What a board comes with, as far as it is known."""

from trex_gui.devices.trex.protocol.device_table import Model
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey
from trex_gui.devices.trex.settings.document import Settings, specs_for

REACH = (
    ParameterKey.DEVICE_NUMBER,
    ParameterKey.UART_RESPONSE_DELAY,
    ParameterKey.CRC7_POLYNOMIAL,
    ParameterKey.UART_SETTINGS,
)
"""What decides how a board is reached; the serial timeout and the like are left alone."""


def factory_settings(product: Model, firmware: str | None) -> Settings:
    """Return the parameters of a new board; calibrations are no part of its own reset.

    Which of the defaults no source confirms, the parameter table says
    (`ParameterSpec.default_confirmed`).
    """
    specs = specs_for(product, firmware).readable
    return Settings(product, firmware, {spec.key: spec.default for spec in specs})


def serial_defaults(product: Model, firmware: str | None) -> Settings:
    """Return only the parameters that decide how a new board is reached."""
    every = factory_settings(product, firmware)
    reach: dict[str, int] = {key: every.parameters[key] for key in REACH if key in every.parameters}
    return Settings(product, firmware, reach)
