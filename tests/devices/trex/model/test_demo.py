"""Panel of the simulated board: control lines and displayed state."""

from collections.abc import Callable, Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.support.demo_panels import RecordingSimulator
from trex_gui.devices.trex.model.demo import (
    BOOT_TEXTS,
    DemoBoard,
    DemoChannel,
    DemoSnapshot,
    read_snapshot,
)
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, Mode
from trex_gui.devices.trex.simulator import boot_modes
from trex_gui.devices.trex.simulator.control import control
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards


class RecordingDemoBoard(DemoBoard):
    """Simulated board that records its control lines."""

    def __init__(self, qtbot: QtBot) -> None:
        self.simulator = RecordingSimulator()
        super().__init__(self.simulator)
        self.wait = qtbot.waitUntil
        with qtbot.waitSignal(self.simulator.ready):
            self.simulator.start()
        self.watch(True)
        self.wait(lambda: self.snapshot is not None)


@pytest.fixture
def board(qtbot: QtBot) -> Iterator[RecordingDemoBoard]:
    board = RecordingDemoBoard(qtbot)
    yield board
    board.watch(False)
    board.simulator.stop()


def seen(board: DemoBoard) -> DemoSnapshot:
    assert board.snapshot is not None
    return board.snapshot


# --- Display ----------------------------------------------------------------------------


def test_new_board_starts_in_serial_mode_with_moving_sticks(board: RecordingDemoBoard) -> None:
    assert seen(board).power
    assert seen(board).mode is Mode.SERIAL_RC
    assert seen(board).jumpers.mode == "serial"
    assert len(seen(board).channels) == 5
    assert len(seen(board).motors) == 2
    assert seen(board).line.plugged
    assert board.automatic == frozenset(CHANNELS)


def test_unwatched_board_is_not_polled(board: RecordingDemoBoard) -> None:
    board.watch(False)
    board.watch(True)  # requests a snapshot at once
    board.watch(False)
    board.simulator.lines.clear()
    board.set_mix(True)
    answers: list[str] = []
    board.simulator.send("jumper mix on", answers.append)
    board.wait(lambda: answers != [])
    assert board.simulator.lines == ["jumper mix on", "jumper mix on"]


def test_ended_simulator_clears_the_snapshot(board: RecordingDemoBoard, qtbot: QtBot) -> None:
    board.hold_stick(1, 1200)
    with qtbot.waitSignal(board.simulator.ended):
        board.simulator.stop()
    assert board.snapshot is None
    assert board.automatic == frozenset(CHANNELS)
    with qtbot.waitSignal(board.simulator.ready):
        board.simulator.start()
    board.wait(lambda: board.snapshot is not None)


def test_snapshot_is_parsed_from_show() -> None:
    line = SimulatedBoards([Board()])
    for text in (
        "channel 2 silent",
        "load 1 4.5",
        "fault 2 on",
        "battery 11.5",
        "jumper mix on",
        "jumper so-ground on",
    ):
        assert control(line, text).startswith("ok")
    line.faults.mute = True
    line.faults.noise = 0.012
    line.advance(0.2)
    snapshot = read_snapshot(control(line, "show").removeprefix("ok "))
    assert snapshot.power
    assert snapshot.channels[0] == DemoChannel("rest", 3750)
    assert snapshot.channels[1] == DemoChannel("silent", None)
    assert snapshot.motors[0].load == 4.5
    assert [motor.fault for motor in snapshot.motors] == [False, True]
    assert snapshot.jumpers.mix
    assert snapshot.jumpers.so_ground
    assert snapshot.line.mute
    assert snapshot.line.noise == 0.012
    assert snapshot.battery == snapshot.supply == 11.5


@pytest.mark.parametrize(
    ("signal", "raw", "source", "stick"),
    [
        ("1700us", 3750, InputSource.RC, 1700),
        ("1700.5us noise 2us lost 0.1", None, InputSource.RC, 1700.5),
        ("2.50V", 100, InputSource.ANALOG, 2.5),
        ("rest", 3750, InputSource.RC, 1500),
        ("1700us", 1023, InputSource.ANALOG, 5),
        ("silent", None, InputSource.RC, None),
    ],
)
def test_stick_position_follows_its_signal(
    signal: str, raw: int | None, source: InputSource, stick: float | None
) -> None:
    assert DemoChannel(signal, raw).stick(source) == stick


# --- Controls ---------------------------------------------------------------------------


HANDS: list[tuple[str, Callable[[DemoBoard], None]]] = [
    ("power off", lambda board: board.set_power(False)),
    ("jumper mix on", lambda board: board.set_mix(True)),
    ("jumper so-ground on", lambda board: board.set_so_ground(True)),
    ("load 2 11.5", lambda board: board.set_load(2, 11.5)),
    ("fault 1 on", lambda board: board.set_fault(1, True)),
    ("fault 1 off", lambda board: board.set_fault(1, False)),
    ("battery 9.0", lambda board: board.set_battery(9.0)),
    ("line noise 0.0120", lambda board: board.set_noise(0.012)),
    ("line mute on", lambda board: board.set_mute(True)),
    ("line error parity", lambda board: board.corrupt("parity")),
]


def test_each_hand_sends_its_control_line(board: RecordingDemoBoard, qtbot: QtBot) -> None:
    for line, act in HANDS:
        board.simulator.lines.clear()
        answers: list[str] = []
        with qtbot.assertNotEmitted(board.rejected):
            act(board)
            board.simulator.send("show", answers.append)
            board.wait(lambda: bool(answers))  # noqa: B023
        assert board.simulator.orders() == [line]


def test_power_cycle_is_visible_and_runs_once(board: RecordingDemoBoard) -> None:
    off: list[bool] = []

    def on_changed() -> None:
        off.append(board.snapshot is not None and not board.snapshot.power)

    board.changed.connect(on_changed)
    board.simulator.lines.clear()
    board.power_cycle()
    board.power_cycle()  # not complete yet
    board.wait(lambda: "power on" in board.simulator.lines and seen(board).power)
    assert board.simulator.orders() == ["power off", "power on"]
    assert any(off)


def test_stick_positions_are_coalesced_to_first_and_last(board: RecordingDemoBoard) -> None:
    board.simulator.lines.clear()
    for microseconds in range(1000, 2001):
        board.hold_stick(1, microseconds)
    board.wait(lambda: seen(board).channels[0].raw == InputSource.RC.counts(2000))
    assert board.simulator.orders() == ["channel 1 1000us", "channel 1 2000us"]
    assert board.automatic == {2, 3, 4, 5}


def test_snapshot_older_than_a_command_is_not_shown(board: RecordingDemoBoard) -> None:
    board.hold_stick(1, 1000)
    board.wait(lambda: seen(board).channels[0].signal == "1000us")
    shown: list[str] = []
    board.wait(lambda: board.simulator.lines[-1] == "show")  # a snapshot was requested
    board.hold_stick(1, 2000)

    def on_changed() -> None:
        if board.snapshot is not None:
            shown.append(board.snapshot.channels[0].signal)

    board.changed.connect(on_changed)
    board.wait(lambda: "2000us" in shown)
    assert "1000us" not in shown


def test_restored_signal_returns_to_the_stick_position(board: RecordingDemoBoard) -> None:
    board.hold_stick(3, 1700)
    board.set_silent(3, True)
    board.wait(lambda: not seen(board).channels[2].has_signal)
    board.wait(lambda: seen(board).channels[2].raw is None)
    board.set_silent(3, False)
    board.wait(lambda: seen(board).channels[2].raw == InputSource.RC.counts(1700))
    board.set_silent(1, True)
    board.wait(lambda: not seen(board).channels[0].has_signal)
    board.set_automatic(False)
    board.center_sticks()
    board.set_automatic(True)
    board.set_mix(True)
    board.wait(lambda: seen(board).jumpers.mix)
    assert not seen(board).channels[0].has_signal, "it stays silent when sticks move"
    board.set_silent(1, False)
    board.wait(lambda: seen(board).channels[0].raw is not None)
    assert 1 in board.automatic


def test_automatic_sticks_can_be_stopped_and_restarted(board: RecordingDemoBoard) -> None:
    board.set_automatic(False)
    assert board.automatic == frozenset()
    assert len(board.simulator.orders()) == 5
    board.set_automatic(True)
    assert board.automatic == frozenset(CHANNELS)
    first = seen(board).channels[0].raw
    board.wait(lambda: seen(board).channels[0].raw != first)


def test_centering_the_sticks_ends_safe_start(board: RecordingDemoBoard) -> None:
    board.hold_stick(1, 2000)
    board.set_mode_jumper("rc")
    board.power_cycle()
    board.wait(lambda: seen(board).mode is Mode.RC and seen(board).safe_start)
    board.center_sticks()
    board.wait(lambda: not seen(board).safe_start)


def test_sticks_are_centred_while_no_panel_watches(board: RecordingDemoBoard, qtbot: QtBot) -> None:
    board.watch(False)
    board.simulator.stop()
    board.wait(lambda: board.snapshot is None)
    with qtbot.waitSignal(board.simulator.ready):
        board.simulator.start()
    board.wait(lambda: board.snapshot is not None)
    board.center_sticks()
    assert board.automatic == frozenset()


def test_held_sticks_keep_their_position_in_analog_mode(board: RecordingDemoBoard) -> None:
    board.hold_stick(1, 2100)
    board.hold_stick(2, 1500)
    board.set_mode_jumper("analog")
    board.power_cycle()
    board.wait(lambda: seen(board).channels[0].raw == 1023)
    board.wait(lambda: seen(board).channels[1].raw == InputSource.ANALOG.counts(2.5))


def test_replugged_cable_gets_a_working_url(board: RecordingDemoBoard, qtbot: QtBot) -> None:
    board.set_plugged(False)
    board.wait(lambda: not board.simulator.plugged and not seen(board).line.plugged)
    board.set_plugged(True)
    board.wait(lambda: board.simulator.plugged and seen(board).line.plugged)
    with qtbot.waitSignal(board.simulator.ready) as again:
        board.simulator.start()
    assert again.args == [board.simulator.url]


def test_factory_reset_restores_board_and_sticks(board: RecordingDemoBoard) -> None:
    board.set_mode_jumper("rc")
    board.power_cycle()
    board.hold_stick(1, 1100)
    board.set_silent(4, True)
    board.set_noise(0.02)
    board.set_mute(True)
    board.wait(lambda: not seen(board).channels[3].has_signal and seen(board).line.mute)
    board.restore_factory()
    board.wait(lambda: seen(board).power and seen(board).mode is Mode.SERIAL_RC)
    assert not seen(board).line.mute
    assert seen(board).line.noise == 0
    assert seen(board).jumpers.mode == "serial"
    assert board.automatic == frozenset(CHANNELS)
    first = seen(board).channels[0].raw
    board.wait(lambda: seen(board).channels[0].raw != first)


def test_refused_command_emits_a_sentence(board: RecordingDemoBoard, qtbot: QtBot) -> None:
    with qtbot.waitSignal(board.changed), qtbot.waitSignal(board.rejected) as refused:
        board.set_mode_jumper("boat")
    assert refused.args[0].startswith("Usage: jumper mode serial|rc|analog")
    assert refused.args[0].endswith(".")


def test_boot_steps_are_those_that_the_simulator_reports() -> None:
    reported = {step.value for step in boot_modes._Step}
    reported |= {"boot loader: requested", "boot loader: ready"}
    assert BOOT_TEXTS.keys() == reported | {"learning: ready"}
