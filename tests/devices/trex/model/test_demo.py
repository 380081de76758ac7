"""Control of the simulated board: control lines and displayed state."""

from collections.abc import Callable, Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.support.demo_panels import RecordingSimulator
from tests.support.virtual_time import VirtualRuntime
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


def snapshot_of(board: DemoBoard) -> DemoSnapshot:
    assert board.snapshot is not None
    return board.snapshot


# --- Snapshots --------------------------------------------------------------------------


def test_unwatched_board_is_not_polled(
    board: RecordingDemoBoard, virtual_time: VirtualRuntime
) -> None:
    board.watch(False)
    board.watch(True)  # requests a snapshot at once
    board.watch(False)
    board.simulator.lines.clear()
    board.set_mix(True)
    virtual_time.advance(1.0)
    assert board.simulator.lines == ["jumper mix on"]


def test_end_of_the_simulator_clears_the_snapshot(board: RecordingDemoBoard, qtbot: QtBot) -> None:
    board.hold_stick(1, 1200)
    with qtbot.waitSignal(board.simulator.ended):
        board.simulator.stop()
    assert board.snapshot is None
    assert board.automatic == frozenset(CHANNELS)
    with qtbot.waitSignal(board.simulator.ready):
        board.simulator.start()
    board.wait(lambda: board.snapshot is not None)


def test_snapshot_is_parsed_from_the_reply_to_show() -> None:
    line = SimulatedBoards([Board()])
    for command in (
        "channel 2 silent",
        "load 1 4.5",
        "fault 2 on",
        "battery 11.5",
        "jumper mix on",
        "jumper so-ground on",
    ):
        assert control(line, command).startswith("ok")
    line.faults.mute = True
    line.faults.noise = 0.012
    line.advance(0.2)
    snapshot = read_snapshot(control(line, "show").removeprefix("ok "))
    assert snapshot.power
    assert snapshot.mode is Mode.SERIAL_RC
    assert snapshot.jumpers.mode == "serial"
    assert snapshot.line.plugged
    assert len(snapshot.channels) == 5
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


CONTROLS: list[tuple[str, Callable[[DemoBoard], None]]] = [
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


def test_each_control_sends_its_control_line(board: RecordingDemoBoard, qtbot: QtBot) -> None:
    for line, operate in CONTROLS:
        board.simulator.lines.clear()
        replies: list[str] = []
        with qtbot.assertNotEmitted(board.rejected):
            operate(board)
            board.simulator.send("show", replies.append)
            board.wait(lambda: bool(replies))  # noqa: B023
        assert board.simulator.changes() == [line]


def test_power_cycle_is_displayed_and_runs_once(board: RecordingDemoBoard) -> None:
    powers: list[bool] = []
    board.changed.connect(lambda: powers.append(snapshot_of(board).power))
    board.simulator.lines.clear()
    board.power_cycle()
    board.power_cycle()  # the first is not complete yet
    board.wait(lambda: "power on" in board.simulator.lines and snapshot_of(board).power)
    assert board.simulator.changes() == ["power off", "power on"]
    assert False in powers


def test_only_first_and_last_stick_position_are_sent(board: RecordingDemoBoard) -> None:
    board.simulator.lines.clear()
    for microseconds in range(1000, 2001):
        board.hold_stick(1, microseconds)
    board.wait(lambda: snapshot_of(board).channels[0].raw == InputSource.RC.counts(2000))
    assert board.simulator.changes() == ["channel 1 1000us", "channel 1 2000us"]
    assert board.automatic == {2, 3, 4, 5}


def test_snapshot_from_before_a_command_is_not_displayed(board: RecordingDemoBoard) -> None:
    board.hold_stick(1, 1000)
    board.wait(lambda: snapshot_of(board).channels[0].signal == "1000us")
    signals: list[str] = []
    board.wait(lambda: board.simulator.lines[-1] == "show")  # a snapshot was requested
    board.hold_stick(1, 2000)
    board.changed.connect(lambda: signals.append(snapshot_of(board).channels[0].signal))
    board.wait(lambda: "2000us" in signals)
    assert "1000us" not in signals


def test_restored_signal_returns_to_the_stick_position(board: RecordingDemoBoard) -> None:
    board.hold_stick(3, 1700)
    board.set_silent(3, True)
    board.wait(lambda: not snapshot_of(board).channels[2].has_signal)
    board.wait(lambda: snapshot_of(board).channels[2].raw is None)
    board.set_silent(3, False)
    board.wait(lambda: snapshot_of(board).channels[2].raw == InputSource.RC.counts(1700))
    board.set_silent(1, True)
    board.wait(lambda: not snapshot_of(board).channels[0].has_signal)
    board.set_automatic(False)
    board.center_sticks()
    board.set_automatic(True)
    board.set_mix(True)
    board.wait(lambda: snapshot_of(board).jumpers.mix)
    assert not snapshot_of(board).channels[0].has_signal, "moving sticks do not restore the signal"
    board.set_silent(1, False)
    board.wait(lambda: snapshot_of(board).channels[0].raw is not None)
    assert 1 in board.automatic


def test_automatic_sticks_can_be_stopped_and_restarted(board: RecordingDemoBoard) -> None:
    board.set_automatic(False)
    assert board.automatic == frozenset()
    assert len(board.simulator.changes()) == 5
    board.set_automatic(True)
    assert board.automatic == frozenset(CHANNELS)
    first = snapshot_of(board).channels[0].raw
    board.wait(lambda: snapshot_of(board).channels[0].raw != first)


def test_centering_the_sticks_ends_safe_start(board: RecordingDemoBoard) -> None:
    board.hold_stick(1, 2000)
    board.set_mode_jumper("rc")
    board.power_cycle()
    board.wait(lambda: snapshot_of(board).mode is Mode.RC and snapshot_of(board).safe_start)
    board.center_sticks()
    board.wait(lambda: not snapshot_of(board).safe_start)


def test_sticks_can_be_centered_while_no_panel_is_visible(
    board: RecordingDemoBoard, qtbot: QtBot
) -> None:
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
    board.wait(lambda: snapshot_of(board).channels[0].raw == 1023)
    board.wait(lambda: snapshot_of(board).channels[1].raw == InputSource.ANALOG.counts(2.5))


def test_replugged_cable_is_reachable_at_the_reported_url(
    board: RecordingDemoBoard, qtbot: QtBot
) -> None:
    board.set_plugged(False)
    board.wait(lambda: not board.simulator.plugged and not snapshot_of(board).line.plugged)
    board.set_plugged(True)
    board.wait(lambda: board.simulator.plugged and snapshot_of(board).line.plugged)
    with qtbot.waitSignal(board.simulator.ready) as ready:
        board.simulator.start()
    assert ready.args == [board.simulator.url]


def test_factory_reset_restores_board_and_sticks(board: RecordingDemoBoard) -> None:
    board.set_mode_jumper("rc")
    board.power_cycle()
    board.wait(lambda: snapshot_of(board).mode is Mode.RC)
    board.hold_stick(1, 1100)
    board.set_silent(4, True)
    board.set_noise(0.02)
    board.set_mute(True)
    board.wait(
        lambda: not snapshot_of(board).channels[3].has_signal and snapshot_of(board).line.mute
    )
    board.restore_factory()
    board.hold_stick(2, 1200)  # while the power is off
    board.wait(lambda: snapshot_of(board).power and snapshot_of(board).mode is Mode.SERIAL_RC)
    snapshot = snapshot_of(board)
    assert not snapshot.line.mute
    assert snapshot.line.noise == 0
    assert snapshot.jumpers.mode == "serial"
    assert board.automatic == frozenset(CHANNELS)


def test_rejected_command_emits_a_sentence(board: RecordingDemoBoard, qtbot: QtBot) -> None:
    with qtbot.waitSignal(board.changed), qtbot.waitSignal(board.rejected) as rejection:
        board.set_mode_jumper("boat")
    assert rejection.args[0].startswith("Usage: jumper mode serial|rc|analog")
    assert rejection.args[0].endswith(".")


def test_each_boot_step_of_the_simulator_has_a_text() -> None:
    reported = {step.value for step in boot_modes._Step}
    reported |= {"boot loader: requested", "boot loader: ready"}
    assert BOOT_TEXTS.keys() == reported | {"learning: ready"}
