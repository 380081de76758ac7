"""Write settings as text: one line each, with the physical value as a comment."""

from collections.abc import Iterator, Sequence
from itertools import groupby

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.calibration import (
    CALIBRATION_FIELDS,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameters import ParameterSpec
from trex_gui.devices.trex.settings.document import Settings

_CALIBRATION_TITLES = {
    InputSource.RC: "Calibrations for RC pulses, in counts of 0.4 µs",
    InputSource.ANALOG: "Calibrations for analog voltages, in counts of 4.89 mV",
}


def write_settings(settings: Settings, *, title_lines: Sequence[str] = ()) -> str:
    """Return the text of a settings file, which reads back as the same settings.

    A value that the board would refuse, though its EEPROM may hold it, stands there as a
    comment that says so: it is not lost, and the file can be used.

    Args:
        settings: what to write.
        title_lines: comments for the head of the file.

    Raises:
        BadRequest: the settings hold a key that their model and firmware do not have.
    """
    check_keys(settings)
    head = [f"product: {settings.product.name}"]
    head += [_comment(part) for line in title_lines for part in line.splitlines() or [""]]
    if settings.firmware is not None:
        head.append(f"firmware: {settings.firmware}")
    blocks = [head, *_parameter_blocks(settings), *_calibration_blocks(settings)]
    return "\n\n".join("\n".join(block) for block in blocks) + "\n"


def check_keys(settings: Settings) -> None:
    """Check that a file can hold every key of the settings.

    Raises:
        BadRequest: their model and firmware do not have one; names it.
    """
    known = {spec.key for spec in settings.specs.readable}
    strangers = [key for key in settings.parameters if key not in known]
    if strangers:
        board = f"{settings.product.name} {settings.firmware or ''}".strip()
        raise BadRequest(f"a {board} has no {', '.join(strangers)}")


def _parameter_blocks(settings: Settings) -> Iterator[list[str]]:
    specs = [spec for spec in settings.specs.readable if spec.key in settings.parameters]
    groups = list(dict.fromkeys(spec.group for spec in specs))
    specs.sort(key=lambda spec: groups.index(spec.group))
    for group, members in groupby(specs, key=lambda spec: spec.group):
        lines = [parameter_line(spec, settings.parameters[spec.key]) for spec in members]
        yield [f"# {group.capitalize()}", *lines]


def parameter_line(spec: ParameterSpec, wire: int) -> str:
    """Return a parameter's line: a setting, or a comment where the board would refuse it."""
    setting = f"{spec.key}: {wire}"
    if problem := spec.problem(wire):
        return _refused(setting, problem)
    text = parameter_text(spec, wire)
    # As wide as the widest line can be, so that a change of one value changes one line.
    width = max(len(f"{row['key']}: {row['max']}") for row in device_table().rows)
    return f"{setting:{width}}  # {text}" if text else setting


def parameter_text(spec: ParameterSpec, wire: int) -> str:
    """Return what stands as a comment beside a value; empty where it would repeat it."""
    text = spec.text(wire)
    return "" if text == str(wire) else text


def _calibration_blocks(settings: Settings) -> Iterator[list[str]]:
    for source in InputSource:
        found = [
            (key, settings.calibrations[key])
            for key in CalibrationKey
            if key.source is source and key in settings.calibrations
        ]
        if not found:
            continue
        width = max(len(_flow_setting(key, calibration)) for key, calibration in found)
        lines = [calibration_line(key, calibration, width) for key, calibration in found]
        yield [f"# {_CALIBRATION_TITLES[source]}", *lines]


def calibration_line(key: CalibrationKey, calibration: Calibration, width: int = 0) -> str:
    """Return a calibration's line: a setting, or a comment where the board would refuse it."""
    setting = _flow_setting(key, calibration)
    if problem := calibration.problem():
        return _refused(setting, problem)
    return f"{setting:{width}}  # {calibration_text(key.source, calibration)}"


def _flow_setting(key: CalibrationKey, calibration: Calibration) -> str:
    parts = (f"{name}: {getattr(calibration, name)}" for name in CALIBRATION_FIELDS)
    return f"{key}: {{{', '.join(parts)}}}"


def calibration_text(source: InputSource, calibration: Calibration) -> str:
    """Return a calibration in µs or V, as it stands in a comment."""
    points = (calibration.minimum, calibration.neutral, calibration.maximum)
    numbers = " / ".join(source.text(point).removesuffix(f" {source.unit}") for point in points)
    return f"{numbers} {source.unit}, deadband {source.text(calibration.deadband)}"


def _refused(setting: str, problem: str) -> str:
    return _comment(f"{setting}  # left out: {problem}")


def _comment(text: str) -> str:
    """Make a comment of any text: control characters and the like have no place in YAML."""
    shown = "".join(c if c.isprintable() else "?" for c in text.expandtabs())
    return f"# {shown}".rstrip()
