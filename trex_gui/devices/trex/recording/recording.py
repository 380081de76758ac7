"""What a recording holds: a header that says of what, and records in the order they came."""

import json
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any, Protocol

from trex_gui.core.errors import BadRequest
from trex_gui.core.recording.blocks import BlockFile
from trex_gui.devices.trex.client.telemetry import Sample
from trex_gui.devices.trex.protocol.commands import Drive
from trex_gui.devices.trex.protocol.device_table import Model, device_table
from trex_gui.devices.trex.protocol.flags import Mode

LONGEST_TEXT = 60_000
"""Characters that a text in a record may have: settings take 4,000."""


@dataclass(frozen=True, slots=True)
class SetpointRecord:
    """What motor 1 or 2 was asked to do, as it was handed to the line."""

    time: float
    motor: int
    drive: Drive
    accelerate: bool = False


@dataclass(frozen=True, slots=True)
class AuxiliarySetpointRecord:
    """The speed, 0-127, that the auxiliary motor was asked for."""

    time: float
    speed: int
    accelerate: bool = False


@dataclass(frozen=True, slots=True)
class Marker:
    """Something that happened: `kind` is a word such as `STOP`, `text` is for people."""

    time: float
    kind: str
    text: str


@dataclass(frozen=True, slots=True)
class SettingsSeen:
    """What the board stores from now on, as the text of a settings file."""

    time: float
    text: str


Record = Sample | SetpointRecord | AuxiliarySetpointRecord | Marker | SettingsSeen
"""Times are seconds on the session's clock, which only rises while a computer runs."""


@dataclass(frozen=True, slots=True)
class Header:
    """Of what a recording is.

    Attributes:
        started: when, in UTC.
        clock: what the session's clock said then, in seconds; times count from there for people.
        mode: the board's mode then; it says what the channels are measured in.
        settings: everything that the board stored then, as the text of a settings file.
        device_number: the board's number then; `None` where it was addressed without one.
        program: what wrote it, with its version.
    """

    started: datetime
    clock: float
    model: Model
    firmware: str
    mode: Mode
    settings: str = ""
    device_number: int | None = None
    program: str = ""

    @property
    def board(self) -> str:
        """Model and firmware, as a person reads them."""
        return f"{self.model.name} {self.firmware}"

    def to_json(self) -> str:
        """Return the header as one line of JSON; units stand beside what they belong to."""
        return json.dumps(
            {
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
            }
        )

    @classmethod
    def from_json(cls, text: str) -> "Header":
        """Return the header of a line of JSON.

        Raises:
            ValueError: it is none, or of a board that is not known here.
        """
        try:
            data: Any = json.loads(text)
            number = data.get("device_number")
            return cls(
                started=datetime.fromisoformat(data["started_utc"]).astimezone(UTC),
                clock=float(data["clock_s"]),
                model=device_table().model(data["model"]),
                firmware=str(data["firmware"]),
                mode=Mode(data["mode"]),
                settings=str(data.get("settings", "")),
                device_number=None if number is None else int(number),
                program=str(data.get("program", "")),
            )
        except (KeyError, TypeError, AttributeError, RecursionError, OverflowError) as error:
            raise ValueError(f"its header lacks something: {error}") from error
        except BadRequest as error:
            raise ValueError(str(error)) from error


class RecordingFile(BlockFile[Header, Record], Protocol):
    """A recording of a board that can be read at any place, whatever its format."""

    def again(self) -> "RecordingFile":
        """Return the same recording opened once more, for another thread.

        Raises:
            RecordingError: it cannot be opened any more.
        """


class Writer(Protocol):
    """Writes records as they come.

    Attributes:
        size: bytes handed to the file so far.
    """

    size: int

    def write(self, records: Sequence[Record]) -> None:
        """Take records; they are in the file after the next `flush`, or before.

        Raises:
            OSError: they cannot be written.
        """

    def flush(self) -> None:
        """Put what was taken into the file, in whole blocks."""

    def finish(self) -> None:
        """Write what makes the file complete; nothing can be written afterwards."""
