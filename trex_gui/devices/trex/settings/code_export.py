"""Export of settings as a Python or Arduino program."""

import textwrap
from collections.abc import Iterator

from trex_gui.core.code import Language, hexadecimal, plain, render
from trex_gui.core.translation import in_english
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
from trex_gui.version import __version__

_COMMENT_WIDTH = 86

_MODE_LETTERS = {mode.source: mode.value for mode in Mode if mode.is_serial}


def file_name(settings: Settings, language: Language) -> str:
    """Return a name for the exported file, such as `trex_board.py`.

    The Arduino IDE requires that `trex_board.ino` is in a folder named `trex_board`.
    """
    return f"{settings.product.key}_board{language.suffix}"


def export_code(settings: Settings, link: ConnectionSettings, language: Language) -> str:
    """Return a program that stores settings and drives motors.

    The text is in English and ASCII. It is identical for equal settings and line settings. Values
    that the board would reject are left out and listed in a comment. The program does not contain
    the port of `link`.

    Raises:
        BadRequest: the settings contain a key that their model and firmware do not have, or the
            connection has a baud rate that no board supports.
    """
    link.line.to_wire()  # raises for an unknown baud rate
    check_keys(settings)
    with in_english():
        return _program(settings, link, language)


def _program(settings: Settings, link: ConnectionSettings, language: Language) -> str:
    valid = settings.without_invalid()
    left_out = [
        p for spec, wire in settings.parameter_items() if (p := spec.problem(wire, forced=True))
    ]
    left_out += [f"{key}: {p}" for key, c in settings.calibration_items() if (p := c.problem())]
    # Serial settings are written last, so an interrupted program leaves the board reachable.
    parameters = valid.parameter_items()
    parameters.sort(key=lambda p: (p[0].needs_power_cycle, p[0].group == "serial", p[0].number))
    product, device, line = settings.product, link.framing.device_number, link.line
    new_device = valid.parameters.get(ParameterKey.DEVICE_NUMBER)
    firmware = "" if settings.firmware is None else f" with firmware {settings.firmware}"
    return render(
        f"code/trex_board{language.suffix}.jinja",
        # Header
        version=__version__,
        product=plain(product.name),
        board=plain(product.name + firmware),
        stem=f"{product.key}_board",
        warning=textwrap.fill(plain(_warning(valid)), _COMMENT_WIDTH),
        # Line
        line=line.text(),
        new_line=_new_line(link, valid),
        baud=line.baud,
        parity=line.parity.name,
        stop_bits=line.stop_bits,
        # Packets
        device=device,
        new_device=new_device,
        renumbers=None not in {new_device, device} and new_device != device,
        device_parameter=parameter_number(ParameterKey.DEVICE_NUMBER),
        crc=link.framing.polynomial is not None,
        polynomial=link.polynomial,
        # Board and settings
        signature=plain(product.signature.decode("ascii")),
        ampere=product.current_unit,
        power_cycle=min(spec.number for spec in settings.specs if spec.needs_power_cycle),
        parameters=[_parameter_row(*item, settings) for item in parameters],
        calibrations=[_calibration_row(*item) for item in valid.calibration_items()],
        left_out="\n".join(map(plain, left_out)),
        notes="\n".join(_notes(settings)),
    )


def _notes(settings: Settings) -> Iterator[str]:
    for key in sorted(settings.notes):
        text = plain(f"{key}: {settings.notes[key]}".replace("\n", " / "))
        yield textwrap.fill(text, _COMMENT_WIDTH, subsequent_indent="    ")


def _parameter_row(spec: ParameterSpec, wire: int, settings: Settings) -> dict[str, object]:
    return {
        "number": spec.number,
        "wire": wire,
        "name": plain(spec.name),
        "text": plain(spec.text(wire)),
        "comment": plain(parameter_text(spec, wire, settings)),
    }


def _calibration_row(key: CalibrationKey, calibration: Calibration) -> dict[str, object]:
    return {
        "source": _MODE_LETTERS[key.source],
        "channel": key.channel,
        "counts": ", ".join(str(getattr(calibration, name)) for name in CALIBRATION_FIELDS),
        "comment": plain(calibration_text(key.source, calibration)),
    }


def _new_line(link: ConnectionSettings, settings: Settings) -> str:
    """Return the line settings after the next power cycle. Empty if they do not change."""
    wire = settings.parameters.get(ParameterKey.UART_SETTINGS)
    bits = settings.parameters.get(ParameterKey.CRC7_POLYNOMIAL)
    line = link.line if wire is None else LineSettings.from_wire(wire)
    if line.detection is not Detection.CRC7:
        return "" if line == link.line else line.text()
    # Without CRC, the connection does not reveal the stored polynomial.
    known = link.polynomial if link.framing.polynomial is not None else DEFAULT_POLYNOMIAL
    polynomial = known if bits is None else 0x80 | bits
    if line == link.line and polynomial == link.polynomial:
        return ""
    return f"{line.text()}, polynomial {hexadecimal(polynomial)}"


def _warning(settings: Settings) -> str:
    spec = settings.specs[ParameterKey.SERIAL_TIMEOUT]
    shutdown_spec = settings.specs[ParameterKey.UART_ERROR_SHUTDOWN]
    wire = settings.parameters.get(spec.key)
    risk = "Motors keep running when the program that started them ends or crashes"
    if wire is None:
        return f"{risk}, unless {spec.name} and {shutdown_spec.name} (twin) are set on the board."
    timeout = f"{spec.name} (parameter {hexadecimal(spec.number)})"
    shutdown = f"{shutdown_spec.name} (parameter {hexadecimal(shutdown_spec.number)}; twin)"
    if wire == 0:
        return f"{risk}, because {timeout} is off. With {shutdown}, it should stop the motors."
    if not settings.parameters.get(shutdown_spec.key):
        return f"{risk}, perhaps even with {timeout} at {spec.text(wire)}. It may need {shutdown}."
    return (
        f"With these settings, {timeout} should stop the motors when the board has received "
        f"nothing for {spec.text(wire)}. Without this timeout, motors would keep running when a "
        f"program ends or crashes."
    )
