"""The program trexcmd, with the commands of every device."""

import errno
from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

import click

from trex_gui.composition import PLUGINS
from trex_gui.core.command_io import FAILURE_EXIT_CODE, standard_streams
from trex_gui.core.plugin import CommandInfo, Lazy
from trex_gui.version import __version__

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

COMMANDS: Mapping[str, CommandInfo] = {
    "list": CommandInfo(
        Lazy("trex_gui.cli.ports:list_command"), "List the ports and the devices on them."
    ),
    "find": CommandInfo(
        Lazy("trex_gui.cli.ports:find_command"), "Find a board whose serial settings are unknown."
    ),
    **{name: info for plugin in PLUGINS for name, info in plugin.commands.items()},
    "completion": CommandInfo(
        Lazy("trex_gui.cli.program:completion"), "Print the completion script for a shell."
    ),
}
"""All commands, in the order of the help text."""


class _Program(click.Group):
    """Group that imports each command on first use."""

    def main(self, *args: Any, **extra: Any) -> Any:
        with standard_streams():
            return super().main(*args, **extra)

    def invoke(self, ctx: click.Context) -> Any:
        try:
            return super().invoke(ctx)
        except OSError as error:
            if error.errno == errno.EPIPE:  # click ends the program without a message
                raise
            prefix = f"{error.filename}: " if error.filename else ""
            failure = click.ClickException(f"{prefix}{error.strerror or error}.")
        except KeyboardInterrupt:
            failure = click.ClickException("Interrupted.")
        except click.ClickException as error:
            failure = error
        failure.exit_code = ctx.meta.get(FAILURE_EXIT_CODE, failure.exit_code)  # type: ignore[misc]
        raise failure

    def list_commands(self, ctx: click.Context) -> list[str]:
        del ctx
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name in COMMANDS:
            return COMMANDS[cmd_name].command.load()
        if ctx.resilient_parsing:
            return None
        raise click.NoSuchCommand(cmd_name, possibilities=COMMANDS, ctx=ctx)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        del ctx
        with formatter.section("Commands"):
            formatter.write_dl([(name, info.help) for name, info in COMMANDS.items()])

    def shell_complete(self, ctx: click.Context, incomplete: str) -> "list[CompletionItem]":
        from click.shell_completion import CompletionItem  # noqa: PLC0415 - for completion

        return [
            *(
                CompletionItem(name, help=info.help)
                for name, info in COMMANDS.items()
                if name.startswith(incomplete)
            ),
            *click.Command.shell_complete(self, ctx, incomplete),
        ]


def _run_guardian(
    context: click.Context, _option: click.Parameter, arguments: tuple[str, ...] | None
) -> None:
    """Run the guardian process. A bundled executable starts itself with `--guardian`."""
    if arguments:
        from trex_gui.core.guardian.process import main as run  # noqa: PLC0415 - rarely needed

        context.exit(run(list(arguments)))


def _log_to_terminal(context: click.Context, _option: click.Parameter, verbose: bool) -> None:
    if verbose and not context.resilient_parsing:
        import logging  # noqa: PLC0415 - rarely needed

        from trex_gui.core.log_file import terminal_handler  # noqa: PLC0415 - rarely needed

        handler, root = terminal_handler(is_verbose=True), logging.getLogger()
        own = logging.getLogger("trex_gui")
        context.call_on_close(lambda: root.removeHandler(handler))
        context.call_on_close(partial(own.setLevel, own.level))
        root.addHandler(handler)
        own.setLevel(logging.DEBUG)


@click.group(
    cls=_Program,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)
@click.version_option(__version__, prog_name="trexcmd")
@click.option(
    "--verbose",
    is_flag=True,
    expose_value=False,
    callback=_log_to_terminal,
    help="Also print the program's log of connections, attempts to connect, and the guardian.",
)
@click.option(
    "--guardian", nargs=5, hidden=True, is_eager=True, expose_value=False, callback=_run_guardian
)
def main() -> None:
    """Inspect, set up and drive a Pololu TReX or TReX Jr motor controller.

    Data goes to standard output, and messages go to standard error. Exit codes: 0 success, 1
    failure of the device or a file, 2 wrong usage. For diff and audit: 0 equal, 1 different, 2
    failure.
    """
    from trex_gui.core.transport.driven import driven_boards  # noqa: PLC0415 - not for --help

    driven_boards()  # logs the boards whose motors were left running


_COMPLETION_HELP = """Print the script that completes commands, parameter names and ports.

\b
bash:  eval "$(trexcmd completion bash)"    in ~/.bashrc
zsh:   eval "$(trexcmd completion zsh)"     in ~/.zshrc
fish:  trexcmd completion fish > ~/.config/fish/completions/trexcmd.fish
"""


@click.command(help=_COMPLETION_HELP)
@click.argument("shell", type=click.Choice(("bash", "zsh", "fish")))
def completion(shell: str) -> None:
    from click.shell_completion import get_completion_class  # noqa: PLC0415 - for completion

    completion_class = get_completion_class(shell)
    assert completion_class is not None  # noqa: S101 - click supports all three shells
    click.echo(completion_class(main, {}, "trexcmd", "_TREXCMD_COMPLETE").source())
