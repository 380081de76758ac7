"""Events of a device for plots, recordings and the log."""

from dataclasses import dataclass
from enum import StrEnum


class EventKind(StrEnum):
    """Kind of an event. Recordings contain the value, so it must not change."""

    APPLY = "apply"
    STOP = "stop"
    FAULT = "fault"
    OVER_LIMIT = "over-limit"
    TIMEOUT = "timeout"
    LINK = "link"
    NOTE = "note"


@dataclass(frozen=True, slots=True)
class Event:
    """Event of a device. `time`: session clock in seconds, as in telemetry."""

    time: float
    kind: EventKind
    text: str  # one line, for the user
    is_problem: bool = False
