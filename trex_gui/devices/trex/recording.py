"""Recordings of a board: header, sample kinds, and rows of measurements."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from typing import Any, Self

from trex_gui.core.errors import BadRequest
from trex_gui.core.recording.kinds import (
    LONGEST_TEXT,
    MARKERS,
    SOURCE,
    Column,
    Marker,
    RecordingFormat,
    SampleKind,
    Value,
)
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.telemetry import (
    POLLED,
    Currents,
    LatchedStatus,
    ModeSample,
    Newest,
    Sample,
)
from trex_gui.devices.trex.driving.requests import SetAuxiliary, SetMotor
from trex_gui.devices.trex.protocol.device_table import Model, device_table
from trex_gui.devices.trex.protocol.driving import Direction, Drive
from trex_gui.devices.trex.protocol.flags import InputSource, Mode
from trex_gui.devices.trex.settings.document import settings_of
from trex_gui.devices.trex.settings.writer import write_settings
from trex_gui.version import __version__

STOP = "stop"  # kind of the marker after which the motors have no setpoint


@dataclass(frozen=True, slots=True)
class SetpointRecord:
    """Setpoint sent to motor 1 or 2."""

    time: float
    motor: int
    drive: Drive
    accelerate: bool = False


@dataclass(frozen=True, slots=True)
class AuxiliarySetpointRecord:
    time: float
    speed: int  # 0-127
    accelerate: bool = False


@dataclass(frozen=True, slots=True)
class SettingsSnapshot:
    """Settings stored from this time on, as a settings file."""

    time: float
    text: str


OwnRecord = Sample | SetpointRecord | AuxiliarySetpointRecord | Marker | SettingsSnapshot


@dataclass(frozen=True, slots=True)
class OtherBoardRecord:
    """Record of a board other than the board in the header."""

    board: int  # device number
    record: OwnRecord

    @property
    def time(self) -> float:
        return self.record.time


Record = OwnRecord | OtherBoardRecord  # times are seconds on the session's clock


def setpoint_record(
    request: SetMotor | SetAuxiliary, time: float
) -> SetpointRecord | AuxiliarySetpointRecord:
    if isinstance(request, SetMotor):
        return SetpointRecord(time, request.motor, request.drive, request.accelerate)
    return AuxiliarySetpointRecord(time, request.speed, request.accelerate)


def settings_text(state: DeviceState) -> str:
    return write_settings(settings_of(state))[:LONGEST_TEXT]


@dataclass(frozen=True, slots=True)
class Header:
    started: datetime
    clock: float  # the session's clock (s) at the start
    model: Model
    firmware: str
    mode: Mode  # at the start; determines the unit of the channels
    settings: str = ""  # stored settings at the start, as the text of a settings file
    device_number: int | None = None  # `None` if the board was addressed without a number
    program: str = f"TReX Studio {__version__}"
    # Device numbers of other boards → amperes per count
    others: Mapping[int, float] = field(default_factory=dict)

    @classmethod
    def of(
        cls,
        state: DeviceState,
        clock: float,
        device_number: int | None,
        others: Mapping[int, float] | None = None,
    ) -> "Header":
        signature, settings = state.signature, settings_text(state)
        return cls(
            datetime.now(UTC),
            clock,
            signature.model,
            signature.firmware,
            state.mode,
            settings,
            device_number,
            others=others or {},
        )

    @property
    def board(self) -> str:
        """Model and firmware, such as `TReX 1.2`."""
        return f"{self.model.name} {self.firmware}"

    def values(self) -> dict[str, Value]:
        return {
            "device_name": self.board,
            "started_utc": self.started.astimezone(UTC).isoformat(),
            "clock_s": self.clock,
            "model": self.model.key,
            "firmware": self.firmware,
            "mode": self.mode.value,
            "ampere_per_count": self.model.current_unit,
            "channel_unit": self.mode.source.unit,
            "channel_counts_per_unit": self.mode.source.counts_per_unit,
            "device_number": self.device_number,
            "settings": self.settings,
            "program": self.program,
            **({"other_boards": json.dumps(self.others)} if self.others else {}),
        }

    @classmethod
    def from_values(cls, values: Mapping[str, Any]) -> "Header":
        try:
            number = values["device_number"]
            return cls(
                started=datetime.fromisoformat(values["started_utc"]).astimezone(UTC),
                clock=float(values["clock_s"]),
                model=device_table().model(values["model"]),
                firmware=str(values["firmware"]),
                mode=Mode(values["mode"]),
                settings=str(values["settings"]),
                device_number=None if number is None else int(number),
                program=str(values["program"]),
                others={
                    int(board): float(unit)
                    for board, unit in json.loads(values.get("other_boards", "{}")).items()
                },
            )
        except (KeyError, TypeError, AttributeError, OverflowError, BadRequest) as error:
            raise ValueError(f"the header is incomplete ({error})") from error


def sample_kinds(source: InputSource, current_unit: float) -> tuple[SampleKind, ...]:
    """Return the kinds of samples. `current_unit` is in A per count."""
    polled = [value.kind(source, current_unit) for value in POLLED.values()]
    return (
        *(kind for kind in polled if kind.held),
        *(kind for kind in polled if not kind.held),
        SampleKind(
            "setpoint",
            SetpointRecord,
            (
                Column("setpoint_motor", "INTEGER", "1 or 2"),
                Column("direction", "TEXT", "forward, reverse, brake or brake_too"),
                Column("speed", "INTEGER", "-127 to 127; 0 while braking"),
                Column("brake", "INTEGER", "braking duty, 0 (coast) to 127", optional=True),
                Column("accelerate", "INTEGER", "1: with the board's acceleration"),
            ),
            lambda r: (
                r.motor,
                r.drive.direction.name.lower(),
                r.drive.signed,
                r.drive.speed if r.drive.is_brake else None,
                int(r.accelerate),
            ),
            _setpoint,
        ),
        SampleKind(
            "aux_setpoint",
            AuxiliarySetpointRecord,
            (
                Column("aux_speed", "INTEGER", "0 to 127"),
                Column("accelerate", "INTEGER", "1: with the board's acceleration"),
            ),
            lambda r: (r.speed, int(r.accelerate)),
            lambda time, speed, value: AuxiliarySetpointRecord(time, speed, bool(value)),
        ),
        MARKERS,
        SampleKind(
            "settings",
            SettingsSnapshot,
            (Column("text", "TEXT", "settings file with the values stored from this time on"),),
            lambda r: (r.text,),
            SettingsSnapshot,
        ),
    )


def _with_board(kind: SampleKind, own: int | None, others: Mapping[int, float]) -> SampleKind:
    """Add a column for the board. `own` is the device number in the header."""

    def pack(record: OwnRecord | OtherBoardRecord) -> Sequence[Value]:
        if isinstance(record, OtherBoardRecord):
            return (*kind.pack(record.record), record.board)
        return (*kind.pack(record), own)

    def unpack(time: float, *values: Any) -> Record:
        *inner, board = values
        record: OwnRecord = kind.unpack(time, *inner)
        return record if board == own else OtherBoardRecord(board, record)

    columns = kind.columns
    if kind.type is Currents:
        columns = tuple(
            replace(column, physical=column.physical and replace(column.physical, scales=others))
            for column in columns
        )
    board = Column(SOURCE, "INTEGER", "device number", optional=own is None)
    return replace(kind, columns=(*columns, board), pack=pack, unpack=unpack)


def _kinds(header: Header) -> tuple[SampleKind, ...]:
    kinds = sample_kinds(header.mode.source, header.model.current_unit)
    if not header.others:
        return kinds
    number, others = header.device_number, header.others
    return tuple(kind if kind is MARKERS else _with_board(kind, number, others) for kind in kinds)


def _type_of(record: Record) -> type[object]:
    return type(record.record if isinstance(record, OtherBoardRecord) else record)


def _setpoint(  # noqa: PLR0917 - a value for each column
    time: float, motor: int, direction: str, speed: int, brake: int | None, accelerate: int
) -> SetpointRecord:
    drive = Drive(Direction[direction.upper()], abs(speed) if brake is None else brake)
    return SetpointRecord(time, motor, drive, bool(accelerate))


FORMAT = RecordingFormat("trex", Header.from_values, _kinds, _type_of)


Row = dict[str, float | int | str | None]  # column name with unit → newest measurement


class MeasurementTable:
    """Rows of measurements, one per new pair of motor currents."""

    def __init__(self, mode: Mode, unit: float) -> None:
        self.mode = mode
        kinds = sample_kinds(mode.source, unit)
        self._kinds: dict[type[Any], SampleKind] = {kind.type: kind for kind in kinds}
        # All polled values except the mode, which changes only at a power cycle.
        measured = [kind for kind in kinds if kind.held and kind.type is not ModeSample]
        self._missing = {kind.type for kind in measured} - {Currents}
        columns = [name for kind in measured for name in kind.exported]
        self.row: Row = dict.fromkeys(["time_s", *columns])
        self._clear_status()

    def _clear_status(self) -> None:
        self.row |= dict.fromkeys(self._kinds[LatchedStatus].exported, 0)

    def add(self, sample: Sample) -> bool:
        """Add a sample. Return True if it completes a row."""
        self._missing.discard(type(sample))
        cells = self._kinds[type(sample)].cells(sample)
        if isinstance(sample, LatchedStatus):
            self.row |= {name: 1 for name, value in cells.items() if value}
        elif not isinstance(sample, ModeSample):
            self.row |= cells
        return isinstance(sample, Currents) and not self._missing

    def finish(self, time: float) -> Row:
        """Return the row at `time` (s). A latched bit is set in only one row."""
        row = {**self.row, "time_s": round(time, 4)}
        self._clear_status()
        return row


@dataclass(slots=True)
class BoardSnapshot(Newest):
    """State of a board at one moment of a recording."""

    settings: str = ""
    setpoints: Mapping[int, Drive] = field(default_factory=dict)  # motor (1 or 2) → setpoint
    auxiliary: int | None = None  # setpoint of the auxiliary motor, 0-127

    @classmethod
    def at_start(cls, header: Header) -> Self:
        return cls({ModeSample: ModeSample(header.clock, header.mode)}, header.settings)

    def update(self, record: Record) -> None:
        match record:
            case Sample():
                self.samples[type(record)] = record
            case SetpointRecord(motor=motor, drive=drive):
                self.setpoints = {**self.setpoints, motor: drive}
            case AuxiliarySetpointRecord(speed=speed):
                self.auxiliary = speed
            case Marker(kind=kind) if kind == STOP:
                self.setpoints, self.auxiliary = {}, None
            case SettingsSnapshot(text=text):
                self.settings = text
