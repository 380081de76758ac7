"""Events of a device, for marks in a plot, a recording and the log."""

from dataclasses import dataclass
from enum import StrEnum


class EventKind(StrEnum):
    """Subject of an event. The value is its spelling in files."""

    APPLY = "apply"
    STOP = "stop"
    FAULT = "fault"
    OVER_LIMIT = "over-limit"
    TIMEOUT = "timeout"
    LINK = "link"
    NOTE = "note"


@dataclass(frozen=True, slots=True)
class Event:
    """Something that happened. `time` is on the session's clock (s), as telemetry's."""

    time: float
    kind: EventKind
    text: str  # one line, for the user
    is_problem: bool = False
