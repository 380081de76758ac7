"""The schema of what each command prints with `--json`, from what simulated devices give."""

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

import click
from genson import SchemaBuilder

from trex_gui.cli import main as trexcmd
from trex_gui.testing import SimulatedTrex

_SERVED = "127.0.0.1:7499"

# Words after each command, several sets where it prints several shapes. Files are in one folder.
WORDS: Mapping[str, tuple[str, ...]] = {
    "aracna query": ("",),
    "audit": ("new.txt", "profile.txt"),
    "boards": ("",),
    "calibration get": ("",),
    "check-settings": ("new.txt", "profile.txt"),
    "diff": ("new.txt profile.txt",),
    "find": ("",),
    "get": ("serial_timeout", "device_number"),
    "history": ("",),
    "history diff": ("1",),
    "history show": ("1",),
    "list": ("",),
    "robots": (_SERVED,),
    "status": ("",),
    "stream": ("--limit 3",),
}
LINE_BY_LINE = {"stream"}


def commands_with_json(
    command: click.Command = trexcmd, words: tuple[str, ...] = ()
) -> Iterator[str]:
    """Return the commands that have the option, by the words that start them."""
    if any(parameter.name == "as_json" for parameter in command.params):
        yield " ".join(words)
    if isinstance(command, click.Group):
        context = click.Context(command)
        for name in command.list_commands(context):
            if (inner := command.get_command(context, name)) is not None:
                yield from commands_with_json(inner, (*words, name))


@contextmanager
def served(port: str, environment: Mapping[str, str]) -> Iterator[None]:
    """Serve a board for the commands that ask the network."""
    command = [sys.executable, "-m", "trex_gui.cli", "serve", "--port", port, "--listen", _SERVED]
    with subprocess.Popen(command, env=environment, stderr=subprocess.PIPE) as server:
        try:
            assert server.stderr is not None
            server.stderr.readline()
            yield
        finally:
            server.kill()


def schemas() -> Iterator[tuple[str, str]]:
    """Yield each command and its schema as JSON.

    Raises:
        KeyError: a command has no words here.
    """
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "TREX_STUDIO_DATA": folder}

        def run(port: str, *words: str) -> str:
            command = [sys.executable, "-m", "trex_gui.cli", *words]
            done = subprocess.run(
                command,
                cwd=folder,
                env={**environment, "TREX_PORT": port},
                capture_output=True,
                text=True,
                check=False,
            )
            return done.stdout

        with (
            SimulatedTrex() as board,
            SimulatedTrex("--aracna") as robot,
            SimulatedTrex() as far,
            served(far.url, environment),
        ):
            run(board.url, "get-settings", "new.txt")
            text = (Path(folder) / "new.txt").read_text("utf-8")
            changed = text.replace("serial_timeout: 0", "serial_timeout: 5")
            (Path(folder) / "profile.txt").write_text(changed, "utf-8")
            run(board.url, "set", "serial_timeout", "1 s")
            for command in sorted(commands_with_json()):
                builder = SchemaBuilder()
                port = robot.url if command.startswith("aracna") else board.url
                for words in WORDS[command]:
                    printed = run(port, *command.split(), "--json", *words.split())
                    documents = printed.splitlines() if command in LINE_BY_LINE else [printed]
                    for document in documents:
                        builder.add_object(json.loads(document))
                yield command, builder.to_json(indent=2)
