"""The settings of a board as a program: it stores and checks them, and drives the motors.

What a program does is written in `resources/code/`, a template a language. Here are the facts
that fill it: the line in force, the tables of settings, and what a person has to know of both.
"""

import textwrap
from collections.abc import Mapping

from trex_gui import __version__
from trex_gui.core.resource_files import resource
from trex_gui.devices.trex.code_export.language import Language
from trex_gui.devices.trex.code_export.tables import Tables
from trex_gui.devices.trex.code_export.template import fill
from trex_gui.devices.trex.code_export.text import plain
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.crc7 import DEFAULT_POLYNOMIAL
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import parameter_number
from trex_gui.devices.trex.settings.document import Settings

_COMMENT_WIDTH = 86


def file_name(settings: Settings, language: Language) -> str:
    """Return a name for the exported file, such as `trex_board.c`.

    The Arduino environment wants `trex_board.ino` in a folder `trex_board`.
    """
    return _stem(settings) + language.suffix


def export_code(settings: Settings, link: ConnectionSettings, language: Language) -> str:
    """Return a program that stands alone: it stores and checks settings and drives motors.

    The same settings and line give the same text, plain ASCII. A value that
    the board would refuse is named in a comment and left out.

    Args:
        settings: what the program stores; nothing but what they hold.
        link: how bytes travel and packets are wrapped; which port is the program's business.
        language: what the program is written in.

    Raises:
        BadRequest: the settings hold a key that their model and firmware do not have, or the
            line has a rate that no board has.
    """
    link.line.to_wire()  # only to refuse
    tables = Tables.of(settings)
    template = resource(f"code/trex_board{language.suffix}.in").read_text(encoding="utf-8")
    values = _values(settings, link, tables, language)
    return fill(template, values, _flags(link, tables))


def _stem(settings: Settings) -> str:
    return f"{settings.product.key}_board"


def _flags(link: ConnectionSettings, tables: Tables) -> Mapping[str, bool]:
    """Return which parts of a template are needed."""
    return {
        "expanded": link.framing.device_number is not None,
        "crc": link.framing.polynomial is not None,
        "even": link.line.detection is Detection.EVEN,
        "odd": link.line.detection is Detection.ODD,
        "two_stop_bits": link.line.stop_bits == 2,
        "parameters": bool(tables.parameters),
        "calibrations": bool(tables.calibrations),
        "stores": bool(tables.parameters or tables.calibrations),
        "left_out": bool(tables.left_out),
        "renumbers": _renumbers(link, tables),
        "line_changes": _new_line(link, tables) is not None,
    }


def _values(
    settings: Settings, link: ConnectionSettings, tables: Tables, language: Language
) -> Mapping[str, str]:
    """Return what stands in the places of a template."""
    product, device = settings.product, link.framing.device_number
    return {
        # What it is for
        "version": __version__,
        "product": plain(product.name),
        "board": plain(product.name + _with_firmware(settings)),
        "stem": _stem(settings),
        "warning": textwrap.fill(plain(_warning(tables)), _COMMENT_WIDTH),
        # The line
        "line": link.line.text(),
        "new_line": _new_line(link, tables) or "",
        "baud": str(link.line.baud),
        "parity": _PARITIES.get(link.line.detection, "NONE"),
        "stop_bits": str(link.line.stop_bits),
        "serial_config": _serial_config(link.line),
        # Packets
        "device": str(device),
        "with_device": "" if device is None else f", device number {device}",
        "new_device": str(tables.wire("device_number")),
        "device_name": _device_name(language, renumbers=_renumbers(link, tables)),
        "device_parameter": _hexadecimal(parameter_number("device_number")),
        "polynomial": _hexadecimal(link.polynomial),
        # The board and its settings
        "signature": plain(product.signature.decode("ascii")),
        "milliampere": f"{product.current_unit * 1000:.0f}",
        "ampere": f"{product.current_unit:g}",
        "power_cycle": _hexadecimal(
            min(spec.number for spec in settings.specs if spec.needs_power_cycle)
        ),
        "parameters": tables.parameter_rows(language),
        "calibrations": tables.calibration_rows(language),
        "left_out": "\n".join(map(plain, tables.left_out)),
    }


_PARITIES = {Detection.EVEN: "EVEN", Detection.ODD: "ODD"}


def _hexadecimal(byte: int) -> str:
    return f"0x{byte:02X}"


def _with_firmware(settings: Settings) -> str:
    return "" if settings.firmware is None else f" with firmware {settings.firmware}"


def _serial_config(line: LineSettings) -> str:
    """Return the second argument of Arduino's `begin`; nothing where the usual is wanted."""
    letter = _PARITIES.get(line.detection, "NONE")[0]
    name = f"SERIAL_8{letter}{line.stop_bits}"
    return "" if name == "SERIAL_8N1" else f", {name}"


def _renumbers(link: ConnectionSettings, tables: Tables) -> bool:
    """Whether the board gets another device number than that in the packets."""
    number, device = tables.wire("device_number"), link.framing.device_number
    return None not in {number, device} and number != device


def _device_name(language: Language, *, renumbers: bool) -> str:
    """Return what holds the device number: a constant, or a variable where it changes."""
    if language is Language.PYTHON:
        return "self.device" if renumbers else "DEVICE"
    return "trex_device" if renumbers else "TREX_DEVICE"


def _new_line(link: ConnectionSettings, tables: Tables) -> str | None:
    """Return how the line will be once the settings act; `None` when it stays as it is."""
    wire, bits = tables.wire("uart_settings"), tables.wire("crc7_polynomial")
    line = link.line if wire is None else LineSettings.from_wire(wire)
    if line.detection is not Detection.CRC7:
        return None if line == link.line else line.text()
    # Whoever talks without CRC now does not say which polynomial the board keeps.
    known = link.polynomial if link.framing.polynomial is not None else DEFAULT_POLYNOMIAL
    polynomial = known if bits is None else 0x80 | bits
    if line == link.line and polynomial == link.polynomial:
        return None
    return f"{line.text()}, polynomial {_hexadecimal(polynomial)}"


def _warning(tables: Tables) -> str:
    """Return what becomes of the motors when the program ends."""
    timeout = next((pair for pair in tables.parameters if pair[0].key == "serial_timeout"), None)
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
