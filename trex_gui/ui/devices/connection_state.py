"""State of the connection to a device."""

from enum import Enum, auto


class ConnectionState(Enum):
    """Whether a line is open and its device responds."""

    DISCONNECTED = auto()
    CONNECTING = auto()
    CONNECTED = auto()
    NOT_RESPONDING = auto()
    DISCONNECTING = auto()
