from itertools import pairwise

from trex_gui.devices.trex.simulator.command import demonstrate
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import TrexLine


def demo_line(mode: str = "serial") -> TrexLine:
    line = TrexLine([Board(mode=mode)])
    demonstrate(line.boards[0], line.timeline)
    return line


def watch(line: TrexLine, seconds: float) -> list[tuple[int | None, ...]]:
    seen = []
    for _ in range(round(seconds / 0.02)):
        line.advance(0.02)
        seen.append(line.boards[0].channels.raw)
    return seen


def test_demo_moves_every_stick_without_override() -> None:
    line = demo_line("rc")
    board = line.boards[0]
    seen = watch(line, 30)
    for channel in zip(*seen, strict=True):
        values = [value for value in channel if value is not None]
        assert len(values) == len(seen)
        assert max(values) - min(values) > 300
        steps = [abs(after - before) for before, after in pairwise(values)]
        assert max(steps) < 60
    assert not board.sticks.override
    assert not board.sticks.safe_start


def test_demo_moves_voltages_in_analog_mode() -> None:
    seen = watch(demo_line("analog"), 10)
    first = [raw[0] for raw in seen if raw[0] is not None]
    assert 0 <= min(first) < 200
    assert 800 < max(first) <= 1023


def test_demo_puts_light_load_on_motors() -> None:
    assert all(physics.load > 1 for physics in demo_line().boards[0].physics)
