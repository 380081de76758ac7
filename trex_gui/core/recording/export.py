"""Export of recordings as CSV for spreadsheets, or as MCAP for PlotJuggler and Foxglove."""

import csv
import io
import json
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import Any, BinaryIO

from trex_gui.core.files import atomic_file
from trex_gui.core.recording.kinds import SOURCE, SampleKind, Value
from trex_gui.core.recording.store import CHUNK, NOT_WRITTEN, ExportRow, Recording, reported

MCAP_SUFFIX = ".mcap"
_MCAP_TIMES = (0, 2**64 // 10**9 - 1)  # seconds since 1970
_JSON_TYPES = {"INTEGER": "integer", "REAL": "number", "TEXT": "string"}

ProgressCallback = Callable[[float], None]


def has_mcap() -> bool:
    return find_spec("mcap") is not None


def export_span(
    recording: Recording[Any, Any],
    path: Path,
    span: tuple[float, float],
    header: Mapping[str, Value],
    progress: ProgressCallback = lambda _fraction: None,
) -> None:
    """Write the samples of a span as MCAP or CSV, depending on the suffix of `path`.

    `span`: first and last time, on the session clock in s. `progress` is called with the completed
    fraction, 0 to 1. An exception in `progress` ends the export. An existing file is replaced only
    by a complete file. Raises RecordingError.
    """
    write = _write_mcap if path.suffix.lower() == MCAP_SUFFIX else _write_csv
    with reported(path, NOT_WRITTEN), atomic_file(path) as file:
        write(recording, file, span, header, progress)


def _rows(
    recording: Recording[Any, Any], span: tuple[float, float], progress: ProgressCallback
) -> Iterator[list[ExportRow]]:
    for first in range(1, recording.count + 1, CHUNK):
        yield recording.export_rows(first, first + CHUNK - 1, *span)
        progress(min(1.0, (first + CHUNK) / recording.count))


def csv_cell(value: Value) -> Value:
    """Escape text that a spreadsheet would read as a formula."""
    is_formula = isinstance(value, str) and value.startswith(("=", "+", "-", "@"))
    return f"'{value}" if is_formula else value


def _write_csv(
    recording: Recording[Any, Any],
    file: BinaryIO,
    span: tuple[float, float],
    header: Mapping[str, Value],
    progress: ProgressCallback,
) -> None:
    """Write one row per sample, with its time, its kind and all columns.

    Held values are repeated until they change, so that a spreadsheet can plot columns against each
    other. The first row has the kind `header`, and the header as JSON in the column `text`.
    """
    names = list(dict.fromkeys(name for kind in recording.kinds for name in kind.exported))
    indices = {name: index for index, name in enumerate(names)}
    columns = {kind.name: [indices[name] for name in kind.exported] for kind in recording.kinds}
    held_by_source: dict[Value, list[Value]] = defaultdict(lambda: [None] * len(names))
    text = io.TextIOWrapper(file, encoding="utf-8", errors="surrogatepass", newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["time_s", "sample", *names])
    cells: list[Value] = [None] * len(names)
    cells[indices["text"]] = json.dumps(header)
    writer.writerow(["0.000000", "header", *cells])
    for rows in _rows(recording, span, progress):
        lines = []
        for time, kind_index, values in rows:
            kind = recording.kinds[kind_index]
            exported = kind.exported
            source = values[exported.index(SOURCE)] if SOURCE in exported else None
            held = held_by_source[source]
            for cleared in kind.clears & columns.keys():
                for index in columns[cleared]:
                    held[index] = None
            cells = held if kind.held else held.copy()
            for index, value in zip(columns[kind.name], values, strict=True):
                if value is not None or not kind.partial:
                    cells[index] = csv_cell(value)
            lines.append((f"{time:.6f}", kind.name, *cells))
        writer.writerows(lines)
    text.flush()
    text.detach()


def _write_mcap(
    recording: Recording[Any, Any],
    file: BinaryIO,
    span: tuple[float, float],
    header: Mapping[str, Value],
    progress: ProgressCallback,
) -> None:
    from mcap.writer import Writer  # noqa: PLC0415 - optional package

    writer = Writer(file)
    writer.start(library="TReX Studio")
    device = str(header.get("device", "recording"))
    writer.add_metadata("recording", {name: str(value) for name, value in header.items()})
    channels = []
    for kind in recording.kinds:
        name = f"{device}.{kind.name}"
        schema = writer.register_schema(name, "jsonschema", json.dumps(_schema(kind)).encode())
        channels.append(writer.register_channel(f"/{device}/{kind.name}", "json", schema))
    started = round(recording.header.started.timestamp() * 1e9)
    # A damaged file may contain any time.
    earliest, latest = (limit - recording.header.started.timestamp() for limit in _MCAP_TIMES)
    for rows in _rows(recording, span, progress):
        for time, index, values in rows:
            names = recording.kinds[index].exported
            data = json.dumps(dict(zip(names, values, strict=True))).encode()
            timestamp = started + round(min(max(time, earliest), latest) * 1e9)
            writer.add_message(channels[index], timestamp, data, timestamp)
    writer.finish()  # type: ignore[no-untyped-call] # the library has no annotation


def _schema(kind: SampleKind) -> dict[str, Any]:
    properties: dict[str, Any] = {}
    for column in kind.columns:
        described = {"description": column.description}
        properties[column.name] = {"type": [_JSON_TYPES[column.type], "null"], **described}
        if column.physical is not None:
            properties[column.physical.name] = {"type": ["number", "null"], **described}
    return {"type": "object", "title": kind.name, "properties": properties}
