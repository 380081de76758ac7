"""Conversion of settings to another model or firmware."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import StrEnum

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.protocol.device_table import Model
from trex_gui.devices.trex.protocol.line_settings import LineSettings, baud_rates
from trex_gui.devices.trex.protocol.parameters import ParameterKey, ParameterSpec
from trex_gui.devices.trex.settings.comparison import Comparison, ComparisonRow
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.writer import calibration_text


class Fate(StrEnum):
    CHANGED = "changed"
    LEFT_OUT = "left out"
    CARRIED_OVER = "carried over"


@dataclass(frozen=True, slots=True)
class ConvertedRow:
    key: str
    name: str
    fate: Fate
    before: str  # in physical units
    after: str  # in physical units; empty if the setting was left out
    reason: str  # as a sentence; empty if the setting was carried over

    def __str__(self) -> str:
        is_same = self.after in {"", self.before}
        values = self.before if is_same else f"{self.before} → {self.after}"
        return f"{self.name}: {values}. {self.reason}".rstrip()


@dataclass(frozen=True, slots=True)
class Conversion:
    settings: Settings
    rows: tuple[ConvertedRow, ...]  # changes first

    @property
    def board(self) -> str:
        return f"{self.settings.product.name} {self.settings.specs.firmware}"

    @property
    def has_changes(self) -> bool:
        return any(row.fate is not Fate.CARRIED_OVER for row in self.rows)

    def of(self, fate: Fate) -> tuple[ConvertedRow, ...]:
        return tuple(row for row in self.rows if row.fate is fate)

    def summary(self) -> str:
        counts = (len(self.of(fate)) for fate in (Fate.CARRIED_OVER, Fate.CHANGED, Fate.LEFT_OUT))
        text = tr("For a {0}: {1} carried over, {2} changed, {3} left out.")
        return text.format(self.board, *counts)

    def compared_with(self, before: Settings) -> Comparison:
        old, new = ({**s.parameters, **s.calibrations} for s in (before, self.settings))
        return Comparison(
            tuple(
                ComparisonRow(
                    row.key, row.name, old.get(row.key), new.get(row.key), row.before, row.after
                )
                for row in self.rows
            )
        )


def convert(settings: Settings, product: Model, firmware: str | None) -> Conversion:
    """Convert settings for a model and firmware. `None` means the newest firmware.

    A wire value changes if this preserves its physical value. Current limits are rounded down: a
    conversion never raises a limit, except to the lowest limit of the model.
    """
    target = Settings(product, firmware)
    parameters: dict[str, int] = {}
    rows: list[ConvertedRow] = []
    for old, wire in settings.parameter_items():
        new = target.specs.readable_by_key.get(old.key)
        if new is None:
            reason = tr("A {0} with firmware {1} does not have this setting.").format(
                product.name, target.specs.firmware
            )
            rows.append(ConvertedRow(old.key, old.name, Fate.LEFT_OUT, old.text(wire), "", reason))
            continue
        if old.key == ParameterKey.UART_SETTINGS:
            converted, reason = _converted_line(settings, target, wire)
        else:
            converted, reason = _converted_wire(old, new, wire, product)
        parameters[old.key] = converted
        fate = Fate.CHANGED if reason else Fate.CARRIED_OVER
        texts = old.text(wire), new.text(converted)
        rows.append(ConvertedRow(old.key, old.name, fate, *texts, reason))
    for key, calibration in settings.calibration_items():
        text = calibration_text(key.source, calibration)
        name = tr("Calibration of {0}").format(key.label)
        rows.append(ConvertedRow(key, name, Fate.CARRIED_OVER, text, text, ""))
    order = list(Fate)
    rows.sort(key=lambda row: order.index(row.fate))
    result = replace(
        target, parameters=parameters, calibrations=settings.calibrations, notes=settings.notes
    )
    return Conversion(result, tuple(rows))


def _converted_wire(
    old: ParameterSpec, new: ParameterSpec, wire: int, product: Model
) -> tuple[int, str]:
    """Return the wire value for the same physical value, and the reason for a change."""
    if old.scale == new.scale or wire == 0:
        return wire, ""
    steps = wire * old.scale / new.scale
    result = min(max(int(steps + 1e-6), 1), new.maximum)
    step = f"{Number(new.scale):g} {new.unit}"
    if steps > new.maximum + 1e-6:
        return result, tr("The maximum for a {0} is {1}.").format(
            product.name, new.text(new.maximum)
        )
    if steps < 1 - 1e-6:
        return result, tr("The minimum for a {0} is {1}; 0 means off (twin).").format(
            product.name, new.text(1)
        )
    if abs(steps - result) < 1e-6:
        return result, tr("The same value in steps of {0}: {1} becomes {2}.").format(
            step, wire, result
        )
    return result, tr("Rounded down to steps of {0}: {1} becomes {2}.").format(step, wire, result)


def _converted_line(settings: Settings, target: Settings, wire: int) -> tuple[int, str]:
    """Return the UART settings for the same real baud rate, and the reason for a change.

    Old firmware halves two of the rates.
    """
    before, after = settings.firmware, target.specs.firmware
    try:
        line = LineSettings.from_wire(wire)
    except BadRequest:
        return wire, ""
    real = line.baud if before is None else line.real_baud(before)
    if real == line.real_baud(after) or real not in baud_rates():
        return wire, ""
    corrected = replace(line, baud=real)
    if corrected.real_baud(after) != real:
        return wire, ""  # the new firmware lacks this rate; a rule reports it
    reason = tr("Firmware {0} really runs at {1} baud when set to {2}.").format(
        before, real, line.baud
    )
    return corrected.to_wire(), reason


def conversion_lines(conversion: Conversion) -> Iterator[str]:
    """Yield a summary, a line for each altered setting, and the unaltered keys."""
    yield conversion.summary()
    for row in conversion.rows:
        if row.fate is not Fate.CARRIED_OVER:
            yield f"{row.fate}: {row}"
    if unaltered := conversion.of(Fate.CARRIED_OVER):
        yield f"{Fate.CARRIED_OVER}: {', '.join(row.key for row in unaltered)}"
