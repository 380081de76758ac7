"""State of a board from the reports of a session."""

from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, datetime

import pytest

from tests.devices.trex.board.test_memory import MemoryHarness
from trex_gui.core.events import Event
from trex_gui.core.session import Closed
from trex_gui.devices.trex.board.mirror import (
    BoardEvent,
    BoardMirror,
    BoardRead,
    DriveLost,
    MotorsShutDown,
    QualityChanged,
    SetUp,
)
from trex_gui.devices.trex.client.client import Counters
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.telemetry import (
    Control,
    Currents,
    LatchedStatus,
    Raw,
    Remapped,
    Sample,
)
from trex_gui.devices.trex.driving.requests import CommandsRepeated
from trex_gui.devices.trex.driving.timeout_stop import TimeoutStop, TimeoutTrial
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION, NEARLY_NEUTRAL
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, Mode, Status, UartError
from trex_gui.devices.trex.protocol.line_settings import Detection
from trex_gui.devices.trex.session.messages import (
    Batch,
    Connected,
    NotResponding,
    ReadReason,
    Report,
    Written,
)
from trex_gui.devices.trex.settings.document import factory_settings

LINE = ConnectionSettings("/dev/ttyUSB0")
WHERE = "/dev/ttyUSB0 at 19200 baud, no error detection, 1 stop bit"
UTC_NOW = datetime(2026, 7, 1, 12, tzinfo=UTC)
NO_UART, NO_STATUS = UartError(0), Status(0)
LINE_ERRORS = [bit for bit in UartError if bit is not UartError.TIMEOUT]


def state(mode: Mode = Mode.SERIAL_RC, **parameters: int) -> DeviceState:
    model = device_table().model("trex")
    stored = {**factory_settings(model, "1.2").parameters, **parameters}
    curves = dict.fromkeys(CHANNELS, DEFAULT_CALIBRATION[InputSource.RC])
    return DeviceState(Signature(model, "1.2"), mode, mode.is_serial, stored, curves, calibrated=0)


class MirrorHarness:
    """A mirror and its events."""

    def __init__(self) -> None:
        self.shelf = MemoryHarness()
        self.board = BoardMirror(self.shelf.memory)
        self.now = 0.0
        self.events: list[BoardEvent] = []

    def handle(self, report: Report) -> list[BoardEvent]:
        found = list(self.board.handle(report, self.now, UTC_NOW))
        self.events += found
        return found

    def read(
        self,
        board: DeviceState,
        occasion: ReadReason = ReadReason.OPENED,
        line: ConnectionSettings = LINE,
    ) -> BoardRead:
        found = self.handle(Connected(board, False, occasion, line))
        (read,) = (event for event in found if isinstance(event, BoardRead))
        return read

    def sample(self, *samples: Sample, **counters: int) -> list[BoardEvent]:
        return self.handle(Batch(samples, Counters(**counters)))

    def lose(self) -> None:
        self.handle(NotResponding("", Counters()))

    def close(self, *, may_move: bool = False) -> None:
        self.handle(Closed(None, may_move=may_move))

    def connection(self) -> tuple[float | None, int, int]:
        return self.board.connected_at, self.board.returns, self.board.restarts

    def stored(self) -> DeviceState | None:
        return self.board.state

    def controls(self) -> bool | None:
        return self.board.serial_controls

    def joint(self) -> bool:
        return self.board.is_joint

    def silence(self) -> TimeoutStop:
        return self.board.timeout_stop

    @property
    def logged(self) -> list[tuple[float, str, str]]:
        return [
            (event.time, event.kind.value, event.text)
            for event in self.events
            if isinstance(event, Event)
        ]


@pytest.fixture
def watched() -> MirrorHarness:
    return MirrorHarness()


# --- Connections ------------------------------------------------------------------------


def test_connection_is_logged_from_its_beginning_to_its_end(watched: MirrorHarness) -> None:
    watched.close()
    assert not watched.logged, "it was never connected"
    watched.now = 5
    watched.read(state())
    watched.lose()
    watched.read(state(), ReadReason.RETURNED)
    watched.read(state(), ReadReason.RELOADED)
    watched.close(may_move=True)
    assert watched.logged == [
        (5, "link", f"Connected to TReX 1.2 on {WHERE}."),
        (5, "link", "The board stopped responding."),
        (5, "link", "The board responds again"),
        (5, "link", "Motors may still be turning: disconnected before a stop was confirmed"),
    ]


def test_returns_and_restarts_are_counted_since_the_line_was_opened(watched: MirrorHarness) -> None:
    watched.now = 2.0
    watched.read(state())
    watched.now = 9.0
    for occasion in (ReadReason.RETURNED, ReadReason.RESTARTED, ReadReason.RESTARTED):
        watched.read(state(), occasion)
    assert watched.connection() == (2.0, 1, 2)
    watched.close()
    assert watched.connection() == (None, 1, 2)
    watched.read(state())
    assert watched.connection() == (9.0, 0, 0)


def test_nothing_is_stored_or_measured_without_a_board(watched: MirrorHarness) -> None:
    watched.read(state())
    watched.sample(Currents(1.0, (1, 2)))
    watched.lose()
    assert watched.stored() is not None
    assert watched.board.inputs(0.0) is None
    assert watched.board.control_text == ""
    watched.close()
    assert watched.stored() is None
    assert watched.board.last == state()


@pytest.mark.parametrize(
    ("occasion", "other", "line", "is_changed", "is_other", "is_new"),
    [
        (ReadReason.OPENED, state(), LINE, True, True, False),
        (ReadReason.OPENED, state(), ConnectionSettings("COM3"), True, True, True),
        (ReadReason.OPENED, state(device_number=9), LINE, True, True, True),
        (ReadReason.RETURNED, state(), LINE, False, False, False),
        (ReadReason.RESTARTED, state(device_number=9), LINE, True, True, True),
        (ReadReason.RELOADED, state(device_number=9), LINE, True, False, False),
    ],
)
def test_error_counts_continue_if_the_board_may_be_the_same(
    watched: MirrorHarness,
    occasion: ReadReason,
    other: DeviceState,
    line: ConnectionSettings,
    is_changed: bool,
    is_other: bool,
    is_new: bool,
) -> None:
    watched.read(state())
    watched.sample(LatchedStatus(1.0, Status.MOTOR1_FAULT, NO_UART))
    if occasion is ReadReason.OPENED:
        watched.close()
    read = watched.read(other, occasion, line)
    assert (read.is_changed, read.is_other, read.is_new) == (is_changed, is_other, is_new)
    assert watched.board.errors.entries[0].count == (0 if is_new else 1)


def test_selected_board_has_counts_of_its_own(watched: MirrorHarness) -> None:
    first, second = state(device_number=7), state(device_number=8, motor_mode=1)
    watched.read(first)
    watched.sample(LatchedStatus(1.0, Status.MOTOR1_FAULT, NO_UART))
    for board, count, is_joint in ((second, 0, True), (first, 1, False), (second, 0, True)):
        watched.read(board, ReadReason.SELECTED)
        assert watched.board.errors.entries[0].count == count
        assert watched.board.is_joint is is_joint


def test_joint_mode_begins_with_the_next_start(watched: MirrorHarness) -> None:
    watched.read(state())
    watched.read(state(motor_mode=1), ReadReason.RELOADED)
    assert not watched.joint()
    watched.board.record_power_cycled()
    assert watched.joint()
    watched.read(state(), ReadReason.RESTARTED)
    assert not watched.joint()


def test_joint_mode_waits_for_the_next_start_beyond_the_end_of_the_line(
    watched: MirrorHarness,
) -> None:
    watched.read(state())
    watched.board.record_written(Written((), state(motor_mode=1), LINE))
    watched.close()
    watched.read(state(motor_mode=1))
    assert not watched.joint()
    watched.close()
    watched.read(state(motor_mode=1, device_number=9))
    assert watched.joint(), "it is another board"


def test_record_follows_the_board(watched: MirrorHarness) -> None:
    watched.board.adapter = "0403:6001-A"
    watched.read(state(serial_timeout=5))
    (record,) = watched.shelf.records.values()
    assert record.adapter == "0403:6001-A"


# --- Status bits ------------------------------------------------------------------------


def test_lasting_fault_is_one_event_and_recurring_fault_two(watched: MirrorHarness) -> None:
    for tenth in range(30):
        watched.sample(LatchedStatus(tenth / 10, Status.MOTOR1_FAULT, NO_UART))
    both = Status.MOTOR1_FAULT | Status.MOTOR2_OVER_LIMIT
    watched.sample(LatchedStatus(9, both, NO_UART))
    assert watched.logged == [
        (0, "fault", "Motor 1 fault"),
        (9, "fault", "Motor 1 fault"),
        (9, "over-limit", "Motor 2 over current limit"),
    ]


def test_serial_error_is_one_event_until_it_is_cleared(watched: MirrorHarness) -> None:
    for second in range(1, 8):
        watched.sample(LatchedStatus(second, Status.UART_ERROR, UartError.FRAMING))
        if second == 5:
            watched.board.errors.clear(UartError.FRAMING)
    watched.sample(LatchedStatus(9, Status.UART_ERROR, UartError.TIMEOUT))
    assert watched.logged == [
        (1, "link", "Framing error"),
        (6, "link", "Framing error"),
        (9, "timeout", "Serial timeout"),
    ]


def test_repeated_motor_commands_are_an_event(watched: MirrorHarness) -> None:
    watched.read(state())
    watched.handle(CommandsRepeated())
    assert "motor commands are repeated" in watched.logged[-1][2]


def shut_down(watched: MirrorHarness, status: Status, uart: UartError) -> str:
    found = watched.sample(LatchedStatus(1.0, status, uart))
    return " ".join(event.reason for event in found if isinstance(event, MotorsShutDown))


@pytest.mark.parametrize("shutdown", [0, 1])
def test_serial_timeout_always_stops_the_motors(watched: MirrorHarness, shutdown: int) -> None:
    watched.read(state(uart_error_shutdown=shutdown))
    assert "Serial Timeout" in shut_down(watched, Status.UART_ERROR, UartError.TIMEOUT)


@pytest.mark.parametrize("bit", LINE_ERRORS)
def test_line_error_stops_the_motors_only_if_errors_do(
    watched: MirrorHarness, bit: UartError
) -> None:
    watched.read(state(uart_error_shutdown=0))
    assert shut_down(watched, Status.UART_ERROR, bit) == ""
    watched.read(state(uart_error_shutdown=1), ReadReason.RELOADED)
    assert "error on the line" in shut_down(watched, Status.UART_ERROR, bit)


def test_motor_status_bits_are_no_stop(watched: MirrorHarness) -> None:
    watched.read(state(uart_error_shutdown=1))
    both = Status.MOTOR1_FAULT | Status.MOTOR2_OVER_LIMIT
    assert shut_down(watched, both, NO_UART) == ""


def lost(found: Sequence[BoardEvent]) -> list[str]:
    return [event.reason for event in found if isinstance(event, DriveLost)]


@pytest.mark.parametrize(("is_earlier", "reasons"), [(False, 1), (True, 0)])
def test_new_motor_fault_ends_the_drive(
    watched: MirrorHarness, *, is_earlier: bool, reasons: int
) -> None:
    watched.read(state())
    fault = LatchedStatus(1.0, Status.MOTOR1_FAULT, NO_UART, is_earlier)
    assert lost(watched.sample(fault)) == ["The board reports: Motor 1 fault."] * reasons


def test_reply_that_channels_control_ends_the_drive(watched: MirrorHarness) -> None:
    watched.read(state(Mode.RC))
    assert lost(watched.sample(Control(1.0, by_serial=True))) == []
    (reason,) = lost(watched.sample(Control(2.0, by_serial=False)))
    assert "RC channels control" in reason


def test_stop_of_the_board_precedes_the_samples_that_show_it(watched: MirrorHarness) -> None:
    timeout = LatchedStatus(2.0, Status.UART_ERROR, UartError.TIMEOUT)
    found = watched.sample(Currents(1.0, (9, 9)), timeout)
    kinds = [type(event) for event in found]
    assert kinds.index(MotorsShutDown) < kinds.index(Currents)


def test_bits_after_a_corrupted_reply_are_doubtful_without_a_crc(watched: MirrorHarness) -> None:
    watched.read(state())
    watched.sample(LatchedStatus(1.0, Status.MOTOR2_FAULT, NO_UART))
    watched.sample(
        Control(1.0, by_serial=True), LatchedStatus(1.0, Status.MOTOR1_FAULT, NO_UART), corrupted=1
    )
    assert watched.board.errors.entries[0].is_doubtful
    inputs = watched.board.inputs(1.0)
    assert inputs is not None
    assert (inputs.faults, inputs.doubtful) == ((1, 2), (1,))


# --- The line ---------------------------------------------------------------------------


def test_current_that_no_sample_confirms_is_dropped_on_a_failing_line(
    watched: MirrorHarness,
) -> None:
    def currents(*counts: tuple[int, int], **failed: int) -> list[tuple[int, int]]:
        samples = (Currents(float(time), pair) for time, pair in enumerate(counts))
        found = watched.sample(*samples, **failed)
        return [event.counts for event in found if isinstance(event, Currents)]

    peak = [(9, 9), (200, 9), (9, 9)]
    watched.read(state())
    assert currents(*peak) == peak
    assert currents(*peak, missing=1) == [(9, 9), (9, 9)]
    rise = [(9, 9), (20, 9), (60, 40), (61, 41)]
    assert currents(*rise, missing=1) == rise
    assert currents((9, 9), missing=1) == []
    assert currents((8, 10), missing=1) == [(9, 9), (8, 10)]
    secured = replace(LINE, line=replace(LINE.line, detection=Detection.CRC7))
    watched.read(state(), line=secured)
    assert currents(*peak, missing=2) == peak


def test_noisy_line_is_an_event_at_its_beginning_and_its_end(watched: MirrorHarness) -> None:
    watched.read(state())
    requests, lost = 0, 0
    for second in range(60):
        requests += 200
        lost += 6 if second < 20 else 0
        watched.sample(Control(float(second), by_serial=True), requests=requests, missing=lost)
    assert [text for _, _, text in watched.logged[1:]] == [
        "The line is noisy: 3.0 % lost",
        "The line is good again",
    ]
    assert QualityChanged() in watched.events
    watched.events.clear()
    watched.lose()
    assert QualityChanged() in watched.events
    assert watched.board.quality.is_noisy is None


# --- Motors -----------------------------------------------------------------------------


def test_serial_controls_since_the_board_was_read(watched: MirrorHarness) -> None:
    assert watched.controls() is None
    watched.read(state(Mode.RC))
    assert watched.controls() is False
    assert "RC channels control" in watched.board.control_text
    watched.sample(Control(1.0, by_serial=True))
    assert "channel 5 overrides" in watched.board.control_text


def test_silence_is_judged_also_after_the_line_was_lost(watched: MirrorHarness) -> None:
    assert watched.silence() is TimeoutStop.OFF
    assert watched.board.silence_remedy == "Cut the power."
    watched.read(state(serial_timeout=5, uart_error_shutdown=1))
    watched.close()
    assert "should stop 0.5 s after" in watched.board.silence_remedy
    watched.board.memory.record_trial(TimeoutTrial(stopped=True, shutdown=True))
    assert watched.silence() is TimeoutStop.TRIED


def test_recent_errors_decide_whether_motors_run(watched: MirrorHarness) -> None:
    watched.read(state(serial_timeout=5))
    watched.sample(
        Raw(1.0, (1500,) * 5), LatchedStatus(1.0, Status.MOTOR2_FAULT, UartError.TIMEOUT)
    )
    inputs = watched.board.inputs(0.0)
    assert inputs is not None
    assert (inputs.faults, inputs.uart, inputs.timeout) == ((2,), UartError.TIMEOUT, "0.5 s")
    inputs = watched.board.inputs(10.0)
    assert inputs is not None
    assert inputs.faults == ()


def test_steps_of_the_set_up_are_those_that_are_stored(watched: MirrorHarness) -> None:
    found = [watched.board.set_up]
    watched.read(state(serial_timeout=0, motor1_current_limit=5, motor2_current_limit=9))
    found.append(watched.board.set_up)
    for first, second in ((5, 0), (0, 9)):
        written = state(serial_timeout=5, motor1_current_limit=first, motor2_current_limit=second)
        watched.board.record_written(Written((), replace(written, calibrated=3), LINE))
        found.append(watched.board.set_up)
    assert found == [None, SetUp(False, True, False), *[SetUp(True, False, True)] * 2]


def test_replies_show_that_so_is_not_grounded(watched: MirrorHarness) -> None:
    returned_by_rs_232 = Connected(state(), True, ReadReason.RETURNED, LINE)
    found = [watched.board.so_ground]
    for report in (
        Connected(state(), False, ReadReason.OPENED, LINE),
        NotResponding("", Counters()),
    ):
        watched.handle(report)
        found.append(watched.board.so_ground)
    assert watched.board.connected_utc == UTC_NOW
    watched.handle(returned_by_rs_232)
    assert [*found, watched.board.so_ground] == [None, False, None, None]


# --- Safe-start -------------------------------------------------------------------------


def may_hold(watched: MirrorHarness) -> bool:
    inputs = watched.board.inputs(0.0)
    assert inputs is not None
    return inputs.is_held


def drive(watched: MirrorHarness, value: int, *, counts: int = 0, signal: bool = True) -> None:
    pulse = (3000 if signal else None, *(1500,) * 4)
    watched.sample(Raw(1.0, pulse), Remapped(1.0, (value, 0, 0, 0, 0)), Currents(1.0, (counts, 0)))


@pytest.fixture
def pushed(watched: MirrorHarness) -> MirrorHarness:
    """A board that was connected while channel 1 commands a speed."""
    watched.read(state(Mode.RC, required_channels=1))
    drive(watched, 100)
    return watched


def test_motor_current_shows_that_safe_start_is_over(pushed: MirrorHarness) -> None:
    drive(pushed, 100, counts=1)
    assert may_hold(pushed), "one count may be noise"
    drive(pushed, 100, counts=2)
    assert not may_hold(pushed)
    pushed.read(state(Mode.RC), ReadReason.RESTARTED)
    drive(pushed, 100)
    assert may_hold(pushed)


def test_required_channel_losing_signal_begins_safe_start_again(pushed: MirrorHarness) -> None:
    drive(pushed, NEARLY_NEUTRAL)
    drive(pushed, 100)
    assert not may_hold(pushed)
    drive(pushed, 0, signal=False)
    drive(pushed, 100)
    assert may_hold(pushed)


def test_joint_motors_are_not_reported_as_held(pushed: MirrorHarness) -> None:
    pushed.read(state(Mode.RC, motor_mode=1), ReadReason.RESTARTED)
    drive(pushed, 100)
    assert not may_hold(pushed)
