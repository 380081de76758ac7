"""provision: one cable, many boards in turn."""

import csv
import hashlib
import sys
from collections.abc import Iterator
from contextlib import ExitStack, suppress
from dataclasses import asdict, dataclass, fields
from datetime import datetime
from pathlib import Path
from queue import SimpleQueue
from typing import Any

import click

from trex_gui.core.cli import CommandFailed, refusals, say
from trex_gui.core.command_io import FileName
from trex_gui.core.errors import NoReply, PortUnavailable, StudioError
from trex_gui.core.files import load, save
from trex_gui.core.host import host
from trex_gui.core.texts import counted
from trex_gui.devices.trex.cli.common import link_options, link_settings
from trex_gui.devices.trex.cli.files import read_file
from trex_gui.devices.trex.discovery import NUMBERS
from trex_gui.devices.trex.library import Trex
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.comparison import ComparisonRow

_FACTORY_NUMBER = 7  # given to no board, so that one that has it is new
_LOOK_S = 0.5  # seconds between two looks for a board
_PULSE = 30  # speed of 127
_WRITE, _END = {"\r", "\n"}, {"q", "\x04", ""}  # keys; Ctrl-D in a terminal, the end of a pipe
_HELD_S = 0.8  # seconds without a key after which it is released: terminals repeat late at first


@dataclass(frozen=True, slots=True)
class ProvisionedBoard:
    """A line of the record."""

    time: str  # local, with the offset to UTC
    name: str
    number: int
    board: str  # model and firmware
    calibrations: str  # a hash of them: boards have no serial number
    differences: str  # keys of what was to be written
    result: str  # ok, skipped, or what went wrong
    certainty: str  # new, known, or number only

    @classmethod
    def of(cls, row: dict[str, Any]) -> "ProvisionedBoard":
        return cls(**{**row, "number": int(row["number"])})


class ProvisionRecord:
    """A CSV file with a line for each board that was set up."""

    def __init__(self, file: Path) -> None:
        """Raise a SettingsError if the file cannot be used."""
        self._file = file
        self.rows: list[ProvisionedBoard] = []
        names = [field.name for field in fields(ProvisionedBoard)]
        if file.exists():
            reader = csv.DictReader(load(file, "records").decode("utf-8-sig").splitlines())
            if reader.fieldnames != names:
                raise CommandFailed(f"{file} is no record of this command; name another one.")
            try:
                self.rows = [ProvisionedBoard.of(row) for row in reader]
            except (TypeError, ValueError) as error:
                raise CommandFailed(f"{file} is damaged: {error}.") from error

    def known(self, number: int) -> ProvisionedBoard | None:
        """Return the newest line of the board with a number."""
        return next((row for row in reversed(self.rows) if row.number == number), None)

    def free_number(self, first: int) -> int:
        taken = {_FACTORY_NUMBER, *(row.number for row in self.rows)}
        numbers: list[int] = [*range(first, NUMBERS), *range(first)]
        for number in numbers:
            if number not in taken:
                return number
        raise CommandFailed(f"All {NUMBERS} device numbers are in {self._file}.")

    def add(self, row: ProvisionedBoard) -> None:
        """Write the whole file anew: after a SettingsError the old one is there."""
        self.rows.append(row)
        with refusals():
            save(self._file, "".join(self._lines()))

    def _lines(self) -> Iterator[str]:
        names = [field.name for field in fields(ProvisionedBoard)]
        for cells in (names, *(asdict(row).values() for row in self.rows)):
            quoted = (f'"{str(cell).replace(chr(34), chr(34) * 2)}"' for cell in cells)
            yield f"{','.join(quoted)}\n"


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
@click.option("--name", default="robot {number}", show_default=True, help="Names of new boards.")
@click.option(
    "--first",
    type=click.IntRange(0, NUMBERS - 1),
    default=1,
    show_default=True,
    help="The first device number to give.",
)
@click.option("--pulse", is_flag=True, help="Then turn each motor slowly while a key is held.")
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
    """Set up one board after the other with the settings of PROFILE, on the same cable.

    Waits for a board, gives a new one a free device number and a name, shows what differs, and
    writes it on one key: Enter writes, s skips the board, q ends. Every value is read back, and a
    line is added to the record. Then the board is unplugged, and the next one follows.

    Boards have no serial number. One whose device number is in the record keeps it, and the record
    says whether its calibrations are those of last time, too.
    """
    link = link_settings(options)
    if link.device_number is not None:
        raise click.UsageError("One board at a time is set up here, without --protocol expanded.")
    read_file(profile)
    with refusals():
        record = ProvisionRecord(Path(file))
    shop = _Shop(link, profile, record, name, first, pulse=pulse)
    done = 0
    while (limit is None or done < limit) and shop.take_board():
        done += 1
    say(f"{counted(done, 'board')} in {file}.")


class _Shop:
    def __init__(
        self,
        link: ConnectionSettings,
        profile: str,
        record: ProvisionRecord,
        name: str,
        first: int,
        *,
        pulse: bool,
    ) -> None:
        self._link, self._profile, self._record = link, profile, record
        self._name, self._first, self._pulses = name, first, pulse

    def take_board(self) -> bool:
        """Wait for a board and set it up; return whether the user wants more."""
        say(f"Waiting for a board on {self._link.url} ...")
        with ExitStack() as stack:
            trex = self._wait_for_board(stack)
            if not self._set_up(trex):
                return False
            say("Unplug it.")
            with suppress(NoReply, PortUnavailable):
                while True:
                    trex.wait(1.0)
        return True

    def _wait_for_board(self, stack: ExitStack) -> Trex:
        said = ""
        while True:
            try:
                return stack.enter_context(self._open())
            except NoReply:
                pass
            except StudioError as error:
                if str(error) != said:
                    said = str(error)
                    say(said)
            with (condition := host().condition()):
                condition.wait(_LOOK_S)

    def _open(self) -> Trex:
        link, line = self._link, self._link.line
        return Trex(
            link.url,
            baud=line.baud,
            detection=line.detection.name.lower(),  # type: ignore[arg-type] # of the same names
            stop_bits=line.stop_bits,
            polynomial=link.polynomial,
            timeout=link.timeouts.extra,
        )

    def _set_up(self, trex: Trex) -> bool:
        board, prints = str(trex.state.signature), _fingerprint(trex)
        stored = trex.parameter("device_number")
        known = self._record.known(stored)
        number = self._record.free_number(self._first) if known is None else stored
        name = known.name if known else self._name.replace("{number}", str(number))
        certainty = "new"
        if known is not None:
            certainty = "known" if known.calibrations == prints else "number only"
        rows = self._differing(trex)
        say(f"\n{board}, {certainty}: {name}, device number {number}")
        for row in rows:
            say(f"  {row.name}: {row.text_before or 'not known'} -> {row.text_after}")
        click.echo("Enter: write and check; s: skip; q: end ", nl=False, err=True)
        while (key := read_key()) not in {*_WRITE, "s", *_END}:
            pass
        click.echo(err=True)
        if key in _END:
            return False
        keys = [row.key for row in rows]
        if number != stored:
            keys.append(ParameterKey.DEVICE_NUMBER)
        result = self._write(trex, number, rows) if key in _WRITE else "skipped"
        if result == "ok":
            stored, prints = number, _fingerprint(trex)
        self._record.add(
            ProvisionedBoard(
                datetime.now().astimezone().isoformat(timespec="seconds"),
                name,
                stored,
                board,
                prints,
                " ".join(keys),
                result,
                certainty,
            )
        )
        say(f"{name}: {result}.")
        return True

    def _differing(self, trex: Trex) -> tuple[ComparisonRow, ...]:
        with refusals():
            rows = trex.compare_settings(self._profile)
        return tuple(row for row in rows if row.key != ParameterKey.DEVICE_NUMBER)

    def _write(self, trex: Trex, number: int, rows: tuple[ComparisonRow, ...]) -> str:
        """Return how it ended, for the record."""
        try:
            trex.apply_settings(rows)
            trex.set_parameters(device_number=number)
            if left := self._differing(trex):
                return f"differs: {' '.join(row.key for row in left)}"
            if self._pulses:
                for motor in (1, 2):
                    pulse(trex, motor)
        except StudioError as error:
            return str(error)
        return "ok"


def pulse(trex: Trex, motor: int) -> None:
    """Turn a motor slowly while a key is held, until Enter is pressed."""
    say(f"Hold a key to turn motor {motor}; Enter: go on.")
    keys: SimpleQueue[str] = SimpleQueue()

    def read() -> None:
        key = ""
        with suppress(EOFError, KeyboardInterrupt):
            while (key := read_key()) not in {"\r", "\n", ""}:
                keys.put(key)
        keys.put("")

    host().start_thread(read)
    clock, pressed, is_running = host().clock, 0.0, False
    while True:
        trex.wait(0.05)
        while not keys.empty():  # all of them: a motor must not turn for keys of a moment ago
            if not keys.get():
                trex.stop()
                return
            pressed = clock()
            if not is_running:
                trex.drive(*((_PULSE, None) if motor == 1 else (None, _PULSE)))
                is_running = True
        if is_running and clock() - pressed > _HELD_S:
            trex.stop()
            is_running = False


def read_key() -> str:
    """Wait for a key of the terminal, or read the next character of a pipe. Empty at its end."""
    return click.getchar() if sys.stdin.isatty() else sys.stdin.read(1)


def _fingerprint(trex: Trex) -> str:
    """Return a hash of the calibrations that the board shows."""
    shown = sorted(trex.state.calibrations.items())
    return hashlib.sha256(repr(shown).encode()).hexdigest()[:8]
