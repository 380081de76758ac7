"""How a board is reached after its next start, as options of this program."""

from collections.abc import Mapping

from trex_gui.core.cli import say
from trex_gui.devices.trex.cli.common import as_options
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.session.reconnecting import after_power_cycle


def say_how_to_reach(used: ConnectionSettings, stored: Mapping[str, int], firmware: str) -> None:
    """Say with which options to reach a board from its next start on, where they will change.

    Args:
        used: how it is reached now.
        stored: every parameter that it keeps, wire values by key.
        firmware: version.
    """
    coming = after_power_cycle(used, stored, firmware)
    if coming is None:
        say("Its UART settings hold a value that is not known; look for it with trexcmd find.")
    elif (options := as_options(coming)) != as_options(used):
        say(f"Switched off and on, it is reached with {options}")
