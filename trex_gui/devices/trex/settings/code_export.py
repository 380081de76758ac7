"""Export settings as a program in C, Python or for Arduino.

The program stores and checks the settings and drives the motors. `resources/code/` has a Jinja
template for each language; this module has the values that fill them.
"""

import textwrap
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

from trex_gui import __version__
from trex_gui.core.resource_files import resource
from trex_gui.devices.trex.protocol.calibration import (
    CALIBRATION_FIELDS,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.flags import Mode
from trex_gui.devices.trex.protocol.framing import DEFAULT_POLYNOMIAL
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey, ParameterSpec, parameter_number
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.writer import calibration_text, check_keys, parameter_text

_COMMENT_WIDTH = 86

_COMMENT_COLUMN = 42
"""Where comments begin at the latest, unless the code before them is longer."""

_SOURCE_LETTERS = {mode.source: mode.value for mode in Mode if mode.is_serial}
"""The reply to 0x82 in serial mode, by the inputs whose calibrations the board shows then."""

_PARITIES = {Detection.EVEN: "EVEN", Detection.ODD: "ODD"}


class Language(Enum):
    """A language; the value is its word on the command line."""

    ARDUINO = "arduino"
    PYTHON = "python"
    C = "c"

    @property
    def title(self) -> str:
        """Return the user's name for a program in the language."""
        titles = {"arduino": "Arduino sketch", "python": "Python program", "c": "C program"}
        return titles[self.value]

    @property
    def suffix(self) -> str:
        """Return the end of a file name."""
        return {"arduino": ".ino", "python": ".py", "c": ".c"}[self.value]

    @property
    def comment(self) -> str:
        """Return what begins a comment after code, in the usual style of the language."""
        return "  #" if self is Language.PYTHON else " //"


def file_name(settings: Settings, language: Language) -> str:
    """Return a name for the exported file, such as `trex_board.c`.

    The Arduino environment wants `trex_board.ino` in a folder `trex_board`.
    """
    return _stem(settings) + language.suffix


def export_code(settings: Settings, link: ConnectionSettings, language: Language) -> str:
    """Return a complete program that stores and checks settings and drives motors.

    The same settings and line give the same text, plain ASCII. A value that the board would
    reject is named in a comment and left out.

    Args:
        settings: what the program stores.
        link: baud rate, framing and the like; the user gives the port to the program.
        language: the language of the program.

    Raises:
        BadRequest: the settings hold a key that their model and firmware do not have, or the
            line has a baud rate that no board has.
    """
    link.line.to_wire()  # raises for an unknown baud rate
    tables = _Tables.of(settings)
    product, device, line = settings.product, link.framing.device_number, link.line
    new_device = tables.wire(ParameterKey.DEVICE_NUMBER)
    renumbers = None not in {new_device, device} and new_device != device
    firmware = "" if settings.firmware is None else f" with firmware {settings.firmware}"
    return _render(
        f"code/trex_board{language.suffix}.jinja",
        # Header
        version=__version__,
        product=plain(product.name),
        board=plain(product.name + firmware),
        stem=_stem(settings),
        warning=textwrap.fill(plain(_warning(tables)), _COMMENT_WIDTH),
        # Line
        line=line.text(),
        new_line=_new_line(link, tables),
        baud=line.baud,
        parity=_PARITIES.get(line.detection, "NONE"),
        even=line.detection is Detection.EVEN,
        odd=line.detection is Detection.ODD,
        stop_bits=line.stop_bits,
        two_stop_bits=line.stop_bits == 2,
        serial_config=_serial_config(line),
        # Packets
        device=device,
        with_device="" if device is None else f", device number {device}",
        new_device=new_device,
        renumbers=renumbers,
        device_name=_device_name(language, renumbers=renumbers),
        device_parameter=_hexadecimal(parameter_number(ParameterKey.DEVICE_NUMBER)),
        crc=link.framing.polynomial is not None,
        polynomial=_hexadecimal(link.polynomial),
        # Board and settings
        signature=plain(product.signature.decode("ascii")),
        milliampere=f"{product.current_unit * 1000:.0f}",
        ampere=f"{product.current_unit:g}",
        power_cycle=_hexadecimal(
            min(spec.number for spec in settings.specs if spec.needs_power_cycle)
        ),
        parameters=_aligned(language, [_row(language, *pair) for pair in tables.parameters]),
        calibrations=_aligned(
            language, [_calibration_row(language, *pair) for pair in tables.calibrations]
        ),
        left_out="\n".join(map(plain, tables.left_out)),
    )


def _render(name: str, **values: object) -> str:
    from jinja2 import Environment, StrictUndefined  # noqa: PLC0415 - only exporting needs it

    environment = Environment(
        trim_blocks=True,
        keep_trailing_newline=True,
        undefined=StrictUndefined,
        autoescape=False,  # noqa: S701 - source code, not HTML; `plain` makes text safe
    )
    template = environment.from_string(resource(name).read_text(encoding="utf-8"))
    return template.render(values)


def plain(text: str) -> str:
    """Return one line of printable ASCII for a comment or a string in C, C++ and Python.

    It contains no `/*`, `*/`, quote, backslash or trigraph (`??/`). Other characters become the
    nearest letter or `?`.
    """
    letters = unicodedata.normalize("NFKD", text.translate(_ASCII))
    kept = (c for c in letters if not unicodedata.combining(c))
    safe = "".join(c if c.isascii() and c.isprintable() else "?" for c in kept)
    safe = safe.replace("\\", "/").replace('"', "'")
    for pair in ("*/", "/*", "??"):
        while pair in safe:
            safe = safe.replace(pair, f"{pair[0]} {pair[1]}")
    return safe.strip()


_ASCII = str.maketrans({"µ": "u", "μ": "u", "−": "-", "–": "-", "—": "-", "×": "x", "…": "..."})


@dataclass(frozen=True, slots=True)
class _Tables:
    """The settings that can be stored, in the order in which the program stores them.

    Attributes:
        parameters: with wire values; those that change the communication come last, so that the
            board stays reachable after an interruption.
        left_out: a sentence for each value that the board would reject.
    """

    parameters: tuple[tuple[ParameterSpec, int], ...]
    calibrations: tuple[tuple[CalibrationKey, Calibration], ...]
    left_out: tuple[str, ...]

    @classmethod
    def of(cls, settings: Settings) -> "_Tables":
        check_keys(settings)
        given = [
            (spec, settings.parameters[spec.key])
            for spec in settings.specs.readable
            if spec.key in settings.parameters
        ]
        found = [
            (key, settings.calibrations[key])
            for key in CalibrationKey
            if key in settings.calibrations
        ]
        left_out = [problem for spec, wire in given if (problem := spec.problem(wire))]
        left_out += [
            f"{key}: {problem}" for key, calibration in found if (problem := calibration.problem())
        ]
        valid = [(spec, wire) for spec, wire in given if not spec.problem(wire)]
        valid.sort(key=lambda p: (p[0].needs_power_cycle, p[0].group == "serial", p[0].number))
        return cls(tuple(valid), tuple(c for c in found if not c[1].problem()), tuple(left_out))

    def wire(self, key: str) -> int | None:
        """Return the new wire value of a parameter; `None` if it is not stored."""
        return next((wire for spec, wire in self.parameters if spec.key == key), None)


def _row(language: Language, spec: ParameterSpec, wire: int) -> tuple[str, str]:
    """Return code and comment for a parameter."""
    number, name = _hexadecimal(spec.number), plain(spec.name)
    comment = plain(parameter_text(spec, wire))
    match language:
        case Language.PYTHON:
            return f'({number}, {wire}, "{name}"),', comment
        case Language.C:
            return f'{{{number}, {wire}, "{name}"}},', comment
        case Language.ARDUINO:  # names would take a quarter of an Uno's memory
            return f"{{{number}, {wire}}},", f"{name}: {plain(spec.text(wire))}"


def _calibration_row(
    language: Language, key: CalibrationKey, calibration: Calibration
) -> tuple[str, str]:
    """Return code and comment for a calibration."""
    letter = _SOURCE_LETTERS[key.source]
    values = ", ".join(str(getattr(calibration, name)) for name in CALIBRATION_FIELDS)
    comment = plain(calibration_text(key.source, calibration))
    if language is Language.PYTHON:
        return f'("{letter}", {key.channel}, ({values})),', comment
    return f"{{'{letter}', {key.channel}, {{{values}}}}},", comment


def _aligned(language: Language, rows: Sequence[tuple[str, str]]) -> str:
    """Return the rows of a table with aligned comments."""
    # The style of ruff and black has two spaces before a comment and none to align it.
    is_aligned = language is not Language.PYTHON
    width = max((len(code) for code, _ in rows), default=0) if is_aligned else 0
    width = min(width, _COMMENT_COLUMN)
    return "\n".join(
        f"{code:{width}}{language.comment} {comment}" if comment else code for code, comment in rows
    )


def _stem(settings: Settings) -> str:
    return f"{settings.product.key}_board"


def _hexadecimal(byte: int) -> str:
    return f"0x{byte:02X}"


def _serial_config(line: LineSettings) -> str:
    """Return the second argument of Arduino's `begin`; empty for the default."""
    letter = _PARITIES.get(line.detection, "NONE")[0]
    name = f"SERIAL_8{letter}{line.stop_bits}"
    return "" if name == "SERIAL_8N1" else f", {name}"


def _device_name(language: Language, *, renumbers: bool) -> str:
    """Return the name of the device number: a constant, or a variable if it changes."""
    if language is Language.PYTHON:
        return "self.device" if renumbers else "DEVICE"
    return "trex_device" if renumbers else "TREX_DEVICE"


def _new_line(link: ConnectionSettings, tables: _Tables) -> str:
    """Return the line settings after the next power cycle; empty if they do not change."""
    wire, bits = tables.wire(ParameterKey.UART_SETTINGS), tables.wire(ParameterKey.CRC7_POLYNOMIAL)
    line = link.line if wire is None else LineSettings.from_wire(wire)
    if line.detection is not Detection.CRC7:
        return "" if line == link.line else line.text()
    # A line without CRC does not say which polynomial the board stores.
    known = link.polynomial if link.framing.polynomial is not None else DEFAULT_POLYNOMIAL
    polynomial = known if bits is None else 0x80 | bits
    if line == link.line and polynomial == link.polynomial:
        return ""
    return f"{line.text()}, polynomial {_hexadecimal(polynomial)}"


def _warning(tables: _Tables) -> str:
    """Return what the motors do when the program ends."""
    timeout = next(
        (pair for pair in tables.parameters if pair[0].key == ParameterKey.SERIAL_TIMEOUT), None
    )
    goes_on = "Motors keep running when the program that started them ends or crashes"
    if timeout is None:
        return f"{goes_on}, unless Serial Timeout is set on the board."
    spec, wire = timeout
    where = f"{spec.name} (parameter {_hexadecimal(spec.number)})"
    if wire == 0:
        return f"{goes_on}: these settings switch {where} off. Set it to have them stopped."
    return (
        f"With these settings motors stop when the board has heard nothing for {spec.text(wire)}: "
        f"{where}. Without it they would keep running when a program ends or crashes."
    )
