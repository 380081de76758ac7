"""Inputs cause no undocumented error, no hang and no growth of memory usage."""

import gc
import logging
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress
from itertools import count
from pathlib import Path
from random import Random
from types import BuiltinFunctionType, FunctionType, ModuleType
from typing import Any

import pytest
from pytestqt.qtbot import QtBot

from tests.fuzz import fuzzing
from tests.fuzz.fuzzing import Finding, Target, attempt, growth, run
from tests.fuzz.programs import CONFIGURATION_KEYS, check_configuration
from tests.fuzz.targets import TARGETS
from tests.fuzz.wire import PACKETS, REPLIES
from tests.support.matrix import LONG_FACTOR
from tests.support.virtual import VirtualTransport
from trex_gui.core.errors import BadReply, NoReply
from trex_gui.core.transport.traffic import TrafficDirection, TrafficEvent, TransactionAssembler
from trex_gui.devices.aracna.protocol.replies import Reader
from trex_gui.devices.aracna.session.traffic_decoder import AracnaDecoder
from trex_gui.devices.aracna.simulator.line import AracnaLine
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.protocol.commands import GetRawChannels, GetSignature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.framing import PacketParser
from trex_gui.devices.trex.session.traffic_decoder import TrexDecoder
from trex_gui.devices.trex.settings.document import factory_settings
from trex_gui.devices.trex.settings.edit_in_place import amend
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.ui.preferences import Preferences

CORPUS_INPUTS = [
    pytest.param(target, path, id=f"{target.name}-{path.name}")
    for target in TARGETS
    for path in target.corpus()
]


@pytest.fixture
def seed(request: pytest.FixtureRequest) -> int:
    """Seed of the random inputs. The seed is random only with `--all`."""
    if not request.config.getoption("--all"):
        return 0
    return Random().getrandbits(32)


@pytest.mark.parametrize(("target", "path"), CORPUS_INPUTS)
def test_input_that_once_failed_is_handled(qtbot: QtBot, target: Target, path: Path) -> None:
    if finding := attempt(target, path.read_bytes(), path.name):
        pytest.fail(str(finding))


def test_settings_file_of_many_lines_is_read_and_edited() -> None:
    def check(data: bytes, folder: Path) -> None:
        read, _ = read_settings(data)
        factory = factory_settings(read.product, read.firmware)
        assert "motor_mode: 0" in amend(data.decode(), factory)

    lines = b"product: TReX\nmotor_mode: 1\n" + b"\n" * 100_000
    if finding := attempt(Target("settings", lambda _random: b"", check), lines, "100,000 lines"):
        pytest.fail(str(finding))


@pytest.mark.timeout(600)
@pytest.mark.parametrize("target", TARGETS, ids=lambda target: target.name)
def test_random_input_is_handled_as_documented(
    qtbot: QtBot, request: pytest.FixtureRequest, target: Target, seed: int
) -> None:
    factor = LONG_FACTOR if request.config.getoption("--all") else 1
    for number in range(target.examples * factor):
        origin = f"seed {seed}, number {number}"
        if finding := attempt(target, target.random_input(seed, number), origin):
            pytest.fail(str(finding))


@pytest.mark.slow
@pytest.mark.timeout(600)
@pytest.mark.parametrize("target", TARGETS, ids=lambda target: target.name)
def test_memory_does_not_grow_with_random_inputs(
    qtbot: QtBot, caplog: pytest.LogCaptureFixture, target: Target, seed: int
) -> None:
    caplog.set_level(logging.CRITICAL)  # pytest keeps every record
    assert growth(target, seed, 0) <= target.growth, f"seed {seed}"


def test_configurations_have_the_keys_that_the_window_reads(
    qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    keys, read = {"units/own_first"}, Preferences._read  # the units are read once in a process

    def record_key(store: Preferences, key: str, *rest: Any) -> object:
        keys.add(key)
        return read(store, key, *rest)

    monkeypatch.setattr(Preferences, "_read", record_key)
    check_configuration(b"", tmp_path)
    assert keys == {*CONFIGURATION_KEYS}


# --- The fuzzer -------------------------------------------------------------------------


def test_same_seed_creates_the_same_inputs() -> None:
    for target in TARGETS:
        first, second = ([target.random_input(7, number) for number in range(5)] for _ in range(2))
        assert first == second
        assert first != [target.random_input(8, number) for number in range(5)]


def test_errors_of_each_kind_are_found_and_can_be_repeated(monkeypatch: pytest.MonkeyPatch) -> None:
    retained: list[bytes] = []

    def check(data: bytes, folder: Path) -> None:
        retained.append(data)  # memory usage grows
        if data[0] < 20:
            raise KeyError("on purpose")
        if data[0] < 40:
            logging.getLogger("session").exception("failed")

    monkeypatch.setattr(fuzzing, "GROWTH_EVERY", 20)
    target = Target("nothing", lambda random: random.randbytes(3000), check)
    reports: list[Finding | str] = []
    ticks = map(float, count())
    findings = run(100, 1, [target], reports.append, ticks.__next__)
    assert reports == [*findings, "Tried 50 inputs: nothing 50."]
    errors = {finding.error.splitlines()[0].partition(":")[0] for finding in findings}
    assert errors == {"Traceback (most recent call last)", "failed", "Growth"}
    first = next(finding for finding in findings if finding.data)
    number = int(first.origin.rpartition(" ")[2])
    assert target.random_input(1, number) == first.data
    assert attempt(target, first.data, "repeated") is not None


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="needs a timer for processor time")
def test_hang_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    def check(data: bytes, folder: Path) -> None:
        while True:
            with suppress(Exception):
                len(data)

    monkeypatch.setattr(fuzzing, "MAX_CASE_S", 0.05)
    finding = attempt(Target("nothing", lambda random: b"", check), b"x", "once")
    assert finding is not None
    assert finding.error.rstrip().endswith("CaseTimeout")


# --- Objects that live as long as the program -------------------------------------------

Feed = Callable[[bytes], object]


def _board_line() -> tuple[object, Feed]:
    line = SimulatedBoards([Board(seed=0)])

    def feed(data: bytes) -> None:
        line.send(data)
        line.inject(data[:20])
        line.advance(0.3)
        line.receive()

    return line, feed


def _robot_line() -> tuple[object, Feed]:
    line = AracnaLine()

    def feed(data: bytes) -> None:
        line.send(data)
        line.advance(0.3)
        line.receive()

    return line, feed


def _client() -> tuple[object, Feed]:
    client = TrexClient(
        VirtualTransport(SimulatedBoards([Board(seed=0)])), ConnectionSettings("virtual")
    )

    def feed(data: bytes) -> None:
        client.transport.line.inject(data[:30])  # type: ignore[attr-defined]  # of the virtual transport
        with suppress(NoReply, BadReply):
            client.request(GetSignature() if data[:1] < b"\x80" else GetRawChannels(0x1F))
        client.transport.wait(0.1)
        client.transport.sent.clear()  # type: ignore[attr-defined]  # of the virtual transport
        client.transport.written.clear()  # type: ignore[attr-defined]

    return client, feed


def _assembler(decoder: Any) -> tuple[object, Feed]:
    assembler, times = TransactionAssembler(decoder), count()

    def feed(data: bytes) -> None:
        direction = TrafficDirection.SENT if data[:1] < b"\x60" else TrafficDirection.RECEIVED
        rows = assembler.feed([TrafficEvent(float(next(times)), direction, data[:100] or b"\0")])
        for row in rows:
            decoder.decoded(row)

    return assembler, feed


def _parser(parser: Any) -> tuple[object, Feed]:
    return parser, parser.feed


LONG_LIVED: dict[str, Callable[[], tuple[object, Feed]]] = {
    "board": _board_line,
    "robot": _robot_line,
    "client": _client,
    "rows of a board": lambda: _assembler(TrexDecoder()),
    "rows of a robot": lambda: _assembler(AracnaDecoder()),
    "lines of a robot": lambda: _parser(Reader()),
    "packets": lambda: _parser(PacketParser(0x89)),
}


def _reachable(root: object) -> Iterator[object]:
    """Yield all objects that an object owns, without classes, functions and modules."""
    seen: set[int] = set()
    remaining = [root]
    while remaining:
        current = remaining.pop()
        if id(current) not in seen and not isinstance(
            current, type | FunctionType | BuiltinFunctionType | ModuleType
        ):
            seen.add(id(current))
            yield current
            remaining += gc.get_referents(current)


@pytest.mark.parametrize("name", LONG_LIVED)
def test_memory_of_long_lived_object_does_not_grow(name: str) -> None:
    subject, feed = LONG_LIVED[name]()
    random = Random(name)

    def feed_many(inputs: int) -> int:
        for _ in range(inputs):
            pieces = random.choices([*PACKETS, *REPLIES, b"\n", random.randbytes(5)], k=6)
            feed(b"".join(pieces))
        return sum(map(sys.getsizeof, _reachable(subject)))

    before = feed_many(50)
    assert feed_many(100) < before + 2500
