"""Columns of CSV files with what a board measures: names with units, and what stands in them.

`trexcmd stream` and recordings name the same things the same way.
"""

import csv
from collections.abc import Sequence

from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, Status, UartError


def physical_name(source: InputSource) -> str:
    """Return the unit of the channels as a column's name has it: `us` or `V`."""
    return "us" if source is InputSource.RC else "V"


def channel_columns(source: InputSource, channel: int) -> tuple[str, str, str]:
    """Return the columns of a channel: counts, µs or V, remapped."""
    name = f"channel_{channel}"
    return f"{name}_raw", f"{name}_{physical_name(source)}", f"{name}_remapped"


def current_column(motor: int) -> str:
    """Return the column of the current of motor 1 or 2."""
    return f"motor_{motor}_current_A"


def measured_columns(source: InputSource) -> list[str]:
    """Return the columns of everything that is measured, behind the time."""
    channels = [name for channel in CHANNELS for name in channel_columns(source, channel)]
    return [*channels, *(current_column(motor) for motor in (1, 2)), "serial_controls"]


def status_column(bit: Status) -> str:
    """Return the column of a status bit."""
    return f"status_{str(bit.name).lower()}"


def uart_column(bit: UartError) -> str:
    """Return the column of a UART error bit."""
    return f"uart_{str(bit.name).lower()}"


def news_columns() -> list[str]:
    """Return the columns of all latched bits."""
    return [*map(status_column, Status), *map(uart_column, UartError)]


def physical(source: InputSource, count: int | None) -> float | None:
    """Return a raw count in µs (to 0.1) or V (to 0.1 mV)."""
    if count is None:
        return None
    return round(source.physical(count), 1 if source is InputSource.RC else 4)


def ampere(count: int, unit: float) -> float:
    """Return a current in A, to 0.1 mA, which is a small part of a count (`unit`, in A)."""
    return round(count * unit, 4)


def joined(cells: Sequence[str]) -> str:
    """Return a row as a line of CSV; texts are on one line, as `plain_line` makes them."""
    return ",".join(map(_quoted, cells))


def _quoted(cell: str) -> str:
    if "," in cell or '"' in cell:
        return '"' + cell.replace('"', '""') + '"'
    return cell


def cells_of(line: bytes) -> list[str]:
    """Return the cells of a line of CSV, with its end or without.

    Raises:
        ValueError: it is none.
    """
    text = line.decode("utf-8", "surrogatepass").removesuffix("\n").removesuffix("\r")
    if '"' not in text and "\r" not in text and "\n" not in text:
        return text.split(",")  # several times as fast, and nearly every row is one of these
    try:
        return next(csv.reader([text], strict=True), [])
    except csv.Error as error:
        raise ValueError(str(error)) from error


def plain_line(text: str) -> str:
    r"""Return a text without line ends: they become `\n` and `\r`, a backslash `\\`."""
    return text.replace("\\", "\\\\").replace("\n", "\\n").replace("\r", "\\r")


def several_lines(text: str) -> str:
    """Undo `plain_line`."""
    if "\\" not in text:
        return text
    parts = []
    letters = iter(text)
    for letter in letters:
        if letter == "\\":
            escaped = next(letters, "")
            parts.append({"n": "\n", "r": "\r"}.get(escaped, escaped))
        else:
            parts.append(letter)
    return "".join(parts)
