"""CMD10 0x85, sentence by sentence."""

import pytest

from tests.devices.trex.conformance.trex import Trex, calibration, only

KNOWN = {
    *range(0x80, 0x88), *range(0x8D, 0x96), 0x9F, *range(0xA0, 0xA5), 0xAF, *range(0xC0, 0xF2),
    0xFF,  # the null command (companion program of the maker)
}  # fmt: skip

CALIBRATION = calibration(1, 2532, 3750, 5032, 32)

EVEN, ODD = 0x40, 0x60
"""In UART settings; inferred, from the bits of the board's processor."""


def wrong_crc(trex: Trex, text: str) -> bytes:
    packet = trex.packet(text)
    return packet[:-1] + bytes([packet[-1] ^ 0x01])


def test_host_waiting_for_replies_causes_no_overrun(trex: Trex) -> None:
    """CMD10 0x85: "so long as you don't transmit" before the data has come, it is fine."""
    for _ in range(5):
        for query in ("81", "86 1F", "87 1F", "8F", "90"):
            trex.request(query)
    for acceleration in (1, 2, 3):
        assert trex.request(f"AF 0E {acceleration:02X} 55 2A") == "00"
        assert trex.request(CALIBRATION) == "00"
        trex.report("C2 10", "CA 10", "F0 10")
    assert trex.request("85") == "00"


def test_impatient_host_overruns_read_and_send_buffer(trex: Trex) -> None:
    """CMD10 0x85: bits 1 and 0.

    Inferred: that it takes no more than 400 bytes, and answers to them, during a write.
    """
    flood = trex.packet("81") * (400 // len(trex.packet("81")))
    trex.everything(trex.packet(CALIBRATION) + flood)
    trex.everything(b"\xff")  # ends what may have been cut
    assert trex.number("85") & 0x03 == 0x03


@pytest.mark.parametrize(
    ("name", "bit"), [("framing", 0x10), ("overrun", 0x08)], ids=["frame error", "data overrun"]
)
def test_uart_hardware_error_sets_its_bit(trex: Trex, name: str, bit: int) -> None:
    """CMD10 0x85: bits 4 and 3, "passed on to the user via the UART error byte"."""
    trex.do(f"line error {name} 1")
    trex.report(b"\xff")
    assert trex.request("84") == "01"
    assert trex.number("85") == bit


# Parity and CRC exclude each other (User's Guide 5.a), and only a UART sees parity.
@only(end="wire", crc=False)
@pytest.mark.parametrize("parity", [EVEN, ODD], ids=["even", "odd"])
def test_parity_mismatch_sets_parity_error(trex: Trex, parity: int) -> None:
    """CMD10 0x85: bit 2. The parity of the host is always that of the board."""
    trex.run_at(115200, parity)
    assert trex.request("85") == "00"
    trex.do("line error parity 1")
    trex.report(b"\xff")
    assert trex.request("85") == "04"


@only(end="wire")  # only a UART can tell what is a parity error
def test_no_parity_error_occurs_without_parity(trex: Trex) -> None:
    """CMD10 0x85."""
    trex.do("line error parity 1")
    trex.report(b"\xff")
    assert trex.request("85") == "00"


@only(crc=True)
def test_crc_mismatch_sets_crc_error(trex: Trex) -> None:
    """CMD10 0x85: bit 5."""
    assert trex.unanswered(wrong_crc(trex, "86 1F"))
    assert trex.request("84") == "01"
    assert trex.request("85") == "20"


@only(crc=True)
def test_packet_with_crc_error_is_discarded(trex: Trex) -> None:
    """CMD10 0x85: "discarded as untrustworthy"."""
    assert trex.unanswered(
        wrong_crc(trex, "81"),
        wrong_crc(trex, "C2 7F"),
        wrong_crc(trex, "F0 7F"),
        wrong_crc(trex, "AF 0E 05 55 2A"),
    )
    assert trex.motor(1)[0] == "brake"
    assert trex.show()["aux"]["speed"] == 0
    assert trex.request("9F 0E") == "00"


@only(crc=True)
def test_packet_without_crc_is_not_executed(trex: Trex) -> None:
    """CMD10 General Overview: the CRC "must be tacked onto the end of every command packet"."""
    assert trex.unanswered(trex.head("81"))
    assert trex.request("85") == "40"  # inferred: the question broke off the one that waits


def test_crc_error_occurs_only_if_crc_is_enabled(trex: Trex) -> None:
    """CMD10 0x85: "when you have enabled cyclic-redundancy checking"."""
    trex.report(trex.head("F0 10"), b"\x55\x2a")  # a wrong CRC, or two bytes of nonsense
    assert bool(trex.number("85") & 0x20) is trex.variant.crc


def test_unknown_command_is_a_format_error(trex: Trex) -> None:
    """CMD10 0x85: cause 1."""
    for command in sorted(set(range(0x80, 0x100)) - KNOWN):
        trex.report(trex.head(f"{command:02X}"))
        assert trex.request("85") == "40", f"{command:02X}"


def test_command_byte_inside_packet_is_a_format_error(trex: Trex) -> None:
    """CMD10 0x85: cause 2."""
    for begun in ("86", "AF 0E 05", "D6 30", "F0"):
        trex.report(trex.head(begun))
        assert trex.request("85") == "40", begun  # its first byte is that command byte
    assert trex.request("9F 0E") == "00"
    assert trex.motor(1)[0] == "brake"
    assert trex.show()["aux"]["speed"] == 0


def test_invalid_data_byte_is_a_format_error(trex: Trex) -> None:
    """CMD10 0x85: cause 3.

    Inferred for 0x86, 0x87 and 0x9F: that channels 6 and 7 and parameter numbers that do not
    exist are "illogical"; wrong format bytes are said to be (0xA0, 0xAF).
    """
    for bad in (
        "86 20", "87 40", "9F 18", "9F 7A", "AF 0E 05 2A 55", "AF 0E 05 55 00",
        CALIBRATION.replace("55 2A", "2A 55"),
    ):  # fmt: skip
        assert trex.unanswered(bad), bad
        assert trex.request("85") == "40", bad


def test_serial_timeout_stops_motors_and_sets_its_bit(trex: Trex) -> None:
    """CMD10 0x85: bit 7. The unit of 100 ms is that of two clients, see trex.md."""
    assert trex.request("AF 07 01 55 2A") == "00"
    trex.report("DA 20 20", "F0 20")
    trex.wait(0.13)
    state = trex.show()
    assert [motor["direction"] for motor in state["motors"]] == ["brake", "brake"]
    assert state["aux"]["speed"] == 0
    assert trex.request("84") == "01"
    assert trex.request("85") == "80"


def test_timely_packets_prevent_serial_timeout(trex: Trex) -> None:
    """CMD10 0x85: "too much time goes by between TReX serial receptions"."""
    assert trex.request("AF 07 02 55 2A") == "00"
    trex.report("DA 20 20")
    for _ in range(3):  # longer in all than the timeout of 200 ms
        trex.wait(0.08)
        trex.request("82")
    assert (trex.motor(1), trex.motor(2)) == (("forward", 0x20), ("forward", 0x20))
    assert trex.request("85") == "00"


def test_timeout_parameter_0_disables_serial_timeout(trex: Trex) -> None:
    """CMD10 0x85."""
    assert trex.request("AF 07 00 55 2A") == "00"
    trex.report("DA 20 20")
    trex.wait(0.15)  # one count of the parameter is 100 ms
    assert trex.motor(1) == ("forward", 0x20)
    assert trex.request("85") == "00"


def test_uart_error_bits_are_latched_until_read(trex: Trex) -> None:
    """CMD10 0x85: "latched"."""
    trex.do("line error framing 1")
    trex.report(b"\xff")
    trex.report(b"\x88")
    for query in ("81", "82", "83", "84", "84", "86 1F", "87 1F", "8F", "95", "9F 00"):
        trex.request(query)
    assert trex.request("85") == "50"


def test_reading_uart_error_byte_clears_all_its_bits(trex: Trex) -> None:
    """CMD10 0x85."""
    trex.do("line error framing 1")
    trex.do("line error overrun 1")
    trex.report(b"\xff\xff")
    trex.report(b"\x88")
    assert trex.request("85") == "58"
    assert trex.request("85") == "00"
