"""Records for tests of recordings: arbitrary records, and records of a driven board."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from random import Random

from hypothesis import strategies as st

from trex_gui.core.recording.kinds import Marker
from trex_gui.core.recording.store import CHUNK, Recording, RecordingWriter
from trex_gui.devices.trex.client.telemetry import (
    POLLED,
    Control,
    Currents,
    LatchedStatus,
    ModeSample,
    Raw,
    Remapped,
    Sample,
)
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.driving import Direction, Drive
from trex_gui.devices.trex.protocol.flags import Mode, Status, UartError
from trex_gui.devices.trex.recording import (
    FORMAT,
    AuxiliarySetpointRecord,
    Header,
    OtherBoardRecord,
    Record,
    SetpointRecord,
    SettingsSnapshot,
)

HEADER = Header(
    started=datetime(2026, 11, 21, 12, 0, tzinfo=UTC),
    clock=1234.5,
    model=device_table().model("trex"),
    firmware="1.2",
    mode=Mode.SERIAL_RC,
    settings="product: TReX\ndevice_number: 7\n",
    device_number=7,
    program="TReX Studio 0.1.0",
)

times = st.floats(HEADER.clock, HEADER.clock + 1e7)
bytes_ = st.integers(0, 255)
seven_bits = st.integers(0, 127)
texts = st.text(st.characters(exclude_categories=["Cs"]), max_size=40)

polled: Mapping[type[Sample], st.SearchStrategy[Sample]] = {
    Currents: st.builds(Currents, times, st.tuples(bytes_, bytes_)),
    Raw: st.builds(Raw, times, st.tuples(*[st.none() | st.integers(0, 6250)] * 5)),
    Remapped: st.builds(Remapped, times, st.tuples(*[st.integers(-127, 127)] * 5)),
    LatchedStatus: st.builds(
        LatchedStatus, times, bytes_.map(lambda bits: Status(bits & 0xF1)), bytes_.map(UartError)
    ),
    Control: st.builds(Control, times, st.booleans()),
    ModeSample: st.builds(ModeSample, times, st.sampled_from(Mode)),
}
"""Samples of each polled value."""

assert polled.keys() == POLLED.keys()

any_record: st.SearchStrategy[Record] = st.one_of(
    *polled.values(),
    st.builds(
        SetpointRecord,
        times,
        st.integers(1, 2),
        st.builds(Drive, st.sampled_from(Direction), seven_bits),
        st.booleans(),
    ),
    st.builds(AuxiliarySetpointRecord, times, seven_bits, st.booleans()),
    st.builds(Marker, times, st.sampled_from(["apply", "stop", "fault"]), texts),
    st.builds(SettingsSnapshot, times, texts),
)


def drive_records(seconds: float = 3600.0) -> Iterator[Record]:
    """Yield the records of a driven board at full rate. The default is one hour."""
    random = Random(1)
    due = {Currents: 0.0, Raw: 0.004, Remapped: 0.008, Control: 0.012, ModeSample: 0.016}
    rate = {Currents: 80, Raw: 50, Remapped: 50, Control: 10, ModeSample: 1}
    speed, duty = 0, 0.0
    while (at := min(due.values())) < seconds:
        kind = min(due, key=lambda kind: due[kind])
        due[kind] += 1 / rate[kind]
        time = HEADER.clock + at + random.random() * 0.002
        if random.random() < 0.01:
            speed = max(-127, min(127, speed + random.randint(-30, 30)))
            yield SetpointRecord(time, random.randint(1, 2), Drive.at(speed), accelerate=True)
            if random.random() < 0.02:
                yield LatchedStatus(time, Status.MOTOR1_OVER_LIMIT, UartError(0))
                yield Marker(time, "stop", "The user pressed stop.")
        duty += (speed - duty) * 0.02
        sticks = [3750 + random.randint(-2, 2) for _ in range(4)]
        match kind:
            case k if k is Currents:
                amps = abs(duty) / 4
                yield Currents(time, (int(amps + random.random()), int(amps)))
            case k if k is Raw:
                yield Raw(time, (*sticks, None))
            case k if k is Remapped:
                yield Remapped(time, (*((stick - 3750) // 2 for stick in sticks), 0))
            case k if k is Control:
                yield Control(time, by_serial=True)
            case _:
                yield ModeSample(time, Mode.SERIAL_RC)


def write(path: Path, records: list[Record], *, step: int = 500, finish: bool = True) -> int:
    """Write a recording with a commit after every `step` records. Return its size."""
    writer = RecordingWriter[Header, Record](path, FORMAT, HEADER)
    for first in range(0, len(records), step):
        writer.write(records[first : first + step])
        writer.commit()
    if finish:
        writer.finish()
    size = writer.size
    writer.close()
    return size


def write_long_recording(path: Path, minutes: int = 60) -> int:
    """Write a recording that repeats one minute, which is quick. Return its number of currents."""
    minute = [record for record in drive_records(60) if not isinstance(record, OtherBoardRecord)]
    writer = RecordingWriter[Header, Record](path, FORMAT, HEADER)
    for number in range(minutes):
        writer.write([replace(record, time=record.time + 60 * number) for record in minute])
    writer.finish()
    writer.close()
    return minutes * sum(isinstance(record, Currents) for record in minute)


def open_recording(path: Path) -> Recording[Header, Record]:
    return Recording(path, FORMAT)


def read_all(recording: Recording[Header, Record]) -> list[Record]:
    """Return all records in order."""
    numbers = range(1, recording.count + 1, CHUNK)
    return [record for first in numbers for record in recording.read(first, first + CHUNK - 1)]


def read_file(path: Path) -> tuple[Header, list[Record], list[str]]:
    """Return header, records and problems of a file."""
    recording = open_recording(path)
    try:
        return recording.header, read_all(recording), recording.problems
    finally:
        recording.close()
