"""restore-defaults: all parameters back to the factory's."""

from typing import Any

import click

from trex_gui.cli.common import identify, link_options, link_settings, open_line
from trex_gui.cli.reaching import say_how_to_reach
from trex_gui.cli.snapshots import keep
from trex_gui.cli.talk import say
from trex_gui.link.reading import ask, read_everything
from trex_gui.link.writing import write_parameter
from trex_gui.protocol.commands import GetMode
from trex_gui.protocol.errors import Rejected, ResultCode
from trex_gui.protocol.parameters import parameters_of
from trex_gui.settings.snapshot import settings_of

_HOW_TO_REACH = ("uart_settings", "device_number")


@click.command("restore-defaults")
@link_options
@click.option("--yes", is_flag=True, help="Do not ask.")
def restore_defaults(yes: bool, **options: Any) -> None:
    """Put every parameter back to the factory's value.

    The board does it when it is switched off and on. Channel calibrations stay as they are. A
    snapshot of what the board stores is kept.
    """
    link = link_settings(options)
    with open_line(link) as client:
        signature = identify(client)
        specs = parameters_of(signature.model.key, signature.firmware)
        spec = specs["factory_reset"]
        mode = ask(client.request, GetMode())
        if not mode.is_serial:
            raise Rejected("Restoring the defaults", ResultCode.NOT_SERIAL_MODE)
        if not yes:
            click.confirm(
                "Put every parameter of this board back to the factory's value?",
                abort=True,
                err=True,
            )
        keep(settings_of(read_everything(client.request)), link, "trexcmd restore-defaults")
        write_parameter(client.request, spec, spec.maximum)
    defaults = {one.key: one.default for one in specs.readable}
    line, number = (specs[key].text(specs[key].default) for key in _HOW_TO_REACH)
    say(
        "The board has taken the order. Switch it off and on: then every parameter is the "
        f"factory's again, it runs at {line} and is device number {number}. The channel "
        "calibrations stay as they are."
    )
    say_how_to_reach(link, defaults, signature.firmware)
