"""A TReX as the tests meet it: packets as the documents print them, whatever the variant."""

import json
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

import pytest

from tests.devices.trex.conformance.ends import LONG_TIMEOUT, End
from tests.devices.trex.oracle.framing import remainder

QUIET = 0.02
"""Seconds of silence after which no answer comes, where the documents name no other time."""

RATES = [1200, 2400, 4800, 9600, 14400, 19200, 28800, 38400, 57600, 76800, 115200]
"""In the order of their codes in UART settings (0x7E)."""

WITH_CRC = 0x20
"""In UART settings: CRC-7 is on (User's Guide 5.e)."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Variant:
    """One way to run a test."""

    end: str
    expanded: bool
    crc: bool
    model: str = "trex"
    firmware: str = "1.2"
    echo: bool = False

    def __str__(self) -> str:
        return "-".join(
            (self.end, "expanded" if self.expanded else "compact", "crc" if self.crc else "plain")
        )


VARIANTS = [
    Variant(end=end, expanded=expanded, crc=crc)
    for end, expanded, crc in product(("parser", "wire"), (False, True), (False, True))
]


def in_gate(variants: Sequence[Variant]) -> list[Any]:
    """Mark rare combinations of traits as slow. Each pair of traits remains."""
    unexpected = [(one.end == "wire") ^ one.expanded ^ one.crc for one in variants]
    return [
        pytest.param(one, marks=pytest.mark.slow) if is_unexpected and not all(unexpected) else one
        for one, is_unexpected in zip(variants, unexpected, strict=True)
    ]


def only(
    *,
    end: str = "",
    expanded: bool | None = None,
    crc: bool | None = None,
    model: str = "trex",
    firmware: str = "1.2",
    echo: bool = False,
) -> pytest.MarkDecorator:
    """Run a test in the variants with these traits, or with another board than a TReX 1.2."""
    chosen = [
        replace(variant, model=model, firmware=firmware, echo=echo)
        for variant in VARIANTS
        if end in {"", variant.end}
        and expanded in {None, variant.expanded}
        and crc in {None, variant.crc}
    ]
    return pytest.mark.parametrize("trex", in_gate(chosen), ids=str, indirect=True)


def text_of(data: bytes) -> str:
    """Bytes as the documents print them."""
    return data.hex(" ").upper()


def words(reply: str) -> list[int]:
    """Two-byte values, the low byte first."""
    data = bytes.fromhex(reply)
    return [low | high << 8 for low, high in zip(data[::2], data[1::2], strict=True)]


def channels(mask: int) -> list[int]:
    """The channels that a data byte or an answer names: bit n stands for channel n+1."""
    return [bit + 1 for bit in range(5) if mask & 1 << bit]


def calibration(channel: int, *values: int) -> str:
    """The packet that sets minimum, neutral, maximum and deadband of a channel.

    Inferred: low and high byte carry seven bits each, since no data byte has an eighth.
    """
    coded = bytes(part for value in values for part in (value & 0x7F, value >> 7))
    return f"{0xA0 + channel - 1:02X} {text_of(coded)} 55 2A"


class Trex:
    """A board behind one of the two ends, in one protocol, with or without CRC.

    Packets are written in hex in the compact form, without CRC; bytes are sent as they are.

    Attributes:
        device, polynomial: what packets are made with.
        took: seconds from the end of the last packet asked to the begin of its answer.
    """

    def __init__(self, end: End, variant: Variant) -> None:
        self.variant = variant
        self.device = 7
        self.polynomial = 0x89
        self.took = 0.0
        self._end = end
        self._reports = self._shown = (0.0, 0.0)
        self.do("factory")
        self.run_at(115200)

    # Packets

    def head(self, text: str) -> bytes:
        """Return a packet as its protocol wants it, without CRC."""
        packet = bytes.fromhex(text)
        if self.variant.expanded:
            return bytes([0x80, self.device, packet[0] & 0x7F, *packet[1:]])
        return packet

    def packet(self, text: str) -> bytes:
        """Return a whole packet."""
        return self.signed(self.head(text))

    def signed(self, packet: bytes) -> bytes:
        """Return the packet with its CRC, if there is one.

        Inferred: it covers 0x80 and the device number too, "the end of every command packet".
        """
        crc = bytes([remainder(packet, self.polynomial)]) if self.variant.crc else b""
        return packet + crc

    # Exchanges

    def request(self, packet: str | bytes, size: int | None = None) -> str:
        """Send a packet. Return the reply without its CRC, or "" without a reply.

        The next exchange and the end check that no byte follows the reply.
        """
        if isinstance(packet, str):
            if size is None:
                size = documented_size(packet, self.variant)
            packet = self.packet(packet)
        assert size, "the documents promise no answer; unanswered() is the question then"
        size += self.variant.crc
        self.nothing_more_comes(0.0)
        begun = self._end.now()
        self._end.write(packet)
        reply = self._end.read(size, LONG_TIMEOUT)
        self.took = self._end.now() - begun - self._end.on_the_wire(len(packet) + len(reply))
        return text_of(self._checked(reply))

    def number(self, packet: str) -> int:
        """Send a packet whose answer is one byte. Return that."""
        reply = self.request(packet)
        assert len(reply) == 2, f"{packet}: {reply!r}"
        return int(reply, 16)

    def report(self, *packets: str | bytes) -> None:
        """Send packets that have no answer. The board has heard them when this returns."""
        begun = self._end.now()
        self._end.write(
            b"".join(self.packet(each) if isinstance(each, str) else each for each in packets)
        )
        self._end.settle()
        self._reports = begun, self._end.now()

    def unanswered(self, *packets: str | bytes, seconds: float = QUIET) -> bool:
        """Send packets and wait. Return whether the board stays silent."""
        self.nothing_more_comes(0.0)
        self.report(*packets)
        return self._end.read(1, seconds) == b""

    def everything(self, *packets: str | bytes) -> bytes:
        """Send packets, return all that comes until it is quiet."""
        self.report(*packets)
        data = b""
        while more := self._end.read(1, QUIET) or self._end.late():
            data += more
        return data

    def nothing_more_comes(self, seconds: float = 0.002) -> None:
        """Fail if the board has sent what nobody asked for."""
        if seconds:
            self._end.wait(seconds)
        assert text_of(self._end.come()) == ""

    def _checked(self, reply: bytes) -> bytes:
        """Check the CRC of an answer and take it off."""
        if not (self.variant.crc and reply):
            return reply
        *_, crc = reply
        assert crc == remainder(reply[:-1], self.polynomial), f"bad CRC: {text_of(reply)}"
        return reply[:-1]

    # The board

    def do(self, text: str) -> str:
        """Send a control line. Return what follows `ok`."""
        answer = self._end.do(text)
        assert answer.startswith("ok"), f"{text}: {answer}"
        return answer.removeprefix("ok").strip()

    def show(self) -> dict[str, Any]:
        """Return what the board does."""
        begun = self._end.now()
        shown: dict[str, Any] = json.loads(self.do("show"))
        self._shown = begun, self._end.now()
        return shown

    def motor(self, number: int) -> tuple[str, int]:
        """Return direction and speed of motor 1 or 2."""
        motor = self.show()["motors"][number - 1]
        return motor["direction"], motor["speed"]

    def target(self, number: int) -> tuple[str, int]:
        """Return direction and speed that motor 1 or 2 is going to."""
        motor = self.show()["motors"][number - 1]
        return motor["target_direction"], motor["target_speed"]

    def set_up(self, **parameters: int) -> None:
        """Have stored parameters other than the factory's, and restart."""
        for key, value in parameters.items():
            self.do(f"eeprom {key} {value}")
        self.restart()

    def restart_in(self, mode: str) -> None:
        """Restart with this mode jumper."""
        self.do(f"jumper mode {mode}")
        self.restart()

    def start(self, mode: str) -> None:
        """Restart with this mode jumper and sticks at rest. Safe-start is over then."""
        self.restart_in(mode)
        self.wait(0.025)
        end = self.now() + LONG_TIMEOUT
        while self.show()["safe_start"]:
            assert self.now() < end, "safe-start does not end"
            self.wait(0.01)

    def restart(self) -> None:
        """Switch off and on."""
        self.do("power cycle")

    def run_at(self, baud: int, settings: int = 0) -> None:
        """Run board and host at a rate. `settings` are more bits of UART settings."""
        crc = WITH_CRC if self.variant.crc else 0
        self.set_up(uart_settings=RATES.index(baud) | crc | settings)
        self._end.run_at(baud)

    def host_at(self, baud: int) -> None:
        """Run the host alone at another rate."""
        self._end.run_at(baud)

    def connect(self, **signals: str) -> None:
        """Connect signals (`c1="1500us"`) to channels. The board has acted on them then."""
        for channel, signal in signals.items():
            self.do(f"channel {channel[1:]} {signal}")
        analog = self.show()["mode"] in {"A", "a"}
        # Inputs are renewed every 20 ms (an average may have begun before), motors every 10.
        self.wait(0.052 if analog else 0.032)

    # Time

    def now(self) -> float:
        """Seconds on the clock by which the board lives."""
        return self._end.now()

    def wait(self, seconds: float) -> None:
        """Let time pass."""
        self._end.wait(seconds)

    def watch(self, seconds: float, every: float = 0.008) -> Iterator[dict[str, Any]]:
        """Show the board again and again, and once when the time is over."""
        end = self.now() + seconds
        while self.now() < end:
            yield self.show()
            self.wait(every)
        yield self.show()

    @property
    def fewest_updates(self) -> int:
        """Fewest possible updates, of 10 ms each, between the last control line and `show`."""
        return max(0, math.floor(round((self._shown[0] - self._reports[1]) / 0.01, 6)))

    @property
    def most_updates(self) -> int:
        """Most possible updates, of 10 ms each, between the last control line and `show`."""
        return math.ceil(round((self._shown[1] - self._reports[0]) / 0.01, 6))


_SIZES = {
    **dict.fromkeys((0x82, 0x83, 0x84, 0x85, 0x8D, 0x8E, 0x95, 0x9F, 0xAF), 1),
    0x8F: 2,
    **dict.fromkeys(range(0x90, 0x95), 8),
    **dict.fromkeys(range(0xA0, 0xA5), 1),
}


def documented_size(packet: str, variant: Variant) -> int:
    """Return how many bytes the command documentation promises for an answer."""
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
