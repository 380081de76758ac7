"""The variants, and the simulators that serve them one test after the other."""

from collections.abc import Iterator

import pytest

from tests.conformance.ends import End, ParserEnd, TerminalEnd
from tests.conformance.trex import VARIANTS, Trex, Variant


@pytest.fixture(autouse=True)
def _own_settings() -> None:
    """Nothing in here remembers settings, and a folder a test costs as much as the test."""


class _Terminals:
    """One simulator a kind of board: starting one takes a third of a second."""

    def __init__(self) -> None:
        self._running: dict[tuple[str, ...], TerminalEnd] = {}

    def terminal(self, variant: Variant) -> TerminalEnd:
        arguments: tuple[str, ...] = ("--model", variant.model, "--firmware", variant.firmware)
        if variant.echo:
            arguments += ("--echo",)
        if arguments not in self._running:
            self._running[arguments] = TerminalEnd(*arguments)
        return self._running[arguments]

    def end(self) -> None:
        for terminal in self._running.values():
            terminal.end()


@pytest.fixture(scope="session")
def _terminals() -> Iterator[_Terminals]:
    terminals = _Terminals()
    yield terminals
    terminals.end()


@pytest.fixture(params=VARIANTS, ids=str)
def trex(request: pytest.FixtureRequest, _terminals: _Terminals) -> Iterator[Trex]:
    """A board as new, in serial mode; in each of the variants that the test does not narrow."""
    variant: Variant = request.param
    end: End
    if variant.end == "terminal":
        end = _terminals.terminal(variant)
    else:
        end = ParserEnd(variant.model, variant.firmware)
    trex = Trex(end, variant)
    yield trex
    if not variant.echo:
        trex.nothing_more_comes()
