"""UART error byte: each sentence of CMD10 0x85."""

import pytest

from tests.devices.trex.conformance.trex import Trex, calibration, only

KNOWN = {
    *range(0x80, 0x88), *range(0x8D, 0x96), 0x9F, *range(0xA0, 0xA5), 0xAF, *range(0xC0, 0xF2),
    0xFF,  # the null command (companion program of the vendor)
}  # fmt: skip

CALIBRATION = calibration(1, 2532, 3750, 5032, 32)

EVEN, ODD = 0x40, 0x60
"""Bits of UART settings for parity. Inferred from the processor of the board."""


def wrong_crc(trex: Trex, text: str) -> bytes:
    packet = trex.packet(text)
    return packet[:-1] + bytes([packet[-1] ^ 0x01])


def test_host_waiting_for_replies_causes_no_overrun(trex: Trex) -> None:
    """CMD10 0x85: no overrun occurs "so long as you don't transmit" before the reply."""
    for _ in range(5):
        for query in ("81", "86 1F", "87 1F", "8F", "90"):
            trex.request(query)
    for acceleration in (1, 2, 3):
        assert trex.request(f"AF 0E {acceleration:02X} 55 2A") == "00"
        assert trex.request(CALIBRATION) == "00"
        trex.send("C2 10", "CA 10", "F0 10")
    assert trex.request("85") == "00"


def test_impatient_host_overruns_read_and_send_buffer(trex: Trex) -> None:
    """CMD10 0x85: bits 1 and 0.

    Inferred: during a write, the buffers have no space for 400 bytes and their replies.
    """
    flood = trex.packet("81") * (400 // len(trex.packet("81")))
    trex.exchange(trex.packet(CALIBRATION) + flood)
    trex.exchange(b"\xff")  # ends an incomplete packet
    assert trex.request_byte("85") & 0x03 == 0x03


@pytest.mark.parametrize(
    ("name", "bit"), [("framing", 0x10), ("overrun", 0x08)], ids=["frame error", "data overrun"]
)
def test_uart_hardware_error_sets_its_bit(trex: Trex, name: str, bit: int) -> None:
    """CMD10 0x85: bits 4 and 3, "passed on to the user via the UART error byte"."""
    trex.control(f"line error {name} 1")
    trex.send(b"\xff")
    assert trex.request("84") == "01"
    assert trex.request_byte("85") == bit


# Parity and CRC exclude each other (User's Guide 5.a), and the parser does not receive parity.
@only(harness="wire", crc=False)
@pytest.mark.parametrize("parity", [EVEN, ODD], ids=["even", "odd"])
def test_parity_mismatch_sets_parity_error(trex: Trex, parity: int) -> None:
    """CMD10 0x85: bit 2. The parity of the host is always that of the board."""
    trex.set_baud(115200, parity)
    assert trex.request("85") == "00"
    trex.control("line error parity 1")
    trex.send(b"\xff")
    assert trex.request("85") == "04"


@only(harness="wire")  # the parser does not receive parity
def test_no_parity_error_occurs_without_parity(trex: Trex) -> None:
    """CMD10 0x85."""
    trex.control("line error parity 1")
    trex.send(b"\xff")
    assert trex.request("85") == "00"


@only(crc=True)
def test_crc_mismatch_sets_crc_error(trex: Trex) -> None:
    """CMD10 0x85: bit 5."""
    assert trex.gets_no_reply(wrong_crc(trex, "86 1F"))
    assert trex.request("84") == "01"
    assert trex.request("85") == "20"


@only(crc=True)
def test_packet_with_crc_error_is_discarded(trex: Trex) -> None:
    """CMD10 0x85: "discarded as untrustworthy"."""
    assert trex.gets_no_reply(
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
    assert trex.gets_no_reply(trex.frame("81"))
    assert trex.request("85") == "40"  # inferred: this request interrupts the incomplete packet


def test_crc_error_occurs_only_if_crc_is_enabled(trex: Trex) -> None:
    """CMD10 0x85: "when you have enabled cyclic-redundancy checking"."""
    trex.send(trex.frame("F0 10"), b"\x55\x2a")  # a wrong CRC, or two bytes outside a packet
    assert bool(trex.request_byte("85") & 0x20) is trex.variant.crc


def test_unknown_command_is_a_format_error(trex: Trex) -> None:
    """CMD10 0x85: cause 1."""
    for command in sorted(set(range(0x80, 0x100)) - KNOWN):
        trex.send(trex.frame(f"{command:02X}"))
        assert trex.request("85") == "40", f"{command:02X}"


def test_command_byte_inside_packet_is_a_format_error(trex: Trex) -> None:
    """CMD10 0x85: cause 2."""
    for incomplete in ("86", "AF 0E 05", "D6 30", "F0"):
        trex.send(trex.frame(incomplete))
        assert trex.request("85") == "40", incomplete  # 85 is the command byte inside the packet
    assert trex.request("9F 0E") == "00"
    assert trex.motor(1)[0] == "brake"
    assert trex.show()["aux"]["speed"] == 0


def test_invalid_data_byte_is_a_format_error(trex: Trex) -> None:
    """CMD10 0x85: cause 3.

    The documents say this of wrong format bytes (0xA0, 0xAF). Inferred: channels 6 and 7 and
    unknown parameter numbers are also "illogical" (0x86, 0x87, 0x9F).
    """
    for packet in (
        "86 20", "87 40", "9F 18", "9F 7A", "AF 0E 05 2A 55", "AF 0E 05 55 00",
        CALIBRATION.replace("55 2A", "2A 55"),
    ):  # fmt: skip
        assert trex.gets_no_reply(packet), packet
        assert trex.request("85") == "40", packet


def test_serial_timeout_stops_motors_and_sets_its_bit(trex: Trex) -> None:
    """CMD10 0x85: bit 7. The unit of 100 ms is from two clients (see trex.md)."""
    assert trex.request("AF 07 01 55 2A") == "00"
    trex.send("DA 20 20", "F0 20")
    trex.wait(0.13)
    state = trex.show()
    assert [motor["direction"] for motor in state["motors"]] == ["brake", "brake"]
    assert state["aux"]["speed"] == 0
    assert trex.request("84") == "01"
    assert trex.request("85") == "80"


def test_timely_packets_prevent_serial_timeout(trex: Trex) -> None:
    """CMD10 0x85: "too much time goes by between TReX serial receptions"."""
    assert trex.request("AF 07 02 55 2A") == "00"
    trex.send("DA 20 20")
    for _ in range(3):  # 240 ms, but the timeout is 200 ms
        trex.wait(0.08)
        trex.request("82")
    assert (trex.motor(1), trex.motor(2)) == (("forward", 0x20), ("forward", 0x20))
    assert trex.request("85") == "00"


def test_timeout_parameter_0_disables_serial_timeout(trex: Trex) -> None:
    """CMD10 0x85."""
    assert trex.request("AF 07 00 55 2A") == "00"
    trex.send("DA 20 20")
    trex.wait(0.15)  # longer than the shortest timeout of 100 ms
    assert trex.motor(1) == ("forward", 0x20)
    assert trex.request("85") == "00"


def test_uart_error_bits_are_latched_until_read(trex: Trex) -> None:
    """CMD10 0x85: "latched". Reading clears all bits."""
    trex.control("line error framing 1")
    trex.send(b"\xff")
    trex.send(b"\x88")
    for query in ("81", "82", "83", "84", "84", "86 1F", "87 1F", "8F", "95", "9F 00"):
        trex.request(query)
    assert trex.request("85") == "50"
    assert trex.request("85") == "00"
