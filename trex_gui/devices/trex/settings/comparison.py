"""Differences between two sets of settings."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.protocol.calibration import (
    CALIBRATION_FIELDS,
    CALIBRATION_KEYS,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.writer import calibration_text

_NOT_GIVEN = tr_noop("not given")


@dataclass(frozen=True, slots=True)
class ComparisonRow:
    key: str  # parameter key or `CalibrationKey`
    name: str  # for the user
    before: int | Calibration | None  # wire value or calibration; `None`: unknown or not given
    after: int | Calibration | None  # wire value or calibration; `None`: does not change
    text_before: str  # in physical units; empty for `None`
    text_after: str  # in physical units; empty for `None`
    note_before: str = ""
    note_after: str = ""

    @property
    def changed(self) -> bool:
        """True if `after` has a different value."""
        return self.after is not None and self.before != self.after

    @property
    def adds_note(self) -> bool:
        """True if `after` has a new or different note."""
        return bool(self.note_after) and self.note_after != self.note_before

    @property
    def is_offered(self) -> bool:
        return self.changed or self.adds_note

    @property
    def is_missing(self) -> bool:
        return self.after is None

    @property
    def is_calibration(self) -> bool:
        return isinstance(self.key, CalibrationKey)

    @property
    def differing_fields(self) -> tuple[str, ...]:
        """Calibration fields that differ, or all fields if one calibration is unknown."""
        if not self.is_calibration or self.before == self.after:
            return ()
        old, new = self.before, self.after
        return tuple(
            f for f in CALIBRATION_FIELDS if getattr(old, f, None) != getattr(new, f, None)
        )


@dataclass(frozen=True, slots=True)
class Comparison:
    """Rows for settings that both models have and at least one side specifies."""

    rows: tuple[ComparisonRow, ...]  # in the order of the parameter table, then calibrations
    left_out: tuple[str, ...] = ()  # a sentence for each omitted setting

    @property
    def differing(self) -> tuple[ComparisonRow, ...]:
        return tuple(row for row in self.rows if row.before != row.after or row.adds_note)

    @property
    def changed(self) -> int:
        return sum(row.changed for row in self.rows)

    @property
    def offered(self) -> int:
        return sum(row.is_offered for row in self.rows)

    @property
    def equal(self) -> int:
        return sum(row.before == row.after for row in self.rows)

    def summary(self) -> str:
        """Return the counts, such as `29 parameters: 4 will change, 25 match`."""
        parameters = [row for row in self.rows if not row.is_calibration]
        calibrations = [row for row in self.rows if row.is_calibration]
        parts = [_counts(parameters, tr("1 parameter"), tr("{0} parameters"))]
        if calibrations:
            parts.append(_counts(calibrations, tr("1 calibration"), tr("{0} calibrations")))
        if self.left_out:
            parts.append(tr("{0} cannot be carried over").format(len(self.left_out)))
        return "; ".join(parts)

    def report(self) -> str:
        """Return a table of the differing rows, followed by `left_out`.

        A row shows old → new in wire and physical units. The last line has no line break. The text
        is empty if there is nothing to report.
        """
        cells = [cell for row in self.differing for cell in _cells(row)]
        widths = [max((len(cell[column]) for cell in cells), default=0) for column in range(3)]
        lines = [
            "  ".join(f"{text:{width}}" for text, width in zip(cell, widths, strict=True)).rstrip()
            for cell in cells
        ]
        return "\n".join([*lines, *self.left_out])


def compare(before: Settings, after: Settings) -> Comparison:
    """Compare settings with their replacements.

    Settings are equal if their wire values are equal. A setting is left out if its wire value has a
    different meaning on the other model.
    """
    numbers = {spec.number: spec.key for side in (before, after) for spec in side.specs.readable}
    keys = [key for _, key in sorted(numbers.items())]
    given = [key for key in keys if key in before.parameters or key in after.parameters]
    reasons = {key: reason for key in given if (reason := _omission_reason(key, before, after))}
    rows = [_parameter_row(key, before, after) for key in given if key not in reasons]
    return Comparison((*rows, *_calibration_rows(before, after)), tuple(reasons.values()))


def compare_with_board(stored: Settings, source: InputSource, target: Settings) -> Comparison:
    """Compare stored settings with `target`. Raises BadRequest if `target` does not fit.

    Only calibrations for `source` are compared, because the board hides all others.
    """
    if target.product.key != stored.product.key:
        text = tr("These settings are for a {0}, not a {1}")
        raise BadRequest(text.format(target.product.name, stored.product.name))
    visible = {key: value for key, value in target.calibrations.items() if key.source is source}
    result = compare(stored, replace(target, calibrations=visible))
    if result.left_out:
        raise BadRequest(" ".join(result.left_out))
    return result


def values_to_write(
    rows: Iterable[ComparisonRow],
) -> tuple[tuple[tuple[str, int], ...], tuple[tuple[CalibrationKey, Calibration], ...]]:
    """Return the parameters and the calibrations of the `after` side."""
    after = [(row.key, row.after) for row in rows]
    return (
        tuple((key, value) for key, value in after if isinstance(value, int)),
        tuple((CALIBRATION_KEYS[key], v) for key, v in after if isinstance(v, Calibration)),
    )


def settings_after(
    before: Settings, written: Iterable[tuple[str, int | Calibration | None]]
) -> Settings:
    """Return `before` with the written values. `None` does not change a setting."""
    parameters, calibrations = dict(before.parameters), dict(before.calibrations)
    for key, value in written:
        if isinstance(value, Calibration):
            calibrations[CALIBRATION_KEYS[key]] = value
        elif value is not None:
            parameters[key] = value
    return replace(before, parameters=parameters, calibrations=calibrations)


def _omission_reason(key: str, before: Settings, after: Settings) -> str:
    """Return the reason to leave out a parameter. Empty if it can be compared."""
    for side, other in ((before, after), (after, before)):
        spec, wire = side.specs.readable_by_key.get(key), side.parameters.get(key)
        if spec is not None and wire is not None and key not in other.specs.readable_by_key:
            board = tr("a {0} with firmware {1}").format(other.product.name, other.specs.firmware)
            return tr("{0} ({1}) is left out: {2} does not have this setting.").format(
                spec.name, spec.text(wire), board
            )
    wire = after.parameters.get(key)
    if wire is None:
        return ""
    old, new = before.specs[key], after.specs[key]
    if new.text(wire) == old.text(wire):
        return ""
    return tr("{0} is left out: {1} means {2} to a {3}, but {4} to a {5}.").format(
        new.name, wire, new.text(wire), after.product.name, old.text(wire), before.product.name
    )


def _parameter_row(key: str, before: Settings, after: Settings) -> ComparisonRow:
    old, new = before.parameters.get(key), after.parameters.get(key)
    spec = before.specs[key]
    old_text = "" if old is None else spec.text(old)
    new_text = "" if new is None else after.specs[key].text(new)
    notes = before.notes.get(key, ""), after.notes.get(key, "")
    return ComparisonRow(key, spec.name, old, new, old_text, new_text, *notes)


def _calibration_rows(before: Settings, after: Settings) -> Iterator[ComparisonRow]:
    for key in CalibrationKey:
        old, new = before.calibrations.get(key), after.calibrations.get(key)
        old_text = "" if old is None else calibration_text(key.source, old)
        new_text = "" if new is None else calibration_text(key.source, new)
        if old is not None or new is not None:
            name = tr("Calibration of {0}").format(key.label)
            notes = before.notes.get(key, ""), after.notes.get(key, "")
            yield ComparisonRow(key, name, old, new, old_text, new_text, *notes)


def _counts(rows: list[ComparisonRow], singular: str, plural: str) -> str:
    changed = sum(row.changed for row in rows)
    missing = sum(row.is_missing for row in rows)
    parts = [
        tr("{0} will change").format(changed),
        tr("{0} match").format(len(rows) - changed - missing),
    ]
    if missing:
        parts.append(f"{missing} {tr(_NOT_GIVEN)}")
    return f"{(singular if len(rows) == 1 else plural).format(len(rows))}: {', '.join(parts)}"


def _cells(row: ComparisonRow) -> Iterator[tuple[str, str, str]]:
    """Yield table cells (key, wire values, physical values) for the values and notes of a row."""
    if isinstance(row.key, CalibrationKey) and None not in {row.before, row.after}:
        for name in row.differing_fields:
            old, new = getattr(row.before, name), getattr(row.after, name)
            texts = f"{row.key.source.text(old)} → {row.key.source.text(new)}"
            yield f"{row.key} {name}", f"{old} → {new}", texts
    elif row.before != row.after:
        missing = tr(_NOT_GIVEN)
        wires = f"{wire_text(row.before, missing)} → {wire_text(row.after, missing)}"
        texts = f"{row.text_before or missing} → {row.text_after or missing}"
        yield row.key, wires, "" if texts == wires else texts
    if text := text_of_notes(row.note_before, row.note_after):
        yield tr("{0} note").format(row.key), "", text


def text_of_notes(before: str, after: str) -> str:
    """Return both notes on one line. Different notes become old → new."""
    notes = (note.replace("\n", " / ") for note in (before, after))
    return " → ".join(dict.fromkeys(filter(None, notes)))


def wire_text(value: int | Calibration | None, missing: str) -> str:
    if isinstance(value, Calibration):
        return " ".join(str(getattr(value, name)) for name in CALIBRATION_FIELDS)
    return missing if value is None else str(value)
