"""Benchmarks, which run in real time.

Each benchmark reports its results with the fixture `figure`. A figure is printed as a line of JSON,
and again in a table at the end of the run. The table can compare figures to an earlier run.
"""

import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path

import pytest

from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.simulator.memory import Eeprom


@dataclass(frozen=True)
class Figure:
    """Measured value. Its name, `figure`, is unique within a run and constant across runs."""

    figure: str
    value: float
    unit: str
    at_most: float | None = None
    at_least: float | None = None

    @property
    def is_within_bounds(self) -> bool:
        is_too_high = self.at_most is not None and self.value > self.at_most
        return not (is_too_high or (self.at_least is not None and self.value < self.at_least))

    @property
    def bounds(self) -> str:
        limits = (("at most", self.at_most), ("at least", self.at_least))
        return ", ".join(f"{word} {limit:g}" for word, limit in limits if limit is not None)

    def to_json(self) -> str:
        return json.dumps({key: value for key, value in asdict(self).items() if value is not None})

    def row(self, earlier: float | None) -> str:
        """Return a line of the table, with the ratio to an earlier value if available."""
        ratio = f"{self.value / earlier:8.2f}" if earlier else " " * 8
        return f"{self.figure:<64}{self.value:12.5g} {self.unit:<8}{ratio}  {self.bounds}".rstrip()


class ReportFigure:
    """Prints figures. A figure outside its bounds fails the test at its end."""

    def __init__(self, figures: list[Figure], capsys: pytest.CaptureFixture[str]) -> None:
        self._figures, self._capsys = figures, capsys
        self.reported: list[Figure] = []

    def __call__(
        self,
        name: str,
        value: float,
        unit: str,
        *,
        at_most: float | None = None,
        at_least: float | None = None,
    ) -> None:
        assert all(each.figure != name for each in self._figures), (
            f"two figures are called {name!r}"
        )
        figure = Figure(name, float(f"{value:.5g}"), unit, at_most, at_least)
        self._figures.append(figure)
        with self._capsys.disabled():
            # The first figure of a test begins a new line after the output of pytest.
            print("" if self.reported else "\n", figure.to_json(), sep="", flush=True)
        self.reported.append(figure)


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
        message = f"cannot compare to {path}: {error}"
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
        for figure in figures:
            terminalreporter.line(figure.row(earlier.get(figure.figure)))


def fast_board(folder: Path, baud: int) -> tuple[str, str]:
    """Return simulator options for a board with this baud rate."""
    eeprom = folder / "board.json"
    Eeprom.open(eeprom, "trex").write("uart_settings", LineSettings(baud).to_wire())
    return ("--eeprom", str(eeprom))


@pytest.fixture
def figure(
    request: pytest.FixtureRequest, capsys: pytest.CaptureFixture[str]
) -> Iterator[ReportFigure]:
    report = ReportFigure(request.config.stash[_FIGURES], capsys)
    yield report
    missed = [figure.row(None) for figure in report.reported if not figure.is_within_bounds]
    if missed:
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
        raise ValueError("the file has no figures")
    return {figure["figure"]: figure["value"] for figure in figures}
