"""What `trexcmd list` and `trexcmd find` report of a TReX."""

from collections.abc import Mapping
from typing import Any

from trex_gui.core.errors import BadReply, NoReply
from trex_gui.core.host import host
from trex_gui.core.plugin import PortAnswer, PortReports
from trex_gui.devices.trex.cli.common import as_options, link_settings
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import query
from trex_gui.devices.trex.discovery import FoundBoard
from trex_gui.devices.trex.protocol.commands import GetSignature


def _identify(url: str, options: Mapping[str, Any]) -> PortAnswer:
    """Look at the line settings of the options only; `trexcmd find` tries the others."""
    settings = link_settings(options, url)
    client = TrexClient(host().open_transport(settings), settings)
    try:
        client.detect_echo()
        signature = query(client.request, GetSignature())
    except NoReply:
        return PortAnswer("echo only" if client.echo else "nothing answers")
    except BadReply as error:
        return PortAnswer(f"no TReX: {error}")
    finally:
        client.close()
    return PortAnswer(str(signature), signature.model.name, signature.firmware)


def _describe(found: FoundBoard) -> str:
    number = f", device number {found.device_number}" if found.device_number is not None else ""
    side = " (RS-232 side)" if found.echo else ""
    text = f"{found.signature} on {found.settings.text()}{number}{side}."
    return f"{text}\n{found.note}" if found.note else text


def _row(found: FoundBoard) -> dict[str, Any]:
    line = found.settings.line
    return {
        "port": found.settings.url,
        "product": found.signature.model.name,
        "firmware": found.signature.firmware,
        "baud": line.baud,
        "detection": line.detection.name.lower(),
        "polynomial": f"{found.settings.polynomial:02X}",
        "stop_bits": line.stop_bits,
        "device_number": found.device_number,
        "echo": found.echo,
        "note": found.note,
        "options": as_options(found.settings),
    }


PORT_REPORTS = PortReports(_identify, _describe, _row)
