"""get, set, restore-defaults: parameters one by one, and all back to the factory's."""

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
from trex_gui.protocol.commands import GetMode, GetParameter, GetSignature
from trex_gui.protocol.errors import BadRequest, Rejected, ResultCode
from trex_gui.protocol.parameters import ParameterSpec, parameters_of

_HOW_TO_REACH = ("uart_settings", "device_number")


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


@click.command("restore-defaults")
@link_options
@click.option("--yes", is_flag=True, help="Do not ask.")
def restore_defaults(yes: bool, **options: Any) -> None:
    """Put every parameter back to the factory's value.

    The board does it when it is switched off and on. Channel calibrations stay as they are.
    """
    with open_line(link_settings(options)) as client:
        spec = _spec(client, "factory_reset")
        mode = ask(client.request, GetMode())
        if not mode.is_serial:
            raise Rejected("Restoring the defaults", ResultCode.NOT_SERIAL_MODE)
        if not yes:
            click.confirm(
                "Put every parameter of this board back to the factory's value?",
                abort=True,
                err=True,
            )
        write_parameter(client.request, spec, spec.maximum)
        signature = ask(client.request, GetSignature())
    specs = parameters_of(signature.model.key, signature.firmware)
    line, number = (specs[key].text(specs[key].default) for key in _HOW_TO_REACH)
    say(
        "The board has taken the order. Switch it off and on: then every parameter is the "
        f"factory's again, it runs at {line} and is device number {number}. The channel "
        "calibrations stay as they are."
    )
