"""The provision command."""

import sys
from collections.abc import Callable
from contextlib import ExitStack, suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import click

from trex_gui.core.cli import reported_errors, say
from trex_gui.core.command_io import FileName
from trex_gui.core.errors import BadRequest, NoReply, PortUnavailable, StudioError
from trex_gui.core.host import host
from trex_gui.core.terminal_keys import pressed_keys
from trex_gui.core.texts import counted
from trex_gui.devices.trex.cli.common import link_options, link_settings
from trex_gui.devices.trex.cli.files import read_file
from trex_gui.devices.trex.discovery import NUMBERS
from trex_gui.devices.trex.library import Trex
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.settings.comparison import Comparison, ComparisonRow
from trex_gui.devices.trex.settings.document import Settings, settings_of
from trex_gui.devices.trex.settings.provision_record import (
    ENDED_IN_MOTOR_TEST,
    ProvisionedBoard,
    ProvisionRecord,
    differing,
    fingerprint,
    result_text,
)

_RETRY_S = 0.5  # seconds between two attempts to reach a board
_PULSE_SPEED = 30  # on a scale of 0 to 127
_FIRST_REPEAT = 0.8  # maximum seconds from the press of a key to its first repeat
_NEXT_REPEAT = 0.25  # maximum seconds between two repeats of a held key
_ENTER = {"\r", "\n"}
_END = {"q", "\x04", ""}  # q, Ctrl-D in a terminal, or the end of a pipe


@click.command()
@link_options
@click.argument("profile", type=FileName(dir_okay=False))
@click.option(
    "--record",
    "file",
    type=FileName(dir_okay=False),
    default="provisioned.csv",
    show_default=True,
    help="CSV file with a line for each board.",
)
@click.option(
    "--name", default="robot {number}", show_default=True, help="Name pattern for new boards."
)
@click.option(
    "--first",
    type=click.IntRange(0, NUMBERS - 1),
    default=1,
    show_default=True,
    help="First device number to assign.",
)
@click.option(
    "--pulse", is_flag=True, help="After writing, turn each motor slowly while Space is held."
)
@click.option("--limit", type=click.IntRange(1), metavar="N", help="End after N boards.")
def provision(
    profile: str,
    *,
    file: str,
    name: str,
    first: int,
    pulse: bool,
    limit: int | None,
    **options: Any,
) -> None:
    """Set up boards with the settings of PROFILE, one after another on the same cable.

    Waits for a board, assigns a free device number and a name to a new board, and shows the
    differences. Press Enter to write the settings, s to skip the board, or q to end. Every value
    is read back, and a line is added to the record. Then unplug the board and connect the next
    board.

    Boards have no serial number. A board whose device number is in the record keeps this number,
    and the record says whether its calibrations have changed.
    """
    link = link_settings(options)
    if link.device_number is not None:
        raise click.UsageError(
            "`trexcmd provision` sets up one board at a time and cannot use the expanded protocol."
        )
    if pulse and not sys.stdin.isatty():
        raise click.UsageError("--pulse needs a terminal, because a pipe cannot report a held key.")
    target = read_file(profile)
    with reported_errors():
        record = ProvisionRecord(Path(file), name=name, first=first)
        setup = _Setup(link, profile, target, record, pulses=pulse)
        done = 0
        while done != limit and setup.set_up_next(is_last=done + 1 == limit):
            done += 1
    say(f"{counted(done, 'board')} in {file}.")


@dataclass
class _Setup:
    link: ConnectionSettings
    profile: str
    target: Settings  # content of the profile
    record: ProvisionRecord
    pulses: bool

    def set_up_next(self, *, is_last: bool) -> bool:
        """Wait for a board and set it up. Return whether the user wants more boards."""
        say(f"Waiting for a board on {self.link.url} ...")
        wants_more = True
        try:
            with ExitStack() as stack:
                trex = self._wait_for_board(stack)
                wants_more = self._set_up(trex)
                if wants_more and not is_last:
                    say("Unplug the board.")
                    with suppress(NoReply, PortUnavailable):
                        while trex.is_responding:
                            trex.wait(1.0)
        except (NoReply, PortUnavailable) as error:
            say(str(error))
            _say_notes(error)
        except BaseException as error:
            _say_notes(error)
            raise
        return wants_more

    def _wait_for_board(self, stack: ExitStack) -> Trex:
        trex, last_text = Trex(self.link.url), ""
        trex.settings = self.link
        while True:
            try:
                return stack.enter_context(trex)
            except StudioError as error:
                is_expected = getattr(error, "code", None) is ErrorCode.NO_BOARD
                if not is_expected and str(error) != last_text:
                    last_text = str(error)
                    say(last_text)
            with (condition := host().condition()):
                condition.wait(_RETRY_S)

    def _set_up(self, trex: Trex) -> bool:
        try:
            rows, stored = self._differing(trex), settings_of(trex.state)
            board = self.record.propose(stored, str(trex.state.signature), rows)
        except BadRequest as error:  # such as another model, but the next board may fit
            say(str(error))
            return True
        say(f"\n{board.board}, {board.certainty}: {board.name}, device number {board.number}")
        for row in rows:
            say(f"  {row.name}: {row.text_before or 'not known'} -> {row.text_after}")
        click.echo("Enter: write and check; s: skip; q: end ", nl=False, err=True)
        while (key := read_key()) not in {*_ENTER, "s", *_END}:
            pass
        click.echo(err=True)
        if key in _END:
            return False
        trex.wait(0.05)  # raises NoReply if the board was unplugged
        if key in _ENTER:
            self._save(board)  # record the number before the board stores it
            result = self._write(trex, board.number, rows)
            if trex.is_responding:
                board = replace(board, calibrations=fingerprint(settings_of(trex.state)))
            board = replace(board, result=result)
        else:
            board = self.record.skipped(board, stored)
        self._save(board)
        say(f"{board.name}: {board.result}.")
        return True

    def _save(self, board: ProvisionedBoard) -> None:
        self.record.add(board)
        while True:
            try:
                self.record.save()
            except StudioError as error:
                say(f"{error} Any key: try again; q: end.")
                if read_key() in _END:
                    raise
            else:
                return

    def _differing(self, trex: Trex) -> tuple[ComparisonRow, ...]:
        return differing(Comparison(trex.compare_settings(self.profile)))

    def _write(self, trex: Trex, number: int, rows: tuple[ComparisonRow, ...]) -> str:
        try:
            trex.apply_settings(rows)
            trex.set_parameters(device_number=number)
            remaining = self._differing(trex)
            if self.pulses and not remaining:
                with pressed_keys() as typed:
                    for motor in (1, 2):
                        if not pulse(trex, motor, typed):
                            return ENDED_IN_MOTOR_TEST
        except StudioError as error:
            return str(error)
        return result_text(self.target, settings_of(trex.state), remaining)


def pulse(trex: Trex, motor: int, typed: Callable[[], str]) -> bool:
    """Turn a motor slowly while Space is held. Return True if the user pressed Enter.

    `typed` returns the keys that were typed since its last call.
    """
    say(f"Hold Space to turn motor {motor}; Enter: continue; q: end.")
    clock, pressed_at, presses = host().clock, 0.0, 0  # presses since the motor started
    typed()
    while True:
        keys = typed()
        if any(key in keys for key in ("\r", "\n", "q", "\x1b", "\x04")):
            trex.stop()
            return "\r" in keys or "\n" in keys
        if " " in keys:
            pressed_at, presses = clock(), presses + 1
            trex.drive(*((_PULSE_SPEED, None) if motor == 1 else (None, _PULSE_SPEED)))
        elif presses and clock() - pressed_at > (_FIRST_REPEAT if presses == 1 else _NEXT_REPEAT):
            presses = 0
            trex.stop()
            typed()  # drop keys typed during the stop
        trex.wait(0.05)


def read_key() -> str:
    """Read a key from the terminal, or a character from a pipe. Empty at the end of the pipe."""
    return click.getchar() if sys.stdin.isatty() else sys.stdin.read(1)


def _say_notes(error: BaseException) -> None:
    for note in getattr(error, "__notes__", ()):
        say(note)
