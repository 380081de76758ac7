"""Settings of a board, a file or the factory."""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field, replace

from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.device_table import Model
from trex_gui.devices.trex.protocol.parameters import (
    ParameterKey,
    ParameterSet,
    ParameterSpec,
    parameters_of,
)

LINK_KEYS = (  # they determine how a connection reaches the board
    ParameterKey.DEVICE_NUMBER,
    ParameterKey.UART_RESPONSE_DELAY,
    ParameterKey.CRC7_POLYNOMIAL,
    ParameterKey.UART_SETTINGS,
)


@dataclass(frozen=True, slots=True)
class Settings:
    product: Model
    firmware: str | None = None  # `None`: unknown
    parameters: Mapping[str, int] = field(default_factory=dict)  # key → wire value
    calibrations: Mapping[CalibrationKey, Calibration] = field(default_factory=dict)
    notes: Mapping[str, str] = field(default_factory=dict)  # key → note; see the module `notes`

    @property
    def specs(self) -> ParameterSet:
        return specs_for(self.product, self.firmware)

    def parameter_items(self) -> list[tuple[ParameterSpec, int]]:
        """Return the given parameters with their wire values, in order of their numbers."""
        given = self.parameters
        return [(spec, given[spec.key]) for spec in self.specs.readable if spec.key in given]

    def calibration_items(self) -> list[tuple[CalibrationKey, Calibration]]:
        """Return the given calibrations, RC pulses before analog voltages."""
        return [(key, self.calibrations[key]) for key in CalibrationKey if key in self.calibrations]

    @property
    def keys(self) -> set[str]:
        return {*self.parameters, *self.calibrations}

    def only(self, keys: Collection[str]) -> "Settings":
        return replace(
            self,
            parameters={key: wire for key, wire in self.parameters.items() if key in keys},
            calibrations={key: c for key, c in self.calibrations.items() if key in keys},
        )

    def without(self, keys: Iterable[str]) -> "Settings":
        return self.only(self.keys.difference(keys))

    def without_invalid(self, *, forced: bool = True) -> "Settings":
        """Return the settings without invalid values. `forced` retains the `open_values`."""
        return replace(
            self,
            parameters={
                spec.key: wire
                for spec, wire in self.parameter_items()
                if not spec.problem(wire, forced=forced)
            },
            calibrations={key: c for key, c in self.calibration_items() if not c.problem()},
        )


def open_values(specs: ParameterSet, parameters: Mapping[str, int]) -> dict[str, int]:
    """Return the values outside an inferred limit, which the board may or may not accept."""
    return {
        spec.key: parameters[spec.key]
        for spec in specs.readable
        if spec.key in parameters and spec.is_open(parameters[spec.key])
    }


def specs_for(product: Model, firmware: str | None) -> ParameterSet:
    """Return the parameters of a model and firmware. `None` means the newest firmware."""
    return parameters_of(product.key, firmware or product.firmware[-1])


def settings_of(state: DeviceState) -> Settings:
    """Return the stored settings, without the calibrations that the board hides."""
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
    """Return the default parameters. A factory reset does not change calibrations (inferred).

    See `unconfirmed_defaults` for defaults without a source.
    """
    specs = specs_for(product, firmware).readable
    return Settings(product, firmware, {spec.key: spec.default for spec in specs})


def serial_defaults(product: Model, firmware: str | None) -> Settings:
    return factory_settings(product, firmware).only(LINK_KEYS)
