"""Recordings to write and read: any that can be, and an hour of one that could have been."""

from collections.abc import Iterator
from datetime import UTC, datetime
from io import BytesIO
from pathlib import Path
from random import Random

from hypothesis import strategies as st

from trex_gui.devices.trex.client.telemetry import (
    Control,
    Currents,
    LatchedStatus,
    ModeSample,
    Raw,
    Remapped,
)
from trex_gui.devices.trex.protocol.commands import Drive
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.driving import Direction
from trex_gui.devices.trex.protocol.flags import Mode, Status, UartError
from trex_gui.devices.trex.recording.csv_format import CsvWriter
from trex_gui.devices.trex.recording.reader import TrexrecFile
from trex_gui.devices.trex.recording.recording import (
    AuxiliarySetpointRecord,
    Header,
    Marker,
    Record,
    RecordingFile,
    SetpointRecord,
    SettingsSeen,
)
from trex_gui.devices.trex.recording.writer import TrexrecWriter

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

times = st.floats(allow_nan=False, allow_infinity=False)
bytes_ = st.integers(0, 255)
seven_bits = st.integers(0, 127)
words = st.text(max_size=40)

records: st.SearchStrategy[Record] = st.one_of(
    st.builds(Currents, times, st.tuples(bytes_, bytes_)),
    st.builds(Raw, times, st.tuples(*[st.none() | st.integers(0, 6250)] * 5)),
    st.builds(Remapped, times, st.tuples(*[st.integers(-127, 127)] * 5)),
    st.builds(
        LatchedStatus, times, bytes_.map(lambda bits: Status(bits & 0xF1)), bytes_.map(UartError)
    ),
    st.builds(Control, times, st.booleans()),
    st.builds(ModeSample, times, st.sampled_from(Mode)),
    st.builds(
        SetpointRecord,
        times,
        st.integers(1, 2),
        st.builds(Drive, st.sampled_from(Direction), seven_bits),
        st.booleans(),
    ),
    st.builds(AuxiliarySetpointRecord, times, seven_bits, st.booleans()),
    st.builds(Marker, times, st.sampled_from(["apply", "stop", "fault"]), words),
    st.builds(SettingsSeen, times, words),
)


def an_hour(seconds: float = 3600.0, begin: float = HEADER.clock) -> Iterator[Record]:
    """What a board at full rate reports while somebody drives it."""
    random = Random(1)
    due = {Currents: 0.0, Raw: 0.004, Remapped: 0.008, Control: 0.012, ModeSample: 0.016}
    rate = {Currents: 80, Raw: 50, Remapped: 50, Control: 10, ModeSample: 1}
    speed, duty = 0, 0.0
    while (at := min(due.values())) < seconds:
        kind = min(due, key=lambda kind: due[kind])
        due[kind] += 1 / rate[kind]
        time = begin + at + random.random() * 0.002
        if random.random() < 0.01:
            speed = max(-127, min(127, speed + random.randint(-30, 30)))
            yield SetpointRecord(time, random.randint(1, 2), Drive.at(speed), accelerate=True)
            if random.random() < 0.02:
                yield LatchedStatus(time, Status.MOTOR1_OVER_LIMIT, UartError(0))
                yield Marker(time, "stop", "A person pressed stop.")
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


def write(path: Path, what: list[Record], *, flush_every: int = 0, finish: bool = True) -> int:
    """Write a `.trexrec`; return its size."""
    with path.open("wb") as file:
        writer = TrexrecWriter(file, HEADER)
        step = flush_every or len(what) or 1
        for at in range(0, len(what), step):
            writer.write(what[at : at + step])
            if flush_every:
                writer.flush()
        if finish:
            writer.finish()
        else:
            writer.flush()
        return writer.size


def read(file: RecordingFile) -> list[Record]:
    """Everything in a recording, in order."""
    return [record for index in range(len(file.blocks)) for record in file.read(index)]


def opened(path: Path) -> tuple[Header, list[Record], list[str]]:
    file = TrexrecFile(path)
    try:
        return file.header, read(file), list(file.problems)
    finally:
        file.close()


def write_an_hour_of_csv(path: Path, minutes: int = 60) -> int:
    """Write a CSV recording as long as an hour's, quickly: a minute again and again.

    Returns how many rows of currents are in it.
    """
    with path.open("wb") as file:
        CsvWriter(file, HEADER).write([])
        buffer = BytesIO()
        CsvWriter(buffer, HEADER).write(list(an_hour(60)))
        rows = [line.split(",", 1) for line in buffer.getvalue().decode().splitlines()[2:]]
        for minute in range(minutes):
            lines = [f"{float(time) + 60 * minute:.6f},{rest}\n" for time, rest in rows]
            file.write("".join(lines).encode())
    return minutes * sum(rest.startswith("currents,") for _, rest in rows)
