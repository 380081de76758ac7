"""The stop: the one motor command that the program may send unasked, and its proof.

Motor commands have no reply. That a stop arrived whole is proved by the board's own status:
it answers, and no UART error bit was latched since the packets were sent.
"""

from collections.abc import Callable
from dataclasses import dataclass

from trex_gui.core.errors import BadReply, NoReply
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.telemetry import LatchedStatus, StatusReader
from trex_gui.devices.trex.protocol.commands import STOP

_CLEAN_ROUNDS = 2
"""Rounds of stop and clean status, one after the other, that make a proof.

A board that still answers somebody is deaf, and latches nothing for packets that it lost
whole: one round can go by unheard, but not the next one too once it has answered.
"""

_CAREFUL_ROUNDS = 8
"""The same on a line that damages bytes, for whoever cannot wait until it is quiet.

Of the last one a motor can still have made a speed, unnoticed, with 2p/9 * (1 - p)**56 at p damaged
bytes each: 0.14 % at worst. See `calm` for what proves more.
"""

ATTEMPTS = 20


@dataclass(frozen=True, slots=True)
class Stopped:
    """How a stop went; `news` are the latched bits that looking for the proof has cleared."""

    confirmed: bool
    news: tuple[LatchedStatus, ...]


def send_stop(client: TrexClient) -> None:
    """Brake both motors fully and switch the auxiliary motor off; proves nothing.

    Raises:
        PortUnavailable: the line is gone.
    """
    for command in STOP:
        client.send(command)


def _never() -> bool:
    return False


def stop_and_confirm(
    client: TrexClient,
    reader: StatusReader,
    attempts: int = ATTEMPTS,
    *,
    careful: bool = False,
    hurries: Callable[[], bool] = _never,
) -> Stopped:
    """Send a stop again and again until the board's status proves that it has arrived.

    It is `careful` on a line that has damaged bytes, and wants more rounds. When somebody
    `hurries` after a round that proved nothing, it is the last one.

    Raises:
        PortUnavailable: the line is gone.
    """
    news: list[LatchedStatus] = []
    clean = 0
    wanted = _CAREFUL_ROUNDS if careful else _CLEAN_ROUNDS
    for _ in range(attempts):
        send_stop(client)
        try:
            seen = reader.read(client.request)
        except (NoReply, BadReply):
            clean = 0
            if hurries():
                break
            continue
        if seen is not None:
            news.append(seen)
        is_clean = not reader.uart_due and (seen is None or not seen.has_line_error)
        clean = clean + 1 if is_clean else 0
        if clean == wanted:
            return Stopped(True, tuple(news))
        if not clean and hurries():
            break
    return Stopped(False, tuple(news))
