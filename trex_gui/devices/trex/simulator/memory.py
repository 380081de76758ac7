"""Stored and active parameters and calibrations."""

import contextlib
import json
import os
from collections import deque
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

from trex_gui.core.errors import StudioError
from trex_gui.core.files import open_ordinary
from trex_gui.core.simulator.timeline import EPSILON
from trex_gui.devices.trex.protocol.calibration import (
    CALIBRATION_FIELDS,
    DEFAULT_CALIBRATION,
    HIGHEST_CODED,
    Calibration,
)
from trex_gui.devices.trex.protocol.device_table import HIGHEST_WIRE, device_table
from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, Mode, channel_mask
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import MotorParameter, ParameterKey, parameters_of

_WHAT = "EEPROM of a simulated TReX"
_CALIBRATION_KEYS = {InputSource.RC: "rc_calibration", InputSource.ANALOG: "analog_calibration"}


class EepromError(StudioError):
    """The EEPROM file cannot be read or written."""


class Eeprom:
    """EEPROM of one board, in wire values. With a `path`, each write is saved to this file.

    The EEPROM has a cell for every parameter in any firmware of the model. `error_shutdown` is the
    factory default of UART-Error Shutdown, which no source mentions.
    """

    def __init__(
        self, model: str = "trex", *, path: Path | None = None, error_shutdown: bool = True
    ) -> None:
        self.model = device_table().model(model)
        self.reset_pending = False
        self.unsaved: EepromError | None = None  # error of the last save, if it failed
        self._path = path
        self._specs = parameters_of(model, self.model.firmware[-1])
        self.factory = {spec.key: spec.default for spec in self._specs.readable}
        self.factory[ParameterKey.UART_ERROR_SHUTDOWN] = int(error_shutdown)
        self._values = dict(self.factory)
        self._calibrations = _factory_calibrations()

    @classmethod
    def open(cls, path: Path, model: str = "trex", *, error_shutdown: bool = True) -> "Eeprom":
        """Open or create a file. Raise EepromError if it is damaged or inaccessible."""
        eeprom = cls(model, path=path, error_shutdown=error_shutdown)
        try:
            with open_ordinary(path) as file:
                text = file.read().decode("utf-8")
        except FileNotFoundError:
            eeprom.save()
        except (OSError, UnicodeDecodeError) as error:
            raise EepromError(f"the EEPROM file {path} cannot be read: {error}") from error
        else:
            eeprom._load(text)
        return eeprom

    def __getitem__(self, key: str) -> int:
        return self._values[key]

    def write(self, key: str, value: int) -> None:
        """Store and save a wire value. Raise KeyError or ValueError for an invalid key or value."""
        if key not in self._values:
            raise KeyError(key)
        self._values[key] = self._specs[key].check(value, forced=True)
        self._save_if_possible()

    def calibration(self, source: InputSource, channel: int) -> Calibration:
        return self._calibrations[source][channel]

    def write_calibration(
        self, source: InputSource, channel: int, calibration: Calibration
    ) -> None:
        self._calibrations[source][channel] = calibration
        self._save_if_possible()

    def write_calibration_value(
        self, source: InputSource, channel: int, field: str, value: int
    ) -> None:
        calibration = replace(self._calibrations[source][channel], **{field: value})
        self.write_calibration(source, channel, calibration)

    def factory_reset(self) -> None:
        self._values = dict(self.factory)
        self._calibrations = _factory_calibrations()
        self.reset_pending = False
        self._save_if_possible()

    def learned(self, source: InputSource) -> int:
        default = DEFAULT_CALIBRATION[source]
        calibrations = self._calibrations[source].items()
        return channel_mask(channel for channel, value in calibrations if value != default)

    def request_reset(self) -> None:
        self.reset_pending = True
        self._save_if_possible()

    def reset_if_pending(self) -> None:
        """Perform the reset that 0x7F requested. Inferred: calibrations do not change."""
        if self.reset_pending:
            self._values = dict(self.factory)
            self.reset_pending = False
            self._save_if_possible()

    def _save_if_possible(self) -> None:
        self.unsaved = None
        try:
            self.save()
        except EepromError as error:
            self.unsaved = error

    def save(self) -> None:
        """Write the file atomically, if there is one. Raise EepromError if this fails."""
        if self._path is None:
            return
        text = json.dumps(self._document(), indent=2) + "\n"
        draft = self._path.with_name(f".{self._path.name}.{os.getpid()}")
        try:
            draft.write_text(text, encoding="utf-8")
            draft.replace(self._path)
        except OSError as error:
            with contextlib.suppress(OSError):
                draft.unlink()
            raise EepromError(f"the EEPROM file {self._path} cannot be written: {error}") from error

    def _document(self) -> dict[str, Any]:
        document: dict[str, Any] = {
            "what": _WHAT,
            "model": self.model.key,
            "reset_at_power_up": self.reset_pending,
            "parameters": self._values,
        }
        for source, key in _CALIBRATION_KEYS.items():
            document[key] = list(map(asdict, self._calibrations[source].values()))
        return document

    def _load(self, text: str) -> None:
        try:
            self._set_document(json.loads(text))
        except (TypeError, ValueError, RecursionError) as error:
            reason = "it is nested too deeply" if isinstance(error, RecursionError) else error
            raise EepromError(
                f"the EEPROM file {self._path} is damaged ({reason}); "
                "repair it, or delete it to start with a new board"
            ) from error

    def _set_document(self, document: object) -> None:
        if not isinstance(document, dict) or document.get("what") != _WHAT:
            raise ValueError(f'it does not begin with "what": "{_WHAT}"')
        if document.get("model") != self.model.key:
            raise ValueError(f"it belongs to model {document.get('model')}, not {self.model.key}")
        parameters = document.get("parameters", {})
        if not isinstance(parameters, dict):
            raise TypeError('"parameters" is not a table')
        for key, value in parameters.items():
            if key not in self._values:
                raise ValueError(f"there is no parameter {key}")
            if type(value) is not int:
                raise TypeError(f"{key} is not a whole number")
            self._values[key] = self._specs[key].check(value, forced=True)
        for source, name in _CALIBRATION_KEYS.items():
            rows = document.get(name)
            if rows is None:
                continue
            if not isinstance(rows, list) or len(rows) != len(CHANNELS):
                raise ValueError(f"{name} is not a list of {len(CHANNELS)} calibrations")
            for channel, row in zip(CHANNELS, rows, strict=True):
                self._calibrations[source][channel] = _read_calibration(
                    f"{name}, channel {channel}", row
                )
        self.reset_pending = document.get("reset_at_power_up") is True


def _read_calibration(name: str, row: object) -> Calibration:
    if not isinstance(row, dict) or set(row) != set(CALIBRATION_FIELDS):
        raise ValueError(f"{name} does not have {', '.join(CALIBRATION_FIELDS)}")
    for field, value in row.items():
        if type(value) is not int or not 0 <= value <= HIGHEST_CODED:
            raise ValueError(f"{name}: {field} is not a number from 0 to {HIGHEST_CODED}")
    return Calibration(**row)  # may be inconsistent: a power cut can mix old and new values


def _factory_calibrations() -> dict[InputSource, dict[int, Calibration]]:
    return {source: dict.fromkeys(CHANNELS, DEFAULT_CALIBRATION[source]) for source in InputSource}


# Seconds for a write to the EEPROM: 4 ms per byte (command documentation, 0xAF and 0xA0-0xA4). The
# four values of a calibration have two bytes each.
PARAMETER_WRITE_S = 0.004
CALIBRATION_WRITE_S = 0.032


@dataclass(frozen=True, slots=True)
class _Step:
    """Pending write to the EEPROM. If the power is cut, `lose` is called instead of `store`.

    Inferred: the power cut erases the cell, and the firmware uses the default at the next power-up.
    """

    seconds: float
    store: Callable[[], None]
    lose: Callable[[], None]


class Memory:
    """Active and stored settings, with pending writes.

    Parameters 0x7B-0x7F take effect after a power cycle. Other parameters take effect when they are
    written.
    """

    def __init__(self, eeprom: Eeprom, firmware: str) -> None:
        self.parameters = parameters_of(eeprom.model.key, firmware)
        self.writes = 0  # number of times that all pending writes were finished
        # Key → (maximum value that this firmware accepts outside an inferred limit, mask of the
        # stored bits)
        self.accepted: dict[str, tuple[int, int]] = {}
        self.eeprom = eeprom
        self._firmware = firmware
        self._steps: deque[_Step] = deque()
        self._done = 0.0  # seconds spent on the first pending step
        self.load()

    def load(self) -> None:
        self.lose_write()
        self.eeprom.reset_if_pending()
        self.active = self.stored()  # key → active wire value
        self.line_settings = LineSettings.from_wire(self.active[ParameterKey.UART_SETTINGS])
        self.baud = self.line_settings.real_baud(self._firmware)  # actual bit rate on the line

    def stored(self) -> dict[str, int]:
        return {spec.key: self.eeprom[spec.key] for spec in self.parameters.readable}

    @property
    def is_joint(self) -> bool:
        return self.active[ParameterKey.MOTOR_MODE] == 1

    @property
    def serial_mode(self) -> Mode:
        analog = self.active[ParameterKey.CHANNEL_INPUT_SOURCE] == 1
        return Mode.SERIAL_ANALOG if analog else Mode.SERIAL_RC

    @property
    def crc_polynomial(self) -> int | None:
        if self.line_settings.detection is not Detection.CRC7:
            return None
        return 0x80 | self.active[ParameterKey.CRC7_POLYNOMIAL]

    def pwm_frequency(self, number: int) -> float:
        prescaler = self.active[MotorParameter.PWM_PRESCALER.of(number)]
        maximum = self.active[MotorParameter.PWM_MAXIMUM.of(number)]
        pwm = device_table().pwm
        return pwm.frequency(min(prescaler, len(pwm.divisors) - 1), maximum)

    @property
    def response_delay(self) -> float:
        """Delay of each reply in seconds (firmware 1.2+)."""
        return 0.001 if self.active.get(ParameterKey.UART_RESPONSE_DELAY) else 0.0

    def get(self, number: int) -> int | None:
        spec = self.parameters.number(number)
        return self.eeprom[spec.key] if spec is not None and spec.readable else None

    def set(self, number: int, value: int, mode: Mode) -> ResultCode:
        """Start to write a parameter. The value is stored after `busy_for` seconds.

        The order of the checks is inferred.
        """
        if not mode.is_serial:
            return ResultCode.NOT_SERIAL_MODE
        spec = self.parameters.number(number)
        if spec is None:
            return ResultCode.BAD_PARAMETER
        highest, mask = self.accepted.get(spec.key, (spec.maximum, HIGHEST_WIRE))
        if value not in spec.valid and not (spec.is_open(value) and value <= highest):
            return ResultCode.BAD_VALUE
        value &= mask
        if spec.readable:
            self._start_write(spec.key, value, at_once=not spec.needs_power_cycle)
        else:
            # Inferred: 0x7F sets a flag, and the next power-up resets all parameters.
            self._steps.append(_Step(PARAMETER_WRITE_S, self.eeprom.request_reset, lambda: None))
        return ResultCode.OK

    def _start_write(self, key: str, value: int, *, at_once: bool) -> None:
        store = partial(self._store, key, value, at_once=at_once)
        lose = partial(self.eeprom.write, key, self.eeprom.factory[key])
        self._steps.append(_Step(PARAMETER_WRITE_S, store, lose))

    def set_calibration(self, channel: int, calibration: Calibration, mode: Mode) -> ResultCode:
        if not mode.is_serial:
            return ResultCode.NOT_SERIAL_MODE
        if not (
            calibration.minimum <= calibration.neutral <= calibration.maximum
            and calibration.minimum < calibration.maximum
        ):
            return ResultCode.BAD_VALUE
        self.store_calibration(mode.source, channel, calibration)
        return ResultCode.OK

    def store_calibration(
        self, source: InputSource, channel: int, calibration: Calibration
    ) -> None:
        for field, value in asdict(calibration).items():
            write = partial(self.eeprom.write_calibration_value, source, channel, field)
            lose = partial(write, getattr(DEFAULT_CALIBRATION[source], field))
            seconds = CALIBRATION_WRITE_S / len(CALIBRATION_FIELDS)
            self._steps.append(_Step(seconds, partial(write, value), lose))

    def restore_line_settings(self) -> None:
        for key in (ParameterKey.UART_SETTINGS, ParameterKey.CRC7_POLYNOMIAL):
            self._start_write(key, self.eeprom.factory[key], at_once=False)

    @property
    def busy_for(self) -> float:
        return sum(step.seconds for step in self._steps) - self._done if self._steps else 0.0

    def advance(self, seconds: float) -> None:
        if not self._steps:
            return
        self._done += seconds
        while self._steps and self._done >= self._steps[0].seconds - EPSILON:
            step = self._steps.popleft()
            self._done -= step.seconds
            step.store()
        if not self._steps:
            self._done = 0.0
            self.writes += 1

    def lose_write(self) -> None:
        """Simulate a power cut. Lose the current write, and drop later writes."""
        if self._steps:
            self._steps[0].lose()
        self._steps.clear()
        self._done = 0.0

    def _store(self, key: str, value: int, *, at_once: bool) -> None:
        self.eeprom.write(key, value)
        if at_once:
            self.active[key] = value
