"""What every command does before and after it changes what a board stores."""

import contextlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace

from trex_gui.core.cli import Interruption, ProgressLine, say
from trex_gui.core.errors import StudioError
from trex_gui.core.files import Finding, SettingsError
from trex_gui.core.texts import counted
from trex_gui.devices.trex.board.keeper import Keeper
from trex_gui.devices.trex.cli.common import as_options, identify
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import (
    DeviceState,
    Progress,
    read_everything,
    require_free_number,
)
from trex_gui.devices.trex.client.writing import WriteResult, after_writing, write_all
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import ErrorCode, OtherBoard, Rejected, ResultCode
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.session.reconnecting import after_power_cycle
from trex_gui.devices.trex.settings.accepted import AcceptedValues
from trex_gui.devices.trex.settings.board_records import BoardRecord, BoardRecords, utc_now
from trex_gui.devices.trex.settings.comparison import (
    Comparison,
    compare,
    values_to_write,
)
from trex_gui.devices.trex.settings.document import Settings, open_values, settings_of
from trex_gui.devices.trex.settings.edit_files import BoardIdentity
from trex_gui.devices.trex.settings.rules import Context, lint


def read_board(client: TrexClient) -> DeviceState:
    """Read everything, with a progress line; see `identify` for errors."""
    identify(client)
    with ProgressLine("Reading") as line:
        return read_everything(client.request, line, has_crc=client.has_crc)


def warn(settings: Settings, context: Context) -> None:
    for found in lint(settings, context):
        say(f"Warning: {found.text}")


def say_changes(result: Comparison) -> None:
    rows = tuple(row for row in result.rows if row.changed)
    if text := replace(result, rows=rows).report():
        say(text)


def require_consent(
    file: str, state: DeviceState, wanted: Mapping[str, int], *, force: bool
) -> None:
    """Raise SettingsError for values beyond inferred limits, unless the board is to decide.

    Values that boards with this model and firmware have stored before need no consent.
    """
    known, specs = AcceptedValues().of(state.signature), state.specs
    findings = [
        Finding(None, key, f"{problem}{specs[key].limits_mark}: --force lets the board decide")
        for key, wire in open_values(specs, wanted).items()
        if wire not in known.get(key, ()) and wire != state.parameters.get(key)
        if (problem := specs[key].problem(wire)) is not None
    ]
    if findings and not force:
        raise SettingsError(file, findings)


def keeper_of(client: TrexClient, state: DeviceState) -> Keeper:
    return Keeper(state, client.settings, say, lambda text: say(f"Warning: {text}"))


def require_serial_mode(state: DeviceState, what: str) -> None:
    """Raise Rejected if the board does not accept writes."""
    if not state.mode.is_serial:
        raise Rejected(what, ResultCode.NOT_SERIAL_MODE)


def change_one(
    client: TrexClient,
    state: DeviceState,
    after: Settings,
    context: Context,
    *,
    what: str,
    command: str,
) -> None:
    """Store one setting, if it differs from what the board stores.

    `after` is what the board is to store. Nothing was written after Rejected (the board is not in
    serial mode) or SettingsError (the snapshot could not be saved).

    `what` names the setting for the user; `command` is the snapshot's reason.
    """
    before, link = settings_of(state), client.settings
    result = compare(before, after)
    if not result.changed:
        say(f"{what} already has this value; nothing is written.")
        return
    require_serial_mode(state, what)
    warn(after, context)
    say_changes(result)
    parameters = after.parameters.items() - before.parameters.items()
    calibrations = after.calibrations.items() - before.calibrations.items()
    write_one(client, state, command, list(parameters), list(calibrations))
    say_what_follows(client, link, state, dict(parameters))


def write_one(
    client: TrexClient,
    state: DeviceState,
    command: str,
    parameters: Sequence[tuple[str, int]],
    calibrations: Sequence[tuple[CalibrationKey, Calibration]] = (),
) -> None:
    """Store one setting, if the board still stores what was read; raise what prevents it."""
    with Interruption():
        (stored,) = write_kept(client, state, command, parameters, calibrations)
    if stored.error is not None:
        raise stored.error


def write_kept(
    client: TrexClient,
    state: DeviceState,
    command: str,
    parameters: Sequence[tuple[str, int]],
    calibrations: Sequence[tuple[CalibrationKey, Calibration]] = (),
    *,
    progress: Progress = lambda _done, _total, _what: None,
    cancelled: Callable[[], bool] = lambda: False,
) -> tuple[WriteResult, ...]:
    """Save a snapshot, write, and remember what was applied; see `write_all`.

    Nothing is written after a BadRequest: another board on the line has the device number.
    """
    number = dict(parameters).get(ParameterKey.DEVICE_NUMBER)
    if number is not None and number != state.parameters.get(ParameterKey.DEVICE_NUMBER):
        require_free_number(client, number)
    transaction = keeper_of(client, state).begin(command, parameters, calibrations)
    results = write_all(
        client.request,
        state.specs,
        parameters,
        calibrations,
        progress,
        before=state,
        has_crc=client.has_crc,
        cancelled=cancelled,
    )
    transaction.finish(results, after_writing(state, results), utc_now())
    return results


@contextlib.contextmanager
def restored_afterwards(client: TrexClient, state: DeviceState, command: str) -> Iterator[None]:
    """Save a snapshot, and restore the board in the end, whatever happens.

    Meanwhile the record of the board expects what was stored before: if this program dies, or the
    line is gone, the next connection shows what differs.
    """
    before, keeper = settings_of(state), keeper_of(client, state)
    record = keeper.memory.record
    assert record is not None  # noqa: S101 - it is found at once
    keeper.begin(command, ()).finish((), state, utc_now())
    try:
        yield
    finally:
        try:
            found = read_everything(client.request, has_crc=client.has_crc)
            rows = [row for row in compare(settings_of(found), before).rows if row.changed]
            if found.signature != state.signature or len(rows) > 3:  # one, and stray writes
                raise OtherBoard(ErrorCode.TOO_MANY_DIFFER, len(rows))
            wanted = values_to_write(rows)
            for result in write_all(client.request, state.specs, *wanted, has_crc=client.has_crc):
                if result.error is not None:
                    raise result.error
            keeper.memory.restore(record)
        except StudioError as error:
            say(f"The board may store other settings than before. {error}")
            say("`trexcmd diff --last` shows them; the snapshot has what was stored.")


def board_settings(state: DeviceState) -> Settings:
    """Return what a board stores, with the notes that are kept here."""
    stored = settings_of(state)
    return replace(stored, notes=remembered(stored).settings.notes)


def remember_notes(client: TrexClient, state: DeviceState, notes: Mapping[str, str]) -> None:
    """Keep these notes, besides others on settings of the board."""
    if not notes:
        return
    memory = keeper_of(client, state).memory
    kept = {} if memory.record is None else memory.record.settings.notes
    if (wanted := {**kept, **notes}) != kept:
        memory.set_notes(wanted)
        say(f"{counted(len(notes), 'note')} kept on this computer: a board stores none.")


def remembered(stored: Settings) -> BoardRecord:
    """Return what this computer keeps of a board; empty, with a warning, if it is damaged."""
    board = BoardIdentity.of(stored)
    found = None
    try:
        found = BoardRecords().load(board)
    except SettingsError as error:
        say(f"Warning: what was applied to this board before is not known. {error}")
    return found or BoardRecord(Settings(board.product, board.firmware))


def say_what_follows(
    client: TrexClient, link: ConnectionSettings, state: DeviceState, stored: dict[str, int]
) -> None:
    """Report what needs a power cycle and how to reach the board now and after it.

    `link` and `state` are as before the writing; `stored` are the parameters that were written.
    """
    specs = state.specs
    if waiting := sorted(specs[key].name for key in stored if specs[key].needs_power_cycle):
        say(f"{', '.join(waiting)}: takes effect when the board is switched off and on.")
    if client.settings != link:
        say(f"Reach the board with {as_options(client.settings)} from now on.")
    say_how_to_reach(client.settings, {**state.parameters, **stored}, state.signature.firmware)


def say_how_to_reach(used: ConnectionSettings, stored: dict[str, int], firmware: str) -> None:
    """Report the options that reach the board from its next start on, if they will change.

    `used`: how it is reached now; `stored`: every parameter that it stores, wire values by key.
    """
    coming = after_power_cycle(used, stored, firmware)
    if coming is None:
        say("Its UART settings have an unknown value; find the board with trexcmd find.")
    elif (options := as_options(coming)) != as_options(used):
        say(f"After it is switched off and on, reach it with {options}")
