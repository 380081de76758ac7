"""TReX under test. Tests write packets as the documents print them, in every variant."""

import json
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

import pytest

from tests.devices.trex.conformance.harnesses import LONG_TIMEOUT, Harness
from tests.devices.trex.oracle.framing import remainder

SILENCE = 0.02
"""Seconds after which no reply is expected, unless the documents name another time."""

RATES = [1200, 2400, 4800, 9600, 14400, 19200, 28800, 38400, 57600, 76800, 115200]
"""Baud rates in the order of their codes in UART settings (0x7E)."""

WITH_CRC = 0x20
"""Bit of UART settings that enables CRC-7 (User's Guide 5.e)."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Variant:
    """Board and connection with which a test runs."""

    harness: str
    expanded: bool
    crc: bool
    model: str = "trex"
    firmware: str = "1.2"
    echo: bool = False

    def __str__(self) -> str:
        protocol = "expanded" if self.expanded else "compact"
        return f"{self.harness}-{protocol}-{'crc' if self.crc else 'plain'}"


VARIANTS = [
    Variant(harness=harness, expanded=expanded, crc=crc)
    for harness, expanded, crc in product(("parser", "wire"), (False, True), (False, True))
]


def mark_slow(variants: Sequence[Variant]) -> list[Any]:
    """Mark half of the combinations of traits as slow. The gate still has each pair of traits."""
    slow = [(each.harness == "wire") ^ each.expanded ^ each.crc for each in variants]
    return [
        pytest.param(variant, marks=pytest.mark.slow) if is_slow and not all(slow) else variant
        for variant, is_slow in zip(variants, slow, strict=True)
    ]


def only(
    *,
    harness: str = "",
    expanded: bool | None = None,
    crc: bool | None = None,
    model: str = "trex",
    firmware: str = "1.2",
    echo: bool = False,
) -> pytest.MarkDecorator:
    """Run a test only in the variants with these traits, by default with a TReX 1.2."""
    variants = [
        replace(variant, model=model, firmware=firmware, echo=echo)
        for variant in VARIANTS
        if harness in {"", variant.harness}
        and expanded in {None, variant.expanded}
        and crc in {None, variant.crc}
    ]
    return pytest.mark.parametrize("trex", mark_slow(variants), ids=str, indirect=True)


def hex_text(data: bytes) -> str:
    """Return bytes as the documents print them."""
    return data.hex(" ").upper()


def two_byte_values(reply: str) -> list[int]:
    """Return two-byte values whose low byte is first."""
    data = bytes.fromhex(reply)
    return [low | high << 8 for low, high in zip(data[::2], data[1::2], strict=True)]


def channels(mask: int) -> list[int]:
    """Return the channels in a mask. Bit n is channel n+1."""
    return [bit + 1 for bit in range(5) if mask & 1 << bit]


def calibration(channel: int, *values: int) -> str:
    """Return the packet that sets minimum, neutral, maximum and deadband of a channel.

    Inferred: low and high byte have seven bits each, because a data byte has no eighth bit.
    """
    data = bytes(part for value in values for part in (value & 0x7F, value >> 7))
    return f"{0xA0 + channel - 1:02X} {hex_text(data)} 55 2A"


class Trex:
    """Board behind one of the two harnesses, in one protocol, with or without CRC.

    Texts are packets in hexadecimal, in the compact protocol and without CRC. They are converted to
    the variant. Bytes are sent unchanged.

    Attributes:
        device: device number in packets.
        polynomial: CRC polynomial of packets and replies.
        reply_delay: seconds from the end of the last request to the beginning of its reply.
    """

    def __init__(self, harness: Harness, variant: Variant) -> None:
        self.variant = variant
        self.device = 7
        self.polynomial = 0x89
        self.reply_delay = 0.0
        self._harness = harness
        self._sent = self._shown = (0.0, 0.0)  # begin and end of the last `send` and `show`
        self.control("factory")
        self.set_baud(115200)

    # Packets

    def frame(self, text: str) -> bytes:
        """Return a packet in the protocol of the variant, without CRC."""
        packet = bytes.fromhex(text)
        if self.variant.expanded:
            return bytes([0x80, self.device, packet[0] & 0x7F, *packet[1:]])
        return packet

    def packet(self, text: str) -> bytes:
        """Return a packet in the protocol of the variant, with CRC if the variant has it."""
        return self.add_crc(self.frame(text))

    def add_crc(self, packet: bytes) -> bytes:
        """Return the packet with its CRC if the variant has it.

        Inferred: the CRC includes 0x80 and the device number ("the end of every command packet").
        """
        crc = bytes([remainder(packet, self.polynomial)]) if self.variant.crc else b""
        return packet + crc

    # Exchanges

    def request(self, packet: str | bytes, size: int | None = None) -> str:
        """Send a packet. Return the reply without its CRC, or "" without a reply.

        The next request and the end of the test check that no byte follows the reply.
        """
        if isinstance(packet, str):
            if size is None:
                size = documented_size(packet, self.variant)
            packet = self.packet(packet)
        assert size, "use gets_no_reply() for a packet without a documented reply"
        size += self.variant.crc
        self.assert_silence(0.0)
        begin = self._harness.now()
        self._harness.write(packet)
        reply = self._harness.read(size, LONG_TIMEOUT)
        transfer_time = self._harness.transfer_time(len(packet) + len(reply))
        self.reply_delay = self._harness.now() - begin - transfer_time
        if self.variant.crc and reply:
            *_, crc = reply
            reply = reply[:-1]
            assert crc == remainder(reply, self.polynomial), f"bad CRC: {hex_text(reply)} {crc:02X}"
        return hex_text(reply)

    def request_byte(self, packet: str) -> int:
        """Send a packet. Return its reply of one byte."""
        reply = self.request(packet)
        assert len(reply) == 2, f"{packet}: {reply!r}"
        return int(reply, 16)

    def send(self, *packets: str | bytes) -> None:
        """Send packets, and wait until the board has received them."""
        begin = self._harness.now()
        self._harness.write(
            b"".join(self.packet(each) if isinstance(each, str) else each for each in packets)
        )
        self._harness.settle()
        self._sent = begin, self._harness.now()

    def gets_no_reply(self, *packets: str | bytes, seconds: float = SILENCE) -> bool:
        """Send packets and wait. Return whether the board sends nothing."""
        self.assert_silence(0.0)
        self.send(*packets)
        return self._harness.read(1, seconds) == b""

    def exchange(self, *packets: str | bytes) -> bytes:
        """Send packets. Return all bytes until the board sends none for 50 ms."""
        self.send(*packets)
        data = b""
        while byte := self._harness.read(1, 0.05):
            data += byte
        return data

    def assert_silence(self, seconds: float = 0.002) -> None:
        """Check that the board has sent no unexpected bytes."""
        if seconds:
            self._harness.wait(seconds)
        assert hex_text(self._harness.read_available()) == ""

    # Board

    def control(self, text: str) -> str:
        """Send a control line. Return the text after `ok`."""
        reply = self._harness.control(text)
        assert reply.startswith("ok"), f"{text}: {reply}"
        return reply.removeprefix("ok").strip()

    def show(self) -> dict[str, Any]:
        """Return the state of the board."""
        begin = self._harness.now()
        state: dict[str, Any] = json.loads(self.control("show"))
        self._shown = begin, self._harness.now()
        return state

    def motor(self, number: int) -> tuple[str, int]:
        """Return direction and speed of motor 1 or 2."""
        motor = self.show()["motors"][number - 1]
        return motor["direction"], motor["speed"]

    def target(self, number: int) -> tuple[str, int]:
        """Return the target direction and speed of motor 1 or 2."""
        motor = self.show()["motors"][number - 1]
        return motor["target_direction"], motor["target_speed"]

    def outputs(self) -> list[Any]:
        """Return direction and speed of motors 1 and 2, and the speed of the auxiliary motor."""
        state = self.show()
        motors = [(motor["direction"], motor["speed"]) for motor in state["motors"]]
        return [*motors, state["aux"]["speed"]]

    def set_parameters(self, **parameters: int) -> None:
        """Store parameters, and restart the board."""
        for key, value in parameters.items():
            self.control(f"eeprom {key} {value}")
        self.restart()

    def restart_in(self, mode: str) -> None:
        """Restart with this mode jumper."""
        self.control(f"jumper mode {mode}")
        self.restart()

    def start(self, mode: str) -> None:
        """Restart with this mode jumper, and wait until safe-start is over. Sticks are neutral."""
        self.restart_in(mode)
        self.wait(0.025)
        end = self.now() + LONG_TIMEOUT
        while self.show()["safe_start"]:
            assert self.now() < end, "safe-start does not end"
            self.wait(0.01)

    def restart(self) -> None:
        self.control("power cycle")

    def set_baud(self, baud: int, settings: int = 0) -> None:
        """Set the rate of board and host. `settings` are additional bits of UART settings."""
        crc = WITH_CRC if self.variant.crc else 0
        self.set_parameters(uart_settings=RATES.index(baud) | crc | settings)
        self._harness.set_host_baud(baud)

    def set_host_baud(self, baud: int) -> None:
        self._harness.set_host_baud(baud)

    def connect(self, **signals: str) -> None:
        """Connect signals (`c1="1500us"`) to channels, and wait until the board uses them."""
        for channel, signal in signals.items():
            self.control(f"channel {channel[1:]} {signal}")
        analog = self.show()["mode"] in {"A", "a"}
        # Inputs are updated every 20 ms, or 40 ms if an average has begun before. Motors are
        # updated every 10 ms.
        self.wait(0.052 if analog else 0.032)

    # Time

    def now(self) -> float:
        return self._harness.now()

    def wait(self, seconds: float) -> None:
        self._harness.wait(seconds)

    def watch(self, seconds: float) -> Iterator[dict[str, Any]]:
        """Yield the state of the board every 8 ms, and at the end."""
        end = self.now() + seconds
        while self.now() < end:
            yield self.show()
            self.wait(0.008)
        yield self.show()

    @property
    def fewest_updates(self) -> int:
        """Fewest possible updates, one every 10 ms, between the last `send` and `show`."""
        return max(0, math.floor(round((self._shown[0] - self._sent[1]) / 0.01, 6)))

    @property
    def most_updates(self) -> int:
        """Most possible updates, one every 10 ms, between the last `send` and `show`."""
        return math.ceil(round((self._shown[1] - self._sent[0]) / 0.01, 6))


_SIZES = {
    **dict.fromkeys((0x82, 0x83, 0x84, 0x85, 0x8D, 0x8E, 0x95, 0x9F, 0xAF), 1),
    0x8F: 2,
    **dict.fromkeys(range(0x90, 0x95), 8),
    **dict.fromkeys(range(0xA0, 0xA5), 1),
}


def documented_size(packet: str, variant: Variant) -> int:
    """Return the size of the reply in the command documentation."""
    command, *data = bytes.fromhex(packet)
    match command:
        case 0x81:
            return 7 if variant.model == "trex" else 9
        case 0x86:
            return 2 * len(channels(data[0]))
        case 0x87:
            return len(channels(data[0]))
        case _:
            return _SIZES[command]
