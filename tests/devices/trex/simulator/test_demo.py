from itertools import pairwise

from trex_gui.devices.trex.simulator.demo import Demo
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.signals import Signal


def watch(board: Board, demo: Demo, seconds: float) -> list[tuple[int | None, ...]]:
    seen = []
    for _ in range(round(seconds / 0.02)):
        board.advance(0.02)
        demo.update()
        seen.append(board.channels.raw)
    return seen


def test_demo_moves_every_stick_without_override() -> None:
    board = Board(mode="rc")
    seen = watch(board, Demo(board), 30)
    for channel in zip(*seen, strict=True):
        values = [value for value in channel if value is not None]
        assert len(values) == len(seen)
        assert max(values) - min(values) > 300
        steps = [abs(after - before) for before, after in pairwise(values)]
        assert max(steps) < 60
    assert not board.override
    assert not board.safe_start


def test_demo_moves_voltages_in_analog_mode() -> None:
    board = Board(mode="analog")
    seen = watch(board, Demo(board), 10)
    first = [raw[0] for raw in seen if raw[0] is not None]
    assert 0 <= min(first) < 200
    assert 800 < max(first) <= 1023


def test_demo_leaves_user_set_channel_alone() -> None:
    board = Board()
    demo = Demo(board)
    watch(board, demo, 1)
    board.connect(2, Signal.pulses(1234))
    seen = watch(board, demo, 5)
    assert {raw[1] for raw in seen} == {3085}
    assert len({raw[0] for raw in seen}) > 100


def test_demo_puts_light_load_on_motors() -> None:
    board = Board()
    Demo(board)
    assert all(physics.load > 1 for physics in board.physics)
