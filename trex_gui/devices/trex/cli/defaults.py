"""restore-defaults: all parameters back to the factory's."""

from typing import Any

import click

from trex_gui.core.cli.console import say
from trex_gui.devices.trex.cli.changes import keep, read_board, require_serial_mode, say_changes
from trex_gui.devices.trex.cli.common import identify, link_options, link_settings, open_line
from trex_gui.devices.trex.cli.reconnect_hint import say_how_to_reach
from trex_gui.devices.trex.client.writing import write_parameter
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey
from trex_gui.devices.trex.protocol.parameters import ParameterSet
from trex_gui.devices.trex.settings.comparison import Comparison, compare
from trex_gui.devices.trex.settings.document import factory_settings, settings_of

_HOW_TO_REACH = (ParameterKey.UART_SETTINGS, ParameterKey.DEVICE_NUMBER)


@click.command("restore-defaults")
@link_options
@click.option("--yes", is_flag=True, help="Do not ask.")
def restore_defaults(yes: bool, **options: Any) -> None:
    """Put every parameter back to the factory's value.

    Shows what will change and asks. The board does it when it is switched off and on. Channel
    calibrations stay as they are. A snapshot of what the board stores is kept.
    """
    link = link_settings(options)
    with open_line(link) as client:
        signature = identify(client)
        state = read_board(client)
        require_serial_mode(state, "Restoring the defaults")
        specs = state.specs
        spec = specs[ParameterKey.FACTORY_RESET]
        there = settings_of(state)
        factory = factory_settings(signature.model, signature.firmware)
        _announce(compare(there, factory), specs)
        if not yes:
            click.confirm(
                "Put every parameter of this board back to the factory's value?",
                abort=True,
                err=True,
            )
        keep(there, link, "trexcmd restore-defaults")
        write_parameter(client.request, spec, spec.maximum)
    line, number = (specs[key].text(specs[key].default) for key in _HOW_TO_REACH)
    say(
        "The board has taken the order. Switch it off and on: then every parameter is the "
        f"factory's again, it runs at {line} and is device number {number}. The channel "
        "calibrations stay as they are."
    )
    say_how_to_reach(link, factory.parameters, signature.firmware)


def _announce(result: Comparison, specs: ParameterSet) -> None:
    """Say what becomes of each parameter, and how far the factory's values are known."""
    if not result.changed:
        say("Every parameter has the factory's value already, as far as that is known.")
        return
    say(f"What will change, {result.changed} of {len(list(specs.readable))} parameters:")
    say_changes(result)
    changing = [specs[row.key] for row in result.rows if row.changed]
    if unsure := [spec.name for spec in changing if not spec.default_confirmed]:
        say(f"Inferred, no source confirms the default of: {', '.join(unsure)}.")
