"""JSON schemas of command output, inferred from simulated devices."""

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

_SERVER = "127.0.0.1:7499"

ARGUMENTS: Mapping[str, tuple[str, ...]] = {
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
    "robots": (_SERVER,),
    "status": ("",),
    "stream": ("--limit 3",),
}
"""Arguments of each command. A command with several kinds of output has several sets.

Files are in the working folder.
"""
LINE_BY_LINE = {"stream"}  # commands that print one document per line


def commands_with_json(
    command: click.Command = trexcmd, words: tuple[str, ...] = ()
) -> Iterator[str]:
    """Yield the commands with `--json`, such as "history show"."""
    if any(parameter.name == "as_json" for parameter in command.params):
        yield " ".join(words)
    if isinstance(command, click.Group):
        context = click.Context(command)
        for name in command.list_commands(context):
            if (inner := command.get_command(context, name)) is not None:
                yield from commands_with_json(inner, (*words, name))


@contextmanager
def serve(port: str, environment: Mapping[str, str]) -> Iterator[None]:
    """Serve a board on the network during the block."""
    command = [sys.executable, "-m", "trex_gui.cli", "serve", "--port", port, "--listen", _SERVER]
    with subprocess.Popen(command, env=environment, stderr=subprocess.PIPE) as server:
        try:
            assert server.stderr is not None
            server.stderr.readline()
            yield
        finally:
            server.kill()


def schemas() -> Iterator[tuple[str, str]]:
    """Yield each command and its JSON schema.

    Raises:
        KeyError: `ARGUMENTS` lacks a command.
    """
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "TREX_STUDIO_DATA": folder}

        def run(port: str, *words: str) -> str:
            command = [sys.executable, "-m", "trex_gui.cli", *words]
            process = subprocess.run(
                command,
                cwd=folder,
                env={**environment, "TREX_PORT": port},
                capture_output=True,
                text=True,
                check=False,
            )
            return process.stdout

        with (
            SimulatedTrex() as board,
            SimulatedTrex("--aracna") as robot,
            SimulatedTrex() as served_board,
            serve(served_board.url, environment),
        ):
            run(board.url, "get-settings", "new.txt")
            text = (Path(folder) / "new.txt").read_text("utf-8")
            changed = text.replace("serial_timeout: 0", "serial_timeout: 5")
            (Path(folder) / "profile.txt").write_text(changed, "utf-8")
            run(board.url, "set", "serial_timeout", "1 s")
            for command in sorted(commands_with_json()):
                builder = SchemaBuilder()
                port = robot.url if command.startswith("aracna") else board.url
                for arguments in ARGUMENTS[command]:
                    output = run(port, *command.split(), "--json", *arguments.split())
                    documents = output.splitlines() if command in LINE_BY_LINE else [output]
                    for document in documents:
                        builder.add_object(json.loads(document))
                yield command, builder.to_json(indent=2)
