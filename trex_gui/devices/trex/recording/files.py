"""Recordings by their file: which format it is, writing one, opening one."""

from pathlib import Path
from typing import BinaryIO

from trex_gui.devices.trex.recording import csv_format, layout
from trex_gui.devices.trex.recording.csv_format import CsvWriter
from trex_gui.devices.trex.recording.csv_reader import CsvFile
from trex_gui.devices.trex.recording.reader import TrexrecFile
from trex_gui.devices.trex.recording.recording import Header, RecordingFile, Writer
from trex_gui.devices.trex.recording.writer import TrexrecWriter

SUFFIXES = (layout.SUFFIX, csv_format.SUFFIX)


def open_recording(path: Path, *, head_only: bool = False) -> RecordingFile:
    """Open a recording of either format; what is in it decides, not its name.

    With `head_only` that takes no time, and it has no blocks before it is looked through.

    Raises:
        RecordingError: there is none that can be read.
    """
    try:
        with path.open("rb") as file:
            is_csv = file.read(6) == b"time_s"
    except (OSError, ValueError):
        is_csv = False  # the reader says what is the matter
    kind = CsvFile if is_csv else TrexrecFile
    return kind(path, head_only=head_only)


def writer_for(path: Path, file: BinaryIO, header: Header) -> Writer:
    """Return what writes a recording into a file of this name.

    Raises:
        OSError: the head cannot be written.
    """
    if path.suffix.lower() == csv_format.SUFFIX:
        return CsvWriter(file, header)
    return TrexrecWriter(file, header)
