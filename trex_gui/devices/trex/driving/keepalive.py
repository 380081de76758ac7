"""How a line is kept busy enough for the board's own serial timeout while motors are armed. Pure.

The board counts from one byte that it receives to the next, and it is deaf while it answers. So the
silence that it sees is the answer to one question and the first byte of the next one.
"""

from collections.abc import Mapping

from trex_gui.devices.trex.client.schedule import Topic
from trex_gui.devices.trex.protocol.commands import (
    Command,
    GetCurrents,
    GetMode,
    GetRawChannels,
    GetRemappedChannels,
    GetSerialControl,
    GetStatus,
)
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings

_MARGIN = 0.015
"""Seconds between an answer and the next question: the board's response delay (1 ms), its 10 ms
cycle halved, and a host that has other things to do (some milliseconds, measured beside a window
that paints)."""

_EAGERNESS = 0.4
"""Share of the timeout after which something is asked even if nothing is due."""

CHEAPEST = Topic.CONTROL
"""What is asked to be heard: one byte out, one byte in, and worth knowing."""

_QUESTIONS: Mapping[Topic, Command[object]] = {
    Topic.CURRENTS: GetCurrents(),
    Topic.RAW: GetRawChannels(),
    Topic.REMAPPED: GetRemappedChannels(),
    Topic.STATUS: GetStatus(),
    Topic.CONTROL: GetSerialControl(),
    Topic.MODE: GetMode(),
}


def silence(line: LineSettings, command: Command[object]) -> float:
    """Return the longest silence, in seconds, that a board sees around its answer to this."""
    size = command.reply_size() + (line.detection is Detection.CRC7)
    return line.seconds(size + 1) + command.seconds_to_answer + _MARGIN


def too_slow(line: LineSettings, timeout: float) -> frozenset[Topic]:
    """Return what must not be asked while motors are armed: its answer outlasts the timeout.

    A timeout of 0 s is none at all.
    """
    if timeout <= 0:
        return frozenset()
    return frozenset(
        topic for topic, command in _QUESTIONS.items() if silence(line, command) >= timeout
    )


def survives_a_loss(line: LineSettings, timeout: float, lateness: float) -> bool:
    """Whether motors go on when one answer is lost, since the next question comes in time.

    Where it does not, the line may feed the timeout for as long as nothing ever goes wrong, and
    that cannot be promised. `lateness`: seconds for which an answer is waited beyond its time on
    the wire, which is as long as nothing else is sent.
    """
    left_out = too_slow(line, timeout)
    asked = [command for topic, command in _QUESTIONS.items() if topic not in left_out]
    return timeout <= 0 or max(silence(line, command) for command in asked) + lateness < timeout


def longest_pause(timeout: float) -> float | None:
    """Return after how many seconds of rest something is to be asked; `None`: never."""
    return timeout * _EAGERNESS if timeout > 0 else None
