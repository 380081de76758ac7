"""Writer for settings files, with physical values as comments."""

from collections.abc import Iterator, Sequence
from functools import cache
from itertools import chain, groupby

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import in_english, tr
from trex_gui.devices.trex.protocol.calibration import (
    CALIBRATION_FIELDS,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameters import ParameterSpec, pwm_keys
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.notes import lines_of_note

_CALIBRATION_TITLES = {
    InputSource.RC: "# Calibrations for RC pulses, in counts of 0.4 µs",
    InputSource.ANALOG: "# Calibrations for analog voltages, in counts of 4.89 mV",
}


def write_settings(settings: Settings, *, title_lines: Sequence[str] = ()) -> str:
    """Return the text of a settings file.

    The program's comments are in English like the keys, so files do not depend on the user's
    language. A value that the board would reject becomes a comment with the reason. Notes become
    comments above their settings. Notes on missing settings are at the end. `title_lines` are
    comments for the header.

    Raises:
        BadRequest: the settings contain a key that their model and firmware do not have.
    """
    check_keys(settings)
    header = [f"product: {settings.product.name}"]
    header += [_comment(part) for line in title_lines for part in line.splitlines() or [""]]
    if settings.firmware is not None:
        header.append(f"firmware: {settings.firmware}")
    with in_english():
        blocks = [header, *_parameter_blocks(settings), *_calibration_blocks(settings)]
    if other_keys := sorted(settings.notes.keys() - settings.keys):
        lines = (lines_of_note(key, settings.notes) for key in other_keys)
        blocks.append(list(chain.from_iterable(lines)))
    return "\n\n".join("\n".join(block) for block in blocks) + "\n"


def check_keys(settings: Settings) -> None:
    """Raise BadRequest if the model and firmware do not have all keys."""
    known = settings.specs.readable_by_key
    if unknown := [key for key in settings.parameters if key not in known]:
        board = f"{settings.product.name} {settings.firmware or ''}".strip()
        raise BadRequest(tr("a {0} has no {1}").format(board, ", ".join(unknown)))


def _parameter_blocks(settings: Settings) -> Iterator[list[str]]:
    items = settings.parameter_items()
    groups = list(dict.fromkeys(spec.group for spec, _ in items))
    items.sort(key=lambda item: groups.index(item[0].group))
    for group, members in groupby(items, key=lambda item: item[0].group):
        lines = [f"# {group.capitalize()}"]
        for spec, wire in members:
            lines += lines_of_note(spec.key, settings.notes)
            lines.append(parameter_line(spec, wire, settings))
        yield lines


def parameter_line(spec: ParameterSpec, wire: int, settings: Settings) -> str:
    """Return the line of a setting. A rejected value becomes a comment."""
    setting = f"{spec.key}: {wire}"
    if problem := spec.problem(wire, forced=True):
        return _left_out(setting, problem)
    text = parameter_text(spec, wire, settings)
    return f"{setting:{_width()}}  # {text}" if text else setting


@cache
def _width() -> int:
    """Return the maximum width of a setting. It is fixed, so a new value changes only its line."""
    return max(len(f"{row['key']}: {row['max']}") for row in device_table().rows)


def parameter_text(spec: ParameterSpec, wire: int, settings: Settings) -> str:
    """Return the comment beside a value, such as `0.5 s to full speed`.

    The comment includes the frequency if the parameter is the prescaler or maximum of a PWM.
    """
    texts = (plain_text(spec, wire), _pwm_text(spec, settings))
    return ", ".join(filter(None, texts))


def plain_text(spec: ParameterSpec, wire: int) -> str:
    """Return a value in its physical unit. Empty if this text equals the wire value."""
    if spec.is_open(wire):
        return tr("beyond a limit{0}: the board decides").format(spec.limits_mark)
    text = spec.text(wire)
    return "" if text == str(wire) else text


def _pwm_text(spec: ParameterSpec, settings: Settings) -> str:
    """Return the frequency if a parameter belongs to a PWM. Empty for other parameters."""
    pair = pwm_keys(spec.key)
    wires = [settings.parameters[key] for key in pair if key in settings.parameters]
    if len(wires) < 2:
        return ""
    try:
        return f"{device_table().pwm.frequency(*wires):.0f} Hz"
    except BadRequest:
        return ""


def _calibration_blocks(settings: Settings) -> Iterator[list[str]]:
    for source, members in groupby(settings.calibration_items(), key=lambda item: item[0].source):
        items = list(members)
        width = max(len(_calibration_setting(*item)) for item in items)
        lines = [_CALIBRATION_TITLES[source]]
        for key, calibration in items:
            lines += lines_of_note(key, settings.notes)
            lines.append(calibration_line(key, calibration, width))
        yield lines


def calibration_line(key: CalibrationKey, calibration: Calibration, width: int = 0) -> str:
    """Return the line of a calibration. Rejected values become a comment."""
    setting = _calibration_setting(key, calibration)
    if problem := calibration.problem():
        return _left_out(setting, problem)
    return f"{setting:{width}}  # {calibration_text(key.source, calibration)}"


def _calibration_setting(key: CalibrationKey, calibration: Calibration) -> str:
    parts = (f"{name}: {getattr(calibration, name)}" for name in CALIBRATION_FIELDS)
    return f"{key}: {{{', '.join(parts)}}}"


def calibration_text(source: InputSource, calibration: Calibration) -> str:
    points = (calibration.minimum, calibration.neutral, calibration.maximum)
    numbers = " / ".join(source.text(point).removesuffix(f" {source.unit}") for point in points)
    deadband = source.text(calibration.deadband)
    return tr("{0}, deadband {1}").format(f"{numbers} {source.unit}", deadband)


def _left_out(setting: str, problem: str) -> str:
    return _comment(f"{setting}  # left out: {problem}")


def _comment(text: str) -> str:
    """Return a comment without the control characters that YAML forbids."""
    printable = "".join(c if c.isprintable() else "?" for c in text.expandtabs())
    return f"# {printable}".rstrip()
