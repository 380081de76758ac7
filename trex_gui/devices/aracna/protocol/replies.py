"""What the robot says, read as it comes: whole lines, and the answer to `.c` motor by motor."""

import re
from dataclasses import dataclass

from trex_gui.devices.aracna.protocol.units import HIGHEST


@dataclass(frozen=True, slots=True)
class Hello:
    """`.h`: the firmware has started; a command that was pending is void."""


@dataclass(frozen=True, slots=True)
class Version:
    """`.q`: the firmware's version and how many motors it was made for.

    Builds from before 22 Sep 2012 do not say how many: `None`.
    """

    version: int
    motors: int | None


@dataclass(frozen=True, slots=True)
class Speeds:
    """`.v`: what each servo holds; -1 for one that does not answer."""

    values: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Positions:
    """`.c`: where each servo is; -1 for one whose position could not be read."""

    values: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Led:
    """`.l`: whether the debug LED is on."""

    on: bool


@dataclass(frozen=True, slots=True)
class Strange:
    """A line that is none of these: cut, damaged, or from something else."""

    line: bytes


Reply = Hello | Version | Speeds | Positions | Led | Strange

_LONGEST = 200
"""Bytes without a line end that are kept; the longest reply of eight motors has 43."""

MOST_MOTORS = 11
"""More values of four digits than the firmware's line buffer of 59 characters takes."""

_NUMBER = rb"-1|0|[1-9]\d{0,4}"
"""What `%d` makes of it: no sign but of -1, nothing in front of it."""

_QUERY = re.compile(rb"\.q(0|[1-9]\d{0,4})(?:,([1-9]\d{0,2}))?")
_VALUES = re.compile(rb"\.([vc])((?:%b)(?:,(?:%b))*)" % (_NUMBER, _NUMBER))
_LED = re.compile(rb"\.l([01])")
_BEGUN = re.compile(rb"\.c((?:(?:%b),)*)(?:-|%b)?\r?" % (_NUMBER, _NUMBER))


def read_line(line: bytes) -> Reply:
    """Return what a line without its end says."""
    if line == b".h":
        return Hello()
    if match := _QUERY.fullmatch(line):
        motors = None if match[2] is None else int(match[2])
        return Strange(line) if (motors or 0) > MOST_MOTORS else Version(int(match[1]), motors)
    if match := _VALUES.fullmatch(line):
        values = tuple(map(int, match[2].split(b",")))
        if max(values) > HIGHEST:
            return Strange(line)
        return Speeds(values) if match[1] == b"v" else Positions(values)
    if match := _LED.fullmatch(line):
        return Led(match[1] == b"1")
    return Strange(line)


def _pieces(line: bytes) -> list[bytes]:
    """Cut what has no end in sight, always at the same places; the last piece is the rest."""
    return [line[at : at + _LONGEST] for at in range(0, max(len(line), 1), _LONGEST)]


class Reader:
    r"""Cuts what comes into lines: `\r\n` and `\n` end one, an empty one says nothing.

    The first line may have begun before anybody listened. A `.h` is heard at any time, behind
    the rest of a line that broke off when the firmware restarted, too.
    """

    def __init__(self) -> None:
        self._rest = b""
        self._may_be_cut = True

    @property
    def passed(self) -> tuple[int, ...] | None:
        """The motors that an unfinished `.c` has told of, in order; `None` while none comes.

        A number counts when its comma is there: the next motor is the one that is waited for.
        """
        match = _BEGUN.fullmatch(self._rest)
        if match is None:
            return None
        return tuple(map(int, match[1].split(b",")[:-1]))

    def feed(self, data: bytes) -> list[Reply]:
        """Take what has come; return what the lines say that are complete now."""
        *lines, self._rest = (self._rest + data).split(b"\n")
        replies: list[Reply] = []
        for line in lines:
            *pieces, end = _pieces(line)
            for piece in (*pieces, end.removesuffix(b"\r")):
                replies += self._take(piece)
        *pieces, self._rest = _pieces(self._rest)
        for piece in pieces:
            replies += self._take(piece)
        return replies

    def _take(self, line: bytes) -> list[Reply]:
        was_first, self._may_be_cut = self._may_be_cut, False
        if not line:
            return []
        reply = read_line(line)
        if not isinstance(reply, Strange):
            return [reply]
        if line.endswith(b".h"):  # the line before it was never ended
            return [Strange(line[:-2]), Hello()]
        if was_first:
            return [Hello()] if line == b"h" else []
        return [reply]

    def begin(self) -> None:
        """Forget what has come: what comes next may begin in mid-line."""
        self._rest = b""
        self._may_be_cut = True
