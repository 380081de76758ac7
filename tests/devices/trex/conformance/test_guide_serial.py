"""User's Guide 5 and what else is sourced about the serial line, a test a sentence.

Sources beside the guide are named as in the reference: forum threads (F), the manual (MH), the
companion program of the maker (C-SHARP).
"""

import pytest

from tests.devices.trex.conformance.ends import LONG_TIMEOUT, WireEnd
from tests.devices.trex.conformance.trex import RATES, Trex, only
from trex_gui.devices.trex.simulator.command import DeviceOption

# 5.b, protocols


@pytest.mark.parametrize("example", ["F0 7F", "80 07 70 7F"])
def test_example_packets_set_auxiliary_motor_to_full_speed(trex: Trex, example: str) -> None:
    """User's Guide 5.b: compact and Pololu protocol."""
    trex.report(trex.signed(bytes.fromhex(example)))
    assert trex.show()["aux"]["speed"] == 127


def test_board_responds_to_both_protocols_on_the_fly(trex: Trex) -> None:
    """User's Guide 5.b: no jumper or parameter says which."""
    for packet in ("82", "80 07 02", "82", "82", "80 07 02", "80 07 02"):
        assert trex.request(trex.signed(bytes.fromhex(packet)), 1) == "72"


@pytest.mark.parametrize("number", [0, 8, 127])
def test_compact_packet_is_accepted_with_any_device_number(trex: Trex, number: int) -> None:
    """F20957: a board with number 8 answered a plain 0x81."""
    trex.set_up(device_number=number)
    assert trex.request(trex.signed(b"\x82"), 1) == "72"
    trex.device = number
    assert trex.request("82") == "72"


# 5.b, errors


def corrupt(trex: Trex, error: str) -> None:
    """Let a command that drives a motor go wrong."""
    if error == "format":
        trex.report(trex.head("C2") + b"\xff")
    elif error == "crc":
        packet = trex.packet("C2 7F")
        trex.report(packet[:-1] + bytes([packet[-1] ^ 1]))
    else:
        trex.do(f"line error {error} 1")
        trex.report(b"\xff")


ERRORS = ["format", "framing", "overrun"]


def check_the_shutdown(trex: Trex, error: str) -> None:
    trex.set_up(uart_error_shutdown=1)
    trex.report("D6 30 40", "F0 50")
    corrupt(trex, error)
    trex.wait(0.012)
    state = trex.show()
    outputs = [(motor["direction"], motor["speed"]) for motor in state["motors"]]
    assert outputs == [("brake", 127), ("brake", 127)]  # inferred: they brake fully
    assert state["aux"]["speed"] == 0


@pytest.mark.parametrize("error", ERRORS)
def test_serial_error_stops_motors_if_shutdown_is_enabled(trex: Trex, error: str) -> None:
    """User's Guide 5.b: parameter 0x08."""
    check_the_shutdown(trex, error)


@only(crc=True)
def test_crc_error_stops_motors_if_shutdown_is_enabled(trex: Trex) -> None:
    """User's Guide 5.b: "if a serial error occurs"."""
    check_the_shutdown(trex, "crc")


@pytest.mark.parametrize("error", ERRORS)
def test_serial_error_keeps_motors_if_shutdown_is_disabled(trex: Trex, error: str) -> None:
    """User's Guide 5.b."""
    trex.set_up(uart_error_shutdown=0)
    trex.report("D6 30 40", "F0 50")
    corrupt(trex, error)
    trex.wait(0.012)
    assert (trex.motor(1), trex.motor(2)) == (("forward", 0x30), ("reverse", 0x40))
    assert trex.show()["aux"]["speed"] == 0x50
    assert trex.request("85") != "00"


@pytest.mark.parametrize("error", ERRORS)
def test_board_accepts_commands_after_serial_error(trex: Trex, error: str) -> None:
    """User's Guide 5.b."""
    trex.set_up(uart_error_shutdown=1)
    corrupt(trex, error)
    assert trex.request("82") == "72"
    trex.report("C2 22")
    assert trex.motor(1) == ("forward", 0x22)
    assert trex.request("AF 0E 05 55 2A") == "00"


# 5, answers


def test_board_never_sends_unsolicited_bytes(trex: Trex) -> None:
    """User's Guide 5."""
    trex.set_up(serial_timeout=1)
    trex.report("D6 30 40", "F0 50", b"\x88", b"\x01\x02")
    trex.do("fault 1 on")
    assert trex.unanswered(seconds=0.13)
    trex.restart()
    assert trex.unanswered()


def test_null_command_has_no_reply_and_no_effect(trex: Trex) -> None:
    """C-SHARP. Inferred: that it raises no error."""
    trex.report("D6 30 40")
    assert trex.unanswered(b"\xff" * 20)
    assert (trex.motor(1), trex.motor(2)) == (("forward", 0x30), ("reverse", 0x40))
    assert trex.request("84") == "00"


@only(end="wire")
@pytest.mark.parametrize("baud", [19200, 115200])
def test_bytes_sent_during_a_reply_are_lost(trex: Trex, baud: int) -> None:
    """User's Guide 5: bytes sent meanwhile are lost."""
    trex.run_at(baud)
    for missed in ("82", "C2 7F"):
        signature = trex.everything("81", missed)
        assert len(signature) == 7 + trex.variant.crc
    assert trex.motor(1) == ("brake", 0)
    assert trex.request("82") == "72"


# 5.a, the line. Neither protocol nor CRC has to do with rates, a CRC only proves the bytes.


@only(end="wire")
def test_new_board_uses_19200_baud_without_error_detection(trex: Trex) -> None:
    """User's Guide 5.a."""
    trex.do("factory")
    trex.host_at(19200)
    assert trex.everything(b"\x82") == b"r"
    assert trex.everything(b"\x80\x07\x01") == b"TReX1.2"


@only(end="wire", expanded=False, crc=True)
@pytest.mark.parametrize("baud", [1200, 9600, 14400, 19200, 28800, 38400, 57600, 115200])
def test_board_runs_at_each_of_its_baud_rates(trex: Trex, baud: int) -> None:
    """User's Guide 5.a: 1200 to 115200 baud. Only the sourced rates are tested."""
    trex.run_at(baud)
    assert trex.request("82") == "72"
    assert trex.show()["active_uart"]["baud"] == baud


@only(end="wire", expanded=False, crc=True, firmware="1.0")
@pytest.mark.parametrize(("chosen", "real"), [(38400, 19200), (28800, 14400)])
def test_old_firmware_halves_two_baud_rates(trex: Trex, chosen: int, real: int) -> None:
    """F1491."""
    trex.run_at(chosen)
    assert trex.everything("82")[:1] != b"r"
    trex.run_at(chosen)
    trex.host_at(real)
    assert trex.request("82") == "72"


@only(end="wire", expanded=False, crc=True, firmware="1.0")
@pytest.mark.parametrize("baud", [rate for rate in RATES[3:] if rate not in {28800, 38400}])
def test_old_firmware_keeps_all_other_baud_rates(trex: Trex, baud: int) -> None:
    """F1491."""
    trex.run_at(baud)
    assert trex.request("82") == "72"


# Response delay


@only(firmware="1.2")
def test_response_delay_holds_replies_back_for_1_ms(trex: Trex) -> None:
    """F1491: for slow hosts."""
    assert trex.request("AF 17 01 55 2A") == "00"
    assert trex.request("9F 17") == "01"
    trex.request("82")
    assert trex.took == pytest.approx(0.001)


@only(firmware="1.2")
def test_replies_without_response_delay_come_at_once(trex: Trex) -> None:
    """F1491: it is an option."""
    assert trex.request("AF 17 00 55 2A") == "00"
    trex.request("82")
    assert trex.took < 0.001


@only(firmware="1.0")
def test_old_firmware_has_no_parameter_17(trex: Trex) -> None:
    """F1491 and a client's list. Inferred: the code is that of a bad number."""
    assert trex.request("AF 17 01 55 2A") == "01"


# RS-232, and several boards


@only(end="wire", echo=True)
def test_rs_232_echoes_everything_sent(trex: Trex) -> None:
    """MH 15. The answer follows."""
    query, drive = trex.packet("82"), trex.packet("C2 20")
    assert trex.everything(drive) == drive
    reply = trex.everything(query)
    assert reply[: len(query) + 1] == query + b"r"
    assert len(reply) == len(query) + 1 + trex.variant.crc


@only(end="wire", echo=True)
def test_null_command_is_echoed_on_rs_232(trex: Trex) -> None:
    """C-SHARP: reading 0xFF back means RS-232."""
    assert trex.everything(b"\xff") == b"\xff"


@pytest.fixture
def chain() -> WireEnd:
    """Three boards on one line, one of them a TReX Jr."""
    return WireEnd(devices=[DeviceOption(7), DeviceOption(9, "trexjr"), DeviceOption(127)])


@pytest.mark.parametrize(
    ("packet", "answer"),
    [
        (b"\x80\x07\x01", b"TReX1.2"),
        (b"\x80\x09\x01", b"TReXJr1.2"),
        (b"\x80\x7f\x1f\x00", b"\x7f"),
        (b"\x80\x08\x01", b""),
    ],
)
def test_only_board_with_the_device_number_replies(
    chain: WireEnd, packet: bytes, answer: bytes
) -> None:
    """User's Guide 5.b: "all other Pololu devices will ignore the command".

    At the wire alone: in the parser there is one board. CRC has no part in it.
    """
    chain.write(packet)
    assert chain.read(len(answer), LONG_TIMEOUT) + chain.read(1, 0.1) == answer


def test_packets_for_several_boards_cause_no_errors(chain: WireEnd) -> None:
    """User's Guide 5.b: "without confusing the other devices on the line"."""
    for motor_speed in (0x10, 0x7F):
        chain.write(bytes([0x80, 0x07, 0x70, motor_speed]))
        chain.write(bytes([0x80, 0x09, 0x42, motor_speed]))
    for number in (0x07, 0x09, 0x7F):
        chain.write(bytes([0x80, number, 0x04]))
        assert chain.read(1, LONG_TIMEOUT) == b"\x00"
