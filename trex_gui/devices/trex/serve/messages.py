"""Messages between server and clients, besides a session's requests and reports."""

from dataclasses import dataclass

VERSION = 1  # of the messages; a server refuses clients with another version


@dataclass(frozen=True, slots=True)
class Hello:
    """Request: the first message of a client."""

    version: int
    program: str  # name and version, for the log


@dataclass(frozen=True, slots=True)
class Alive:
    """Request: the client still runs."""


@dataclass(frozen=True, slots=True)
class Leave:
    """Request: the last message of a client."""


@dataclass(frozen=True, slots=True)
class Welcome:
    """Report: a client was accepted. The newest reports of the session follow."""

    name: str  # of the board, as it is served


@dataclass(frozen=True, slots=True)
class Tick:
    """Report: nothing else to report, but the server still runs."""


@dataclass(frozen=True, slots=True)
class Refused:
    """Report: the last message to a client that is not, or no longer, served."""

    reason: str


ClientRequest = Hello | Alive | Leave
ServerReport = Welcome | Tick | Refused
