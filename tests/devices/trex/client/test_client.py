"""Transactions of a client in virtual time."""

import contextlib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.session.helpers import create_harness
from tests.support.matrix import examples
from tests.support.virtual import SessionHarness
from trex_gui.core.errors import BadReply, NoReply
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.commands import (
    Command,
    DriveBoth,
    DriveMotor,
    GetCalibration,
    GetCurrents,
    GetMode,
    GetParameter,
    GetRawChannels,
    GetSerialControl,
    GetSignature,
    SetCalibration,
    SetParameter,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Direction, Drive
from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import Mode
from trex_gui.devices.trex.protocol.line_settings import Detection
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.memory import Eeprom

few_examples = examples(40)

PORT_LATENCY = 0.06
"""Latency that is allowed for a local port, in seconds. The virtual port is faster."""


# --- Replies ----------------------------------------------------------------------------


@pytest.mark.parametrize("number", [None, 7])
@pytest.mark.parametrize("detection", list(Detection))
def test_every_packet_format_is_understood(number: int | None, detection: Detection) -> None:
    harness, settings = create_harness(detection=detection)
    client = harness.client(ConnectionSettings("virtual", settings.line, device_number=number))
    assert client.request(GetParameter(0x7E)) == settings.line.to_wire()


# --- Deadlines --------------------------------------------------------------------------


@pytest.mark.parametrize("baud", [1200, 115200])
@pytest.mark.parametrize(
    ("command", "size", "board_time"),
    [
        (GetMode(), 2, 0.0),
        (GetRawChannels(), 12, 0.0),
        (SetParameter(7, 5), 6, 0.05),
        (SetCalibration(1, Calibration(2500, 3750, 5000, 75)), 12, 0.1),
    ],
    ids=str,
)
def test_timeout_is_wire_time_plus_allowance(
    baud: int, command: Command[object], size: int, board_time: float
) -> None:
    harness, settings = create_harness(baud)
    harness.board.power_off()
    client = harness.client(settings)
    start = harness.line.now
    with pytest.raises(NoReply, match="No reply to"):
        client.request(command)
    duration = harness.line.now - start
    wire = settings.line.seconds(size)
    assert wire + board_time <= duration <= wire + board_time + harness.transport.latency + 0.01


def test_extra_timeout_is_added_to_deadline(harness: SessionHarness) -> None:
    harness.board.power_off()
    client = harness.client(ConnectionSettings("virtual", timeouts=Timeouts(extra=2.0)))
    with pytest.raises(NoReply):
        client.request(GetMode())
    assert 2.0 < harness.line.now < 2.1


def test_delayed_reply_within_allowance_is_accepted() -> None:
    harness, settings = create_harness()
    harness.board.eeprom.write("uart_response_delay", 1)
    harness.board.power_cycle()
    harness.transport.latency = 0.0
    assert harness.client(settings).request(GetMode()) is Mode.SERIAL_RC


# --- Late and unsolicited bytes ---------------------------------------------------------


def client_after_silence(harness: SessionHarness, requests: int) -> TrexClient:
    """Return a client that has sent this number of unanswered requests."""
    harness.transport.latency = PORT_LATENCY
    client = harness.client()
    harness.line.faults.mute = True
    for _ in range(requests):
        with pytest.raises(NoReply):
            client.request(GetParameter(0x7E))
    harness.line.faults.mute = False
    return client


@pytest.mark.parametrize("pause", [0.1, 0.0], ids=["before the next request", "during it"])
def test_late_reply_is_discarded(harness: SessionHarness, pause: float) -> None:
    client = client_after_silence(harness, 1)
    harness.line.timeline.at(harness.line.now + 0.03, lambda: harness.line.inject(b"\x05"))
    harness.line.advance(pause)
    assert client.request(GetParameter(0)) == 7
    assert client.counters.unsolicited == 1


def test_burst_of_late_replies_is_rejected(harness: SessionHarness) -> None:
    client = client_after_silence(harness, 3)
    # A stalled adapter delivers all replies while the next request waits.
    harness.line.timeline.at(
        harness.line.now + PORT_LATENCY + 0.0005, lambda: harness.line.inject(b"\x05\x05\x05")
    )
    with pytest.raises(BadReply, match="Late replies"):
        client.request(GetParameter(0))
    assert client.request(GetParameter(0)) == 7
    assert client.counters.unsolicited >= 3


def test_reply_after_lost_replies_is_accepted(harness: SessionHarness) -> None:
    client = client_after_silence(harness, 3)
    assert client.request(GetParameter(0)) == 7
    start = harness.line.now
    assert client.request(GetParameter(0)) == 7
    assert harness.line.now - start < PORT_LATENCY, "replies are matched to requests again"


def test_motor_command_does_not_wait_for_late_reply(harness: SessionHarness) -> None:
    client = client_after_silence(harness, 1)
    start = harness.line.now
    client.send(DriveMotor(1, Drive.brake(127)))
    assert harness.line.now == start


def test_reply_through_slow_port_is_in_time(harness: SessionHarness) -> None:
    write = harness.transport.write

    def write_slowly(data: bytes) -> None:
        harness.line.advance(0.2)
        write(data)

    harness.transport.write = write_slowly  # type: ignore[method-assign]
    assert harness.client().request(GetMode()) is Mode.SERIAL_RC


def test_incomplete_reply_is_reported_with_its_bytes(harness: SessionHarness) -> None:
    harness.line.faults.to_drop = 3
    with pytest.raises(NoReply, match=r"Incomplete reply to 81: only 58 31 2E 32 arrived\."):
        harness.client().request(GetSignature())


def test_reply_with_wrong_crc_raises_bad_reply() -> None:
    harness, settings = create_harness(detection=Detection.CRC7)
    client = harness.client(settings)
    harness.board.power_off()
    harness.line.inject(b"\x07\x00")
    with pytest.raises(BadReply, match="CRC is 00"):
        client.request(GetParameter(0))


def test_remaining_bytes_of_bad_reply_are_discarded(harness: SessionHarness) -> None:
    client = harness.client()
    harness.board.power_off()
    harness.line.inject(b"Hello there")
    with pytest.raises(BadReply, match="48"):
        client.request(GetMode())
    harness.board.power_on()
    assert client.request(GetMode()) is Mode.SERIAL_RC


# --- Motor commands ---------------------------------------------------------------------


def test_motor_command_returns_immediately(harness: SessionHarness) -> None:
    harness.client().request(DriveMotor(1, Drive.at(50)))
    assert harness.line.now == 0.0
    harness.line.advance(0.01)
    assert harness.board.motors[0].speed == 50


@pytest.mark.parametrize("baud", [1200, 115200])
def test_request_waits_until_motor_command_is_sent(baud: int) -> None:
    harness, settings = create_harness(baud)
    client = harness.client(settings)
    client.request(DriveBoth(Drive.at(50), Drive.at(-50)))
    client.request(GetMode())
    assert harness.line.now == pytest.approx(settings.line.seconds(3 + 2))


def test_motor_commands_do_not_queue_up_in_port(harness: SessionHarness) -> None:
    client = harness.client()
    for speed in range(100):
        client.request(DriveMotor(1, Drive.at(speed)))
        assert harness.line.backlog <= 0.0011


def test_drain_waits_for_last_bit(harness: SessionHarness) -> None:
    client = harness.client()
    client.request(DriveMotor(2, Drive(Direction.REVERSE, 100)))
    client.drain()
    assert harness.board.motors[1].speed == 100


# --- Echo -------------------------------------------------------------------------------


@pytest.mark.parametrize("echo", [True, False])
def test_rs232_side_is_detected_by_its_echo(board: Board, *, echo: bool) -> None:
    harness = SessionHarness(board, echo=echo)
    client = harness.client()
    client.echo = not echo
    assert client.detect_echo() is echo
    assert client.echo is echo
    assert set(harness.transport.sent) == {0xFF}


def test_echo_detection_ignores_old_bytes(harness: SessionHarness) -> None:
    harness.line.inject(b"\xff\xff")
    harness.line.advance(0.1)
    assert harness.client().detect_echo() is False


def test_echo_of_motor_command_is_consumed(board: Board) -> None:
    harness = SessionHarness(board, echo=True)
    client = harness.client()
    client.request(DriveBoth(Drive.at(1), Drive.at(2)))
    assert client.request(GetSerialControl()) is True
    assert client.counters.unsolicited == 0


def test_corrupted_echo_raises_bad_reply(board: Board) -> None:
    harness = SessionHarness(board, echo=True)
    harness.line.faults.to_drop = 1
    with pytest.raises(BadReply, match="echo should be 9F 07"):
        harness.client().request(GetParameter(7))


# --- Device numbers ---------------------------------------------------------------------


@pytest.mark.parametrize(("number", "expected"), [(7, 42), (None, None)])
def test_only_expanded_protocol_uses_a_new_device_number(
    harness: SessionHarness, number: int | None, expected: int | None
) -> None:
    client = harness.client(ConnectionSettings("virtual", device_number=number))
    assert client.request(SetParameter(0, 42)) is ResultCode.OK
    assert client.settings.device_number == expected
    assert client.request(GetParameter(0)) == 42


def test_client_ignores_rejected_device_number() -> None:
    harness, _ = create_harness(mode="rc")
    client = harness.client(ConnectionSettings("virtual", device_number=7))
    assert client.request(SetParameter(0, 42)) is ResultCode.NOT_SERIAL_MODE
    assert client.request(GetParameter(0)) == 7


# --- Counters ---------------------------------------------------------------------------


def test_counters_count_requests_timeouts_and_bad_replies(harness: SessionHarness) -> None:
    client = harness.client()
    client.request(GetMode())
    harness.line.inject(b"\x00")
    harness.line.advance(0.1)
    client.request(GetMode())
    harness.board.power_off()
    harness.line.inject(b"\x00")
    with pytest.raises(BadReply):
        client.request(GetMode())
    with pytest.raises(NoReply):
        client.request(GetMode())
    counters = client.counters
    assert (counters.requests, counters.missing, counters.corrupted) == (4, 1, 1)
    assert counters.unsolicited == 1


def test_slowest_round_trip_ignores_timeouts(harness: SessionHarness) -> None:
    client = harness.client()
    client.request(GetMode())
    quick = client.counters.slowest
    assert quick == pytest.approx(client.settings.line.seconds(2))
    client.request(SetParameter(7, 5))
    slow = client.counters.slowest
    assert slow == pytest.approx(client.settings.line.seconds(6) + 0.004, abs=1e-4)
    harness.board.power_off()
    with pytest.raises(NoReply):
        client.request(SetParameter(7, 5))
    assert client.counters.slowest == slow


# --- Noise ------------------------------------------------------------------------------

REQUESTS: list[Command[object]] = [
    GetSignature(),
    GetMode(),
    GetSerialControl(),
    GetCurrents(),
    GetRawChannels(),
    GetCalibration(3),
    *(GetParameter(number) for number in (0, 1, 7, 0x0B, 0x7E)),
]


@few_examples
@given(
    seed=st.integers(0, 2**32 - 1),
    noise=st.sampled_from([0.0, 0.01, 0.1, 0.5]),
    requests=st.lists(st.sampled_from(REQUESTS), min_size=1, max_size=8),
    reply_losses=st.lists(st.integers(0, 4), min_size=8, max_size=8),
    request_losses=st.lists(st.integers(0, 3), min_size=8, max_size=8),
    echo=st.booleans(),
    number=st.sampled_from([None, 7]),
)
def test_crc_rejects_replies_with_few_corrupted_bytes(
    *,
    seed: int,
    noise: float,
    requests: list[Command[object]],
    reply_losses: list[int],
    request_losses: list[int],
    echo: bool,
    number: int | None,
) -> None:
    quiet, settings = create_harness(detection=Detection.CRC7)
    quiet.line.advance(0.1)  # every channel receives its first pulse
    expected = [quiet.client(settings).request(command) for command in requests]

    harness, _ = create_harness(detection=Detection.CRC7, echo=echo)
    harness.line.advance(0.1)
    harness.line.faults._random.seed(seed)
    harness.line.faults.noise = noise
    client = harness.client(ConnectionSettings("virtual", settings.line, device_number=number))
    faults = harness.line.faults
    losses = zip(reply_losses, request_losses, strict=True)
    for command, right, lost in zip(requests, expected, losses, strict=False):
        faults.to_drop, faults.to_drop_sent = lost
        corrupted = faults.counters["corrupted"]
        try:
            reply = client.request(command)
        except (NoReply, BadReply):
            continue
        # CRC-7 detects one or two wrong bits, and all but one in 128 of other errors.
        assert reply == right or faults.counters["corrupted"] - corrupted > 2


@few_examples
@given(garbage=st.binary(max_size=40), command=st.sampled_from(REQUESTS))
def test_client_recovers_from_unsolicited_bytes(garbage: bytes, command: Command[object]) -> None:
    harness = SessionHarness(Board(eeprom=Eeprom()))
    client = harness.client()
    harness.line.inject(garbage)
    with contextlib.suppress(NoReply, BadReply):
        client.request(command)
    harness.line.advance(0.1)
    assert client.request(GetMode()) is Mode.SERIAL_RC
