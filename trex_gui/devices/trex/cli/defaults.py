"""restore-defaults: reset all parameters to factory defaults."""

from typing import Any

import click

from trex_gui.core.cli import say
from trex_gui.devices.trex.cli.changes import keep, read_board, require_serial_mode, say_changes
from trex_gui.devices.trex.cli.common import identify, link_options, link_settings, open_line
from trex_gui.devices.trex.cli.reconnect_hint import say_how_to_reach
from trex_gui.devices.trex.client.writing import write_parameter
from trex_gui.devices.trex.protocol.parameters import ParameterKey, ParameterSet
from trex_gui.devices.trex.settings.comparison import Comparison, compare
from trex_gui.devices.trex.settings.document import factory_settings, settings_of

_HOW_TO_REACH = (ParameterKey.UART_SETTINGS, ParameterKey.DEVICE_NUMBER)


@click.command("restore-defaults")
@link_options
@click.option("--yes", is_flag=True, help="Do not ask.")
def restore_defaults(yes: bool, **options: Any) -> None:
    """Reset every parameter to its factory default.

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
                "Reset every parameter of this board to its default?",
                abort=True,
                err=True,
            )
        keep(there, link, "trexcmd restore-defaults")
        write_parameter(client.request, spec, spec.maximum)
    line, number = (specs[key].text(specs[key].default) for key in _HOW_TO_REACH)
    say(
        "The board accepted the reset. Switch it off and on: then every parameter has its "
        f"default, the board runs at {line} and its device number is {number}. The channel "
        "calibrations do not change."
    )
    say_how_to_reach(link, factory.parameters, signature.firmware)


def _announce(result: Comparison, specs: ParameterSet) -> None:
    """Report the changes, and the defaults that no source confirms."""
    if not result.changed:
        say("Every parameter already has its default, as far as defaults are known.")
        return
    say(f"What will change, {result.changed} of {len(list(specs.readable))} parameters:")
    say_changes(result)
    changing = [specs[row.key] for row in result.rows if row.changed]
    if unsure := [spec.name for spec in changing if not spec.default_confirmed]:
        say(f"Inferred, no source confirms the default of: {', '.join(unsure)}.")
