"""Factory settings, and strategies for any valid settings."""

from dataclasses import replace
from functools import cache

from hypothesis import strategies as st

from trex_gui.devices.trex.protocol.calibration import (
    DEFAULT_CALIBRATION,
    HIGHEST_CODED,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.settings.document import Settings, specs_for
from trex_gui.devices.trex.settings.notes import clean_note

TREX, TREX_JR = device_table().models


def factory(model_key: str = "trex", firmware: str | None = "1.2") -> Settings:
    """Return factory settings with both sets of calibrations."""
    model = device_table().model(model_key)
    return Settings(
        product=model,
        firmware=firmware,
        parameters={spec.key: spec.default for spec in specs_for(model, firmware).readable},
        calibrations={key: DEFAULT_CALIBRATION[key.source] for key in CalibrationKey},
    )


def in_reverse_order(settings: Settings) -> Settings:
    """Return equal settings whose dictionaries have the reverse order."""
    return replace(
        settings,
        parameters=dict(reversed([*settings.parameters.items()])),
        calibrations=dict(reversed([*settings.calibrations.items()])),
    )


_coded = st.integers(0, HIGHEST_CODED)


@st.composite
def any_calibration(draw: st.DrawFn) -> Calibration:
    minimum = draw(st.integers(0, HIGHEST_CODED - 1))
    maximum = draw(st.integers(minimum + 1, HIGHEST_CODED))
    return Calibration(minimum, draw(st.integers(minimum, maximum)), maximum, draw(_coded))


any_note = st.text(max_size=30).map(clean_note).filter(bool)


@cache
def _parameters_and_notes(
    model_key: str, firmware: str | None
) -> tuple[st.SearchStrategy[dict[str, int]], st.SearchStrategy[dict[str, str]]]:
    """Return strategies for parameters and notes. Cached, because their creation is slow."""
    specs = specs_for(device_table().model(model_key), firmware).readable
    values = {spec.key: st.sampled_from(sorted(spec.valid)) for spec in specs}
    keys = st.sampled_from([*values, *CalibrationKey])
    parameters = st.fixed_dictionaries({}, optional=values)
    return parameters, st.dictionaries(keys, any_note, max_size=4)


_calibrations = st.dictionaries(st.sampled_from(CalibrationKey), any_calibration())


@st.composite
def any_settings(draw: st.DrawFn) -> Settings:
    """Valid settings with any number of parameters, calibrations and notes."""
    model = draw(st.sampled_from([TREX, TREX_JR]))
    firmware = draw(st.none() | st.sampled_from(model.firmware))
    parameters, notes = _parameters_and_notes(model.key, firmware)
    return Settings(
        product=model,
        firmware=firmware,
        parameters=draw(parameters),
        calibrations=draw(_calibrations),
        notes=draw(notes),
    )
