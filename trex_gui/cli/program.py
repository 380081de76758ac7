"""The program: its commands in one table, each loaded when it is called."""

import importlib
from collections.abc import Mapping
from typing import Any, NamedTuple

import click

from trex_gui import __version__


class Entry(NamedTuple):
    """Where a command is, and what the list of commands says of it.

    `module` lies in `trex_gui.devices`, or in this package.
    """

    module: str
    name: str
    help: str


COMMANDS: Mapping[str, Entry] = {
    "list": Entry("trex.cli.ports", "list_command", "List the ports and what answers on them."),
    "find": Entry(
        "trex.cli.ports", "find_command", "Find a board whose serial settings are unknown."
    ),
    "status": Entry(
        "trex.cli.status", "status", "Show what the board is, how it is set, what it measures."
    ),
    "stream": Entry(
        "trex.cli.stream", "stream", "Write what the board measures as CSV, until Ctrl-C."
    ),
    "get": Entry("trex.cli.parameters", "get_command", "Show one parameter."),
    "set": Entry("trex.cli.set_parameter", "set_command", "Store one parameter and read it back."),
    "get-settings": Entry("trex.cli.files", "get_settings", "Save the board's settings to a file."),
    "set-settings": Entry(
        "trex.cli.files", "set_settings", "Give the board the settings of a file."
    ),
    "check-settings": Entry(
        "trex.cli.files", "check_settings", "Check a settings file without a board."
    ),
    "diff": Entry("trex.cli.files", "diff", "Compare settings files, or a file with the board."),
    "history": Entry("trex.cli.history", "history", "List what boards stored before each change."),
    "calibration": Entry(
        "trex.cli.calibration", "calibration", "Show or store channel calibrations."
    ),
    "export": Entry(
        "trex.cli.export", "export", "Write the settings as C, Python or an Arduino sketch."
    ),
    "restore-defaults": Entry(
        "trex.cli.defaults", "restore_defaults", "Go back to factory parameters."
    ),
    "motor": Entry("trex.cli.motor", "motor", "Run a motor until Ctrl-C, or for some seconds."),
    "stop": Entry("trex.cli.motor", "stop", "Stop every motor and prove it."),
    "aracna": Entry("aracna.cli.commands", "aracna", "Ask an Aracna, move it, play its poses."),
    "raw": Entry("trex.cli.packets", "raw", "Send bytes and show what comes back."),
    "decode": Entry("trex.cli.packets", "decode", "Say what packets some bytes are."),
    "completion": Entry("completion", "completion", "Print the completion script of a shell."),
}
"""Every command, in the order in which a person meets them."""


class _Program(click.Group):
    """A group that imports a command only when it is needed."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        del ctx
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        del ctx
        if (entry := COMMANDS.get(cmd_name)) is None:
            return None
        package = "trex_gui.devices" if "." in entry.module else "trex_gui.cli"
        module = importlib.import_module(f".{entry.module}", package)
        command = getattr(module, entry.name)
        assert isinstance(command, click.Command)  # noqa: S101 - for the type checker
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        try:
            return super().resolve_command(ctx, args)
        except click.UsageError as error:
            import difflib  # noqa: PLC0415 - only a slip needs it

            if not (close := difflib.get_close_matches(args[0], COMMANDS, n=1)):
                raise
            message = f"{error.message.rstrip('.')}. Did you mean {close[0]}?"
            raise click.UsageError(message, ctx) from None

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        del ctx
        with formatter.section("Commands"):
            formatter.write_dl([(name, entry.help) for name, entry in COMMANDS.items()])

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[Any]:
        from click.shell_completion import CompletionItem  # noqa: PLC0415

        return [
            *(
                CompletionItem(name, help=entry.help)
                for name, entry in COMMANDS.items()
                if name.startswith(incomplete)
            ),
            *click.Command.shell_complete(self, ctx, incomplete),
        ]


@click.group(
    cls=_Program,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)
@click.version_option(__version__, prog_name="trexcmd")
def main() -> None:
    """Look at, set up and drive a Pololu TReX or TReX Jr motor controller.

    Data goes to standard output, messages go to standard error. Exit codes: 0 done, 1 the
    device or a file refused, 2 wrong usage.
    """
