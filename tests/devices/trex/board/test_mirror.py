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
    LeaseChanged,
    NotResponding,
    ReadReason,
    Report,
    Written,
)
from trex_gui.devices.trex.settings.document import factory_settings

CONNECTION = ConnectionSettings("/dev/ttyUSB0")
CONNECTION_TEXT = "/dev/ttyUSB0 at 19200 baud, no error detection, 1 stop bit"
NOW = datetime(2026, 7, 1, 12, tzinfo=UTC)
NO_UART = UartError(0)
MOTOR_STATUS = Status.MOTOR1_FAULT | Status.MOTOR2_OVER_LIMIT
LINE_ERRORS = [bit for bit in UartError if bit is not UartError.TIMEOUT]


def state(mode: Mode = Mode.SERIAL_RC, **parameters: int) -> DeviceState:
    model = device_table().model("trex")
    stored = {**factory_settings(model, "1.2").parameters, **parameters}
    curves = dict.fromkeys(CHANNELS, DEFAULT_CALIBRATION[InputSource.RC])
    return DeviceState(Signature(model, "1.2"), mode, mode.is_serial, stored, curves, calibrated=0)


class MirrorHarness:
    """A mirror and its events."""

    def __init__(self) -> None:
        self.files = MemoryHarness()
        self.board = BoardMirror(self.files.memory)
        self.now = 0.0
        self.events: list[BoardEvent] = []

    def handle(self, report: Report) -> list[BoardEvent]:
        events = list(self.board.handle(report, self.now, NOW))
        self.events += events
        return events

    def read(
        self,
        board: DeviceState,
        occasion: ReadReason = ReadReason.OPENED,
        connection: ConnectionSettings = CONNECTION,
    ) -> BoardRead:
        events = self.handle(Connected(board, False, occasion, connection))
        (read,) = (event for event in events if isinstance(event, BoardRead))
        return read

    def sample(self, *samples: Sample, **counters: int) -> list[BoardEvent]:
        return self.handle(Batch(samples, Counters(**counters)))

    def stop_responding(self) -> None:
        self.handle(NotResponding("", Counters()))

    def close(self, *, may_move: bool = False) -> None:
        self.handle(Closed(None, may_move=may_move))

    def connection(self) -> tuple[float | None, datetime | None, int, int]:
        board = self.board
        return board.connected_at, board.connected_utc, board.returns, board.restarts

    def stored(self) -> DeviceState | None:
        return self.board.state

    def controls(self) -> bool | None:
        return self.board.serial_controls

    def joint(self) -> bool:
        return self.board.is_joint

    def timeout_stop(self) -> TimeoutStop:
        return self.board.timeout_stop

    @property
    def logged(self) -> list[tuple[float, str, str]]:
        return [
            (event.time, event.kind.value, event.text)
            for event in self.events
            if isinstance(event, Event)
        ]


@pytest.fixture
def harness() -> MirrorHarness:
    return MirrorHarness()


# --- Connections ------------------------------------------------------------------------


def test_connection_is_logged_from_start_to_end(harness: MirrorHarness) -> None:
    harness.close()
    assert not harness.logged, "no board was connected"
    harness.now = 5
    harness.read(state())
    harness.stop_responding()
    harness.read(state(), ReadReason.RETURNED)
    harness.read(state(), ReadReason.RELOADED)
    harness.close(may_move=True)
    assert harness.logged == [
        (5, "link", f"Connected to TReX 1.2 on {CONNECTION_TEXT}."),
        (5, "link", "The board stopped responding."),
        (5, "link", "The board responds again"),
        (5, "link", "Motors may still be turning: disconnected before a stop was confirmed"),
    ]


def test_returns_and_restarts_are_counted_per_connection(harness: MirrorHarness) -> None:
    harness.now = 2.0
    harness.read(state())
    harness.now = 9.0
    for occasion in (ReadReason.RETURNED, ReadReason.RESTARTED, ReadReason.RESTARTED):
        harness.read(state(), occasion)
    assert harness.connection() == (2.0, NOW, 1, 2)
    harness.close()
    assert harness.connection() == (None, None, 1, 2)
    harness.read(state())
    assert harness.connection() == (9.0, NOW, 0, 0)


def test_silent_board_has_no_inputs_and_closed_board_no_state(harness: MirrorHarness) -> None:
    harness.read(state())
    harness.sample(Currents(1.0, (1, 2)))
    harness.stop_responding()
    assert harness.stored() is not None
    assert harness.board.inputs(0.0) is None
    assert harness.board.control_text == ""
    harness.close()
    assert harness.stored() is None
    assert harness.board.last == state()


@pytest.mark.parametrize(
    ("occasion", "second", "connection", "is_changed", "is_other", "is_new"),
    [
        (ReadReason.OPENED, state(), CONNECTION, True, True, False),
        (ReadReason.OPENED, state(), ConnectionSettings("COM3"), True, True, True),
        (ReadReason.OPENED, state(device_number=9), CONNECTION, True, True, True),
        (ReadReason.RETURNED, state(), CONNECTION, False, False, False),
        (ReadReason.RESTARTED, state(device_number=9), CONNECTION, True, True, True),
        (ReadReason.RELOADED, state(device_number=9), CONNECTION, True, False, False),
    ],
)
def test_error_counts_continue_if_the_board_may_be_the_same(
    harness: MirrorHarness,
    occasion: ReadReason,
    second: DeviceState,
    connection: ConnectionSettings,
    is_changed: bool,
    is_other: bool,
    is_new: bool,
) -> None:
    harness.read(state())
    harness.sample(LatchedStatus(1.0, Status.MOTOR1_FAULT, NO_UART))
    if occasion is ReadReason.OPENED:
        harness.close()
    read = harness.read(second, occasion, connection)
    assert (read.is_changed, read.is_other, read.is_new) == (is_changed, is_other, is_new)
    assert harness.board.errors.entries[0].count == (0 if is_new else 1)


def test_selected_board_has_its_own_errors_and_samples(harness: MirrorHarness) -> None:
    first, second = state(device_number=7), state(device_number=8, motor_mode=1)
    harness.read(first)
    harness.sample(LatchedStatus(1.0, Status.MOTOR1_FAULT, NO_UART))
    for board, count, is_joint in ((second, 0, True), (first, 1, False), (second, 0, True)):
        harness.sample(Currents(1.0, (9, 9)))
        harness.read(board, ReadReason.SELECTED)
        assert Currents not in harness.board.newest.samples
        assert harness.board.errors.entries[0].count == count
        assert harness.board.is_joint is is_joint


def test_joint_mode_begins_at_the_next_start(harness: MirrorHarness) -> None:
    harness.read(state())
    harness.read(state(motor_mode=1), ReadReason.RELOADED)
    assert not harness.joint()
    harness.board.record_power_cycled()
    assert harness.joint()
    harness.read(state(), ReadReason.RESTARTED)
    assert not harness.joint()


def test_joint_mode_waits_for_the_next_start_after_reconnecting(harness: MirrorHarness) -> None:
    harness.read(state())
    harness.board.record_written(Written((), state(motor_mode=1), CONNECTION))
    harness.close()
    harness.read(state(motor_mode=1))
    assert not harness.joint()
    harness.close()
    harness.read(state(motor_mode=1, device_number=9))
    assert harness.joint(), "board 9 is another board"


def test_record_of_a_board_names_its_adapter(harness: MirrorHarness) -> None:
    harness.board.adapter = "0403:6001-A"
    harness.read(state(serial_timeout=5))
    (record,) = harness.files.records.values()
    assert record.adapter == "0403:6001-A"


# --- Status bits ------------------------------------------------------------------------


def test_lasting_fault_is_one_event_and_recurring_fault_two(harness: MirrorHarness) -> None:
    for tenth in range(30):
        harness.sample(LatchedStatus(tenth / 10, Status.MOTOR1_FAULT, NO_UART))
    harness.sample(LatchedStatus(4, MOTOR_STATUS, NO_UART))
    assert harness.logged == [
        (0, "fault", "Motor 1 fault"),
        (4, "fault", "Motor 1 fault"),
        (4, "over-limit", "Motor 2 over current limit"),
    ]


def test_serial_error_is_one_event_until_it_is_cleared(harness: MirrorHarness) -> None:
    for second in range(1, 8):
        harness.sample(LatchedStatus(second, Status.UART_ERROR, UartError.FRAMING))
        if second == 5:
            harness.board.errors.clear(UartError.FRAMING)
    harness.sample(LatchedStatus(9, Status.UART_ERROR, UartError.TIMEOUT))
    assert harness.logged == [
        (1, "link", "Framing error"),
        (6, "link", "Framing error"),
        (9, "timeout", "Serial timeout"),
    ]


def test_driver_of_a_served_board_is_known_and_logged(harness: MirrorHarness) -> None:
    alice, own = LeaseChanged("bob", "alice", False), LeaseChanged("bob", "bob", True)
    for lease, other in ((alice, "alice"), (alice, "alice"), (own, "")):
        harness.handle(lease)
        assert harness.board.other_driver == other
    assert [text for _, _, text in harness.logged] == ["Driver: alice", "Driver: this program"]
    harness.handle(alice)
    harness.close()
    assert harness.board.other_driver == ""


def test_repeated_motor_commands_are_logged(harness: MirrorHarness) -> None:
    harness.read(state())
    harness.handle(CommandsRepeated())
    assert "motor commands are repeated" in harness.logged[-1][2]


@pytest.mark.parametrize(
    ("shutdown", "status", "uart", "reasons"),
    [
        *((stored, Status.UART_ERROR, UartError.TIMEOUT, ["Serial Timeout"]) for stored in (0, 1)),
        *((0, Status.UART_ERROR, bit, []) for bit in LINE_ERRORS),
        *((1, Status.UART_ERROR, bit, ["error on the line"]) for bit in LINE_ERRORS),
        (1, MOTOR_STATUS, NO_UART, []),
    ],
)
def test_active_error_shutdown_determines_reported_motor_stops(
    harness: MirrorHarness, shutdown: int, status: Status, uart: UartError, reasons: list[str]
) -> None:
    harness.read(state(uart_error_shutdown=1 - shutdown))
    harness.read(state(uart_error_shutdown=shutdown), ReadReason.RELOADED)
    events = harness.sample(LatchedStatus(1.0, status, uart))
    stops = [event.reason for event in events if isinstance(event, MotorsShutDown)]
    assert len(stops) == len(reasons)
    assert all(reason in stop for reason, stop in zip(reasons, stops, strict=True))


def drive_loss_reasons(events: Sequence[BoardEvent]) -> list[str]:
    return [event.reason for event in events if isinstance(event, DriveLost)]


@pytest.mark.parametrize(("is_earlier", "reasons"), [(False, 1), (True, 0)])
def test_only_a_new_motor_fault_ends_driving(
    harness: MirrorHarness, *, is_earlier: bool, reasons: int
) -> None:
    harness.read(state())
    fault = LatchedStatus(1.0, Status.MOTOR1_FAULT, NO_UART, is_earlier)
    expected = ["The board reports: Motor 1 fault."] * reasons
    assert drive_loss_reasons(harness.sample(fault)) == expected


def test_control_by_the_rc_channels_ends_driving(harness: MirrorHarness) -> None:
    harness.read(state(Mode.RC))
    assert drive_loss_reasons(harness.sample(Control(1.0, by_serial=True))) == []
    (reason,) = drive_loss_reasons(harness.sample(Control(2.0, by_serial=False)))
    assert "RC channels control" in reason


def test_motor_shutdown_is_reported_before_its_samples(harness: MirrorHarness) -> None:
    timeout = LatchedStatus(2.0, Status.UART_ERROR, UartError.TIMEOUT)
    events = harness.sample(Currents(1.0, (9, 9)), timeout)
    kinds = [type(event) for event in events]
    assert kinds.index(MotorsShutDown) < kinds.index(Currents)


def test_bits_after_a_corrupted_reply_are_doubtful_without_crc(harness: MirrorHarness) -> None:
    harness.read(state())
    harness.sample(LatchedStatus(1.0, Status.MOTOR2_FAULT, NO_UART))
    harness.sample(
        Control(1.0, by_serial=True), LatchedStatus(1.0, Status.MOTOR1_FAULT, NO_UART), corrupted=1
    )
    assert harness.board.errors.entries[0].is_doubtful
    inputs = harness.board.inputs(1.0)
    assert inputs is not None
    assert (inputs.faults, inputs.doubtful) == ((1, 2), (1,))


# --- The line ---------------------------------------------------------------------------


def test_unconfirmed_current_is_dropped_on_a_failing_line(harness: MirrorHarness) -> None:
    def currents(*counts: tuple[int, int], **failed: int) -> list[tuple[int, int]]:
        samples = (Currents(float(time), pair) for time, pair in enumerate(counts))
        events = harness.sample(*samples, **failed)
        return [event.counts for event in events if isinstance(event, Currents)]

    peak = [(9, 9), (200, 9), (9, 9)]
    harness.read(state())
    assert currents(*peak) == peak
    assert currents(*peak, missing=1) == [(9, 9), (9, 9)]
    rise = [(9, 9), (20, 9), (60, 40), (61, 41)]
    assert currents(*rise, missing=1) == rise
    assert currents((9, 9), missing=1) == []
    assert currents((8, 10), missing=1) == [(9, 9), (8, 10)]
    with_crc = replace(CONNECTION, line=replace(CONNECTION.line, detection=Detection.CRC7))
    harness.read(state(), connection=with_crc)
    assert currents(*peak, missing=2) == peak


def test_noisy_line_is_logged_when_it_begins_and_ends(harness: MirrorHarness) -> None:
    harness.read(state())
    requests, lost = 0, 0
    for second in range(60):
        requests += 200
        lost += 6 if second < 20 else 0
        harness.sample(Control(float(second), by_serial=True), requests=requests, missing=lost)
    assert [text for _, _, text in harness.logged[1:]] == [
        "The line is noisy: 3.0 % of the replies were lost or corrupted",
        "The line is good again",
    ]
    assert QualityChanged() in harness.events
    harness.events.clear()
    harness.stop_responding()
    assert QualityChanged() in harness.events
    assert harness.board.quality.is_noisy is None


# --- Motors -----------------------------------------------------------------------------


def test_control_is_known_after_the_board_was_read(harness: MirrorHarness) -> None:
    assert harness.controls() is None
    harness.read(state(Mode.RC))
    assert harness.controls() is False
    assert "RC channels control" in harness.board.control_text
    harness.sample(Control(1.0, by_serial=True))
    assert "channel 5 overrides" in harness.board.control_text


def test_timeout_stop_is_known_after_disconnecting(harness: MirrorHarness) -> None:
    assert harness.timeout_stop() is TimeoutStop.OFF
    assert harness.board.silence_remedy == "Cut the power."
    harness.read(state(serial_timeout=5, uart_error_shutdown=1))
    harness.close()
    assert "should stop its motors 0.5 s after" in harness.board.silence_remedy
    harness.board.memory.record_trial(TimeoutTrial(stopped=True, shutdown=True))
    assert harness.timeout_stop() is TimeoutStop.TRIED


def test_only_recent_errors_block_the_motors(harness: MirrorHarness) -> None:
    harness.read(state(serial_timeout=5))
    harness.sample(
        Raw(1.0, (1500,) * 5), LatchedStatus(1.0, Status.MOTOR2_FAULT, UartError.TIMEOUT)
    )
    inputs = harness.board.inputs(0.0)
    assert inputs is not None
    assert (inputs.faults, inputs.uart, inputs.timeout) == ((2,), UartError.TIMEOUT, "0.5 s")
    inputs = harness.board.inputs(10.0)
    assert inputs is not None
    assert inputs.faults == ()


def test_stored_settings_complete_the_setup_steps(harness: MirrorHarness) -> None:
    steps = [harness.board.set_up]
    harness.read(state(serial_timeout=0, motor1_current_limit=5, motor2_current_limit=9))
    steps.append(harness.board.set_up)
    for first, second in ((5, 0), (0, 9)):
        written = state(serial_timeout=5, motor1_current_limit=first, motor2_current_limit=second)
        harness.board.record_written(Written((), replace(written, calibrated=3), CONNECTION))
        steps.append(harness.board.set_up)
    assert steps == [None, SetUp(False, True, False), *[SetUp(True, False, True)] * 2]


def test_replies_show_that_so_is_not_grounded(harness: MirrorHarness) -> None:
    echoing = Connected(state(), True, ReadReason.RETURNED, CONNECTION)
    grounded = [harness.board.so_ground]
    for report in (
        Connected(state(), False, ReadReason.OPENED, CONNECTION),
        NotResponding("", Counters()),
    ):
        harness.handle(report)
        grounded.append(harness.board.so_ground)
    harness.handle(echoing)
    assert [*grounded, harness.board.so_ground] == [None, False, None, None]


# --- Safe-start -------------------------------------------------------------------------


def is_held(harness: MirrorHarness) -> bool:
    inputs = harness.board.inputs(0.0)
    assert inputs is not None
    return inputs.is_held


def sample_channel(
    harness: MirrorHarness, value: int, *, counts: int = 0, signal: bool = True
) -> None:
    pulse = (3000 if signal else None, *(1500,) * 4)
    harness.sample(Raw(1.0, pulse), Remapped(1.0, (value, 0, 0, 0, 0)), Currents(1.0, (counts, 0)))


@pytest.fixture
def safe_start(harness: MirrorHarness) -> MirrorHarness:
    """Board in safe-start. It was connected while channel 1 commanded a speed."""
    harness.read(state(Mode.RC, required_channels=1))
    sample_channel(harness, 100)
    return harness


def test_motor_current_ends_safe_start(safe_start: MirrorHarness) -> None:
    sample_channel(safe_start, 100, counts=1)
    assert is_held(safe_start), "one count may be noise"
    sample_channel(safe_start, 100, counts=2)
    assert not is_held(safe_start)
    for occasion, holds in ((ReadReason.RELOADED, False), (ReadReason.RESTARTED, True)):
        safe_start.read(state(Mode.RC), occasion)
        sample_channel(safe_start, 100)
        assert is_held(safe_start) is holds


def test_signal_loss_of_required_channel_restarts_safe_start(safe_start: MirrorHarness) -> None:
    sample_channel(safe_start, NEARLY_NEUTRAL)
    sample_channel(safe_start, 100)
    assert not is_held(safe_start)
    sample_channel(safe_start, 0, signal=False)
    sample_channel(safe_start, 100)
    assert is_held(safe_start)


def test_joint_motors_are_not_reported_as_held(safe_start: MirrorHarness) -> None:
    safe_start.read(state(Mode.RC, motor_mode=1), ReadReason.RESTARTED)
    sample_channel(safe_start, 100)
    assert not is_held(safe_start)
