"""Requests and reports that the sessions of every device share; frozen and picklable."""

from dataclasses import dataclass

from trex_gui.core.errors import StudioError


@dataclass(frozen=True, slots=True)
class Close:
    """Request: stop whatever moves, close the port, end."""


@dataclass(frozen=True, slots=True)
class Progress:
    """Report: a long operation is at step `done` of `total`; `what` comes next."""

    done: int
    total: int
    what: str


@dataclass(frozen=True, slots=True)
class Outcome:
    """Report: the end of a request; exactly one for each that has an `id`."""

    id: int
    value: object = None
    error: StudioError | None = None


@dataclass(frozen=True, slots=True)
class Closed:
    """Report, the last one: the session has ended and the port is free.

    Attributes:
        error: why the line was lost; `None` after `Close`.
        may_move: motors were driven and no stop has been confirmed since.
    """

    error: StudioError | None
    may_move: bool = False
