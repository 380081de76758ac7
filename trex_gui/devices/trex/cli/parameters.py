"""get: one parameter."""

import json
from typing import Any

import click

from trex_gui.core.cli.options import json_option
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.cli.common import (
    complete_parameter,
    identify,
    link_options,
    link_settings,
    open_line,
)
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import ask
from trex_gui.devices.trex.protocol.commands import GetParameter
from trex_gui.devices.trex.protocol.parameters import ParameterSpec, parameters_of


def spec_of(client: TrexClient, name: str) -> ParameterSpec:
    """Return the parameter that a person calls so, as it is for the board on the line.

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
        wire = ask(client.request, GetParameter(spec.number))
    if as_json:
        click.echo(json.dumps({"name": spec.key, "value": wire, "text": spec.text(wire)}))
    else:
        click.echo(f"{wire}\t{spec.text(wire)}")
