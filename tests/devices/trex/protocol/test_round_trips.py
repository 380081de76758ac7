"""Properties of both parsers, with every command, every framing and arbitrary bytes."""

from itertools import pairwise
from typing import Any

from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.protocol.test_calibration import calibrations
from tests.support.matrix import examples
from trex_gui.devices.trex.protocol.commands import (
    COMMANDS,
    Command,
    DriveAuxiliary,
    DriveBoth,
    DriveMotor,
    GetCalibratedChannels,
    GetCalibration,
    GetCurrent,
    GetCurrents,
    GetMode,
    GetParameter,
    GetRawChannels,
    GetRemappedChannels,
    GetSerialControl,
    GetSignature,
    GetStatus,
    GetUartErrors,
    Null,
    SetCalibration,
    SetParameter,
)
from trex_gui.devices.trex.protocol.driving import Direction, Drive
from trex_gui.devices.trex.protocol.framing import (
    Framing,
    Malformed,
    NeedData,
    Packet,
    PacketParser,
    Reply,
    ReplyParser,
    crc7,
)

few_examples = examples(40)

seven_bits = st.integers(0, 0x7F)
masks = st.integers(0, 0x1F)
channels = st.integers(1, 5)
motors = st.integers(1, 2)
drives = st.builds(Drive, st.sampled_from(Direction), seven_bits)


BY_CLASS: dict[type[Command[Any]], st.SearchStrategy[Command[Any]]] = {
    GetSignature: st.builds(GetSignature),
    GetMode: st.builds(GetMode),
    GetSerialControl: st.builds(GetSerialControl),
    GetStatus: st.builds(GetStatus),
    GetUartErrors: st.builds(GetUartErrors),
    GetRawChannels: st.builds(GetRawChannels, masks),
    GetRemappedChannels: st.builds(GetRemappedChannels, masks),
    GetCurrent: st.builds(GetCurrent, motors),
    GetCurrents: st.builds(GetCurrents),
    GetCalibration: st.builds(GetCalibration, channels),
    GetCalibratedChannels: st.builds(GetCalibratedChannels),
    GetParameter: st.builds(GetParameter, seven_bits),
    SetCalibration: st.builds(SetCalibration, channels, calibrations()),
    SetParameter: st.builds(SetParameter, seven_bits, seven_bits),
    DriveMotor: st.builds(DriveMotor, motors, drives, st.booleans()),
    DriveBoth: st.builds(DriveBoth, drives, drives, st.booleans()),
    DriveAuxiliary: st.builds(DriveAuxiliary, seven_bits, st.booleans()),
    Null: st.builds(Null),
}
commands = st.one_of(*BY_CLASS.values())

polynomials = st.none() | st.integers(0x80, 0xFF)
framings = st.builds(Framing, st.none() | seven_bits, polynomials)

REPLIES: dict[type[Command[Any]], st.SearchStrategy[bytes]] = {
    GetSignature: st.sampled_from([b"TReX1.0", b"TReX1.3", b"TReXJr1.0", b"TReXJr1.2"]),
    GetMode: st.sampled_from([b"R", b"A", b"r", b"a"]),
    GetSerialControl: st.sampled_from([b"\x00", b"\x01"]),
    GetCalibratedChannels: masks.map(lambda mask: bytes([mask])),
    GetParameter: seven_bits.map(lambda value: bytes([value])),
    SetCalibration: st.integers(0, 3).map(lambda code: bytes([code])),
    SetParameter: st.integers(0, 3).map(lambda code: bytes([code])),
}


@st.composite
def exchanges(draw: st.DrawFn) -> tuple[Command[Any], bytes]:
    """Return a command and a possible reply without its CRC."""
    command = draw(commands)
    size = command.reply_size()
    return command, draw(REPLIES.get(type(command), st.binary(min_size=size, max_size=size)))


@st.composite
def noise(draw: st.DrawFn) -> bytes:
    """Return arbitrary bytes, often similar to packets."""
    parts = []
    for _ in range(draw(st.integers(0, 4))):
        whole = draw(framings).encode(draw(commands))
        parts += [whole[: draw(st.integers(0, len(whole)))], draw(st.binary(max_size=4))]
    return b"".join(parts)


cuts = st.lists(st.integers(0, 80), max_size=6)


def in_pieces(raw: bytes, positions: list[int]) -> list[bytes]:
    bounds = [0, *sorted(min(position, len(raw)) for position in positions), len(raw)]
    return [raw[start:end] for start, end in pairwise(bounds)]


def test_strategies_cover_every_command_class() -> None:
    assert set(BY_CLASS) == set(COMMANDS.values())


@few_examples
@given(command=commands, framing=framings)
def test_only_first_byte_of_packet_has_top_bit_set(command: Command[Any], framing: Framing) -> None:
    first, *rest = framing.encode(command)
    assert first >= 0x80
    assert all(byte < 0x80 for byte in rest)


@few_examples
@given(command=commands, framing=framings)
def test_packet_ends_with_crc_of_all_its_bytes(command: Command[Any], framing: Framing) -> None:
    plain = Framing(framing.device_number).encode(command)
    has_crc = framing.polynomial is not None and not isinstance(command, Null)
    crc = bytes([crc7(plain, framing.polynomial or 0x89)]) if has_crc else b""
    assert framing.encode(command) == plain + crc


@few_examples
@given(
    sent=st.lists(st.tuples(commands, st.none() | seven_bits), max_size=6),
    polynomial=polynomials,
    positions=cuts,
)
def test_packets_cut_anywhere_give_the_sent_commands(
    sent: list[tuple[Command[Any], int | None]], polynomial: int | None, positions: list[int]
) -> None:
    packets = [
        Packet(Framing(number, polynomial).encode(command), command, number)
        for command, number in sent
    ]
    raw = b"".join(packet.raw for packet in packets)
    parser = PacketParser(polynomial)
    events = [event for piece in in_pieces(raw, positions) for event in parser.feed(piece)]
    assert events == packets
    assert parser.flush() == []


@few_examples
@given(raw=noise(), polynomial=polynomials, positions=cuts)
def test_noise_cut_anywhere_gives_the_same_events(
    raw: bytes, polynomial: int | None, positions: list[int]
) -> None:
    whole, cut = PacketParser(polynomial), PacketParser(polynomial)
    events = [event for piece in in_pieces(raw, positions) for event in cut.feed(piece)]
    assert events == whole.feed(raw)
    rest = cut.flush()
    assert rest == whole.flush()
    assert b"".join(event.raw for event in events + rest) == raw
    for event in events + rest:
        assert event.raw
        assert not isinstance(event, Malformed) or event.reason


@few_examples
@given(before=noise(), command=commands, framing=framings)
def test_packet_after_noise_is_understood(
    before: bytes, command: Command[Any], framing: Framing
) -> None:
    parser = PacketParser(framing.polynomial)
    raw = framing.encode(command)
    *_, last = parser.feed(before + raw)
    assert last == Packet(raw, command, framing.device_number)


def on_the_wire(command: Command[Any], payload: bytes, framing: Framing, echo: bool) -> bytes:
    sent = framing.encode(command) if echo else b""
    has_crc = framing.polynomial is not None and payload
    crc = bytes([crc7(payload, framing.polynomial or 0x89)]) if has_crc else b""
    return sent + payload + crc


@few_examples
@given(exchange=exchanges(), framing=framings, echo=st.booleans(), positions=cuts)
def test_reply_cut_anywhere_gives_the_same_reply(
    exchange: tuple[Command[Any], bytes], framing: Framing, echo: bool, positions: list[int]
) -> None:
    command, payload = exchange
    raw = on_the_wire(command, payload, framing, echo)
    parser = ReplyParser(command, framing, echo=echo)
    received = b""
    for piece in in_pieces(raw, positions):
        received += piece
        result = parser.feed(piece)
        if received == raw:
            assert result == Reply(raw, command.parse(payload))
        else:
            assert isinstance(result, NeedData)
            assert 1 <= result.size <= len(raw) - len(received)


@few_examples
@given(exchange=exchanges(), framing=framings, echo=st.booleans(), more=st.binary(min_size=1))
def test_bytes_after_any_reply_make_it_malformed(
    exchange: tuple[Command[Any], bytes], framing: Framing, echo: bool, more: bytes
) -> None:
    command, payload = exchange
    raw = on_the_wire(command, payload, framing, echo) + more
    result = ReplyParser(command, framing, echo=echo).feed(raw)
    assert isinstance(result, Malformed)
    assert result.raw == raw


@few_examples
@given(exchange=exchanges(), position=st.integers(0, 8 * 12))
def test_flipped_bit_in_reply_never_passes_crc(
    exchange: tuple[Command[Any], bytes], position: int
) -> None:
    command, payload = exchange
    framing = Framing(None, 0x89)
    raw = bytearray(on_the_wire(command, payload, framing, echo=False))
    if raw:
        index, bit = divmod(position % (8 * len(raw)), 8)
        raw[index] ^= 1 << bit
        assert not isinstance(ReplyParser(command, framing).feed(bytes(raw)), Reply)


@few_examples
@given(
    command=commands,
    framing=framings,
    expects_echo=st.booleans(),
    has_echo=st.booleans(),
    pieces=st.lists(st.binary(max_size=12), max_size=4),
)
def test_reply_parser_never_raises(
    command: Command[Any],
    framing: Framing,
    expects_echo: bool,
    has_echo: bool,
    pieces: list[bytes],
) -> None:
    parser = ReplyParser(command, framing, echo=expects_echo)
    received = b""
    for piece in [framing.encode(command)] * has_echo + pieces:
        received += piece
        result = parser.feed(piece)
        if isinstance(result, NeedData):
            assert result.size >= 1
        else:
            assert result.raw == received
