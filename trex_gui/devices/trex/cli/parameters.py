"""The set and restore-defaults commands."""

import re
from dataclasses import replace
from typing import Any

import click

from trex_gui.core.cli import say
from trex_gui.core.decimals import DECIMAL
from trex_gui.core.errors import BadRequest
from trex_gui.core.files import SettingsError
from trex_gui.devices.trex.cli.changes import (
    change_one,
    read_board,
    require_consent,
    require_serial_mode,
    say_changes,
    say_how_to_reach,
    write_one,
)
from trex_gui.devices.trex.cli.common import (
    complete_parameter,
    link_options,
    link_settings,
    open_line,
    open_line_for_writing,
    specs_of,
)
from trex_gui.devices.trex.client.reading import require_free_number
from trex_gui.devices.trex.protocol.parameters import (
    ParameterKey,
    ParameterKind,
    ParameterSet,
    ParameterSpec,
    unconfirmed_defaults,
)
from trex_gui.devices.trex.settings.comparison import Comparison, compare
from trex_gui.devices.trex.settings.document import factory_settings, settings_of
from trex_gui.devices.trex.settings.rules import Context


@click.command("set", context_settings={"ignore_unknown_options": True})
@link_options
@click.argument("name", shell_complete=complete_parameter)
@click.argument("value")
@click.option(
    "--force",
    is_flag=True,
    help="Let the board decide whether to accept a value beyond an inferred limit.",
)
def set_command(name: str, value: str, force: bool, **options: Any) -> None:
    """Store one parameter and read it back.

    A VALUE without a unit is a wire value: a whole number as in settings files. For example, 15
    means 1.5 s for `serial_timeout`. Any other VALUE has a unit ("1.5 s") or is a word ("off"). The
    decimal separator is a point or a comma. Thousands separators are not allowed.

    A snapshot of the stored settings is saved first. Nothing is written if the board already has
    this value.

    With --force, limits that no source confirms are not enforced. The board may reject the value or
    store a different value. The program remembers that the firmware accepts the stored value.
    """
    link = link_settings(options)
    _check_value(name, value)
    with open_line_for_writing(link) as (client, rates):
        state = read_board(client)
        spec = state.specs[name]
        wire = _wire(spec, value)
        try:
            require_consent(spec.name, state, {spec.key: wire}, force=force)
        except SettingsError as error:
            raise click.UsageError(str(error)) from error
        stored = settings_of(state)
        change_one(
            client,
            state,
            replace(stored, parameters={**stored.parameters, spec.key: wire}),
            Context(port_rates=rates, active_line=link.line),
            name=spec.name,
            command=f"trexcmd set {spec.key}",
        )
        click.echo(f"{wire}\t{spec.text(wire)}")


def _wire(spec: ParameterSpec, value: str) -> int:
    text = value.strip()
    if re.fullmatch(r"[-+]?\d{1,9}", text):
        return spec.check(int(text), forced=True)
    if re.fullmatch(DECIMAL, text) and spec.kind is not ParameterKind.CHANNELS:
        raise BadRequest(f"{text} has no unit, and a wire value must be a whole number")
    return spec.wire(text)


def _check_value(name: str, value: str) -> None:
    """Raise a UsageError for a value that no board accepts."""
    specs = specs_of(name)
    if not specs[0].readable:
        raise click.UsageError(
            f"{specs[0].name} is a command, not a stored value. Use `trexcmd restore-defaults`, "
            "which shows the changes, asks for confirmation and saves a snapshot first."
        )
    problem: BadRequest | None = None
    for spec in specs:
        try:
            _wire(spec, value)
        except BadRequest as error:
            problem = problem or error
        else:
            return
    raise click.UsageError(f"{problem}.")


@click.command("restore-defaults")
@link_options
@click.option("--yes", is_flag=True, help="Do not ask for confirmation.")
def restore_defaults(yes: bool, **options: Any) -> None:
    """Reset every parameter to its factory default.

    Shows the changes and asks for confirmation. The board resets when it is switched off and on.
    Channel calibrations do not change (inferred). A snapshot of the stored settings is saved first.
    Nothing is written if another board on the line has the device number that this board would get.
    """
    link = link_settings(options)
    with open_line(link) as client:
        state = read_board(client)
        require_serial_mode(state, "Restoring the defaults")
        specs = state.specs
        spec = specs[ParameterKey.FACTORY_RESET]
        stored = settings_of(state)
        signature = state.signature
        factory = factory_settings(signature.model, signature.firmware)
        number = factory.parameters[ParameterKey.DEVICE_NUMBER]
        if link.device_number not in {None, number}:
            require_free_number(client, number)
        _announce(compare(stored, factory), specs)
        if not yes:
            question = "Reset every parameter of this board to its default?"
            click.confirm(question, abort=True, err=True)
        write_one(client, state, "trexcmd restore-defaults", [(spec.key, spec.maximum)])
    line = specs[ParameterKey.UART_SETTINGS].text(factory.parameters[ParameterKey.UART_SETTINGS])
    say(
        "The board accepted the reset. Switch the board off and on. Then every parameter has its "
        f"default, the board runs at {line}, and its device number is {number}. The channel "
        "calibrations do not change (inferred)."
    )
    say_how_to_reach(link, dict(factory.parameters), signature.firmware)


def _announce(result: Comparison, specs: ParameterSet) -> None:
    if not result.changed:
        say("Every parameter already has its default, as far as defaults are known.")
        return
    say(f"{result.changed} of {len(specs.readable)} parameters will change:")
    say_changes(result)
    changing = [specs[row.key] for row in result.rows if row.changed]
    if unsure := unconfirmed_defaults(changing):
        say(f"No source confirms these defaults: {unsure}.")
