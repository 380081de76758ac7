"""Benchmarks run in real time.

Each reports its results with the fixture `figure`. A figure is printed as a line of JSON, and again
in a table at the end of the run. On request the table compares figures to an earlier run.
"""

import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Protocol

import pytest

from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.simulator.memory import Eeprom


@dataclass(frozen=True)
class Figure:
    """Measured value. Its name is unique within a run and constant across runs."""

    figure: str
    value: float
    unit: str
    at_most: float | None = None
    at_least: float | None = None

    @property
    def is_within_bounds(self) -> bool:
        is_too_great = self.at_most is not None and self.value > self.at_most
        return not (is_too_great or (self.at_least is not None and self.value < self.at_least))

    @property
    def bounds(self) -> str:
        limits = (("at most", self.at_most), ("at least", self.at_least))
        return ", ".join(f"{word} {limit:g}" for word, limit in limits if limit is not None)

    def to_json(self) -> str:
        given = {name: value for name, value in asdict(self).items() if value is not None}
        return json.dumps(given)

    def row(self, earlier: float | None) -> str:
        """Return a line of the table, with the ratio to an earlier value if available."""
        ratio = f"{self.value / earlier:8.2f}" if earlier else " " * 8
        return f"{self.figure:<64}{self.value:12.5g} {self.unit:<8}{ratio}  {self.bounds}".rstrip()


class ReportFigure(Protocol):
    """Prints a figure. A figure outside its bounds fails the test at its end."""

    def __call__(
        self,
        name: str,
        value: float,
        unit: str,
        *,
        at_most: float | None = None,
        at_least: float | None = None,
    ) -> None: ...


_FIGURES = pytest.StashKey[list[Figure]]()
_EARLIER = pytest.StashKey[dict[str, float]]()


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--compare",
        type=Path,
        metavar="FILE",
        help="show the ratio to the figures in the saved output of an earlier run",
    )


def pytest_configure(config: pytest.Config) -> None:
    config.stash[_FIGURES] = []
    path: Path | None = config.getoption("--compare", default=None)
    try:
        config.stash[_EARLIER] = earlier_values(path) if path else {}
    except (OSError, ValueError) as error:
        message = f"{path} cannot be compared to: {error}"
        raise pytest.UsageError(message) from error


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if item.path.is_relative_to(Path(__file__).parent):
            item.add_marker(pytest.mark.realtime)


def pytest_terminal_summary(
    terminalreporter: pytest.TerminalReporter, config: pytest.Config
) -> None:
    figures, earlier = config.stash[_FIGURES], config.stash[_EARLIER]
    if figures:
        terminalreporter.section("figures" + (" and ratios to the earlier run" if earlier else ""))
        for one in figures:
            terminalreporter.line(one.row(earlier.get(one.figure)))


def fast_board(folder: Path, baud: int) -> tuple[str, str]:
    """Return simulator options for a board with this baud rate."""
    board = folder / "board.json"
    Eeprom.open(board, "trex").write("uart_settings", LineSettings(baud).to_wire())
    return ("--eeprom", str(board))


@pytest.fixture
def figure(
    request: pytest.FixtureRequest, capsys: pytest.CaptureFixture[str]
) -> Iterator[ReportFigure]:
    figures = request.config.stash[_FIGURES]
    reported: list[Figure] = []

    def report(
        name: str,
        value: float,
        unit: str,
        *,
        at_most: float | None = None,
        at_least: float | None = None,
    ) -> None:
        assert all(one.figure != name for one in figures), f"two figures are called {name!r}"
        one = Figure(name, float(f"{value:.5g}"), unit, at_most, at_least)
        figures.append(one)
        with capsys.disabled():
            # The first one follows what pytest wrote about the test.
            print("" if reported else "\n", one.to_json(), sep="", flush=True)
        reported.append(one)

    yield report
    if missed := [one.row(None) for one in reported if not one.is_within_bounds]:
        pytest.fail("\n".join(missed), pytrace=False)


def earlier_values(path: Path) -> dict[str, float]:
    """Return the figures of a saved run.

    Raises:
        OSError: the file cannot be read.
        ValueError: the file has no figures.
    """
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    figures = [json.loads(line) for line in lines if line.startswith('{"figure":')]
    if not figures:
        raise ValueError("there are no figures in it")
    return {one["figure"]: one["value"] for one in figures}
