"""The survey command."""

import json
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from itertools import groupby
from pathlib import Path
from typing import Any

import click

from trex_gui.core.cli import Interruption, ProgressLine
from trex_gui.core.command_io import FileName
from trex_gui.core.errors import BadReply, NoReply
from trex_gui.core.files import save
from trex_gui.core.texts import hex_text
from trex_gui.devices.trex.cli.changes import keeper_of, read_board, require_serial_mode
from trex_gui.devices.trex.cli.common import link_options, link_settings, open_line
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import ATTEMPTS, query, read_reliably
from trex_gui.devices.trex.protocol import commands as c
from trex_gui.devices.trex.protocol.device_table import HIGHEST_WIRE
from trex_gui.devices.trex.protocol.errors import Rejected, TrexBadReplyError
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.protocol.framing import Malformed
from trex_gui.devices.trex.protocol.parameters import Grade, ParameterSpec
from trex_gui.devices.trex.session.reconnecting import LINK_KEYS
from trex_gui.devices.trex.settings.document import settings_of
from trex_gui.version import __version__

_ALL = range(HIGHEST_WIRE + 1)
_SAMPLES = {0, 1, 2, 4, 8, 16, 32, 64, 127}  # reveal bits that the board does not store
_SILENT = "no reply"
_Store = Callable[[ParameterSpec, int], int]  # writes a value and returns the stored value


@click.command()
@link_options
@click.argument("file", type=FileName(dir_okay=False))
@click.option(
    "--limits", is_flag=True, help="Also test each range without a source, after confirmation."
)
@click.option(
    "--as-new", is_flag=True, help="Record in FILE that the board has its factory settings."
)
def survey(file: str, *, limits: bool, as_new: bool, **options: Any) -> None:
    """Write facts about a board's firmware to FILE, for the developers of this program.

    Reads all 128 parameter numbers and the calibrations, and sends every other query. This clears
    the error bits. The board treats an unknown number as a serial error, which may stop motors that
    the channels drive. FILE names no person, computer, port or adapter, and contains no notes.

    With --limits, tests the range of each setting whose range no document confirms. Values are
    written and read back, and the setting is restored. Motors are never driven. The device number
    and the serial settings never change. A snapshot is saved first, and everything is restored at
    the end, even after Ctrl-C.
    """
    with open_line(link_settings(options)) as client:
        state = read_board(client)
        if limits:
            require_serial_mode(state, "Trying values")
            question = "Write test values to settings whose range has no source, then restore them?"
            click.confirm(question, abort=True, err=True)
        facts = _Survey(client)
        with ProgressLine("Reading") as line:
            for number in _ALL:
                line(number, len(_ALL), f"parameter {number:02X}")
                facts.read(number)
        if limits:
            specs = [
                spec
                for spec, stored in settings_of(state).parameter_items()
                if spec.number in facts.stored and spec.key not in LINK_KEYS
                if spec.grade("min", "max") > Grade.SOURCED
                if not spec.problem(stored, forced=True)
            ]
            with (
                Interruption(must_finish=True) as interrupted,
                keeper_of(client, state).restored_afterwards(
                    client, state, "trexcmd survey"
                ) as store,
                ProgressLine("Trying") as line,
            ):
                for done, spec in enumerate(specs):
                    line(done, len(specs), spec.name)
                    facts.find_range(spec, state.parameters[spec.key], store, interrupted)
        text = facts.text(state.signature, as_new=as_new)
        click.echo(text, nl=False)  # before saving, which may fail
        save(Path(file), text)


class _AnyByte(c.GetParameter):
    """Query for a parameter number that may not exist. The reply may be any byte."""

    def parse(self, reply: bytes) -> int:
        return reply[0]


class _Survey:
    def __init__(self, client: TrexClient) -> None:
        self._client, self._request, self._has_crc = client, client.request, client.has_crc
        self._unknown: dict[str, list[int]] = {}  # reply → parameter numbers
        self.stored: dict[int, int] = {}  # number → value of a known parameter
        self._tables: dict[str, dict[str, Any]] = {"errors": {}, "ranges": {}, "altered": {}}

    def read(self, number: int) -> None:
        command, reply = _AnyByte(number), _SILENT
        try:
            value = read_reliably(self._request, command, has_crc=self._has_crc)
        except NoReply:
            query(self._request, c.GetMode())  # raises NoReply if the board is gone
        else:
            if value <= HIGHEST_WIRE and "FORMAT" not in self._errors_of(command):
                self.stored[number] = value
                return
            reply = f"{value:02X}"
        if not self._unknown:
            self._tables["errors"]["unknown_number"] = self._errors_of(command)
        self._unknown.setdefault(reply, []).append(number)

    def find_range(
        self, spec: ParameterSpec, stored: int, store: _Store, interrupted: Interruption
    ) -> None:
        """Find the range by trial, and restore the stored value."""
        tried: dict[int, int | None] = {stored: stored}
        values = [wire for wire in _ALL if wire in spec.valid or spec.is_open(wire)]

        def accepts(wire: int) -> bool:
            if interrupted:
                raise click.Abort
            if wire not in tried:
                tried[wire] = self._try(store, spec, wire)
            return tried[wire] == wire

        for end in (values[0], values[-1]):
            good, bad = stored, end
            while not accepts(bad) and abs(bad - good) > 1:
                middle = (good + bad) // 2
                good, bad = (middle, bad) if accepts(middle) else (good, middle)
        accepted = list(filter(accepts, sorted({*tried, *_SAMPLES} & {*values})))
        candidates: Sequence[int] = range(accepted[0], accepted[-1] + 1)
        if not all(map(accepts, tried.keys() & candidates)):  # the range has gaps
            candidates = values
        altered = [f"{w} as {s}" for w, s in sorted(tried.items()) if s not in {None, w}]
        number = f"0x{spec.number:02X}"
        self._tables["ranges"][number] = _spans(filter(accepts, candidates), "d")
        self._tables["altered"] |= {number: ", ".join(altered)} if altered else {}
        self._try(store, spec, stored)

    def _try(self, store: _Store, spec: ParameterSpec, wire: int) -> int | None:
        """Write a value. Return the stored value, or `None` if the board rejects the write."""
        try:
            return store(spec, wire)
        except Rejected:
            if "rejected_write" not in (errors := self._tables["errors"]):
                errors["rejected_write"] = self._errors_of(c.SetParameter(spec.number, wire))
            return None
        except TrexBadReplyError:
            return read_reliably(self._request, c.GetParameter(spec.number), has_crc=self._has_crc)

    def _errors_of(self, command: c.Command[Any]) -> list[str]:
        """Return the errors that a command causes on every attempt."""
        always = ~UartError.TIMEOUT  # the wait for a reply may cause a timeout
        for _ in range(ATTEMPTS):
            query(self._request, c.GetUartErrors())
            with suppress(NoReply, BadReply):
                self._request(command)
            always &= query(self._request, c.GetUartErrors())
        return [str(bit.name) for bit in always]

    def _reply(self, command: c.Command[Any]) -> str:
        packet = self._client.settings.framing.encode(command)
        raw = self._client.send_packet(Malformed(packet, "")).raw  # the reply is not checked
        return hex_text(raw[len(packet) * self._client.echo :]) or _SILENT

    def text(self, board: c.Signature, *, as_new: bool) -> str:
        """Return the survey as TOML. Values are decimal, parameter numbers hexadecimal."""
        header = {"model": board.model.key, "firmware": board.firmware, "stores_defaults": as_new}
        unknown = {f'"{reply}"': _spans(numbers, "02X") for reply, numbers in self._unknown.items()}
        queries = {
            f"0x{opcode:02X}": self._reply(cls.from_packet(opcode, b"\x1f"))
            for opcode, cls in c.COMMANDS.items()
            if opcode < 0x9F
        }
        stored = {f"0x{number:02X}": value for number, value in self.stored.items()}
        tables: dict[str, dict[str, Any]] = {"board": header, "unknown": unknown}
        tables |= {"queries": queries, "stored": stored, **self._tables}
        lines = [f"# Facts about a board, found by `trexcmd survey` of TReX Studio {__version__}."]
        for name, rows in tables.items():
            lines += ["", f"[{name}]", *(f"{key} = {json.dumps(row)}" for key, row in rows.items())]
        return "\n".join(lines) + "\n"


def _spans(numbers: Iterable[int], format_spec: str) -> str:
    """Return numbers in ascending order as text, such as `18-7A 7F`."""
    pairs = groupby(enumerate(numbers), key=lambda pair: pair[1] - pair[0])
    spans = [[number for _, number in group] for _, group in pairs]
    return " ".join("-".join(format(n, format_spec) for n in sorted({s[0], s[-1]})) for s in spans)
