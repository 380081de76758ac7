r"""A recording as CSV: a row for each sample, for spreadsheets and for reading it back.

The first line names the columns, with units. The second has `header` in its column `sample`
and says in `text`, as JSON, of which board the recording is. After that each line is one
sample: `time_s` counts from the start (to 1 µs), `sample` says which kind it is, and its
columns hold it:

| sample | columns |
|---|---|
| currents | `motor_1_current_A`, `motor_2_current_A` |
| raw | `channel_1_raw` … and the same in µs or V; an empty one has no signal |
| remapped | `channel_1_remapped` …, -127 to 127 |
| control | `serial_controls`: 1 when serial commands reach the motors |
| mode | `mode`: the letter that the board answers |
| status | `status_…`, `uart_…`: 1 for each bit that was latched |
| wish | `wished_motor` (1 or 2), its direction, signed speed or braking duty, `accelerate` |
| auxiliary | `auxiliary_speed`, `accelerate` |
| event | `event` is its kind, `text` is what happened |
| settings | `text` is a settings file: what the board stores from now on |

What is measured stands in every row, as it was last known, so that a spreadsheet can draw one
column against another. Line ends within a text are written `\n`.
"""

from typing import BinaryIO

from trex_gui.core.recording.csv_lines import CsvLines
from trex_gui.devices.trex.client.telemetry import (
    Control,
    Currents,
    LatchedStatus,
    ModeSample,
    Raw,
    Remapped,
)
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, Status, UartError
from trex_gui.devices.trex.recording.columns import (
    ampere,
    joined,
    measured_columns,
    news_columns,
    physical,
    plain_line,
)
from trex_gui.devices.trex.recording.recording import (
    AuxiliarySetpointRecord,
    Header,
    Marker,
    Record,
    SetpointRecord,
    SettingsSeen,
)

SUFFIX = ".csv"
WISH_COLUMNS = ("wished_motor", "direction", "speed", "brake", "auxiliary_speed", "accelerate")
_CURRENTS = 3 * len(CHANNELS)


def columns(source: InputSource) -> list[str]:
    """Return the names of all columns of a recording whose channels are measured so."""
    return [
        *("time_s", "sample"),
        *measured_columns(source),
        *("mode", *WISH_COLUMNS, *news_columns(), "event", "text"),
    ]


class CsvWriter(CsvLines[Record]):
    """Writes a recording of a board as CSV."""

    def __init__(self, file: BinaryIO, header: Header) -> None:
        super().__init__(file)
        self._clock = header.clock
        self._source = header.mode.source
        self._unit = header.model.current_unit
        # What was last known stands in every row: channels, currents, control, mode.
        self._known = [""] * (len(measured_columns(self._source)) + 1)
        self._known[-1] = header.mode.value
        self._bits: list[Status | UartError] = [*Status, *UartError]
        names = columns(self._source)
        self.put(joined(names))
        cells = ["0.000000", "header", *[""] * (len(names) - 3), plain_line(header.to_json())]
        self.put(joined(cells))

    def line_of(self, record: Record) -> str:
        known = self._known
        wish = news = ""
        event = text = ""
        match record:
            case Currents(counts=counts):
                name = "currents"
                for motor, count in enumerate(counts):
                    known[_CURRENTS + motor] = str(ampere(count, self._unit))
            case Raw(counts=raw):
                name = "raw"
                for place, count_or_none in enumerate(raw):
                    known[3 * place] = "" if count_or_none is None else str(count_or_none)
                    value = physical(self._source, count_or_none)
                    known[3 * place + 1] = "" if value is None else str(value)
            case Remapped(values=values):
                name = "remapped"
                known[2:_CURRENTS:3] = map(str, values)
            case Control(by_serial=by_serial):
                name = "control"
                known[-2] = str(int(by_serial))
            case ModeSample(mode=mode):
                name = "mode"
                known[-1] = mode.value
            case LatchedStatus(status=status, uart=uart):
                name = "status"
                news = ",".join(
                    str(int(bool(bit & (status if isinstance(bit, Status) else uart))))
                    for bit in self._bits
                )
            case SetpointRecord(motor=motor, drive=drive, accelerate=accelerate):
                name = "wish"
                brake = str(drive.speed) if drive.is_brake else ""
                direction = drive.direction.name.lower()
                wish = f"{motor},{direction},{drive.signed},{brake},,{int(accelerate)}"
            case AuxiliarySetpointRecord(speed=speed, accelerate=accelerate):
                name = "auxiliary"
                wish = f",,,,{speed},{int(accelerate)}"
            case Marker():
                name = "event"
                event, text = plain_line(record.kind), plain_line(record.text)
            case SettingsSeen():
                name = "settings"
                text = plain_line(record.text)
        return (
            f"{record.time - self._clock:.6f},{name},{','.join(known)},{wish or ',,,,,'},"
            f"{news or ',' * (len(self._bits) - 1)},{joined((event, text))}"
        )
