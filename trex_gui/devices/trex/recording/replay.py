"""What was known at one time of a recording, found without reading it from the start."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path

from trex_gui.core.files.atomic import atomic_file
from trex_gui.core.recording.block_replay import BlockReplay
from trex_gui.core.recording.errors import RecordingError
from trex_gui.devices.trex.client.telemetry import (
    Control,
    Currents,
    LatchedStatus,
    ModeSample,
    Raw,
    Remapped,
)
from trex_gui.devices.trex.protocol.commands import Drive
from trex_gui.devices.trex.protocol.flags import Mode
from trex_gui.devices.trex.recording.csv_format import CsvWriter
from trex_gui.devices.trex.recording.recording import (
    AuxiliarySetpointRecord,
    Marker,
    Record,
    RecordingFile,
    SetpointRecord,
    SettingsSeen,
)

STOP = "stop"
"""The kind of a marker after which nothing is asked of a motor."""


@dataclass(slots=True)
class Latest:
    """The newest of everything; `None` while nothing was known yet.

    `wishes` has motors 1 and 2; one that nothing was asked of is missing.
    """

    mode: Mode
    settings: str
    raw: tuple[int | None, ...] | None = None
    remapped: tuple[int, ...] | None = None
    currents: tuple[int, int] | None = None
    by_serial: bool | None = None
    wishes: dict[int, Drive] = field(default_factory=dict)
    auxiliary: int | None = None

    def take(self, record: Record) -> None:
        """Take a record as the newest."""
        match record:
            case Currents(counts=counts):
                self.currents = counts
            case Raw(counts=raw):
                self.raw = raw
            case Remapped(values=values):
                self.remapped = values
            case Control(by_serial=by_serial):
                self.by_serial = by_serial
            case ModeSample(mode=mode):
                self.mode = mode
            case SetpointRecord(motor=motor, drive=drive):
                self.wishes = {**self.wishes, motor: drive}
            case AuxiliarySetpointRecord(speed=speed):
                self.auxiliary = speed
            case Marker(kind=kind):
                if kind == STOP:
                    self.wishes, self.auxiliary = {}, None
            case SettingsSeen(text=text):
                self.settings = text
            case LatchedStatus():
                pass


class Replay(BlockReplay[Record, Latest]):
    """Goes to any time of a recording of a board."""

    def __init__(self, file: RecordingFile) -> None:
        super().__init__(file, Latest(file.header.mode, file.header.settings))


def export_span(
    file: RecordingFile,
    path: Path,
    start: float,
    end: float,
    tell: Callable[[float], None] = lambda _share: None,
) -> None:
    """Write what was recorded from `start` to `end` (session's clock) as CSV.

    `tell` is told the share that is done, 0 to 1, after each block; what it raises ends the work,
    and then nothing was written: whatever had the name before is still there.

    Raises:
        RecordingError: the recording cannot be read, or the CSV cannot be written.
    """
    settings = file.header.settings
    indices = [
        index
        for index, block in enumerate(file.blocks)
        if block.first <= end and block.last >= start
    ]
    try:
        with atomic_file(path) as target:
            writer: CsvWriter | None = None
            for done, index in enumerate(indices, 1):
                records = file.read(index)
                if writer is None:
                    for record in records:
                        if isinstance(record, SettingsSeen) and record.time <= start:
                            settings = record.text
                    writer = CsvWriter(target, replace(file.header, settings=settings))
                writer.write([record for record in records if start <= record.time <= end])
                tell(done / len(indices))
            (writer or CsvWriter(target, file.header)).finish()
    except OSError as error:
        reason = error.strerror or error
        raise RecordingError(str(path), f"It cannot be written: {reason}.") from error
