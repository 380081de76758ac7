"""check-settings: check, repair and convert a settings file without a board."""

from dataclasses import asdict

import click

from trex_gui.core.cli import CommandFailed, json_option, print_json, refusals, say
from trex_gui.core.files import SettingsError, Severity
from trex_gui.core.texts import counted
from trex_gui.devices.trex.cli.files import FILE, content_of, name_of, save_file, say_repairs
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_in_place import amend
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.repair import repair_file
from trex_gui.devices.trex.settings.rules import lint
from trex_gui.devices.trex.settings.writer import write_settings


@click.command("check-settings")
@click.argument("file", metavar="IN", type=FILE)
@click.argument("out", required=False, type=FILE)
@click.option("--fix", is_flag=True, help="Repair what can be repaired, in IN or as OUT.")
@json_option
def check_settings(file: str, out: str | None, fix: bool, as_json: bool) -> None:
    """Check a settings file without a board; with OUT, write the checked file there.

    Lists errors and warnings by line on standard error; - is standard input or output. With
    --fix, values with units become wire values, numbers beyond their range the nearest one in it,
    and proposals of warnings are accepted. Each repair is listed; comments and order are kept.
    Nothing is written while errors are left.
    """
    target = out if out is not None else file if fix else None
    if as_json and target == "-":
        raise click.UsageError("--json and OUT cannot both use standard output.")
    name = name_of(file)
    with refusals():
        data = content_of(file)
    repairs: tuple[str, ...] = ()
    text: str | bytes = data
    settings: Settings | None = None
    try:
        if fix:
            text, repairs = repair_file(data, name)
        settings, findings = read_settings(text, name)
    except SettingsError as error:
        findings = error.findings
    lint_findings = lint(settings) if settings is not None else ()
    say_repairs(file, repairs)
    for finding in findings:
        say(f"{name}: {finding}")
    for found in lint_findings:
        say(f"{name}: warning: {found.message}" + (f" {found.proposal}." if found.proposal else ""))
    if as_json:
        report = {
            "usable": settings is not None,
            "findings": [asdict(finding) for finding in findings],
            "warnings": [
                {
                    "rule": found.rule,
                    "keys": list(found.keys),
                    "message": found.message,
                    "proposal": found.proposal,
                }
                for found in lint_findings
            ],
            "repairs": list(repairs),
        }
        print_json(report)
    if settings is None:
        errors = sum(finding.severity is Severity.ERROR for finding in findings)
        nothing = "; nothing was written" if fix else ""
        raise CommandFailed(f"{name} has {counted(errors, 'error')}{nothing}.")
    if isinstance(text, str):
        if target == file != "-" and text.encode() == data:
            say(f"{name}: nothing to repair.")
        elif target is not None:
            save_file(target, text)
    elif target is not None:
        save_file(target, _checked(data, settings))


def _checked(data: bytes, settings: Settings) -> str:
    try:
        text = amend(data.decode("utf-8"), settings)
    except SettingsError as error:
        say(f"Comments and order could not be kept: {error}")
        return write_settings(settings)
    if text.endswith(("\n", "\r")):
        return text
    return text + ("\r\n" if "\r\n" in text else "\n")
