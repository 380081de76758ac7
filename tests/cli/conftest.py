"""trexcmd in this process and as one of its own, against a simulated board."""

import contextlib
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator

import pytest
from click.testing import CliRunner, Result

from tests.support.simulator import SimulatedDevice
from trex_gui.cli import main
from trex_gui.cli.program import COMMANDS
from trex_gui.link import client

Run = Callable[..., Result]
Start = Callable[..., "subprocess.Popen[str]"]

PATIENCE = 15.0
"""Seconds for which an answer is waited for: a simulator may stand still on a busy computer."""

_LINE = {"patience": PATIENCE}
_PATIENT = {
    **dict.fromkeys(COMMANDS.keys() - {"find"}, _LINE),
    "calibration": {"get": _LINE, "set": _LINE},
    "history": {"diff": _LINE},
}
"""What the commands take in place of their own defaults; for `find` silence is the rule."""

_WITHOUT_AN_ECHO = """
from trex_gui.link import client
client._ECHO_PROBES = 0
from trex_gui.cli import main
main(prog_name="trexcmd")
"""


@pytest.fixture
def trexcmd(quick_simulator: SimulatedDevice, monkeypatch: pytest.MonkeyPatch) -> Iterator[Run]:
    """Run the program to its end, on a simulated board as it comes from the factory.

    It is patient, unless `--timeout` says otherwise. No echo is looked for then: none comes, and
    it would be waited for in vain before each command.
    """

    def run(*words: str, stdin: str | None = None, **environment: str) -> Result:
        variables = {"TREX_PORT": quick_simulator.url, **environment}
        with monkeypatch.context() as patched:
            if words[0] != "find" and not any(word.startswith("--timeout") for word in words):
                patched.setattr(client, "_ECHO_PROBES", 0)
            return CliRunner().invoke(
                main, list(words), env=variables, input=stdin, default_map=_PATIENT
            )

    quick_simulator.do("factory")
    assert becomes(lambda: None in measured(quick_simulator), False)
    yield run
    with contextlib.suppress(AssertionError, OSError):
        quick_simulator.do("factory")  # calibrations too, which nobody looks at otherwise


@pytest.fixture
def start(quick_simulator: SimulatedDevice) -> Iterator[Start]:
    """Start the program as a process; whatever still runs in the end is killed.

    It is patient, and looks for no echo then, as with `trexcmd`.
    """
    running: list[subprocess.Popen[str]] = []

    def begin(
        *words: str, url: str | None = None, patience: float = PATIENCE
    ) -> subprocess.Popen[str]:
        program = ("-c", _WITHOUT_AN_ECHO) if patience > 1 else ("-m", "trex_gui.cli")
        process = subprocess.Popen(
            [sys.executable, *program, *words, f"--timeout={patience:g}"],
            env={**os.environ, "TREX_PORT": url or quick_simulator.url},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        running.append(process)
        return process

    yield begin
    for process in running:
        process.kill()
        process.communicate()


def becomes(look: Callable[[], object], wanted: object, seconds: float = 30) -> bool:
    """Look again and again until it is as wanted; return whether that was in time.

    Looks with pauses: a simulator that is asked all the time has none left for the program.
    """
    end = time.monotonic() + seconds
    while look() != wanted:
        if time.monotonic() > end:
            return False
        time.sleep(0.02)
    return True


def measured(simulator: SimulatedDevice) -> list[int | None]:
    """Return what the board has measured on each channel; `None` where there was no signal yet."""
    return [channel["raw"] for channel in simulator.show()["channels"]]


def outputs(simulator: SimulatedDevice) -> list[int]:
    """Return the signed speeds of both motors and the auxiliary one; braking is 0."""
    state = simulator.show()
    signs = {"forward": 1, "reverse": -1, "brake": 0}
    speeds = [signs[motor["direction"]] * motor["speed"] for motor in state["motors"]]
    return [*speeds, state["aux"]["speed"]]
