"""Parameters and calibrations in the firmware: active, stored, being written."""

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import InputSource, Mode
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import MotorParameter, ParameterKey, parameters_of
from trex_gui.devices.trex.simulator.eeprom import CALIBRATION_FIELDS, Eeprom

PARAMETER_WRITE = 0.004
CALIBRATION_WRITE = 0.032
"""Seconds of a write to the EEPROM (command documentation, 0xAF and 0xA0-0xA4): 4 ms per byte;
the four values of a calibration have two bytes each."""


@dataclass(frozen=True, slots=True)
class _Step:
    """One value on its way into the EEPROM.

    Attributes:
        seconds: duration of the write.
        store: called at its end.
        lose: called when the power is cut before.
    """

    seconds: float
    store: Callable[[], None]
    lose: Callable[[], None]


_EPSILON = 1e-9  # seconds; swallows the rounding of summed times


class Memory:
    """Active and stored settings, and the writes that are going on.

    Parameters 0x7B-0x7F take effect after a power cycle, the others when their write ends.

    Attributes:
        active: active parameters by key.
        line_settings, baud: active settings of the serial line, and its real bit rate.
        writes: number of finished writes.
    """

    def __init__(self, eeprom: Eeprom, firmware: str) -> None:
        self.parameters = parameters_of(eeprom.model.key, firmware)
        self.writes = 0
        self._eeprom = eeprom
        self._firmware = firmware
        self._steps: deque[_Step] = deque()
        self._done = 0.0  # seconds spent on the first of them
        self.load()

    def load(self) -> None:
        """Activate the stored settings, at power-up."""
        self.lose_write()
        self._eeprom.reset_if_pending()
        self.active = self.stored()
        self.line_settings = LineSettings.from_wire(self.active[ParameterKey.UART_SETTINGS])
        self.baud = self.line_settings.real_baud(self._firmware)

    def stored(self) -> dict[str, int]:
        """Return the stored parameters that this firmware knows."""
        return {spec.key: self._eeprom[spec.key] for spec in self.parameters.readable}

    @property
    def is_joint(self) -> bool:
        """Whether both drivers are one for motor 1."""
        return self.active[ParameterKey.MOTOR_MODE] == 1

    @property
    def serial_source(self) -> Mode:
        """The mode that a board in serial mode is in."""
        analog = self.active[ParameterKey.CHANNEL_INPUT_SOURCE] == 1
        return Mode.SERIAL_ANALOG if analog else Mode.SERIAL_RC

    @property
    def crc_polynomial(self) -> int | None:
        """The polynomial (0x80-0xFF), `None` when packets carry no CRC."""
        if self.line_settings.detection is not Detection.CRC7:
            return None
        return 0x80 | self.active[ParameterKey.CRC7_POLYNOMIAL]

    def pwm_frequency(self, number: int) -> float:
        """Return the PWM frequency in Hz of motor 1 or 2."""
        prescaler = self.active[MotorParameter.PWM_PRESCALER.of(number)]
        maximum = self.active[MotorParameter.PWM_MAXIMUM.of(number)]
        return device_table().pwm.frequency(prescaler, maximum)

    @property
    def response_delay(self) -> float:
        """Seconds before each reply: 1 ms if the parameter is set (firmware 1.2+)."""
        return 0.001 if self.active.get(ParameterKey.UART_RESPONSE_DELAY) else 0.0

    def get(self, number: int) -> int | None:
        """Return the stored value of a parameter; `None` if this firmware does not know it."""
        spec = self.parameters.number(number)
        if spec is None or not spec.readable:
            return None
        return self._eeprom[spec.key]

    def set(self, number: int, value: int, mode: Mode) -> ResultCode:
        """Begin to write a parameter; it is stored `busy_for` seconds later.

        Inferred: the order of the checks.
        """
        if not mode.is_serial:
            return ResultCode.NOT_SERIAL_MODE
        spec = self.parameters.number(number)
        if spec is None:
            return ResultCode.BAD_PARAMETER
        if value not in spec.valid:
            return ResultCode.BAD_VALUE
        if not spec.readable:
            # Inferred: 0x7F sets a mark, and the next power-up resets all parameters.
            step = _Step(PARAMETER_WRITE, self._eeprom.request_reset, lambda: None)
        else:
            store = partial(self._store, spec.key, value, at_once=not spec.needs_power_cycle)
            step = _Step(PARAMETER_WRITE, store, partial(self._eeprom.lose, spec.key))
        self._steps.append(step)
        return ResultCode.OK

    def calibration(self, source: InputSource, channel: int) -> Calibration:
        """Return the calibration of a channel (1-5) for one kind of input."""
        return self._eeprom.calibration(source, channel)

    def learned(self, source: InputSource) -> int:
        """Return the mask of channels whose calibration differs from the default (0x95)."""
        return self._eeprom.learned(source)

    def set_calibration(self, channel: int, calibration: Calibration, mode: Mode) -> ResultCode:
        """Begin to write a channel's calibration into the set that the mode uses."""
        if not mode.is_serial:
            return ResultCode.NOT_SERIAL_MODE
        low, middle, high = calibration.minimum, calibration.neutral, calibration.maximum
        if not (low <= middle <= high and low < high):
            return ResultCode.BAD_VALUE
        self.store_calibration(mode.source, channel, calibration)
        return ResultCode.OK

    def store_calibration(
        self, source: InputSource, channel: int, calibration: Calibration
    ) -> None:
        """Begin to write a calibration, after pending writes."""
        for field in CALIBRATION_FIELDS:
            value = getattr(calibration, field)
            store = partial(self._eeprom.write_calibration_value, source, channel, field, value)
            lose = partial(self._eeprom.lose_calibration_value, source, channel, field)
            self._steps.append(_Step(CALIBRATION_WRITE / len(CALIBRATION_FIELDS), store, lose))

    def restore_line_settings(self) -> None:
        """Begin to write the default serial settings, for the recovery by jumpers."""
        for key in (ParameterKey.UART_SETTINGS, ParameterKey.CRC7_POLYNOMIAL):
            store = partial(self._store, key, self.parameters[key].default, at_once=False)
            lose = partial(self._eeprom.lose, key)
            self._steps.append(_Step(PARAMETER_WRITE, store, lose))

    @property
    def busy_for(self) -> float:
        """Seconds until all pending writes are finished; 0 without any."""
        return sum(step.seconds for step in self._steps) - self._done if self._steps else 0.0

    def advance(self, seconds: float) -> None:
        if not self._steps:
            return
        self._done += seconds
        while self._steps and self._done >= self._steps[0].seconds - _EPSILON:
            step = self._steps.popleft()
            self._done -= step.seconds
            step.store()
        if not self._steps:
            self._done = 0.0
            self.writes += 1

    def lose_write(self) -> None:
        """Cut the power: the value being written is lost, later ones keep their old value."""
        if self._steps:
            self._steps[0].lose()
        self._steps.clear()
        self._done = 0.0

    def _store(self, key: str, value: int, *, at_once: bool) -> None:
        self._eeprom.write(key, value)
        if at_once:
            self.active[key] = value
