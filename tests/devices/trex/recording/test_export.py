"""Exports of a recording: CSV for spreadsheets, MCAP for PlotJuggler and Foxglove."""

import csv
import json
from pathlib import Path

import pytest
from mcap.reader import make_reader

from tests.devices.trex.recording.samples import HEADER, drive_records, open_recording, write
from trex_gui.core.recording.export import export_span
from trex_gui.core.recording.kinds import Marker, RecordingError
from trex_gui.devices.trex.client.telemetry import Currents, LatchedStatus, Raw
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.flags import Status, UartError
from trex_gui.devices.trex.recording import (
    AuxiliarySetpointRecord,
    MeasurementTable,
    Record,
    SetpointRecord,
)

T0 = HEADER.clock
WHOLE_SPAN = (T0 - 1, T0 + 1e6)


def export(
    folder: Path, records: list[Record], name: str = "a.csv", span: tuple[float, float] = WHOLE_SPAN
) -> Path:
    write(folder / "a.trexrec", records)
    recording = open_recording(folder / "a.trexrec")
    export_span(recording, folder / name, span, {"device": "trex", **HEADER.values()})
    recording.close()
    return folder / name


def rows_of(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_csv_has_units_and_rows_repeat_last_values(tmp_path: Path) -> None:
    rows = rows_of(export(tmp_path, list(drive_records(2))))
    assert {"time_s", "motor_1_current_A", "channel_1_us", "channel_1_remapped"} <= set(rows[0])
    assert rows[0]["sample"] == "header"
    assert json.loads(rows[0]["text"])["settings"].startswith("product: TReX")
    last = rows[-1]
    assert float(last["time_s"]) == pytest.approx(2, abs=0.1)
    assert float(last["channel_1_us"]) == pytest.approx(1500, abs=1)
    assert float(last["motor_2_current_A"]) >= 0
    assert last["channel_5_raw"] == last["channel_5_us"] == ""
    assert all(None not in row for row in rows)


def test_csv_has_every_column_that_stream_writes(tmp_path: Path) -> None:
    (header,) = rows_of(export(tmp_path, []))
    assert MeasurementTable(HEADER.mode, HEADER.model.current_unit).row.keys() < set(header)


def test_csv_names_setpoints_status_and_markers(tmp_path: Path) -> None:
    _, forward, brake, auxiliary, status, marker = rows_of(
        export(
            tmp_path,
            [
                SetpointRecord(T0 + 1, 2, Drive.at(-70), accelerate=True),
                SetpointRecord(T0 + 2, 1, Drive.brake(40)),
                AuxiliarySetpointRecord(T0 + 3, 99),
                LatchedStatus(T0 + 4, Status.MOTOR1_FAULT, UartError.CRC),
                Marker(T0 + 5, "stop", 'a, "b"\nc\\n'),
            ],
        )
    )
    assert [forward[name] for name in ("sample", "setpoint_motor", "direction", "speed")] == [
        *("setpoint", "2", "reverse", "-70")
    ]
    assert (forward["brake"], forward["accelerate"]) == ("", "1")
    assert (brake["direction"], brake["speed"], brake["brake"]) == ("brake", "0", "40")
    assert (auxiliary["sample"], auxiliary["aux_speed"]) == ("aux_setpoint", "99")
    assert (status["status_motor1_fault"], status["uart_crc"], status["uart_parity"]) == (
        *("1", "1", "0"),
    )
    assert (marker["sample"], marker["marker_kind"]) == ("marker", "stop")
    assert marker["text"] == 'a, "b"\nc\\n'
    assert marker["speed"] == marker["uart_crc"] == ""


@pytest.mark.parametrize("first", "=+-@")
def test_text_that_looks_like_a_formula_is_written_as_text(tmp_path: Path, first: str) -> None:
    note = Marker(T0 + 2, "user", f"{first}1+2")
    written = export(tmp_path, [SetpointRecord(T0 + 1, 2, Drive.at(-70)), note])
    _, setpoint, marker = rows_of(written)
    assert marker["text"] == f"'{first}1+2"
    assert setpoint["speed"] == "-70", "a number is not changed"


def test_export_contains_only_the_span(tmp_path: Path) -> None:
    records = list(drive_records(60))
    begin, end = T0 + 20, T0 + 35.5
    rows = rows_of(export(tmp_path, records, span=(begin, end)))[1:]
    times = [record.time - T0 for record in records if begin <= record.time <= end]
    assert [float(row["time_s"]) for row in rows] == pytest.approx(times, abs=2e-6)


def test_mcap_has_a_topic_with_schema_for_each_kind(tmp_path: Path) -> None:
    records: list[Record] = [
        Currents(T0 + 1, (10, 0)),
        Raw(T0 + 1.5, (3750, None, 3750, 3750, 3750)),
        Marker(T0 + 2, "stop", "Stop"),
    ]
    path = export(tmp_path, records, "a.mcap")
    with path.open("rb") as file:
        reader = make_reader(file)
        messages = [
            (channel.topic, message.log_time, json.loads(message.data))
            for _, channel, message in reader.iter_messages()
        ]
        summary = reader.get_summary()
        metadata = [record.metadata for record in reader.iter_metadata()]
    assert [topic for topic, _, _ in messages] == ["/trex/currents", "/trex/raw", "/trex/marker"]
    started = round(HEADER.started.timestamp() * 1e9)
    assert [time - started for _, time, _ in messages] == [10**9, 15 * 10**8, 2 * 10**9]
    assert messages[0][2]["motor_1_current_A"] == 1.5
    assert messages[1][2]["channel_1_us"] == 1500.0
    assert messages[1][2]["channel_2_raw"] is None
    assert messages[2][2] == {"marker_kind": "stop", "text": "Stop"}
    assert metadata[0]["device_name"] == "TReX 1.2"
    assert summary is not None
    schemas = {each.name: json.loads(each.data) for each in summary.schemas.values()}
    properties = schemas["trex.currents"]["properties"]
    assert properties["motor_1_current_A"]["type"] == ["number", "null"]
    assert properties["motor_1_current_counts"]["type"] == ["integer", "null"]


def test_failed_export_keeps_the_existing_file(tmp_path: Path) -> None:
    write(tmp_path / "a.trexrec", list(drive_records(10)))
    target = tmp_path / "a.csv"
    target.write_text("before", encoding="utf-8")
    recording = open_recording(tmp_path / "a.trexrec")

    def cancel(_share: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        export_span(recording, target, WHOLE_SPAN, HEADER.values(), cancel)
    with pytest.raises(RecordingError, match="cannot be written: No such file"):
        export_span(recording, tmp_path / "none" / "a.csv", WHOLE_SPAN, HEADER.values())
    recording.close()
    assert target.read_text(encoding="utf-8") == "before"
    assert sorted(file.name for file in tmp_path.iterdir()) == ["a.csv", "a.trexrec"]
