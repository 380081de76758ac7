"""The check-settings command."""

from dataclasses import asdict, dataclass
from typing import Any

import click

from trex_gui.core.cli import CommandFailed, json_option, print_json, reported_errors, say
from trex_gui.core.errors import BadRequest
from trex_gui.core.files import Finding, SettingsError, Severity
from trex_gui.core.texts import counted
from trex_gui.devices.trex.cli.files import FILE, content_of, name_of, save_file
from trex_gui.devices.trex.protocol.device_table import Model, device_table
from trex_gui.devices.trex.settings.conversion import Conversion, conversion_lines, convert
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_in_place import amend
from trex_gui.devices.trex.settings.reader import read_settings, repair_values
from trex_gui.devices.trex.settings.rules import LintFinding, accept_proposals, lint
from trex_gui.devices.trex.settings.writer import write_settings


@dataclass(slots=True)
class _Checked:
    data: bytes
    text: str | bytes = b""  # `data` with repaired values; `settings` may contain further changes
    settings: Settings | None = None
    repairs: tuple[str, ...] = ()
    findings: tuple[Finding, ...] = ()
    conversion: Conversion | None = None
    warnings: tuple[LintFinding, ...] = ()

    def check(self, name: str, board: tuple[Model, str | None] | None, *, fix: bool) -> None:
        self.text = self.data
        if fix:
            self.text, self.repairs = repair_values(self.data, name)
        self.settings, self.findings = read_settings(self.text, name)
        if board is not None:
            self.conversion = convert(self.settings, *board)
            self.settings = self.conversion.settings
        if fix:
            self.settings, accepted = accept_proposals(self.settings)
            self.repairs += tuple(f"{finding.proposal}: {finding.message}" for finding in accepted)
        self.warnings = lint(self.settings)

    def lines(self) -> list[str]:
        lines = [f"repaired: {line}" for line in self.repairs]
        lines += map(str, self.findings)
        lines += conversion_lines(self.conversion) if self.conversion else ()
        return [*lines, *(f"warning: {finding.text}" for finding in self.warnings)]

    def report(self) -> dict[str, Any]:
        return {
            "usable": self.settings is not None,
            "findings": list(map(asdict, self.findings)),
            "warnings": [
                {name: getattr(finding, name) for name in ("rule", "keys", "message", "proposal")}
                for finding in self.warnings
            ],
            "repairs": self.repairs,
            "conversion": list(map(asdict, self.conversion.rows if self.conversion else ())),
        }

    def written(self, settings: Settings, *, keep_all: bool) -> str:
        """Return the text of the file with `settings`, ending with a newline.

        With `keep_all`, raises SettingsError if comments or the order of settings would be lost.
        """
        before = self.text if isinstance(self.text, str) else self.text.decode("utf-8")
        try:
            after = amend(before, settings)
        except SettingsError as error:
            if keep_all:
                raise
            say(f"The comments and the order of settings could not be kept: {error}")
            return write_settings(settings)
        if after.endswith(("\n", "\r")):
            return after
        return after + ("\r\n" if "\r\n" in after else "\n")


def _board(
    _context: click.Context, _parameter: click.Parameter, given: str | None
) -> tuple[Model, str | None] | None:
    """Parse `trexjr` or `trexjr-1.0`."""
    if given is None:
        return None
    key, _, firmware = given.partition("-")
    try:
        model = device_table().model(key)
    except BadRequest as error:
        raise click.BadParameter(str(error)) from error
    if firmware and firmware not in model.firmware:
        known = ", ".join(model.firmware)
        raise click.BadParameter(f"unknown firmware {firmware}; known versions are {known}")
    return model, firmware or None


@click.command("check-settings")
@click.argument("file", metavar="IN", type=FILE)
@click.argument("out", required=False, type=FILE)
@click.option(
    "--fix", is_flag=True, help="Repair values where possible, in OUT or by default in IN."
)
@click.option(
    "--for",
    "board",
    metavar="MODEL[-FIRMWARE]",
    callback=_board,
    help="Convert the settings for another board, such as trexjr or trexjr-1.0. Give OUT to save "
    "the result.",
)
@json_option
def check_settings(
    file: str, out: str | None, fix: bool, board: tuple[Model, str | None] | None, as_json: bool
) -> None:
    """Check a settings file without a board. With OUT, write the checked file there.

    Lists errors and warnings by line on standard error. "-" is standard input or output.

    With --fix, values with units become wire values, numbers outside their range become the nearest
    limit, and the changes that warnings propose are made. With --for, values that have a different
    meaning on the other board are converted, and settings that the other board does not have become
    comments. Each change is listed. Comments and the order of settings are kept. Nothing is written
    while errors remain.
    """
    target = out if out is not None else file if fix and board is None else None
    if as_json and target == "-":
        raise click.UsageError("--json and OUT cannot both use standard output.")
    if fix and board is not None and out is None:
        raise click.UsageError("--for never changes IN. Give the file to write as OUT.")
    name = name_of(file)
    with reported_errors():
        data = content_of(file)
    checked = _Checked(data)
    text = ""
    try:
        checked.check(name, board, fix=fix)
        if checked.settings is not None and target is not None:
            text = checked.written(checked.settings, keep_all=fix)
    except SettingsError as error:
        checked = _Checked(data, findings=error.findings)
    for line in checked.lines():
        say(f"{name}: {line}")
    if as_json:
        print_json(checked.report())
    if checked.settings is None:
        errors = sum(finding.severity is Severity.ERROR for finding in checked.findings)
        nothing = "; nothing was written" if fix else ""
        raise CommandFailed(f"{name} has {counted(errors, 'error')}{nothing}.")
    if target == file != "-" and text.encode() == data:
        say(f"{name}: nothing to repair.")
    elif target is not None:
        save_file(target, text)
