"""Messages between a server and its clients, beside the requests and reports of a session."""

from dataclasses import dataclass

VERSION = 1  # of the messages; a server refuses clients of another one


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
    """Request, the last one of a client."""


@dataclass(frozen=True, slots=True)
class Welcome:
    """Report: a client was accepted. The newest reports of the session follow."""

    name: str  # of the board, as it is served


@dataclass(frozen=True, slots=True)
class Tick:
    """Report: nothing else was to be reported for a moment."""


@dataclass(frozen=True, slots=True)
class Refused:
    """Report, the last one: why this client is not, or no longer, served."""

    reason: str


ClientRequest = Hello | Alive | Leave
ServerReport = Welcome | Tick | Refused
