"""What every command does before and after it changes what a board stores."""

from collections.abc import Mapping
from dataclasses import replace

from trex_gui.core.cli import ProgressLine, say
from trex_gui.devices.trex.cli.common import as_options
from trex_gui.devices.trex.cli.reconnect_hint import say_how_to_reach
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import DeviceState, read_everything
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import Rejected, ResultCode
from trex_gui.devices.trex.settings.comparison import Comparison, compare
from trex_gui.devices.trex.settings.document import Settings, settings_of
from trex_gui.devices.trex.settings.history import SettingsHistory
from trex_gui.devices.trex.settings.rules import Context, lint


def read_board(client: TrexClient) -> DeviceState:
    """Read everything, with a line on a terminal that says how far it is."""
    with ProgressLine("Reading") as line:
        return read_everything(client.request, line)


def warn(settings: Settings, context: Context) -> None:
    """Report the findings of the settings check."""
    for found in lint(settings, context):
        say(f"Warning: {found.message}" + (f" {found.proposal}." if found.proposal else ""))


def say_changes(result: Comparison) -> None:
    """Say what will be written, old → new; what stays as it is has no line."""
    rows = tuple(row for row in result.rows if row.changed)
    if text := replace(result, rows=rows).report():
        say(text)


def require_serial_mode(state: DeviceState, what: str) -> None:
    """Check that the board accepts writes.

    Raises:
        Rejected: it is not in serial mode.
    """
    if not state.mode.is_serial:
        raise Rejected(what, ResultCode.NOT_SERIAL_MODE)


def prepare_one(
    state: DeviceState,
    after: Settings,
    context: Context,
    link: ConnectionSettings,
    *,
    what: str,
    command: str,
) -> bool:
    """Do what comes before the write of one setting; return whether there is one to write.

    Args:
        state: what the board stores.
        after: what it is to store.
        context: for the rules.
        link: how the board was reached.
        what: the setting, for the user.
        command: the snapshot's reason.

    Raises:
        Rejected: the board is not in serial mode.
        SettingsError: the snapshot cannot be saved; nothing must be written then.
    """
    before = settings_of(state)
    result = compare(before, after)
    if not result.changed:
        say(f"{what} has this value already; nothing is written.")
        return False
    require_serial_mode(state, what)
    warn(after, context)
    say_changes(result)
    keep(before, link, command)
    return True


def say_what_follows(
    client: TrexClient, link: ConnectionSettings, state: DeviceState, stored: Mapping[str, int]
) -> None:
    """Report what needs a power cycle and how to reach the board now and after it.

    Args:
        client: the line after the writing.
        link: how the board was reached before it.
        state: what the board stored before it.
        stored: the parameters that were written, wire values by key.
    """
    specs = state.specs
    if waiting := sorted(specs[key].name for key in stored if specs[key].needs_power_cycle):
        say(f"{', '.join(waiting)}: in force when the board is switched off and on.")
    if client.settings != link:
        say(f"Reach the board with {as_options(client.settings)} from now on.")
    say_how_to_reach(client.settings, {**state.parameters, **stored}, state.signature.firmware)


def keep(settings: Settings, link: ConnectionSettings, reason: str) -> None:
    """Save a snapshot where the window keeps its own, and say where.

    Raises:
        SettingsError: it cannot be saved; nothing must be written to the board then.
    """
    history = SettingsHistory()
    snapshot = history.take(settings, adapter=link.name or link.url, reason=reason)
    say(f"Snapshot of the previous settings: {snapshot.path}.")
    if problem := history.bound().problem:
        say(f"Warning: {problem} `trexcmd history keep 500` sets it anew.")
