"""trexcmd in this process, against a simulated robot whose bytes take no time."""

from collections.abc import Callable, Iterator

import pytest
from click.testing import CliRunner, Result

from tests.support.aracna import AracnaProcess
from trex_gui.cli import main

Run = Callable[..., Result]


@pytest.fixture
def robot() -> Iterator[AracnaProcess]:
    process = AracnaProcess("--unpaced")
    yield process
    process.end()


@pytest.fixture
def trexcmd(robot: AracnaProcess) -> Run:
    """Run `trexcmd` to its end; what talks to the robot has patience with a busy computer."""

    def run(*words: str) -> Result:
        if words[0] == "aracna":
            words = (*words[:2], "--timeout", "2", *words[2:])
        return CliRunner().invoke(main, list(words), env={"TREX_PORT": robot.url})

    return run
