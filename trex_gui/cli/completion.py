"""completion: the script that teaches a shell this program's words."""

import click
from click.shell_completion import get_completion_class

from trex_gui.core.cli import refuse

_SHELLS = ("bash", "zsh", "fish")


_HELP = """Print the script that completes commands, parameter names and ports.

\b
bash:  eval "$(trexcmd completion bash)"    in ~/.bashrc
zsh:   eval "$(trexcmd completion zsh)"     in ~/.zshrc
fish:  trexcmd completion fish > ~/.config/fish/completions/trexcmd.fish
"""


@click.command(help=_HELP)
@click.argument("shell", type=click.Choice(_SHELLS))
@click.pass_context
def completion(ctx: click.Context, shell: str) -> None:
    """Print the completion script of a shell."""
    maker = get_completion_class(shell)
    if maker is None:
        refuse(f"There is no completion for {shell}.")
    click.echo(maker(ctx.find_root().command, {}, "trexcmd", "_TREXCMD_COMPLETE").source())
