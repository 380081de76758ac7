"""Serial line: each sentence of User's Guide 5, and facts of other sources."""

import pytest

from tests.devices.trex.conformance.harnesses import LONG_TIMEOUT, WireHarness
from tests.devices.trex.conformance.trex import RATES, Trex, only
from trex_gui.devices.trex.simulator.command import DeviceOption

# 5.b: protocols


def test_board_responds_to_both_protocols_in_turn(trex: Trex) -> None:
    """User's Guide 5.b. No jumper or parameter selects the protocol."""
    for packet in ("82", "80 07 02", "82", "82", "80 07 02", "80 07 02"):
        assert trex.request(trex.add_crc(bytes.fromhex(packet)), 1) == "72"


@pytest.mark.parametrize("number", [0, 8, 127])
def test_compact_packet_is_accepted_with_any_device_number(trex: Trex, number: int) -> None:
    """F20957: a board with the number 8 replied to 0x81."""
    trex.set_parameters(device_number=number)
    assert trex.request(trex.add_crc(b"\x82"), 1) == "72"
    trex.device = number
    assert trex.request("82") == "72"


# 5.b: errors


def cause_error(trex: Trex, error: str) -> None:
    """Send a corrupted command."""
    if error == "format":
        trex.send(trex.frame("C2") + b"\xff")
    elif error == "crc":
        packet = trex.packet("C2 7F")
        trex.send(packet[:-1] + bytes([packet[-1] ^ 1]))
    else:
        trex.control(f"line error {error} 1")
        trex.send(b"\xff")


ERRORS = ["format", "framing", "overrun"]


def assert_error_stops_motors(trex: Trex, error: str, *, shutdown: bool) -> None:
    """Check that an error stops the motors only if the shutdown is enabled."""
    trex.set_parameters(uart_error_shutdown=int(shutdown))
    trex.send("D6 30 40", "F0 50")
    cause_error(trex, error)
    trex.wait(0.012)
    stopped = [("brake", 127), ("brake", 127), 0]  # inferred: motors brake fully
    assert trex.outputs() == (stopped if shutdown else [("forward", 0x30), ("reverse", 0x40), 0x50])
    assert trex.request("85") != "00"


@pytest.mark.parametrize("error", ERRORS)
@pytest.mark.parametrize("shutdown", [True, False])
def test_serial_error_stops_motors_only_if_shutdown_is_enabled(
    trex: Trex, error: str, *, shutdown: bool
) -> None:
    """User's Guide 5.b: parameter 0x08."""
    assert_error_stops_motors(trex, error, shutdown=shutdown)


@only(crc=True)
@pytest.mark.parametrize("shutdown", [True, False])
def test_crc_error_stops_motors_only_if_shutdown_is_enabled(trex: Trex, *, shutdown: bool) -> None:
    """User's Guide 5.b: "if a serial error occurs"."""
    assert_error_stops_motors(trex, "crc", shutdown=shutdown)


@pytest.mark.parametrize("error", ERRORS)
def test_board_accepts_commands_after_serial_error(trex: Trex, error: str) -> None:
    """User's Guide 5.b."""
    trex.set_parameters(uart_error_shutdown=1)
    cause_error(trex, error)
    assert trex.request("82") == "72"
    trex.send("C2 22")
    assert trex.motor(1) == ("forward", 0x22)
    assert trex.request("AF 0E 05 55 2A") == "00"


# 5: replies


def test_board_never_sends_unsolicited_bytes(trex: Trex) -> None:
    """User's Guide 5."""
    trex.set_parameters(serial_timeout=1)
    trex.send("D6 30 40", "F0 50", b"\x88", b"\x01\x02")
    trex.control("fault 1 on")
    assert trex.gets_no_reply(seconds=0.13)
    trex.restart()
    assert trex.gets_no_reply()


def test_null_command_has_no_reply_and_no_effect(trex: Trex) -> None:
    """C-SHARP. Inferred: it causes no error."""
    trex.send("D6 30 40")
    assert trex.gets_no_reply(b"\xff" * 20)
    assert (trex.motor(1), trex.motor(2)) == (("forward", 0x30), ("reverse", 0x40))
    assert trex.request("84") == "00"


@only(harness="wire")
@pytest.mark.parametrize("baud", [19200, 115200])
def test_bytes_sent_during_a_reply_are_lost(trex: Trex, baud: int) -> None:
    """User's Guide 5: bytes sent during a reply are lost."""
    trex.set_baud(baud)
    for missed in ("82", "C2 7F"):
        signature = trex.exchange("81", missed)
        assert len(signature) == 7 + trex.variant.crc
    assert trex.motor(1) == ("brake", 0)
    assert trex.request("82") == "72"


# 5.a: the line. Protocol and CRC do not affect the rate. The CRC only verifies the bytes.


@only(harness="wire")
def test_new_board_uses_19200_baud_without_error_detection(trex: Trex) -> None:
    """User's Guide 5.a."""
    trex.control("factory")
    trex.set_host_baud(19200)
    assert trex.exchange(b"\x82") == b"r"
    assert trex.exchange(b"\x80\x07\x01") == b"TReX1.2"


@only(harness="wire", expanded=False, crc=True)
@pytest.mark.parametrize("baud", [1200, 9600, 14400, 19200, 28800, 38400, 57600, 115200])
def test_board_runs_at_each_of_its_baud_rates(trex: Trex, baud: int) -> None:
    """User's Guide 5.a: 1200 to 115200 baud. Only the sourced rates are tested."""
    trex.set_baud(baud)
    assert trex.request("82") == "72"
    assert trex.show()["active_uart"]["baud"] == baud


@only(harness="wire", expanded=False, crc=True, firmware="1.0")
@pytest.mark.parametrize(("selected", "real"), [(38400, 19200), (28800, 14400)])
def test_old_firmware_halves_two_baud_rates(trex: Trex, selected: int, real: int) -> None:
    """The source is F1491."""
    trex.set_baud(selected)
    assert trex.exchange("82")[:1] != b"r"
    trex.set_baud(selected)
    trex.set_host_baud(real)
    assert trex.request("82") == "72"


@only(harness="wire", expanded=False, crc=True, firmware="1.0")
@pytest.mark.parametrize("baud", [rate for rate in RATES[3:] if rate not in {28800, 38400}])
def test_old_firmware_runs_at_all_other_baud_rates(trex: Trex, baud: int) -> None:
    """The source is F1491."""
    trex.set_baud(baud)
    assert trex.request("82") == "72"


# Response delay


@only(firmware="1.2")
@pytest.mark.parametrize("milliseconds", [0, 1])
def test_response_delay_delays_replies_by_1_ms(trex: Trex, milliseconds: int) -> None:
    """F1491: the delay is an option for slow hosts."""
    assert trex.request(f"AF 17 0{milliseconds} 55 2A") == "00"
    assert trex.request_byte("9F 17") == milliseconds
    trex.request("82")
    assert trex.reply_delay == pytest.approx(milliseconds / 1000)


@only(firmware="1.0")
def test_old_firmware_has_no_parameter_17(trex: Trex) -> None:
    """F1491 and the list of a client. Inferred: the result code is 1, a bad number."""
    assert trex.request("AF 17 01 55 2A") == "01"


# RS-232, and several boards


@only(harness="wire", echo=True)
def test_rs_232_echoes_everything_sent(trex: Trex) -> None:
    """MH 15. The reply follows the echo. C-SHARP: reading 0xFF back means RS-232."""
    query, drive = trex.packet("82"), trex.packet("C2 20")
    assert trex.exchange(drive) == drive
    assert trex.exchange(b"\xff") == b"\xff"
    reply = trex.exchange(query)
    assert reply[: len(query) + 1] == query + b"r"
    assert len(reply) == len(query) + 1 + trex.variant.crc


@pytest.fixture
def chain() -> WireHarness:
    """Line with three boards: 7, 9 (a TReX Jr) and 127."""
    return WireHarness(devices=[DeviceOption(7), DeviceOption(9, "trexjr"), DeviceOption(127)])


@pytest.mark.parametrize(
    ("packet", "reply"),
    [
        (b"\x80\x07\x01", b"TReX1.2"),
        (b"\x80\x09\x01", b"TReXJr1.2"),
        (b"\x80\x7f\x1f\x00", b"\x7f"),
        (b"\x80\x08\x01", b""),
    ],
)
def test_only_board_with_the_device_number_replies(
    chain: WireHarness, packet: bytes, reply: bytes
) -> None:
    """User's Guide 5.b: "all other Pololu devices will ignore the command"."""
    chain.write(packet)
    assert chain.read(len(reply), LONG_TIMEOUT) + chain.read(1, 0.1) == reply


def test_packets_for_several_boards_cause_no_errors(chain: WireHarness) -> None:
    """User's Guide 5.b: "without confusing the other devices on the line"."""
    for motor_speed in (0x10, 0x7F):
        chain.write(bytes([0x80, 0x07, 0x70, motor_speed]))
        chain.write(bytes([0x80, 0x09, 0x42, motor_speed]))
    for number in (0x07, 0x09, 0x7F):
        chain.write(bytes([0x80, number, 0x04]))
        assert chain.read(1, LONG_TIMEOUT) == b"\x00"
