"""The board's EEPROM: parameters and channel calibrations, optionally in a file."""

import json
import os
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

from trex_gui.core.errors import StudioError
from trex_gui.devices.trex.protocol.calibration import (
    DEFAULT_CALIBRATION,
    HIGHEST_CODED,
    Calibration,
)
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, channel_mask
from trex_gui.devices.trex.protocol.parameters import ParameterSpec, parameters_of

_WHAT = "EEPROM of a simulated TReX"
_CALIBRATION_KEYS = {InputSource.RC: "rc_calibration", InputSource.ANALOG: "analog_calibration"}
CALIBRATION_FIELDS = ("minimum", "neutral", "maximum", "deadband")


class EepromError(StudioError):
    """The EEPROM file cannot be read or written; the text says which and why."""


class Eeprom:
    """EEPROM of one board in wire values; a file, if there is one, is saved after each write.

    It has a cell for every parameter of any firmware of the model.

    Attributes:
        reset_pending: whether the next power-up resets the parameters to factory defaults.
        unsaved: why the last write is not in the file; `None` if it is.
    """

    def __init__(self, model: str = "trex", *, path: Path | None = None) -> None:
        self.model = device_table().model(model)
        self.reset_pending = False
        self.unsaved: EepromError | None = None
        self._path = path
        self._specs = parameters_of(model, self.model.firmware[-1])
        self._values = self._factory_values()
        self._calibrations = _factory_calibrations()

    @classmethod
    def open(cls, path: Path, model: str = "trex") -> "Eeprom":
        """Return the EEPROM in a file, or a new one that is saved to the file.

        Raises:
            EepromError: the file is damaged, belongs to another model, or cannot be written.
        """
        eeprom = cls(model, path=path)
        try:
            text = path.read_text(encoding="utf-8")
        except FileNotFoundError:
            eeprom.save()
        except (OSError, UnicodeDecodeError) as error:
            raise EepromError(f"the EEPROM file {path} cannot be read: {error}") from error
        else:
            eeprom._load(text)
        return eeprom

    def __getitem__(self, which: str | int) -> int:
        """Return a parameter by key or number; `KeyError` when there is no such cell."""
        return self._values[self._spec(which).key]

    def write(self, which: str | int, value: int) -> None:
        """Store a parameter (wire value) and save.

        Raises:
            KeyError: there is no such cell.
            ValueError: the parameter cannot be this value.
        """
        spec = self._spec(which)
        self._values[spec.key] = spec.check(value)
        self._save_if_possible()

    def calibration(self, source: InputSource, channel: int) -> Calibration:
        """Return the calibration of a channel (1-5) for one kind of input."""
        return self._calibrations[source][channel]

    def write_calibration(
        self, source: InputSource, channel: int, calibration: Calibration
    ) -> None:
        """Store a channel's calibration and save."""
        self._calibrations[source][channel] = calibration
        self._save_if_possible()

    def write_calibration_value(
        self, source: InputSource, channel: int, field: str, value: int
    ) -> None:
        """Store one of the four values of a calibration and save."""
        calibration = replace(self._calibrations[source][channel], **{field: value})
        self.write_calibration(source, channel, calibration)

    def lose(self, which: str | int) -> None:
        """Lose a parameter whose write was interrupted.

        Inferred, here and for calibrations: the cell is left erased, and the firmware uses the
        factory default at the next power-up.
        """
        self.write(which, self._spec(which).default)

    def lose_calibration_value(self, source: InputSource, channel: int, field: str) -> None:
        """Lose one of the four values of a calibration; see `lose`."""
        value = getattr(DEFAULT_CALIBRATION[source], field)
        self.write_calibration_value(source, channel, field, value)

    def factory_reset(self) -> None:
        """Reset parameters and calibrations to factory defaults, and save."""
        self._values = self._factory_values()
        self._calibrations = _factory_calibrations()
        self.reset_pending = False
        self._save_if_possible()

    def learned(self, source: InputSource) -> int:
        """Return the mask of channels whose calibration differs from the default (0x95)."""
        default = DEFAULT_CALIBRATION[source]
        calibrations = self._calibrations[source].items()
        return channel_mask(channel for channel, value in calibrations if value != default)

    def request_reset(self) -> None:
        """Mark the parameters for a reset at the next power-up, and save."""
        self.reset_pending = True
        self._save_if_possible()

    def reset_if_pending(self) -> None:
        """Do the reset that 0x7F requested, at power-up. Inferred: calibrations stay."""
        if self.reset_pending:
            self._values = self._factory_values()
            self.reset_pending = False
            self._save_if_possible()

    def _save_if_possible(self) -> None:
        """Save; when that fails the board continues without the file."""
        try:
            self.save()
        except EepromError as error:
            self.unsaved = error
        else:
            self.unsaved = None

    def save(self) -> None:
        """Write the file, if there is one, atomically.

        Raises:
            EepromError: it cannot be written.
        """
        if self._path is None:
            return
        text = json.dumps(self._document(), indent=2) + "\n"
        try:
            _replace(self._path, text)
        except OSError as error:
            message = f"the EEPROM file {self._path} cannot be written: {error}"
            raise EepromError(message) from error

    def _spec(self, which: str | int) -> ParameterSpec:
        if isinstance(which, int):
            spec = self._specs.number(which)
        else:
            spec = next((spec for spec in self._specs if spec.key == which), None)
        if spec is None or not spec.readable:
            raise KeyError(which)
        return spec

    def _factory_values(self) -> dict[str, int]:
        return {spec.key: spec.default for spec in self._specs.readable}

    def _document(self) -> dict[str, Any]:
        document: dict[str, Any] = {
            "what": _WHAT,
            "model": self.model.key,
            "reset_at_power_up": self.reset_pending,
            "parameters": self._values,
        }
        for source, key in _CALIBRATION_KEYS.items():
            document[key] = [
                {field: getattr(calibration, field) for field in CALIBRATION_FIELDS}
                for calibration in self._calibrations[source].values()
            ]
        return document

    def _load(self, text: str) -> None:
        try:
            self._take(json.loads(text))
        except json.JSONDecodeError as error:
            raise self._damaged(f"line {error.lineno}: {error.msg}") from error
        except RecursionError as error:
            raise self._damaged("it is nested too deep") from error
        except (TypeError, ValueError) as error:
            raise self._damaged(str(error)) from error

    def _damaged(self, why: str) -> EepromError:
        return EepromError(
            f"the EEPROM file {self._path} is damaged ({why}); "
            "repair it, or delete it to start with a new board"
        )

    def _take(self, document: object) -> None:
        if not isinstance(document, dict) or document.get("what") != _WHAT:
            raise ValueError(f'it does not begin with "what": "{_WHAT}"')
        if document.get("model") != self.model.key:
            raise ValueError(f"it belongs to model {document.get('model')}, not {self.model.key}")
        parameters = document.get("parameters", {})
        if not isinstance(parameters, dict):
            raise TypeError("parameters is not a table")
        for key, value in parameters.items():
            self._take_parameter(key, value)
        for source, name in _CALIBRATION_KEYS.items():
            rows = document.get(name)
            if rows is None:
                continue
            if not isinstance(rows, list) or len(rows) != len(CHANNELS):
                raise ValueError(f"{name} is not a list of {len(CHANNELS)}")
            for channel, row in zip(CHANNELS, rows, strict=True):
                self._calibrations[source][channel] = _read_calibration(
                    f"{name}, channel {channel}", row
                )
        self.reset_pending = document.get("reset_at_power_up") is True

    def _take_parameter(self, key: str, value: object) -> None:
        try:
            spec = self._spec(key)
        except KeyError:
            raise ValueError(f"there is no parameter {key}") from None
        if type(value) is not int:
            raise TypeError(f"{key} is not a whole number")
        self._values[key] = spec.check(value)


def _read_calibration(name: str, row: object) -> Calibration:
    if not isinstance(row, dict) or set(row) != set(CALIBRATION_FIELDS):
        raise ValueError(f"{name} does not have {', '.join(CALIBRATION_FIELDS)}")
    for field, value in row.items():
        if type(value) is not int or not 0 <= value <= HIGHEST_CODED:
            raise ValueError(f"{name}: {field} is not a number from 0 to {HIGHEST_CODED}")
    return Calibration(**row)  # in any order: a power cut may have mixed old and new values


def _factory_calibrations() -> dict[InputSource, dict[int, Calibration]]:
    return {source: dict.fromkeys(CHANNELS, DEFAULT_CALIBRATION[source]) for source in InputSource}


def _replace(path: Path, text: str) -> None:
    handle, name = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
    temporary = Path(name)
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(text)
        temporary.replace(path)
    except OSError:
        temporary.unlink(missing_ok=True)
        raise
