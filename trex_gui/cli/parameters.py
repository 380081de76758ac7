"""get, set: parameters one by one."""

import json
from typing import Any

import click

from trex_gui.cli.common import (
    complete_parameter,
    identify,
    json_option,
    link_options,
    link_settings,
    open_line,
)
from trex_gui.cli.talk import say
from trex_gui.link.client import Client
from trex_gui.link.reading import ask
from trex_gui.link.writing import write_parameter
from trex_gui.protocol.commands import GetParameter
from trex_gui.protocol.errors import BadRequest
from trex_gui.protocol.parameters import ParameterSpec, parameters_of


def _spec(client: Client, name: str) -> ParameterSpec:
    signature = identify(client)
    return parameters_of(signature.model.key, signature.firmware)[name]


@click.command("get")
@link_options
@click.argument("name", shell_complete=complete_parameter)
@json_option
def get_command(name: str, as_json: bool, **options: Any) -> None:
    """Show one parameter, such as serial_timeout: wire value and what it means."""
    with open_line(link_settings(options)) as client:
        spec = _spec(client, name)
        if not spec.readable:
            raise BadRequest(f"{spec.name} can only be written")
        wire = ask(client.request, GetParameter(spec.number))
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
    ("1.5 s", "off").
    """
    with open_line(link_settings(options)) as client:
        spec = _spec(client, name)
        is_wire = value.strip().isdecimal() and len(value) < 10
        wire = int(value) if is_wire else spec.wire(value)
        stored = write_parameter(client.request, spec, wire)
    click.echo(f"{stored}\t{spec.text(stored)}")
    if spec.needs_power_cycle:
        say("Stored; it takes effect when the board is switched off and on.")
