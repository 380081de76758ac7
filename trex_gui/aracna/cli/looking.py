"""What `trexcmd list` and `trexcmd find` say of a port where no TReX answers."""

from collections.abc import Callable
from typing import Any

from trex_gui.aracna.link.discovery import Found, find_aracna
from trex_gui.link.settings import LinkSettings


def look(url: str, patience: float, cancelled: Callable[[], bool] = lambda: False) -> Found | None:
    """Return the Aracna on a port, if one is there. Moves nothing, whatever is.

    Raises:
        PortUnavailable: the port cannot be opened, or is gone.
    """
    search = find_aracna(LinkSettings(url, patience=patience), cancelled=cancelled)
    return search.found[0] if search.found else None


def listed(found: Found) -> dict[str, Any]:
    """Return what `list --json` says of it."""
    return {
        "answer": f"{found.name}, {found.motors} motors",
        "product": "Aracna",
        "firmware": str(found.version.version),
    }


def row(found: Found) -> dict[str, Any]:
    """Return what `find --json` says of it, under the same names as of a TReX."""
    return {
        "port": found.settings.url,
        "product": "Aracna",
        "firmware": str(found.version.version),
        "baud": found.settings.line.baud,
        "detection": found.settings.line.detection.name.lower(),
        "polynomial": None,
        "stop_bits": found.settings.line.stop_bits,
        "device_number": None,
        "echo": False,
        "note": found.note,
        "options": f"--port {found.settings.url}",
    }
