"""Results of a scan for a TReX: boards, or a diagnosis."""

from dataclasses import dataclass, field

from trex_gui.core.discovery.prober import Diagnosis, Evidence
from trex_gui.core.transport.settings import SerialFormat
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import LineSettings

_LOADER = b"?"
"""Reply of a board that waits for new firmware to anything, after an echo."""

_SHOWN = 12
"""Longest excerpt, in bytes, of an unknown reply."""


@dataclass(frozen=True, slots=True)
class FoundBoard:
    """A board, and how to reach it.

    Attributes:
        settings: what to connect with; addressed by number only where several boards share
            the line.
        device_number: the number that it stores, if it was read.
        note: a hint for the user; may be empty.
    """

    settings: ConnectionSettings
    signature: Signature
    device_number: int | None = None
    echo: bool = False
    note: str = ""

    @property
    def name(self) -> str:
        """Product and firmware, such as `TReX 1.2`."""
        return str(self.signature)


@dataclass(slots=True)
class TrexScan:
    """What a scan has seen.

    Attributes:
        found: boards; more than one only where several share the line.
        echo: whether what was sent came back.
        strange: other replies, and the settings of their probes, in order.
        several: settings at which several boards answered at once.
        skipped: settings that the port does not support.
        fixed: whether the rate is set at the other end, so that only one probe was possible.
        cancelled: whether it was cancelled.
    """

    url: str
    found: list[FoundBoard] = field(default_factory=list)
    echo: bool = False
    strange: list[tuple[SerialFormat, bytes]] = field(default_factory=list)
    several: LineSettings | None = None
    skipped: list[LineSettings] = field(default_factory=list)
    fixed: bool = False
    cancelled: bool = False

    def diagnosis(self) -> str:
        """Explain why no board was found, and what to check."""
        return self.judged().text

    def judged(self) -> Diagnosis:
        """The same, with how much was learned."""
        evidence, text = self._what_was_seen()
        if self.skipped:
            rates = sorted({line.baud for line in self.skipped})
            text += (
                f" The port cannot be set to {', '.join(map(str, rates))} baud, so nothing was "
                "probed there."
            )
        return Diagnosis(evidence, text)

    def _what_was_seen(self) -> tuple[Evidence, str]:
        if self.several is not None:
            return Evidence.KNOWN, (
                f"Several boards answer at once on {self.url} at {self.several.text()}. "
                "The full scan tries each device number."
            )
        if self.strange:
            return self._what_came()
        if self.echo:
            return Evidence.ECHO, (
                f"No TReX answers on {self.url}: everything sent comes back, and nothing else, at "
                "every rate. Either this is the RS-232 side of a board that is off, or the "
                "adapter's TX and RX are joined."
            )
        if self.fixed:
            return Evidence.SILENCE, (
                f"No TReX answers on {self.url}. Its baud rate is set at the other end of the "
                "network, so only that one could be tried, without parity and without CRC."
            )
        return Evidence.SILENCE, (
            f"No TReX answers on {self.url} at any baud rate, with any parity or with CRC. Check "
            "that the board has power (an LED is lit), that the adapter's TX goes to SI and its "
            "RX to SO (or both RS-232 pins, never mixed), and that ground is connected. A board "
            "with a CRC polynomial of its own is only found by the full scan."
        )

    def _what_came(self) -> tuple[Evidence, str]:
        if all(data == _LOADER for _, data in self.strange):
            return Evidence.KNOWN, (
                f"What is connected to {self.url} answers as a TReX that waits for new "
                "firmware. Take the SO-G jumper off, then switch the board off and on."
            )
        line, data = self.strange[0]
        shown = data[:_SHOWN].hex(" ").upper() + (" …" if len(data) > _SHOWN else "")
        often = f", and something at {more} more" if (more := len(self.strange) - 1) else ""
        text = (
            f"Something is connected to {self.url}, but it does not answer as a TReX does: "
            f"{shown} came at {line.text()}{often}. Another device, or a line that is disturbed."
        )
        if self.echo:
            text += " What is sent comes back, too."
        return Evidence.STRANGE, text
