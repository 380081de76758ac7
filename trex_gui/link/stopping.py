"""The stop: the one motor command that the program may send unasked, and its proof.

Motor commands have no reply. That a stop arrived whole is proved by the board's own status:
it answers, and no UART error bit was latched since the packets were sent.
"""

from dataclasses import dataclass

from trex_gui.link.client import Client
from trex_gui.link.telemetry import StatusNews, StatusReader
from trex_gui.protocol.commands import STOP
from trex_gui.protocol.errors import BadReply, NoReply
from trex_gui.protocol.flags import UartError

_COPIES = 2
"""How often the packets are sent at a time: a second copy overrides one that noise changed."""

ATTEMPTS = 10

_HARMLESS = UartError.TIMEOUT
"""What a board may latch without having lost a packet."""


@dataclass(frozen=True, slots=True)
class Stopped:
    """How a stop went; `news` are the latched bits that looking for the proof has cleared."""

    proved: bool
    news: tuple[StatusNews, ...]


def send_stop(client: Client) -> None:
    """Brake both motors fully and switch the auxiliary motor off; proves nothing.

    Raises:
        PortUnavailable: the line is gone.
    """
    for _ in range(_COPIES):
        for command in STOP:
            client.send(command)


def stop_and_prove(client: Client, reader: StatusReader, attempts: int = ATTEMPTS) -> Stopped:
    """Send a stop again and again until the board's status proves that it has arrived.

    Raises:
        PortUnavailable: the line is gone.
    """
    news: list[StatusNews] = []
    for _ in range(attempts):
        send_stop(client)
        try:
            seen = reader.read(client.request)
        except (NoReply, BadReply):
            continue
        if seen is not None:
            news.append(seen)
        if not reader.uart_due and (seen is None or not seen.uart & ~_HARMLESS):
            return Stopped(True, tuple(news))
    return Stopped(False, tuple(news))
