"""get: one parameter."""

import json
from dataclasses import replace
from typing import Any

import click

from trex_gui.core.cli import Interruption, json_option
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.cli.changes import prepare_one, read_board, say_what_follows
from trex_gui.devices.trex.cli.common import (
    complete_parameter,
    identify,
    link_options,
    link_settings,
    open_line,
    open_line_to_change,
)
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import query
from trex_gui.devices.trex.client.writing import write_parameter
from trex_gui.devices.trex.protocol.commands import GetParameter
from trex_gui.devices.trex.protocol.parameters import ParameterSpec, parameters_of
from trex_gui.devices.trex.settings.document import settings_of
from trex_gui.devices.trex.settings.rules import Context


def spec_of(client: TrexClient, name: str) -> ParameterSpec:
    """Return the parameter with a name or key, for the connected board.

    Raises:
        BadRequest: the board has none such.
        NoReply, BadReply: no board answers.
    """
    signature = identify(client)
    return parameters_of(signature.model.key, signature.firmware)[name]


@click.command("get")
@link_options
@click.argument("name", shell_complete=complete_parameter)
@json_option
def get_command(name: str, as_json: bool, **options: Any) -> None:
    """Show one parameter, such as serial_timeout: wire value and what it means."""
    with open_line(link_settings(options)) as client:
        spec = spec_of(client, name)
        if not spec.readable:
            raise BadRequest(f"{spec.name} can only be written")
        wire = query(client.request, GetParameter(spec.number))
    if as_json:
        click.echo(json.dumps({"name": spec.key, "value": wire, "text": spec.text(wire)}))
    else:
        click.echo(f"{wire}\t{spec.text(wire)}")


@click.command("set", context_settings={"ignore_unknown_options": True})
@link_options
@click.argument("name", shell_complete=complete_parameter)
@click.argument("value")
def set_command(name: str, value: str, **options: Any) -> None:
    """Store one parameter and read it back.

    VALUE is a wire value as in settings files (15), or one with its unit or in words
    ("1.5 s", "off"). A snapshot of what the board stores is kept first; a value that it has
    already is not written.
    """
    link = link_settings(options)
    with open_line_to_change(link) as (client, rates):
        spec = spec_of(client, name)
        if not spec.readable:
            raise BadRequest(
                f"{spec.name} is an order, not a value to store: `trexcmd restore-defaults` "
                "shows what it would change, keeps a snapshot and asks before it gives it"
            )
        is_wire = value.strip().isdecimal() and len(value) < 10
        wire = spec.check(int(value)) if is_wire else spec.wire(value)
        state = read_board(client)
        there = settings_of(state)
        is_new = prepare_one(
            state,
            replace(there, parameters={**there.parameters, spec.key: wire}),
            Context(port_rates=rates, used_by_line=link.line),
            link,
            what=spec.name,
            command=f"trexcmd set {spec.key}",
        )
        if is_new:
            with Interruption():
                write_parameter(client.request, spec, wire)
        click.echo(f"{wire}\t{spec.text(wire)}")
        if is_new:
            say_what_follows(client, link, state, {spec.key: wire})
