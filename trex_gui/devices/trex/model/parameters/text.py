"""Texts of the parameter table."""

from collections.abc import Sequence
from enum import IntEnum
from functools import cache

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.parameters.values import ParameterValues
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.device_table import Model, device_table
from trex_gui.devices.trex.protocol.parameters import (
    Grade,
    ParameterKind,
    motor_name,
    other_motor_key,
    pwm_keys,
)
from trex_gui.ui.units import units

_MAXIMA = FULL_SCALE + 1  # number of maxima; a frequency code is prescaler * _MAXIMA + maximum
_GRADED = ("min", "max"), ("default",), ("scale", "bits")  # fields with a grade of evidence
_IN_WORDS = {ParameterKind.CHOICE, ParameterKind.CHANNELS, ParameterKind.UART}
_HIGHEST_PWM = 20_000.0  # Hz (inferred), for drivers without a rating


class ParameterColumn(IntEnum):
    """Columns of the table. MOTOR1 also shows the parameters of the whole board."""

    NAME = 0
    MOTOR1 = 1
    MOTOR2 = 2


class ParameterText:
    def __init__(self, values: ParameterValues) -> None:
        self.frequencies: tuple[int, ...] = ()  # codes, lowest frequency first
        self._guide = ""
        self._values = values
        self._pairs: dict[str, tuple[str, ...]] = {}
        self._evidence = {
            Grade.TWIN: tr(
                "(twin): documented for Pololu's qik 2s12v10, which has the same motor drivers."
            ),
            Grade.INFERRED: tr("(inferred): not confirmed by any document."),
        }

    def set_board(self, board: Model) -> None:
        self.frequencies = frequency_codes(board)
        self._guide = board.guide
        pairs = ((key, pwm_keys(key)) for key in self._values.specs)
        self._pairs = {key: pair for key, pair in pairs if self._values.specs.keys() >= set(pair)}

    def keys_of(self, key: str) -> tuple[str, ...]:
        """Return the keys of a cell. A PWM frequency has two: prescaler and maximum."""
        return self._pairs.get(key, (key,))

    # --- Values -------------------------------------------------------------------------

    def title(self, key: str) -> str:
        """Return the name, such as `Motor 1 Current Limit`."""
        keys = self.keys_of(key)
        if len(keys) == 1:
            return self._values.specs[key].name
        return tr("{0} PWM Frequency").format(motor_name(key))

    def short_title(self, key: str) -> str:
        """Return the name without its motor, such as `Current Limit`."""
        has_single_key = len(self.keys_of(key)) == 1
        return self._values.specs[key].short_name if has_single_key else tr("PWM Frequency")

    def value(self, key: str) -> str:
        keys, wires = self.keys_of(key), self.wires(key)
        if len(wires) < len(keys):
            is_optional = all(map(self._values.can_edit, keys))
            return tr("not given") if is_optional else tr("not read")
        return self._text_of(key, wires)

    def wires(self, key: str) -> list[int]:
        wires = map(self._values.value_of, self.keys_of(key))
        return [wire for wire in wires if wire is not None]

    def _text_of(self, key: str, wires: Sequence[int]) -> str:
        text = self._physical(key, wires)
        is_number = len(wires) == 1 and self._values.specs[key].kind not in _IN_WORDS
        return units().ordered(text, str(wires[0]))[0] if is_number else text

    def _physical(self, key: str, wires: Sequence[int]) -> str:
        if len(wires) > 1:
            return frequency_text(frequency_code(*wires))
        return self._values.specs[key].text(wires[0])

    def with_wire(self, key: str, wires: Sequence[int]) -> str:
        """Return the wire value and the physical value: `15 (1.5 s)`."""
        text, numbers = self._physical(key, wires), _numbers(wires)
        return text if text == numbers else f"{numbers} ({text})"

    def change(self, key: str) -> str:
        """Return the value, and the stored value of an edited parameter: `8.1 A, was off`."""
        value, stored = self.value(key), self.stored(key)
        if not any(self._values.is_modified(cell_key) for cell_key in self.keys_of(key)):
            return value
        return tr("{0}, was {1}").format(value, stored or tr("not given"))

    def description(self, key: str) -> str:
        spec = self._values.specs[key]
        if len(self.keys_of(key)) == 1:
            late = tr("Takes effect when the board is switched off and on.")
            return f"{spec.description} {late if spec.needs_power_cycle else ''}".rstrip()
        return tr(
            "Switching frequency of the motor's PWM. Low frequencies make the motor whine "
            "and heat up; frequencies above the driver's rating heat the driver. Type a "
            "number or use the arrow keys. The board stores the nearest frequency that it "
            "supports."
        )

    # --- Sentences ----------------------------------------------------------------------

    def limits(self, key: str) -> str:
        spec = self._values.specs[key]
        is_own = units().own_first or len(self.keys_of(key)) > 1
        limits = self._range(key) if is_own else spec.short_range()
        return tr("{0} · default: {1}").format(limits, self._text_of(key, self._defaults(key)))

    def summary(self, key: str) -> str:
        """Return the wire value, the parameter numbers and the weakest grade of evidence."""
        wires = self.wires(key)
        numbers = [f"{self._values.specs[cell_key].number:#04x}" for cell_key in self.keys_of(key)]
        parts = (
            tr("wire {0}").format(_numbers(wires)) if wires else "",
            ", ".join(numbers),
            max(self._grades(key)).mark,
        )
        return " · ".join(part.strip(" ()") for part in parts if part)

    def _grades(self, key: str) -> list[Grade]:
        specs = [self._values.specs[cell_key] for cell_key in self.keys_of(key)]
        return [max(spec.grade(*fields) for spec in specs) for fields in _GRADED]

    def about(self, key: str) -> tuple[str, ...]:
        keys = self.keys_of(key)
        limits, default, meaning = self._grades(key)
        wires = self.wires(key)
        sentences = (
            tr("Wire value: {0}.").format(self.with_wire(key, wires)) if wires else "",
            tr("The meaning of the wire values is undocumented{0}.").format(meaning.mark)
            if meaning
            else "",
            tr("Range: {0}{1}.").format(self._range(key), limits.mark),
            self._also_accepted(keys),
            tr("Default: {0}{1}.").format(self.with_wire(key, self._defaults(key)), default.mark),
            *(self._values.specs[cell_key].doubt for cell_key in keys),
            *(self._evidence.get(grade, "") for grade in sorted({limits, default, meaning})),
        )
        return tuple(filter(None, sentences))

    def _also_accepted(self, keys: Sequence[str]) -> str:
        wires = sorted(
            wire for cell_key in keys for wire in self._values.accepted.get(cell_key, ())
        )
        text = tr("This firmware has also stored wire values outside this range: {0}.")
        return text.format(", ".join(map(str, wires))) if wires else ""

    def guide(self, key: str) -> tuple[str, str]:
        """Return the address and title of the user's guide section about a parameter."""
        section = self._values.specs[key].section
        if not section:
            return self._guide, tr("User's guide")
        return f"{self._guide}/{section}", tr("User's guide, section {0}").format(section)

    def _range(self, key: str) -> str:
        if len(self.keys_of(key)) > 1:
            return frequency_range(self.frequencies)
        return self._values.specs[key].range_text()

    def _defaults(self, key: str) -> list[int]:
        return [self._values.specs[cell_key].default for cell_key in self.keys_of(key)]

    def notes(self, key: str) -> tuple[str, ...]:
        """Return sentences about problems, and about a different value that is still active."""
        keys = self.keys_of(key)
        active = [self._values.active.get(cell_key) for cell_key in keys]
        sentences = [self._values.problems.get(cell_key, "") for cell_key in keys]
        if (wire := active[0]) is not None:
            sentences.append(tr("Still active: {0}.").format(self._text_of(key, [wire])))
        return tuple(filter(None, sentences))

    def _other_motor(self, key: str) -> str:
        other = other_motor_key(key)
        if other is None or other not in self._values.specs or self.value(other) == self.value(key):
            return ""
        return tr("{0} differs: {1}.").format(motor_name(other), self.value(other))

    def reset(self, key: str) -> str:
        return tr("Reset to default: {0}").format(self.with_wire(key, self._defaults(key)))

    def stored(self, key: str) -> str:
        wires = [self._values.stored.get(cell_key) for cell_key in self.keys_of(key)]
        known = [wire for wire in wires if wire is not None]
        return self._text_of(key, known) if len(known) == len(wires) else ""

    def spoken(self, key: str) -> str:
        """Return the name, value and edit for a screen reader."""
        text = tr("{0}: {1}.").format(self.title(key), self.change(key))
        return " ".join(filter(None, (text, self._other_motor(key), *self.notes(key))))


# --- PWM frequency ----------------------------------------------------------------------


def frequency_code(prescaler: int, maximum: int) -> int:
    return prescaler * _MAXIMA + maximum


def frequency_wires(code: int) -> tuple[int, int]:
    return divmod(code, _MAXIMA)


@cache
def frequency_codes(board: Model) -> tuple[int, ...]:
    """Return the codes of suitable PWM frequencies, lowest first."""
    choices = device_table().pwm.choices(board.highest_pwm or _HIGHEST_PWM)
    return tuple(frequency_code(*pair) for pair in choices)


def frequency_text(code: int) -> str:
    wires = frequency_wires(code)
    try:
        return tr("{0:.0f} Hz").format(device_table().pwm.frequency(*wires))
    except BadRequest:
        return _numbers(wires)


def frequency_range(codes: Sequence[int]) -> str:
    return tr("{0} to {1}").format(frequency_text(codes[0]), frequency_text(codes[-1]))


def _numbers(wires: Sequence[int]) -> str:
    if len(wires) > 1:
        return tr("prescaler {0}, maximum {1}").format(*wires)
    return str(wires[0])
