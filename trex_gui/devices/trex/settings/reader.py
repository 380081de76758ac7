"""Reader for settings files that reports all errors and warnings by line."""

import difflib
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from ruamel.yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from trex_gui.core.decimals import AmbiguousNumber
from trex_gui.core.errors import BadRequest
from trex_gui.core.files import Finding, SettingsError, Severity, decode
from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.protocol.calibration import (
    CALIBRATION_FIELDS,
    CALIBRATION_KEYS,
    HIGHEST_CODED,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.protocol.device_table import Model, device_table, version_key
from trex_gui.devices.trex.protocol.parameters import ParameterKind, ParameterSpec, parameters_of
from trex_gui.devices.trex.settings.document import Settings, specs_for
from trex_gui.devices.trex.settings.notes import read_notes
from trex_gui.devices.trex.settings.yaml_subset import compose, line_of, shortened

BYTE_ORDER_MARK = "\ufeff"
MAX_FINDINGS = 100  # further errors are only counted
_MAX_NAMES = 3  # missing parameters that a warning names
_QUANTITIES = {ParameterKind.NUMBER, ParameterKind.ACCELERATION, ParameterKind.PWM_MAXIMUM}
_INTEGER = re.compile(r"[-+]?(?:0|[1-9][0-9]{0,17})|0[xX][0-9A-Fa-f]{1,16}")
_FIRMWARE = re.compile(r"[0-9](?:\.[0-9]{1,3}){1,2}")

_MESSAGES: Mapping[str, str] = {
    "unterminated": tr_noop("the last line has no line break; was the file cut short?"),
    "more_errors": tr_noop("{count} more errors are not listed"),
    "key_is_no_name": tr_noop("there must be a name before the colon, not a list or a group"),
    "repeated": tr_noop("was already given in line {first}"),
    "repeated_in_group": tr_noop("{name} was already given in line {first}"),
    "product_missing": tr_noop("the first setting must be {wanted}, but this file has no product"),
    "product_not_first": tr_noop("must be the first setting of the file"),
    "product_misspelt": tr_noop("must be {models}, not {given}; did you mean {model}?"),
    "product_unknown": tr_noop("must be {models}, not {given}; these are not settings of a TReX"),
    "firmware_invalid": tr_noop("must be a version such as {newest}, not {given}"),
    "firmware_unknown": tr_noop("versions {oldest} to {newest} are known, but {given} is not"),
    "not_a_setting": tr_noop("is a command to the board, not a setting"),
    "value_invalid": tr_noop("must be {allowed}, not {given}{hint}"),
    "value_open": tr_noop("should be {allowed}{grade}, not {given}; the board decides"),
    "needs_firmware": tr_noop(
        "a {product} has this setting only from firmware {since} on, but the file is for {firmware}"
    ),
    "other_product": tr_noop("a {product} does not have this setting in any firmware"),
    "key_unknown": tr_noop("there is no such setting{guess}"),
    "calibration_layout": tr_noop("must be written as {layout}, not {given}"),
    "field_unknown": tr_noop("a calibration has no {field!r}{guess}"),
    "field_invalid": tr_noop("{field} must be 0 to {highest}, not {given}"),
    "field_missing": tr_noop("{fields} is missing"),
    "fields_missing": tr_noop("{fields} are missing"),
    "calibration_invalid": "{problem}",
    "parameter_missing": tr_noop("1 of {total} parameters is missing: {names}"),
    "parameters_missing": tr_noop("{count} of {total} parameters are missing: {names}"),
}


def read_settings(
    text: str | bytes, name: str = "settings"
) -> tuple[Settings, tuple[Finding, ...]]:
    """Return the settings in a file, and the warnings. `name` is the file name for errors.

    Raises:
        SettingsError: the file cannot be used. The error contains all findings. The settings are
            checked only if the file is valid YAML with a known product.
    """
    data = text if isinstance(text, bytes) else text.encode("utf-8", "surrogatepass")
    content = decode(data, name)
    reader = _Reader()
    settings = reader.read(compose(content, name), read_notes(content))
    if content[-1:] not in {"\n", "\r"}:
        reader.warn(len(content.splitlines()), None, "unterminated")
    findings = reader.sorted_findings()
    if settings is None or any(f.severity is Severity.ERROR for f in findings):
        raise SettingsError(name, findings)
    return settings, findings


def repair_values(data: bytes, name: str) -> tuple[str, tuple[str, ...]]:
    """Repair invalid values in a text if their meaning is clear.

    A value with a unit or in words becomes its wire value. A number outside its range becomes the
    nearest limit. A misspelt product becomes the correct name. Ambiguous values do not change.
    Returns the text and a line for each repair.

    Raises:
        SettingsError: `data` is not the text of a settings file.
    """
    body = decode(data, name)
    reader = _Reader()
    reader.read(compose(body, name), {})
    fixes = sorted(reader.fixes)
    for fix in reversed(fixes):
        body = body[: fix.start] + fix.text + body[fix.end :]
    mark = BYTE_ORDER_MARK if data.startswith(BYTE_ORDER_MARK.encode()) else ""
    return mark + body, tuple(f"line {fix.line}: {fix.message}" for fix in fixes)


class _Fix(NamedTuple):
    start: int
    end: int
    text: str
    line: int
    message: str  # such as `serial_timeout: 1.5 s becomes 15 (1.5 s)`


class _Entry(NamedTuple):
    line: int
    value: Node


@dataclass(slots=True)
class _Reader:
    findings: list[Finding] = field(default_factory=list)
    fixes: list[_Fix] = field(default_factory=list)
    left_out: int = 0  # errors after the first `MAX_FINDINGS`
    parameters: dict[str, int] = field(default_factory=dict)
    calibrations: dict[CalibrationKey, Calibration] = field(default_factory=dict)

    def error(self, line: int | None, key: str | None, code: str, **fields: object) -> None:
        if len(self.findings) < MAX_FINDINGS:
            self.findings.append(_finding(line, key, code, Severity.ERROR, **fields))
        else:
            self.left_out += 1

    def warn(self, line: int | None, key: str | None, code: str, **fields: object) -> None:
        self.findings.append(_finding(line, key, code, Severity.WARNING, **fields))

    def fix(self, key: str, entry: "_Entry", text: str, meaning: str) -> None:
        value = entry.value
        if isinstance(value, ScalarNode) and (value.style or "'") in "'\"":
            message = tr("{0}: {1} becomes {2}").format(key, _given_text(value), meaning)
            start, end = value.start_mark.index, value.end_mark.index
            self.fixes.append(_Fix(start, end, text, entry.line, message))

    def sorted_findings(self) -> tuple[Finding, ...]:
        """Return the findings in order of lines. Findings about the whole file come last."""
        findings = sorted(self.findings, key=lambda f: (f.line is None, f.line or 0))
        if self.left_out:
            findings.append(
                _finding(None, None, "more_errors", Severity.ERROR, count=self.left_out)
            )
        return tuple(findings)

    def read(self, root: MappingNode, notes: Mapping[str, str]) -> Settings | None:
        """Return the settings, or `None` if the product is missing or unknown."""
        entries = self._entries(root, None)
        product = self._product(entries)
        if product is None:
            return None
        firmware = self._firmware(entries.get("firmware"), product)
        for key, entry in entries.items():
            if key in CALIBRATION_KEYS:
                self._read_calibration(key, entry)
            elif key not in {"product", "firmware"}:
                self._read_parameter(key, entry, product, firmware)
        self._warn_of_missing(entries.keys(), product, firmware)
        return Settings(product, firmware, self.parameters, self.calibrations, notes)

    def _entries(self, node: MappingNode, owner: str | None) -> dict[str, _Entry]:
        entries: dict[str, _Entry] = {}
        for key_node, value in node.value:
            line = line_of(key_node)
            if not isinstance(key_node, ScalarNode):
                self.error(line, owner, "key_is_no_name")
                continue
            key = str(key_node.value)
            if key in entries:
                code, name = "repeated_in_group" if owner else "repeated", shortened(key)
                self.error(line, owner or name, code, name=name, first=entries[key].line)
            else:
                entries[key] = _Entry(line, value)
        return entries

    def _product(self, entries: Mapping[str, _Entry]) -> Model | None:
        models = device_table().models
        expected = tr(" or ").join(f"'product: {model.name}'" for model in models)
        entry = entries.get("product")
        if entry is None:
            self.error(1, None, "product_missing", wanted=expected)
            return None
        if next(iter(entries)) != "product":
            self.error(entry.line, "product", "product_not_first")
        given = _scalar_text(entry.value)
        names = tr(" or ").join(model.name for model in models)
        fields = {"models": names, "given": _given_text(entry.value)}
        for model in models:
            if _normalized(given) in {_normalized(model.name), _normalized(model.key)}:
                if given != model.name:
                    fields["model"] = model.name
                    self.error(entry.line, "product", "product_misspelt", **fields)
                    self.fix("product", entry, model.name, model.name)
                return model
        self.error(entry.line, "product", "product_unknown", **fields)
        return None

    def _firmware(self, entry: _Entry | None, product: Model) -> str | None:
        if entry is None:
            return None
        given = _scalar_text(entry.value)
        known = product.firmware
        if not _FIRMWARE.fullmatch(given):
            fields = {"newest": known[-1], "given": _given_text(entry.value)}
            self.error(entry.line, "firmware", "firmware_invalid", **fields)
            return None
        if not version_key(known[0]) <= version_key(given) <= version_key(known[-1]):
            fields = {"oldest": known[0], "newest": known[-1], "given": given}
            self.warn(entry.line, "firmware", "firmware_unknown", **fields)
        return given

    def _read_parameter(
        self, key: str, entry: _Entry, product: Model, firmware: str | None
    ) -> None:
        wire = _integer(entry.value)
        spec = next((s for s in specs_for(product, firmware) if s.key == key), None)
        if spec is None:
            self._report_unknown(key, entry.line, product, firmware)
        elif not spec.readable:
            self.error(entry.line, key, "not_a_setting")
        elif wire is not None and spec.problem(wire, forced=True) is None:
            self.parameters[key] = wire
            if spec.is_open(wire):
                fields = {"allowed": _range(spec), "grade": spec.limits_mark, "given": wire}
                self.warn(entry.line, key, "value_open", **fields)
        else:
            given, hint = _given_text(entry.value), _hint(spec, entry.value)
            fields = {"allowed": _range(spec), "given": given, "hint": hint}
            self.error(entry.line, key, "value_invalid", **fields)
            meant = _meant(spec, entry.value)
            if meant is None and wire is not None and spec.kind in _QUANTITIES:
                meant = min(max(wire, spec.minimum), spec.maximum)
            if isinstance(meant, int):
                text = spec.text(meant)
                meaning = str(meant) if text == str(meant) else f"{meant} ({text})"
                self.fix(key, entry, str(meant), meaning)

    def _report_unknown(self, key: str, line: int, product: Model, firmware: str | None) -> None:
        row = next((row for row in device_table().rows if row["key"] == key), None)
        if row is not None and product.key not in row["models"]:
            self.error(line, shortened(key), "other_product", product=product.name)
            return
        if firmware is not None and row is not None:
            fields = {"product": product.name, "since": row["since"], "firmware": firmware}
            self.error(line, shortened(key), "needs_firmware", **fields)
            return
        specs = specs_for(product, firmware).readable
        keys = ["product", "firmware", *(s.key for s in specs), *CALIBRATION_KEYS]
        guess = _guess(key, keys) if len(self.findings) < MAX_FINDINGS else ""  # guessing is slow
        self.error(line, shortened(key), "key_unknown", guess=guess)

    def _read_calibration(self, key: str, entry: _Entry) -> None:
        if not isinstance(entry.value, MappingNode):
            layout = "{" + ", ".join(f"{name}: …" for name in CALIBRATION_FIELDS) + "}"
            given = _given_text(entry.value)
            self.error(entry.line, key, "calibration_layout", layout=layout, given=given)
            return
        inner = self._entries(entry.value, key)
        values: dict[str, int] = {}
        for name, part in inner.items():
            wire = _integer(part.value)
            if name not in CALIBRATION_FIELDS:
                guess = _guess(name, CALIBRATION_FIELDS)
                self.error(part.line, key, "field_unknown", field=shortened(name), guess=guess)
            elif wire is None or not 0 <= wire <= HIGHEST_CODED:
                fields = {"field": name, "highest": HIGHEST_CODED, "given": _given_text(part.value)}
                self.error(part.line, key, "field_invalid", **fields)
            else:
                values[name] = wire
        if missing := [name for name in CALIBRATION_FIELDS if name not in inner]:
            code = "field_missing" if len(missing) == 1 else "fields_missing"
            self.error(entry.line, key, code, fields=tr(" and ").join(missing))
        if len(values) < len(CALIBRATION_FIELDS):
            return
        calibration = Calibration(**values)
        if problem := calibration.problem():
            self.error(entry.line, key, "calibration_invalid", problem=problem)
        else:
            self.calibrations[CALIBRATION_KEYS[key]] = calibration

    def _warn_of_missing(
        self, given: Collection[str], product: Model, firmware: str | None
    ) -> None:
        expected = parameters_of(product.key, firmware or product.firmware[0]).readable
        missing = [spec.key for spec in expected if spec.key not in given]
        if missing:
            names = ", ".join(missing[:_MAX_NAMES]) + (" …" if len(missing) > _MAX_NAMES else "")
            code = "parameter_missing" if len(missing) == 1 else "parameters_missing"
            self.warn(None, None, code, count=len(missing), total=len(expected), names=names)


def _finding(
    line: int | None, key: str | None, code: str, severity: Severity, **fields: object
) -> Finding:
    return Finding(line, key, tr(_MESSAGES[code]).format(**fields), severity, code)


def _integer(node: Node) -> int | None:
    """Return the value of an unquoted decimal or 0x integer. `None` for other nodes."""
    if not isinstance(node, ScalarNode) or node.style is not None:
        return None
    text = str(node.value)
    if not _INTEGER.fullmatch(text):
        return None
    return int(text, 16 if text[1:2] in {"x", "X"} else 10)


def _scalar_text(node: Node) -> str:
    return str(node.value) if isinstance(node, ScalarNode) else ""


def _given_text(node: Node) -> str:
    if not isinstance(node, ScalarNode):
        return tr("a list") if isinstance(node, SequenceNode) else tr("a group of settings")
    text = shortened(str(node.value))
    if node.style is not None:
        return tr("{0} in quotes").format(text) if node.style in "'\"" else tr("a block of text")
    return text or tr("nothing")


def _range(spec: ParameterSpec) -> str:
    if spec.kind in {ParameterKind.CHOICE, ParameterKind.UART}:
        return spec.range_text()
    low, high = spec.text(spec.minimum), spec.text(spec.maximum)
    meaning = (
        tr("channels 1 to 5")
        if spec.kind is ParameterKind.CHANNELS
        else tr("{0} to {1}").format(low, high)
    )
    wires = tr("{0} to {1}").format(spec.minimum, spec.maximum)
    return wires if meaning == wires else f"{wires} ({meaning})"


def _hint(spec: ParameterSpec, node: Node) -> str:
    """Return a hint on how to write a value such as `1.5 s`. May be empty."""
    meant, text = _meant(spec, node), _scalar_text(node)
    if not isinstance(meant, int):
        return f"; {meant}" if meant else ""
    is_quoted = _INTEGER.fullmatch(text) is not None and _integer(node) is None
    return (
        tr("; write {0}").format(text)
        if is_quoted
        else tr("; write {1} for {0}").format(shortened(text), meant)
    )


def _meant(spec: ParameterSpec, node: Node) -> int | AmbiguousNumber | None:
    """Return the wire value of a physical value (`1.5 s`) or of a quoted number.

    Returns the error for an ambiguous number, and `None` for a value without a clear meaning.
    """
    text = _scalar_text(node)
    if len(text) > len("19200 baud, no error detection, 1 stop bit"):
        return None
    if _INTEGER.fullmatch(text) and _integer(node) is None:  # in quotes
        wire = int(text, 0)
        return wire if spec.problem(wire) is None else None
    # 9600 or 1.5 could be in any unit. A complete polynomial is recognized by its highest bit.
    if spec.kind is not ParameterKind.POLYNOMIAL and not any(c.isalpha() for c in text):
        return None
    try:
        return spec.wire(text)
    except AmbiguousNumber as error:
        return error
    except BadRequest:
        return None


def _guess(key: str, keys: Sequence[str]) -> str:
    word = shortened(key).strip().lower().replace("-", "_").replace(" ", "_")
    close = difflib.get_close_matches(word, keys, n=1)
    return tr("; did you mean {0}?").format(close[0]) if close else ""


def _normalized(word: str) -> str:
    return word.replace(" ", "").casefold()
