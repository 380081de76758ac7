"""Receive and send buffers of the board, and packets without a reply."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.simulator.ports import (
    NO_REPLY,
    create_board,
    exchange,
    feed,
    pass_pause,
    pop_errors,
    read_replies,
)
from tests.support.matrix import examples
from trex_gui.core.simulator.sampling import ReceiveError
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.simulator.command import simulate
from trex_gui.devices.trex.simulator.control import report
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.motors import MotorDirection
from trex_gui.devices.trex.simulator.uart import RECEIVE_BUFFER, SEND_BUFFER, SerialPort

WRITE = "AF 07 0F 55 2A"


def test_bytes_during_eeprom_write_are_handled_after_it(port: SerialPort) -> None:
    feed(port, WRITE + "9F 07 82")
    assert read_replies(port) == NO_REPLY
    pass_pause(port)
    assert read_replies(port) == "00 0F 72"
    assert port.pause == 0
    assert exchange(port, "82") == "72"


def test_response_delay_adds_to_write_time() -> None:
    port = SerialPort(create_board(uart_response_delay=1))
    feed(port, WRITE)
    assert port.pause == pytest.approx(0.005)


def test_byte_beyond_receive_buffer_latches_read_overrun(port: SerialPort) -> None:
    feed(port, WRITE)
    feed(port, "FF" * RECEIVE_BUFFER)
    assert not pop_errors(port)
    port.feed(0x82)
    assert pop_errors(port) == UartError.READ_OVERRUN
    pass_pause(port)
    assert read_replies(port) == "00"
    assert exchange(port, "82") == "72"


def test_replies_that_just_fill_send_buffer_are_sent(port: SerialPort) -> None:
    queries = "81" * 4 + "82" * 3  # replies of 28 and 3 bytes, after the reply to the write
    feed(port, WRITE + queries)
    pass_pause(port)
    assert len(read_replies(port).split()) == SEND_BUFFER
    assert not pop_errors(port)


def test_reply_bytes_beyond_send_buffer_are_lost(port: SerialPort) -> None:
    feed(port, WRITE + "81" * 5)
    pass_pause(port)
    sent = bytes.fromhex(read_replies(port))
    assert sent == (b"\0" + b"TReX1.2" * 5)[:SEND_BUFFER]
    assert pop_errors(port) == UartError.SEND_OVERRUN


def test_send_overrun_stops_motor(port: SerialPort) -> None:
    feed(port, "C2 7F")
    feed(port, WRITE + "81" * 5)
    pass_pause(port)
    assert port.board.motors[0].direction is MotorDirection.BRAKE


def test_bad_byte_during_write_discards_its_packet(port: SerialPort) -> None:
    feed(port, WRITE + "C2")
    port.feed_error(ReceiveError.FRAMING)
    feed(port, "40")
    pass_pause(port)
    assert port.board.motors[0].target_direction is MotorDirection.BRAKE
    assert UartError.FRAMING in pop_errors(port)


def test_read_overrun_discards_affected_packet(port: SerialPort) -> None:
    feed(port, WRITE + "FF" * (RECEIVE_BUFFER - 1) + "C2")
    feed(port, "10 F0")  # do not fit into the buffer
    pass_pause(port)
    feed(port, "40")  # data byte of the lost packet
    assert port.board.motors[0].target_direction is MotorDirection.BRAKE
    assert port.board.aux.speed == 0
    assert UartError.READ_OVERRUN in pop_errors(port)


def test_power_cut_empties_buffers(port: SerialPort) -> None:
    feed(port, WRITE + "81 F0")
    port.board.power_cycle()
    feed(port, "7F 82")
    assert port.pause == 0
    assert read_replies(port) == "72"
    assert port.board.aux.speed == 0


def test_board_receives_bytes_after_delayed_replies() -> None:
    line = SimulatedBoards([create_board(uart_response_delay=1)])
    line.send(b"\x82\x83")
    assert line.read(2, 1) == b"r\x01"
    line.send(b"\x82")
    assert line.read(1, 1) == b"r"


@examples(40)
@given(
    junk=st.lists(st.sampled_from(["81", "82", "FF", "90", "AF070F552A", "A0"]), max_size=60),
    delay=st.sampled_from([0, 1]),
)
def test_buffers_never_exceed_their_sizes(junk: list[str], delay: int) -> None:
    port = SerialPort(create_board(uart_response_delay=delay))
    feed(port, WRITE + "".join(junk))
    for _ in range(100):
        assert len(port.outgoing) <= SEND_BUFFER
        assert sum(byte >= 0 for byte in port._buffer) <= RECEIVE_BUFFER  # negative: a gap
        if not port.pause:
            break
        pass_pause(port)
    assert not port.pause
    read_replies(port)
    assert exchange(port, "FF 82") == "72"


# --- Packets without a reply ----------------------------------------------------------


@pytest.mark.parametrize("settings", [0x05, 0x25], ids=["plain", "crc"])
def test_null_command_of_either_protocol_needs_no_checksum(settings: int) -> None:
    port = SerialPort(create_board(settings=settings))
    assert exchange(port, "FF 80 07 7F") == NO_REPLY
    assert not pop_errors(port)


def test_packets_for_other_boards_are_counted(port: SerialPort) -> None:
    assert exchange(port, "80 08 06 1F 80 01 2F 7B 01 55 2A 80 03 04 02 01 40") == NO_REPLY
    assert report(port.board)["counters"]["packets_for_others"] == 3


def test_bad_byte_discards_its_packet(port: SerialPort) -> None:
    port.feed(0xF0)
    port.feed_error(ReceiveError.PARITY)
    assert pop_errors(port) == UartError.PARITY
    assert exchange(port, "7F") == NO_REPLY
    assert pop_errors(port) == UartError.FORMAT
    assert port.board.aux.speed == 0


def test_unpowered_board_ignores_packets(port: SerialPort) -> None:
    port.board.power_off()
    assert exchange(port, "81") == NO_REPLY
    port.feed_error(ReceiveError.FRAMING)
    port.board.power_on()
    assert not pop_errors(port)


def test_board_can_reject_packets_like_the_twin() -> None:
    """The guide of the qik 2s12v10, 5.d, describes these replies."""
    line = simulate(unknown_parameter="byte", rejected_write="error").line
    assert isinstance(line, SimulatedBoards)
    (board,) = line.boards
    port = SerialPort(board)
    assert exchange(port, "C0 20 9F 60 85") == "FF 40"
    assert board.motors[0].speed == 127, "errors stop the motors"
    assert exchange(port, "AF 60 00 55 2A 85") == "01 40"
    assert exchange(port, "AF 07 00 55 2A 85") == "00 00"
