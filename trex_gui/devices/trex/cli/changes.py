"""Steps shared by commands that change stored settings."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from trex_gui.core.cli import Interruption, ProgressLine, say
from trex_gui.core.files import Finding, SettingsError
from trex_gui.core.texts import counted
from trex_gui.core.transport.adapters import adapter_key
from trex_gui.devices.trex.board.keeper import Keeper, read_record
from trex_gui.devices.trex.cli.common import as_options, identify
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import DeviceState, read_everything
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import Rejected, ResultCode
from trex_gui.devices.trex.session.reconnecting import after_power_cycle
from trex_gui.devices.trex.settings.accepted import AcceptedValues
from trex_gui.devices.trex.settings.board_records import BoardRecord, utc_now
from trex_gui.devices.trex.settings.comparison import Comparison, compare
from trex_gui.devices.trex.settings.document import Settings, open_values, settings_of
from trex_gui.devices.trex.settings.edit_files import BoardIdentity
from trex_gui.devices.trex.settings.rules import Context, lint


def read_board(client: TrexClient) -> DeviceState:
    identify(client)
    with ProgressLine("Reading") as line:
        return read_everything(client.request, line, has_crc=client.has_crc)


def say_warning(text: str) -> None:
    say(f"Warning: {text}")


def warn(settings: Settings, context: Context) -> None:
    for finding in lint(settings, context):
        say_warning(finding.text)


def say_changes(result: Comparison) -> None:
    rows = tuple(row for row in result.rows if row.changed)
    if text := replace(result, rows=rows).report():
        say(text)


def require_consent(
    name: str, state: DeviceState, target: Mapping[str, int], *, force: bool
) -> None:
    """Raise SettingsError for values beyond inferred limits, unless `force` is set.

    Values that boards with this model and firmware have already stored need no consent. `name` is
    the name of the file or setting, for the error.
    """
    known, specs = AcceptedValues().of(state.signature), state.specs
    findings = [
        Finding(None, key, f"{problem}{specs[key].limits_mark}: --force lets the board decide")
        for key, wire in open_values(specs, target).items()
        if wire not in known.get(key, ()) and wire != state.parameters.get(key)
        if (problem := specs[key].problem(wire)) is not None
    ]
    if findings and not force:
        raise SettingsError(name, findings)


def keeper_of(client: TrexClient, state: DeviceState) -> Keeper:
    keeper, adapter = Keeper(say, say_warning), adapter_key(client.settings.url)
    keeper.memory.set_board(
        settings_of(state), state.source, utc_now(), opened=True, adapter=adapter
    )
    keeper.load()
    return keeper


def require_serial_mode(state: DeviceState, name: str) -> None:
    if not state.mode.is_serial:
        raise Rejected(name, ResultCode.NOT_SERIAL_MODE)


def change_one(
    client: TrexClient,
    state: DeviceState,
    after: Settings,
    context: Context,
    *,
    name: str,
    command: str,
) -> None:
    """Store the setting of `after` that differs from the stored settings.

    `name` is the name of the setting for the user. `command` is the reason of the snapshot.

    Raises Rejected if the board is not in serial mode, or SettingsError if the snapshot cannot be
    saved. In both cases, nothing is written.
    """
    before, link = settings_of(state), client.settings
    result = compare(before, after)
    if not result.changed:
        say(f"{name} already has this value; nothing is written.")
        return
    require_serial_mode(state, name)
    warn(after, context)
    say_changes(result)
    parameters = after.parameters.items() - before.parameters.items()
    calibrations = after.calibrations.items() - before.calibrations.items()
    write_one(client, state, command, list(parameters), list(calibrations))
    say_next_steps(client, link, state, dict(parameters))


def write_one(
    client: TrexClient,
    state: DeviceState,
    command: str,
    parameters: Sequence[tuple[str, int]],
    calibrations: Sequence[tuple[CalibrationKey, Calibration]] = (),
) -> None:
    with Interruption():
        (stored,) = keeper_of(client, state).write(client, state, command, parameters, calibrations)
    if stored.error is not None:
        raise stored.error


def board_settings(state: DeviceState) -> Settings:
    """Return the stored settings with the notes saved on this computer."""
    stored = settings_of(state)
    return replace(stored, notes=record_of(stored).settings.notes)


def save_notes(client: TrexClient, state: DeviceState, notes: Mapping[str, str]) -> None:
    if not notes:
        return
    memory = keeper_of(client, state).memory
    saved = {} if memory.record is None else memory.record.settings.notes
    if (merged := {**saved, **notes}) != saved:
        memory.set_notes(merged)
        saved_notes = counted(len(notes), "note")
        say(f"{saved_notes} saved on this computer, because a board cannot store notes.")


def record_of(stored: Settings) -> BoardRecord:
    """Load the record of a board. If it is damaged, warn and return an empty record."""
    board = BoardIdentity.of(stored)
    return read_record(board, say_warning) or BoardRecord(Settings(board.product, board.firmware))


def say_next_steps(
    client: TrexClient, link: ConnectionSettings, state: DeviceState, stored: dict[str, int]
) -> None:
    """Report pending settings and the options that reach the board.

    `link` and `state` are from before the write. `stored` contains the written parameters.
    """
    specs = state.specs
    if pending := sorted(specs[key].name for key in stored if specs[key].needs_power_cycle):
        say(f"Takes effect when the board is switched off and on: {', '.join(pending)}.")
    if client.settings != link:
        say(f"From now on, connect with {as_options(client.settings)}.")
    say_how_to_reach(client.settings, {**state.parameters, **stored}, state.signature.firmware)


def say_how_to_reach(used: ConnectionSettings, stored: dict[str, int], firmware: str) -> None:
    """Report the options that reach the board after its next power cycle, if they change."""
    after = after_power_cycle(used, stored, firmware)
    if after is None:
        say("The UART settings are not known. After a power cycle, run `trexcmd find`.")
    elif (options := as_options(after)) != as_options(used):
        say(f"After the board is switched off and on, connect with {options}")
