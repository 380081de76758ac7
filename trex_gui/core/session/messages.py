"""Requests and reports shared by the sessions of all devices; frozen and picklable."""

from dataclasses import dataclass

from trex_gui.core.errors import StudioError


@dataclass(frozen=True, slots=True)
class Close:
    """Request: stop all motors, close the port and end the session."""


@dataclass(frozen=True, slots=True)
class Progress:
    """Report: `done` of `total` steps are complete; `what` is the next one."""

    done: int
    total: int
    what: str


@dataclass(frozen=True, slots=True)
class Outcome:
    """Report: the result of a request; exactly one for each request with an `id`."""

    id: int
    value: object = None
    error: StudioError | None = None


@dataclass(frozen=True, slots=True)
class Closed:
    """Report, the last one: the session has ended and the port is free.

    Attributes:
        error: reason why the line was lost; `None` after `Close`.
        may_move: motors were driven and no stop has been confirmed since.
    """

    error: StudioError | None
    may_move: bool = False
