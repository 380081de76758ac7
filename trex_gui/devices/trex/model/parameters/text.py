"""The texts of the parameter table: values in physical units, states and explanations."""

from collections.abc import Mapping
from enum import IntEnum
from html import escape

from PySide6.QtCore import QCoreApplication, QObject

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.model.parameters.draft import Draft
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.parameters import (
    ParameterKind,
    ParameterSpec,
    motor_name,
    other_motor_key,
)

FULL_SPEED_S = 12.7  # seconds to full speed (127) at one speed step in 100 ms
_PWM = {"pwm_maximum": "pwm_prescaler", "pwm_prescaler": "pwm_maximum"}


class ParameterColumn(IntEnum):
    NAME = 0
    VALUE = 1
    WIRE = 2
    RESET = 3
    DEFAULT = 4
    RANGE = 5
    SOURCE = 6
    EFFECT = 7


class ParameterText(QObject):
    """Derives every text from the current draft; has no state.

    `problems` are reasons of failed reads and writes by key.
    """

    def __init__(
        self,
        specs: Mapping[str, ParameterSpec],
        draft: Draft,
        problems: Mapping[str, str],
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._specs = specs
        self._draft = draft
        self._problems = problems
        self._sources = {
            (True, True): (
                self.tr("vendor"),
                self.tr("The vendor's documents or staff confirm range and default."),
            ),
            (True, False): (
                self.tr("default inferred"),
                self.tr("The range is confirmed by the vendor; the default is inferred."),
            ),
            (False, True): (
                self.tr("range inferred"),
                self.tr("The default is confirmed by the vendor; the range is inferred."),
            ),
            (False, False): (self.tr("inferred"), self.tr("Range and default are inferred.")),
        }

    # --- Cells --------------------------------------------------------------------------

    def cell(self, spec: ParameterSpec, column: ParameterColumn) -> str:
        match column:
            case ParameterColumn.NAME:
                return spec.name
            case ParameterColumn.VALUE:
                return self.value(spec)
            case ParameterColumn.WIRE:
                wire = self._draft.value(spec.key)
                return "" if wire is None else str(wire)
            case ParameterColumn.DEFAULT:
                return spec.text(spec.default)
            case ParameterColumn.RANGE:
                return self._range(spec)
            case ParameterColumn.SOURCE:
                return self.source(spec)
            case ParameterColumn.EFFECT:
                return self.tr("power cycle") if spec.needs_power_cycle else self.tr("at once")
            case ParameterColumn.RESET:
                return ""

    def value(self, spec: ParameterSpec) -> str:
        """Return the value after Apply or Save."""
        wire = self._draft.value(spec.key)
        if wire is None:
            return self.tr("not given") if self._draft.accepts(spec.key) else self.tr("not read")
        return self.physical(spec, wire)

    def physical(self, spec: ParameterSpec, wire: int) -> str:
        """Return a wire value in its unit, with the frequency or time that it results in."""
        text = value_text(spec, wire)
        hertz = self._frequency(spec, wire)
        return text if hertz is None else self.tr("{0} ({1:.0f} Hz)").format(text, hertz)

    def with_wire(self, spec: ParameterSpec, wire: int) -> str:
        """Return wire and physical value, `15 (1.5 s)`, or one number where both are the same."""
        text = value_text(spec, wire)
        return text if text == str(wire) else f"{wire} ({text})"

    def source(self, spec: ParameterSpec) -> str:
        """Return how far the vendor's documents confirm limits and default, in a word or two."""
        return self._sources[spec.limits_confirmed, spec.default_confirmed][0]

    # --- Sentences ----------------------------------------------------------------------

    def limits(self, spec: ParameterSpec) -> str:
        """Return range and default, wire values included."""
        shown = spec.range_text()
        if spec.kind is ParameterKind.ACCELERATION:
            shown = self.tr("{0} (wire value {1} to {2})").format(
                acceleration_range(spec), spec.minimum, spec.maximum
            )
        return self.tr("Range: {0}.").format(shown) + " " + self._default(spec)

    def origin(self, spec: ParameterSpec) -> str:
        """Return where limits and default come from, and what that means."""
        text = self._sources[spec.limits_confirmed, spec.default_confirmed][1]
        if {"scale", "bits"} & spec.inferred:
            text += " " + self.tr("The meaning of the wire values is inferred, too.")
        if not (spec.limits_confirmed and spec.default_confirmed):
            text += " " + self.tr(
                "The vendor's parameter document was not available. The board rejects any value "
                "that it does not support."
            )
        return text

    def other_motor(self, spec: ParameterSpec) -> str:
        """Return the other motor's value if it differs, as a sentence."""
        other = self._specs.get(other_motor_key(spec.key) or "")
        if other is None or self._draft.value(other.key) == self._draft.value(spec.key):
            return ""
        return self.tr("{0} differs: {1}.").format(motor_name(other.key), self.value(other))

    def reset(self, spec: ParameterSpec) -> str:
        """Return the effect of a reset to the default."""
        return self.tr("Reset to default: {0}").format(self.with_wire(spec, spec.default))

    def stored(self, spec: ParameterSpec) -> str:
        """Return the stored value if it was edited, as a sentence."""
        if not self._draft.is_modified(spec.key):
            return ""
        wire = self._draft.stored.get(spec.key)
        shown = self.tr("nothing") if wire is None else self.with_wire(spec, wire)
        return self.tr("Stored: {0}.").format(shown)

    def tool_tip(self, spec: ParameterSpec, column: ParameterColumn) -> str:
        """Return the details of a cell as rich text, which tool tips wrap."""
        match column:
            case ParameterColumn.NAME:
                lines = self._about(spec, spec.description)
            case ParameterColumn.DEFAULT:
                lines = [self._default(spec)]
            case ParameterColumn.RANGE:
                lines = [self.limits(spec)]
            case ParameterColumn.SOURCE:
                lines = [self.origin(spec)]
            case ParameterColumn.EFFECT if spec.needs_power_cycle:
                lines = [self.tr("Stored by Apply, active after the board is switched off and on.")]
            case ParameterColumn.EFFECT:
                lines = [self.tr("Active as soon as it is applied.")]
            case _:
                value = self.value(spec)
                lines = self._about(spec, value, self.stored(spec), spec.description)
        return "".join(f"<p>{line}</p>" for line in lines)

    def _about(self, spec: ParameterSpec, *texts: str) -> list[str]:
        texts = (*texts, self.other_motor(spec), self._problems.get(spec.key, ""))
        return [f"<b>{escape(spec.name)}</b>", *(escape(text) for text in texts if text)]

    def _default(self, spec: ParameterSpec) -> str:
        return self.tr("Default: {0}.").format(self.with_wire(spec, spec.default))

    def _range(self, spec: ParameterSpec) -> str:
        if spec.kind is ParameterKind.ACCELERATION:
            return acceleration_range(spec)
        return spec.short_range()

    def _frequency(self, spec: ParameterSpec, wire: int) -> float | None:
        """Return the PWM frequency in Hz that a value results in together with its partner."""
        partner = pwm_partner(spec.key)
        other = None if partner is None else self._draft.value(partner)
        if other is None:
            return None
        prescaler, top = (other, wire) if spec.kind is ParameterKind.PWM_MAXIMUM else (wire, other)
        try:
            return device_table().pwm.frequency(prescaler, top)
        except BadRequest:
            return None


def pwm_partner(key: str) -> str | None:
    """Return the key that sets the PWM frequency together with this one."""
    for own, other in _PWM.items():
        if key.endswith(own):
            return key.removesuffix(own) + other
    return None


def value_text(spec: ParameterSpec, wire: int) -> str:
    """Return a wire value in the unit that the window shows."""
    is_ramp = spec.kind is ParameterKind.ACCELERATION and wire
    return acceleration_text(wire) if is_ramp else spec.text(wire)


# --- Acceleration -----------------------------------------------------------------------


def acceleration_text(wire: int) -> str:
    """Return an acceleration as the time to full speed: `0.5 s to full speed`."""
    return _tr("{0} s to full speed").format(_seconds_text(wire))


def acceleration_range(spec: ParameterSpec) -> str:
    fast, slow = _seconds_text(spec.maximum), _seconds_text(1)
    return _tr("{0} to {1} s to full speed, or {2}").format(fast, slow, spec.zero)


def acceleration_wire(seconds: float) -> int:
    """Return the wire value with the nearest time to full speed; 0 for none."""
    if seconds <= 0:
        return 0
    return min(range(1, FULL_SCALE + 1), key=lambda wire: abs(FULL_SPEED_S / wire - seconds))


def _seconds_text(wire: int) -> str:
    """Return the shortest number of seconds that means this wire value."""
    texts = (f"{FULL_SPEED_S / wire:.{decimals}f}" for decimals in range(1, 5))
    return next(text for text in texts if acceleration_wire(float(text)) == wire)


def _tr(text: str) -> str:
    return QCoreApplication.translate("ParameterText", text)
