"""What `trexcmd list` and `trexcmd find` report of an Aracna."""

from collections.abc import Mapping
from typing import Any

from trex_gui.core.discovery.prober import Evidence
from trex_gui.core.host import host
from trex_gui.core.plugin import PortAnswer, PortReports
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.discovery import FoundRobot, find_aracna


def _identify(url: str, options: Mapping[str, Any]) -> PortAnswer:
    settings = PortSettings(url, timeouts=Timeouts(extra=options["extra_timeout"]))
    search = find_aracna(settings, open_wire=host().open_transport)
    if search.found:
        [found] = search.found
        text = f"{found.name}, {found.motors} motors"
        return PortAnswer(text, "Aracna", str(found.version.version))
    diagnosis = search.diagnosis()
    return PortAnswer(diagnosis.text if diagnosis.evidence > Evidence.ECHO else "")


def _describe(found: FoundRobot) -> str:
    text = f"{found.name}, {found.motors} motors, on {found.settings.text()}."
    return f"{text} {found.note}".strip()


def _row(found: FoundRobot) -> dict[str, Any]:
    """Return the same keys as for a TReX."""
    line = found.settings.line
    return {
        "port": found.settings.url,
        "product": "Aracna",
        "firmware": str(found.version.version),
        "baud": line.baud,
        "detection": line.parity.name.lower(),
        "polynomial": None,
        "stop_bits": line.stop_bits,
        "device_number": None,
        "echo": False,
        "note": found.note,
        "options": f"--port {found.settings.url}",
    }


PORT_REPORTS = PortReports(_identify, _describe, _row)
