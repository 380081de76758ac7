"""What `trexcmd list` and `trexcmd find` say of a port where no TReX answers."""

from typing import Any

from trex_gui.core.cli.host import host
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.discovery import (
    ARACNA_PROBER,
    AracnaScan,
    FoundRobot,
    find_aracna,
)

__all__ = ["ARACNA_PROBER", "FoundRobot", "listed", "look", "row", "told"]


def look(url: str, patience: float) -> AracnaScan:
    """Return what asking for an Aracna on a port has seen. Moves nothing, whatever is there.

    Raises:
        PortUnavailable: the port cannot be opened, or is gone.
    """
    return find_aracna(
        PortSettings(url, timeouts=Timeouts(extra=patience)), open_wire=host().open_transport
    )


def listed(found: FoundRobot) -> dict[str, Any]:
    """Return what `list --json` says of it."""
    return {
        "answer": f"{found.name}, {found.motors} motors",
        "product": "Aracna",
        "firmware": str(found.version.version),
    }


def told(found: FoundRobot) -> str:
    """Return what `find` says of it to a person."""
    text = f"{found.name}, {found.motors} motors, on {found.settings.text()}."
    return f"{text} {found.note}".strip()


def row(found: FoundRobot) -> dict[str, Any]:
    """Return what `find --json` says of it, under the same names as of a TReX."""
    return {
        "port": found.settings.url,
        "product": "Aracna",
        "firmware": str(found.version.version),
        "baud": found.settings.line.baud,
        "detection": found.settings.line.parity.name.lower(),
        "polynomial": None,
        "stop_bits": found.settings.line.stop_bits,
        "device_number": None,
        "echo": False,
        "note": found.note,
        "options": f"--port {found.settings.url}",
    }
