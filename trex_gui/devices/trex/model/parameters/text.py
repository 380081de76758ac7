"""The texts of the parameter table: values in physical units, states and explanations."""

from collections.abc import Mapping
from html import escape

from PySide6.QtCore import QObject

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.model.parameters.draft import Draft
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.parameters import (
    ParameterKind,
    ParameterSpec,
    motor_name,
    other_motor_key,
)

FULL_SPEED_MS = 12_700
"""Milliseconds to full speed (127) at one speed step in 100 ms."""

_PWM = {"pwm_maximum": "pwm_prescaler", "pwm_prescaler": "pwm_maximum"}


def pwm_partner(key: str) -> str | None:
    """Return the key of what sets the PWM frequency together with this; `None`: nothing."""
    for own, other in _PWM.items():
        if key.endswith(own):
            return key.removesuffix(own) + other
    return None


class ParameterText(QObject):
    """Derives every text from the current draft; has no state.

    Attributes:
        specs: the parameters that there are, by key.
    """

    def __init__(
        self, draft: Draft, problems: Mapping[str, str], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._draft = draft
        self._problems = problems
        self.specs: Mapping[str, ParameterSpec] = {}

    # --- Cells --------------------------------------------------------------------------

    def value(self, spec: ParameterSpec) -> str:
        """What would be in the device after Apply."""
        wire = self._draft.value(spec.key)
        if wire is not None:
            return self.physical(spec, wire)
        return self.tr("not given") if self._draft.takes(spec.key) else self.tr("not read")

    def physical(self, spec: ParameterSpec, wire: int) -> str:
        """A wire value, with what follows from it and others: frequency, time to full speed."""
        text = spec.text(wire)
        if spec.kind is ParameterKind.ACCELERATION and wire:
            return self.tr("{0} to full speed").format(duration(FULL_SPEED_MS / wire))
        if spec.kind is ParameterKind.UART:
            return text.replace("no error detection", self.tr("no check"))
        hertz = self._frequency(spec, wire)
        return text if hertz is None else self.tr("{0} ({1:.0f} Hz)").format(text, hertz)

    def with_wire(self, spec: ParameterSpec, wire: int) -> str:
        """A value both ways: `15 (1.5 s)`, or once where both are the same."""
        text = spec.text(wire)
        if spec.kind is ParameterKind.ACCELERATION:
            text = self.physical(spec, wire)
        return text if text == str(wire) else f"{wire} ({text})"

    def range(self, spec: ParameterSpec) -> str:
        """The allowed values in few words, in the unit of the values."""
        if spec.kind is ParameterKind.ACCELERATION:
            fast, slow = (FULL_SPEED_MS / 1000 / wire for wire in (spec.maximum, 1))
            return self.tr("{0}, {1:.1f} to {2:.1f} s").format(spec.text(0), fast, slow)
        return spec.short_range()

    def source(self, spec: ParameterSpec) -> str:
        """How far the maker's documents confirm limits and default, in a word or two."""
        match spec.limits_confirmed, spec.default_confirmed:
            case True, True:
                return self.tr("vendor")
            case True, False:
                return self.tr("default inferred")
            case False, True:
                return self.tr("range inferred")
            case _:
                return self.tr("inferred")

    def effect(self, spec: ParameterSpec) -> str:
        """When a stored value acts."""
        return self.tr("power cycle") if spec.needs_power_cycle else self.tr("at once")

    # --- Sentences ----------------------------------------------------------------------

    def limits(self, spec: ParameterSpec) -> str:
        """Range and default in full, wire values included."""
        text = self.tr("Range: {0}.").format(spec.range_text())
        if spec.kind is ParameterKind.ACCELERATION:
            text += " " + self.tr("As time to full speed: {0}.").format(self.range(spec))
        return text + " " + self.tr("Default: {0}.").format(self.with_wire(spec, spec.default))

    def origin(self, spec: ParameterSpec) -> str:
        """Where limits and default come from, and what that means."""
        match spec.limits_confirmed, spec.default_confirmed:
            case True, True:
                text = self.tr("The maker's documents or staff confirm range and default.")
            case True, False:
                text = self.tr("The range is confirmed by the maker; the default is inferred.")
            case False, True:
                text = self.tr("The default is confirmed by the maker; the range is inferred.")
            case _:
                text = self.tr("Range and default are inferred.")
        if {"scale", "bits"} & spec.inferred:
            text += " " + self.tr("So is what a wire value means.")
        if not (spec.limits_confirmed and spec.default_confirmed):
            text += " " + self.tr(
                "The maker's parameter document was not available: the board has the last word, "
                "and rejects a value that it does not accept."
            )
        return text

    def other_motor(self, spec: ParameterSpec) -> str | None:
        """What the other motor has, as a sentence; `None` where it has the same, or no such."""
        other = self.specs.get(other_motor_key(spec.key) or "")
        if other is None or self._draft.value(other.key) == self._draft.value(spec.key):
            return None
        return self.tr("{0} differs: {1}.").format(motor_name(other.key), self.value(other))

    def reset_text(self, spec: ParameterSpec) -> str:
        """The effect of resetting to the default."""
        return self.tr("Back to default: {0}").format(self.with_wire(spec, spec.default))

    def stored(self, spec: ParameterSpec) -> str:
        """What is stored, as a sentence."""
        wire = self._draft.stored.get(spec.key)
        shown = self.tr("nothing") if wire is None else self.with_wire(spec, wire)
        return self.tr("Stored: {0}.").format(shown)

    # --- Tool tips ----------------------------------------------------------------------

    def tip_of_name(self, spec: ParameterSpec) -> str:
        return self._tip(spec, spec.description)

    def tip_of_value(self, spec: ParameterSpec) -> str:
        stored = self.stored(spec) if self._draft.is_modified(spec.key) else ""
        return self._tip(spec, self.value(spec), stored, spec.description)

    def tip_of_default(self, spec: ParameterSpec) -> str:
        wire = self.tr("Default: {0}.").format(self.with_wire(spec, spec.default))
        return _paragraphs(wire)

    def tip_of_range(self, spec: ParameterSpec) -> str:
        return _paragraphs(self.limits(spec))

    def tip_of_source(self, spec: ParameterSpec) -> str:
        return _paragraphs(self.origin(spec))

    def tip_of_effect(self, spec: ParameterSpec) -> str:
        if spec.needs_power_cycle:
            text = self.tr("Stored by Apply, active when the board was switched off and on.")
        else:
            text = self.tr("Active as soon as it is applied.")
        return _paragraphs(text)

    def _tip(self, spec: ParameterSpec, head: str, *more: str) -> str:
        text_parts = (head, *more, self.other_motor(spec) or "", self._problems.get(spec.key, ""))
        return _paragraphs(
            f"<b>{escape(spec.name)}</b>", *(escape(text) for text in text_parts if text)
        )

    def _frequency(self, spec: ParameterSpec, wire: int) -> float | None:
        """The PWM frequency in Hz that a value makes together with its partner."""
        partner = pwm_partner(spec.key)
        other = None if partner is None else self._draft.value(partner)
        if other is None:
            return None
        prescaler, top = (other, wire) if spec.kind is ParameterKind.PWM_MAXIMUM else (wire, other)
        try:
            return device_table().pwm.frequency(prescaler, top)
        except BadRequest:
            return None


def duration(milliseconds: float) -> str:
    """Return a duration with a unit: `508 ms`, `3.2 s`."""
    if milliseconds < 1000:
        return f"{milliseconds:.0f} ms"
    return f"{milliseconds / 1000:.1f} s"


def _paragraphs(*texts: str) -> str:
    """Return rich text: only that is wrapped in a tool tip."""
    return "".join(f"<p>{text}</p>" for text in texts)
