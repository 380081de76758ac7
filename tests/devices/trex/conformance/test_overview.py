"""Each sentence of CMD10 General Overview and 0x80."""

import pytest

from tests.devices.trex.conformance.trex import Trex, calibration, documented_size

QUERIES = (
    "81", "82", "83", "84", "85", "86 1F", "87 1F", "8D", "8E", "8F",
    "90", "91", "92", "93", "94", "95", "9F 00",
)  # fmt: skip

PARAMETER = "AF 0E 05 55 2A"
"""Packet that sets the acceleration of motor 1 to 5."""

CALIBRATIONS = [calibration(channel, 2532, 3750, 5032, 32) for channel in range(1, 6)]

MOTOR_COMMANDS = [
    *(f"{command:02X} 20" for command in range(0xC0, 0xD0)),
    *(f"{command:02X} 20 20" for command in range(0xD0, 0xF0)),
    *("F0 20", "F1 20"),
]


def test_bytes_without_top_bit_are_not_commands(trex: Trex) -> None:
    """CMD10 General Overview: commands are 128 - 255."""
    assert trex.gets_no_reply(b"\x01", b"\x02", b"\x7f")
    assert len(trex.request("81")) == 7 * 3 - 1


def test_each_reply_has_its_documented_size(trex: Trex) -> None:
    """CMD10 0x81 - 0x9F: each command names the size of its reply. A CRC follows the reply."""
    for query in QUERIES:
        reply = trex.exchange(query)
        assert len(reply) == documented_size(query, trex.variant) + trex.variant.crc, query


@pytest.mark.parametrize("mode", ["serial", "rc", "analog"])
def test_queries_are_answered_in_every_mode(trex: Trex, mode: str) -> None:
    """CMD10 General Overview: 0x81 - 0x9F."""
    trex.restart_in(mode)
    for query in QUERIES:
        assert trex.request(query), query
    assert trex.request("85") == "00"


@pytest.mark.parametrize("mode", ["rc", "analog"])
def test_set_commands_are_rejected_outside_serial_mode(trex: Trex, mode: str) -> None:
    """CMD10 General Overview: 0xA0 - 0xAF. The result code is from CMD10 0xA0 and 0xAF."""
    trex.restart_in(mode)
    queries = ("90", "91", "92", "93", "94", "9F 0E")
    before = [trex.request(query) for query in queries]
    assert trex.request(PARAMETER) == "03"
    assert [trex.request(packet) for packet in CALIBRATIONS] == ["03"] * 5
    assert [trex.request(query) for query in queries] == before


@pytest.mark.parametrize("mode", ["serial", "rc", "analog"])
def test_motor_commands_have_no_reply_in_any_mode(trex: Trex, mode: str) -> None:
    """CMD10 General Overview: 0xC0 - 0xF1."""
    trex.restart_in(mode)
    assert trex.gets_no_reply(*MOTOR_COMMANDS)
    assert trex.request("84") == "00"


@pytest.mark.parametrize("mode", ["rc", "analog"])
def test_motors_ignore_commands_without_serial_control(trex: Trex, mode: str) -> None:
    """CMD10 General Overview: "only respond in serial mode or when serial override is active"."""
    trex.start(mode)
    trex.send("D6 30 40", "F0 50")
    trex.wait(0.03)
    assert trex.motor(1)[0] == trex.motor(2)[0] == "brake"
    assert trex.show()["aux"] == {"speed": 0, "target_speed": 0}


@pytest.mark.parametrize(("mode", "low"), [("rc", "1000us"), ("analog", "0.5V")])
def test_motors_respond_during_serial_override(trex: Trex, mode: str, low: str) -> None:
    """CMD10 General Overview. Low channel 5 starts serial override (User's Guide 4.a)."""
    trex.start(mode)
    trex.connect(c5=low)
    trex.send("D6 30 40", "F0 50")
    assert trex.outputs() == [("forward", 0x30), ("reverse", 0x40), 0x50]


def test_channels_control_motors_after_serial_override(trex: Trex) -> None:
    """CMD10 General Overview: motors only respond "when serial override is active"."""
    trex.start("rc")
    trex.connect(c5="1000us")
    trex.send("D6 30 40")
    trex.connect(c5="1500us")
    assert trex.request_byte("83") == 0
    assert trex.motor(1)[0] == trex.motor(2)[0] == "brake"


@pytest.mark.parametrize("number", [0, 6, 8, 127])
def test_packet_for_other_device_number_is_ignored(trex: Trex, number: int) -> None:
    """CMD10 0x80: "can be chained along with such products to the same serial line".

    Inferred: a packet for another board causes no error, even if it is long.
    """
    head = bytes([0x80, number])
    assert trex.gets_no_reply(
        trex.add_crc(head + b"\x02"),
        trex.add_crc(head + b"\x06\x1f"),
        trex.add_crc(head + b"\x42\x7f"),
        head + b"\x11\x22\x33\x44\x55\x66\x77",
    )
    assert trex.motor(1)[1] == 0
    assert trex.request("84") == "00"
