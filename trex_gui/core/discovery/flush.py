"""The byte that separates two probes on a line where any device may be listening.

A device at another baud rate takes what is sent for other bytes and may keep them as the start of a
packet: together with a later probe, harmless by itself, they could form a motor command. FF at
1200 baud ends whatever has begun: a TReX at that rate ignores it, one at any other rate receives a
byte that no packet may contain.
"""

from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import SerialFormat

FLUSH_BYTE = b"\xff"
FLUSH_LINE = SerialFormat(1200)


def flush(wire: Transport, extra: float = 0.0) -> None:
    """End every packet that a device may have begun to receive, at whatever rate it runs.

    Args:
        wire: the line.
        extra: seconds to add to the time that the byte needs.

    Raises:
        BadRequest: the port cannot be set to 1200 baud.
        PortUnavailable: the line is gone.
    """
    wire.reconfigure(FLUSH_LINE)
    wire.write(FLUSH_BYTE)
    wire.wait(FLUSH_LINE.seconds(len(FLUSH_BYTE)) + wire.latency + extra)
