"""What a board stored before a command changed it."""

from trex_gui.core.cli.console import say
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.history import SettingsHistory


def keep(settings: Settings, link: ConnectionSettings, reason: str) -> None:
    """Save a snapshot where the window keeps its own, and say where.

    Raises:
        SettingsError: it cannot be saved; nothing must be written to the board then.
    """
    history = SettingsHistory()
    snapshot = history.take(settings, adapter=link.name or link.url, reason=reason)
    say(f"What the board stores now is kept in {snapshot.path}.")
    if problem := history.bound().problem:
        say(f"Warning: {problem} `trexcmd history keep 500` sets it anew.")
