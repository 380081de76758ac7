"""The replay command, which runs in virtual time."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import click

from trex_gui.core.cli import CommandFailed, reported_errors, say
from trex_gui.core.command_io import FileName
from trex_gui.core.errors import BadRequest
from trex_gui.core.files import SettingsError, load
from trex_gui.core.simulator.line import SimulatedLine
from trex_gui.core.texts import counted, hex_text
from trex_gui.core.translation import tr
from trex_gui.core.transport.traffic import Transaction
from trex_gui.core.transport.transcript import LARGEST, TranscriptRow, read_transcript
from trex_gui.devices.trex.protocol import commands as c
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.flags import InputSource, Mode
from trex_gui.devices.trex.protocol.framing import DEFAULT_POLYNOMIAL, Malformed, Packet, Reply
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey, parameter_number, parameters_of
from trex_gui.devices.trex.protocol.raw_packets import packets_of
from trex_gui.devices.trex.session.traffic_decoder import TrexDecoder, last_exchange
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.memory import Eeprom

_MEASURED = (
    c.GetRawChannels,
    c.GetRemappedChannels,
    c.GetCurrent,
    c.GetCurrents,
    c.GetSerialControl,
    c.GetStatus,
    c.GetUartErrors,
)
"""Queries for measurements and errors. Only the sizes of their replies are compared."""

_WAIT = 0.3  # virtual seconds for a reply; the longest write takes 32 ms
_MAX_GAP = 2.0  # virtual seconds between two rows; longer gaps are shortened

_SAMPLE = 50  # rows that are examined to find the CRC polynomial

_JUMPERS = {Mode.RC: "rc", Mode.ANALOG: "analog"}


@click.command()
@click.argument("file", type=FileName(dir_okay=False))
@click.option(
    "--all", "everything", is_flag=True, help="Print all differences, not just the first."
)
def replay(file: str, everything: bool) -> None:
    """Send the packets of a traffic log to a simulated board and compare the replies.

    FILE is a log saved by the traffic page or written by --traffic. The simulated board starts with
    the model, mode and stored values that the replies in FILE show. No port is opened, and no real
    motor moves. Probes that searched for a board are left out. For measurements and error bits,
    only the sizes of the replies are compared. The exit code is 1 if a reply differs.
    """
    with reported_errors():
        recorded = RecordedTraffic.load(Path(file))
    rows = recorded.rows
    say(f"Simulated board: {recorded.text()}.")
    differing = 0
    for row, received in recorded.replayed():
        differing += 1
        if differing == 1 or everything:
            click.echo(f"Line {row.line}: {hex_text(row.sent)}")
            for title, reply in (("file", row.received), ("simulator", received)):
                data = hex_text(reply) or "nothing"
                click.echo(f"  {title + ':':11}{data}  ({recorded.meaning(row, reply)})")
        if not everything:
            break
    for warning in recorded.warnings:
        say(f"Warning: {warning}")
    if differing:
        raise CommandFailed(
            f"Replies differ in {differing} of {counted(len(rows), 'transaction')}."
            if everything
            else "A reply differs; --all shows every difference."
        )
    click.echo(f"{counted(len(rows), 'transaction')}, no differences.")


@dataclass(slots=True)
class RecordedTraffic:
    rows: Sequence[TranscriptRow]
    settings: ConnectionSettings = field(default_factory=lambda: ConnectionSettings(""))
    signature: c.Signature | None = None
    mode: Mode = Mode.SERIAL_RC
    parameters: dict[int, int] = field(default_factory=dict)
    calibrations: dict[tuple[InputSource, int], Calibration] = field(default_factory=dict)
    is_echoed: bool = False
    warnings: list[str] = field(default_factory=list)

    @classmethod
    def load(cls, path: Path) -> "RecordedTraffic":
        """Read a transcript except search probes. Raises SettingsError if nothing remains."""
        text = load(path, tr("traffic logs"), LARGEST).decode("utf-8", "replace")
        all_rows = read_transcript(text, str(path), TrexDecoder())
        rows = [row for row in all_rows if not row.is_search]
        if not any(row.sent for row in rows):
            message = tr("there is nothing to compare: only probes were sent")
            raise SettingsError.of(str(path), message)
        return cls.of(rows)

    @classmethod
    def of(cls, rows: Sequence[TranscriptRow]) -> "RecordedTraffic":
        traffic = cls(rows)
        if (polynomial := _polynomial(rows)) is not None:
            line = LineSettings(detection=Detection.CRC7)
            traffic.settings = ConnectionSettings("", line, polynomial=polynomial)
        answered = [row for row in rows if row.received and row.sent]
        echoed = [row for row in answered if row.received.startswith(row.sent)]
        traffic.is_echoed = len(echoed) * 2 > len(answered)
        written: set[object] = set()
        for row in rows:
            traffic._record_values(row, written)
        return traffic

    def _record_values(self, row: TranscriptRow, written: set[object]) -> None:
        """Record the initial values that a row shows.

        `written` contains the parameters and calibrations that earlier rows changed. These are not
        recorded, because replies no longer show their initial values. Parameters and calibrations
        that the row changes are added to `written`.
        """
        packet, reply = last_exchange(self._transaction(row))
        if isinstance(packet, Packet) and isinstance(reply, Reply) and reply.raw:
            parameter = parameter_number(ParameterKey.DEVICE_NUMBER)
            if packet.device_number is not None and parameter not in written:
                self.parameters.setdefault(parameter, packet.device_number)
        match packet, reply:
            case Packet(command=c.GetSignature()), Reply(value=c.Signature() as signature):
                self.signature = self.signature or signature
            case Packet(command=c.GetMode()), Reply(value=Mode() as mode):
                self.mode = mode
            case Packet(command=c.SetParameter(number=number)), _:
                written.add(number)
            case Packet(command=c.SetCalibration(channel=channel)), _:
                written.add((self.mode.source, channel))
            case Packet(command=c.GetParameter(number=number)), Reply(value=int(value)):
                if number not in written:
                    self.parameters.setdefault(number, value)
            case Packet(command=c.GetCalibration(channel=channel)), Reply(
                value=Calibration() as calibration
            ):
                if (self.mode.source, channel) not in written:
                    self.calibrations.setdefault((self.mode.source, channel), calibration)

    def _transaction(self, row: TranscriptRow) -> Transaction:
        return Transaction(
            row.line,
            row.time,
            row.sent,
            row.received,
            settings=self.settings,
            echo=self.is_echoed,
            is_over=True,
        )

    def text(self) -> str:
        board = (
            tr("TReX 1.2, because no signature was read")
            if self.signature is None
            else self.signature
        )
        count = len(self.parameters)
        known = tr("1 stored value") if count == 1 else tr("{0} stored values").format(count)
        return tr("{0}, {1} from the file, all other values at their defaults").format(board, known)

    def meaning(self, row: TranscriptRow, reply: bytes) -> str:
        transaction = self._transaction(replace(row, received=reply))
        return TrexDecoder().decoded(transaction).text

    def replayed(self) -> Iterator[tuple[TranscriptRow, bytes]]:
        """Yield each row whose reply differs, with the reply of the simulator."""
        line = self._line()
        at, before = line.now, self.rows[0].time if self.rows else 0.0
        for row in self.rows:
            at += min(max(row.time - before, 0.0), _MAX_GAP)
            before = row.time
            line.advance_to(at)
            line.receive()
            if not row.sent:
                continue
            line.send(row.sent)
            received = line.read(max(len(row.received), 1), _WAIT) + line.receive()
            packet, _ = last_exchange(self._transaction(row))
            is_measured = isinstance(packet, Packet) and isinstance(packet.command, _MEASURED)
            if is_measured and len(received) == len(row.received):
                continue
            if received != row.received:
                yield row, received

    def _line(self) -> SimulatedLine:
        signature = self.signature
        model = "trex" if signature is None else signature.model.key
        firmware = "1.2" if signature is None else signature.firmware
        eeprom = Eeprom(model)
        specs = parameters_of(model, firmware)
        stored = dict(self.parameters)
        if self.settings.line.has_crc:
            stored.setdefault(
                parameter_number(ParameterKey.UART_SETTINGS), self.settings.line.to_wire()
            )
            bits = self.settings.polynomial & 0x7F
            stored.setdefault(parameter_number(ParameterKey.CRC7_POLYNOMIAL), bits)
        for number, value in stored.items():
            spec = specs.number(number)
            if spec is not None and spec.readable:
                try:
                    eeprom.write(spec.key, value)
                except BadRequest as error:
                    self.warnings.append(
                        tr("{0}; the simulated board uses the default value instead.").format(error)
                    )
        for (source, channel), calibration in self.calibrations.items():
            eeprom.write_calibration(source, channel, calibration)
        board = Board(model, firmware, eeprom=eeprom, mode=_JUMPERS.get(self.mode, "serial"))
        return SimulatedBoards([board], echo=self.is_echoed, paced=False)


def _polynomial(rows: Sequence[TranscriptRow]) -> int | None:
    """Return the CRC polynomial that makes the most packets readable. `None`: no CRC."""

    def malformed_packets(polynomial: int | None) -> int:
        packets = (item for row in rows[:_SAMPLE] for item in packets_of(row.sent, polynomial))
        return sum(isinstance(item.packet, Malformed) for item in packets)

    candidates: tuple[int | None, ...] = (None, DEFAULT_POLYNOMIAL, *range(0x80, 0x100))
    return min(candidates, key=malformed_packets)
