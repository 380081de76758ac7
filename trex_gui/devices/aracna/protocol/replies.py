"""Replies of the robot, including an incomplete reply to `.c`."""

import re
from dataclasses import dataclass

from trex_gui.devices.aracna.protocol.joints import HIGHEST, MOTORS

UNREADABLE = -1  # value of a servo that did not reply
MAX_MOTORS = 11  # more values of four digits do not fit into the firmware's 59-character buffer

_MOTORS_BY_VERSION = {0: 2}  # for firmware that does not report its number of motors


@dataclass(frozen=True, slots=True)
class Hello:
    """Reply `.h`: the firmware has started. A pending command is void."""


@dataclass(frozen=True, slots=True)
class Version:
    """Reply to `.q`. `motors`: `None` from firmware built before 22 Sep 2012."""

    version: int
    motors: int | None

    @property
    def motor_count(self) -> int:
        """Reported number of motors, or the default of the version."""
        return self.motors or _MOTORS_BY_VERSION.get(self.version, MOTORS)


@dataclass(frozen=True, slots=True)
class Speeds:
    """Reply to `.v`: each servo's speed, or `UNREADABLE`."""

    values: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Positions:
    """Reply to `.c`: each servo's position, or `UNREADABLE`."""

    values: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Led:
    on: bool


@dataclass(frozen=True, slots=True)
class Unrecognized:
    """Line that is not a reply: truncated, corrupted or from another device."""

    line: bytes


Reply = Hello | Version | Speeds | Positions | Led | Unrecognized
REPLY_TYPES: dict[str, type[Reply]] = {  # letter of a command → class of its reply
    "q": Version,
    "v": Speeds,
    "c": Positions,
    "l": Led,
}

_MAX_LENGTH = 200  # maximum bytes of a line; the longest reply for eight motors has 43
_NUMBER = rb"-1|0|[1-9]\d{0,4}"  # printed by `%d`: no padding, no sign except in -1
_QUERY = re.compile(rb"\.q(0|[1-9]\d{0,4})(?:,([1-9]\d{0,2}))?")
_VALUES = re.compile(rb"\.([vc])((?:%b)(?:,(?:%b))*)" % (_NUMBER, _NUMBER))
_LED = re.compile(rb"\.l([01])")
_PARTIAL = re.compile(rb"\.c((?:(?:%b),)*)(?:-|%b)?\r?" % (_NUMBER, _NUMBER))


def parse_reply(line: bytes) -> Reply:
    if line == b".h":
        return Hello()
    if match := _QUERY.fullmatch(line):
        motors = None if match[2] is None else int(match[2])
        if (motors or 0) > MAX_MOTORS:
            return Unrecognized(line)
        return Version(int(match[1]), motors)
    if match := _VALUES.fullmatch(line):
        values = tuple(map(int, match[2].split(b",")))
        if max(values) > HIGHEST:
            return Unrecognized(line)
        return Speeds(values) if match[1] == b"v" else Positions(values)
    if match := _LED.fullmatch(line):
        return Led(match[1] == b"1")
    return Unrecognized(line)


def parse_replies(line: bytes) -> list[Reply]:
    """Parse a line, which may be empty or end with the `.h` of a restart."""
    if not line:
        return []
    reply = parse_reply(line)
    if isinstance(reply, Unrecognized) and line.endswith(b".h"):
        return [Unrecognized(line[:-2]), Hello()]
    return [reply]


def _chunks(line: bytes) -> list[bytes]:
    return [line[at : at + _MAX_LENGTH] for at in range(0, max(len(line), 1), _MAX_LENGTH)]


class Reader:
    r"""Parser of received lines, which end in `\r\n` or `\n`.

    An unrecognized first line is ignored, because its beginning may be missing.
    """

    def __init__(self) -> None:
        self._rest = b""
        self._may_be_truncated = True

    @property
    def arrived(self) -> tuple[int, ...] | None:
        """Positions in an incomplete `.c` reply. `None` without such a reply.

        A position counts only after its comma. The firmware then waits for the next motor.
        """
        match = _PARTIAL.fullmatch(self._rest)
        return None if match is None else tuple(map(int, match[1].split(b",")[:-1]))

    def feed(self, data: bytes) -> list[Reply]:
        *lines, self._rest = (self._rest + data).split(b"\n")
        replies: list[Reply] = []
        for line in lines:
            *chunks, end = _chunks(line)
            for chunk in (*chunks, end.removesuffix(b"\r")):
                replies += self._parse(chunk)
        *chunks, self._rest = _chunks(self._rest)
        for chunk in chunks:
            replies += self._parse(chunk)
        return replies

    def _parse(self, line: bytes) -> list[Reply]:
        was_first, self._may_be_truncated = self._may_be_truncated, False
        replies = parse_replies(line)
        if was_first and len(replies) == 1 and isinstance(replies[0], Unrecognized):
            return [Hello()] if line == b"h" else []
        return replies
