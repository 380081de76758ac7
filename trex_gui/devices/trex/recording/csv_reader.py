"""Reading a recording of a board that was written as CSV."""

from collections.abc import Callable, Sequence

from trex_gui.core.recording.csv_blocks import CsvBlocks, Row
from trex_gui.devices.trex.client.telemetry import (
    Control,
    Currents,
    LatchedStatus,
    ModeSample,
    Raw,
    Remapped,
)
from trex_gui.devices.trex.protocol.commands import Drive
from trex_gui.devices.trex.protocol.driving import Direction
from trex_gui.devices.trex.protocol.flags import CHANNELS, Mode, Status, UartError
from trex_gui.devices.trex.recording.columns import (
    current_column,
    several_lines,
    status_column,
    uart_column,
)
from trex_gui.devices.trex.recording.csv_format import columns
from trex_gui.devices.trex.recording.recording import (
    AuxiliarySetpointRecord,
    Header,
    Marker,
    Record,
    SetpointRecord,
    SettingsSeen,
)


class CsvFile(CsvBlocks[Header, Record]):
    """A recording of a board in a CSV file."""

    kind_column = "sample"

    def header_of(self, text: str) -> Header:
        return Header.from_json(text)

    def columns(self) -> Sequence[str]:
        return columns(self.header.mode.source)

    def record_of(self, kind: str, time: float, row: Row) -> Record:
        make = _MAKERS.get(kind)
        if make is None:
            raise ValueError(f"there is no sample {kind!r}")
        return make(time, row, self.header.model.current_unit)


def _currents(time: float, row: Row, unit: float) -> Currents:
    first, second = (round(float(row[current_column(motor)]) / unit) for motor in (1, 2))
    return Currents(time, (first, second))


def _raw(time: float, row: Row, _unit: float) -> Raw:
    cells = [row[f"channel_{channel}_raw"] for channel in CHANNELS]
    return Raw(time, tuple(int(cell) if cell else None for cell in cells))


def _remapped(time: float, row: Row, _unit: float) -> Remapped:
    return Remapped(time, tuple(int(row[f"channel_{channel}_remapped"]) for channel in CHANNELS))


def _status(time: float, row: Row, _unit: float) -> LatchedStatus:
    status, uart = Status(0), UartError(0)
    for bit in Status:
        status |= bit if row[status_column(bit)] == "1" else Status(0)
    for error in UartError:
        uart |= error if row[uart_column(error)] == "1" else UartError(0)
    return LatchedStatus(time, status, uart)


def _wish(time: float, row: Row, _unit: float) -> SetpointRecord:
    direction = Direction[row["direction"].upper()]
    speed = int(row["brake"]) if row["brake"] else abs(int(row["speed"]))
    return SetpointRecord(
        time, int(row["wished_motor"]), Drive(direction, speed), row["accelerate"] == "1"
    )


_MAKERS: dict[str, Callable[[float, Row, float], Record]] = {
    "currents": _currents,
    "raw": _raw,
    "remapped": _remapped,
    "status": _status,
    "wish": _wish,
    "control": lambda time, row, _: Control(time, bool(int(row["serial_controls"]))),
    "mode": lambda time, row, _: ModeSample(time, Mode(row["mode"])),
    "auxiliary": lambda time, row, _: AuxiliarySetpointRecord(
        time, int(row["auxiliary_speed"]), row["accelerate"] == "1"
    ),
    "event": lambda time, row, _: Marker(
        time, several_lines(row["event"]), several_lines(row["text"])
    ),
    "settings": lambda time, row, _: SettingsSeen(time, several_lines(row["text"])),
}
