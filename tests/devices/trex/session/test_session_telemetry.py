"""Polled values: rates, samples and reports."""

import itertools
from collections.abc import Callable

import pytest

from tests.devices.trex.client.corruption import corrupt_packet
from tests.devices.trex.session.helpers import (
    commands,
    create_harness,
    latch_fault,
    motor_commands_in,
    of_type,
    on_write,
    packet,
    read_at,
    run_for,
    samples,
    schedule_heartbeats,
    timed_run,
)
from tests.support.virtual import SessionHarness
from trex_gui.core.errors import BadReply, NoReply, PortUnavailable
from trex_gui.core.session import Close
from trex_gui.core.timing import FRAME, UNWATCHED_INTERVAL
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.telemetry import (
    POLLED,
    Control,
    Currents,
    LatchedStatus,
    ModeSample,
    Raw,
    Remapped,
)
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.driving.requests import Arm, MotorsStopped, SetMotor
from trex_gui.devices.trex.protocol.commands import (
    DriveMotor,
    GetMode,
    GetParameter,
    GetStatus,
    SetParameter,
)
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.flags import InputSource, Mode, Status, UartError
from trex_gui.devices.trex.session import board_reader, jobs
from trex_gui.devices.trex.session.messages import (
    Batch,
    Connected,
    ReadReason,
    Request,
    SetWatched,
    Write,
)
from trex_gui.devices.trex.session.polling import Topic, rates
from trex_gui.devices.trex.simulator.channels import Signal
from trex_gui.ui.plotting.history import MAX_GAP


def measured_rates(harness: SessionHarness, seconds: float) -> dict[Topic, float]:
    """Return the polls per second by topic in the last seconds of a session."""
    last = harness.line.now
    return {
        topic: sum(sample.time > last - seconds for sample in samples(harness.reports, topic))
        / seconds
        for topic in POLLED.keys() - {LatchedStatus}
    }


@pytest.mark.parametrize(("baud", "mode"), [(19200, "serial"), (115200, "analog")])
def test_polls_reach_update_rate_of_board_from_19200_baud(baud: int, mode: str) -> None:
    harness, settings = create_harness(baud, mode=mode)
    run_for(harness, 6.0, settings)
    source = InputSource.ANALOG if mode == "analog" else InputSource.RC
    expected = rates(source)
    for topic, rate in measured_rates(harness, 5.0).items():
        assert rate == pytest.approx(expected[topic], rel=0.04, abs=0.21), topic


def test_unwatched_board_is_polled_slowly() -> None:
    harness, settings = create_harness(115200)
    harness.script.at(0.0, SetWatched(False)).at(6.0, Close())
    timed = timed_run(harness, settings)
    times = [time for time, report in timed if isinstance(report, Batch)]
    harness.reports += [report for _, report in timed]
    expected = rates(InputSource.RC, watched=False)
    for topic, rate in measured_rates(harness, 5.0).items():
        assert rate == pytest.approx(expected[topic], rel=0.04, abs=0.21), topic
    gaps = [later - sooner for sooner, later in itertools.pairwise(times[:-1])]
    assert min(gaps) >= UNWATCHED_INTERVAL - 1e-9
    assert expected[Currents] * MAX_GAP > 2, "the plot of currents has gaps"
    safety = (LatchedStatus, Control, ModeSample)
    assert all(expected[topic] == POLLED[topic].rate for topic in safety)


@pytest.mark.parametrize(
    "request_",
    [SetWatched(True), Arm(), SetMotor(1, Drive.at(50))],
    ids=["watched", "armed", "driven"],
)
def test_polling_is_fast_again_when_watched_or_motors_may_move(request_: Request) -> None:
    harness, settings = create_harness(115200)
    harness.script.at(0.0, SetWatched(False)).at(3.0, request_)
    run_for(harness, 3.5, settings)
    assert measured_rates(harness, 0.4)[Currents] == pytest.approx(80, rel=0.1)


def test_undisturbed_session_polls_in_order_and_commands_no_motor(harness: SessionHarness) -> None:
    reports, sent = run_for(harness, 5.3), harness.transport.sent
    polls = sum(isinstance(command, GetStatus) for command in commands(sent))
    assert polls == pytest.approx(50, abs=4), "ten polls of the status a second"
    batches = of_type(reports, Batch)
    assert all(batch.samples for batch in batches), "no batch is empty"
    times = [sample.time for batch in batches for sample in batch.samples]
    assert times == sorted(times)
    assert len(times) > 500
    requests = [batch.counters.requests for batch in batches]
    assert requests == sorted(set(requests)), "each batch has the counters of its time"
    assert samples(reports, LatchedStatus) == []
    assert motor_commands_in(sent) == []
    assert not of_type(reports, MotorsStopped), "no heartbeat is missed"


def test_polls_use_95_percent_of_a_slow_line() -> None:
    harness, settings = create_harness(9600)
    run_for(harness, 5.0, settings)
    assert len(harness.transport.sent) + harness.line.faults.counters["received"] > 0.95 * 5 * 960


def test_samples_are_delivered_once_per_displayed_frame() -> None:
    harness, settings = create_harness(115200)
    harness.script.at(3.0, Close())
    timed = timed_run(harness, settings)
    batches = [(time, report) for time, report in timed if isinstance(report, Batch)]
    assert all(time - batch.samples[0].time < 2 * FRAME for time, batch in batches)
    times = [time for time, _ in batches[:-1]]  # the close delivers the remaining samples early
    gaps = [later - sooner for sooner, later in itertools.pairwise(times)]
    assert min(gaps) >= FRAME - 1e-9


def test_samples_contain_measurements_of_the_board(harness: SessionHarness) -> None:
    harness.board.channels.signals[1] = Signal.pulses(2000)
    harness.board.channels.signals[4] = Signal.parse("invalid", InputSource.RC)
    harness.board.force_current(2, 3.0)
    reports = run_for(harness, 2.0)
    assert samples(reports, Raw)[-1].counts == (5000, 3750, 3750, None, 3750)
    assert samples(reports, Remapped)[-1].values == (127, 0, 0, 0, 0)
    assert samples(reports, Currents)[-1].counts == (0, 20)
    assert samples(reports, Control)[-1].by_serial is True
    assert samples(reports, ModeSample)[-1].mode is Mode.SERIAL_RC


# --- Status -----------------------------------------------------------------------------


def test_fault_is_reported_once_each_time_it_is_latched(harness: SessionHarness) -> None:
    for time in (1.0, 1.5):
        harness.script.at(time, lambda: latch_fault(harness.board, 1))
    latched = samples(run_for(harness, 2.0), LatchedStatus)
    assert [(sample.status, sample.uart) for sample in latched] == [
        (Status.MOTOR1_FAULT, UartError(0)),
        (Status.MOTOR1_FAULT, UartError(0)),
    ]
    assert [round(sample.time, 1) for sample in latched] == pytest.approx([1.0, 1.5], abs=0.11)


def test_simultaneous_faults_are_reported_together(harness: SessionHarness) -> None:
    harness.script.at(1.0, lambda: latch_fault(harness.board, 1, 2))
    harness.script.at(1.0, lambda: harness.board.report_error(UartError.CRC))
    (latched,) = samples(run_for(harness, 2.0), LatchedStatus)
    assert latched.status == Status.MOTOR1_FAULT | Status.MOTOR2_FAULT | Status.UART_ERROR
    assert latched.uart == UartError.CRC


def test_status_bits_survive_lost_uart_error_byte(harness: SessionHarness) -> None:
    def lose_uart_errors(packet: bytes) -> None:
        harness.line.faults.mute = packet == b"\x85"

    on_write(harness, before=lose_uart_errors)
    harness.script.at(1.0, lambda: latch_fault(harness.board, 2))
    harness.script.at(1.0, lambda: harness.board.report_error(UartError.CRC))
    latched = samples(run_for(harness, 2.0), LatchedStatus)
    assert latched[0].status == Status.MOTOR2_FAULT | Status.UART_ERROR


def test_lost_uart_error_request_is_repeated(harness: SessionHarness) -> None:
    harness.script.at(1.0, lambda: corrupt_packet(harness, b"\x85", b""))
    harness.script.at(1.0, lambda: harness.board.report_error(UartError.CRC))
    latched = samples(run_for(harness, 2.0), LatchedStatus)
    assert [(sample.status, sample.uart) for sample in latched] == [
        (Status.UART_ERROR, UartError(0)),
        (Status(0), UartError.CRC),
    ]


def test_uart_error_is_read_after_lost_status_reply(harness: SessionHarness) -> None:
    requests: list[bytes] = []

    def lose_first_reply(packet: bytes) -> None:
        if packet == b"\x84" and harness.line.now > 1.0:
            requests.append(packet)
            harness.line.faults.to_drop = int(len(requests) == 1)

    on_write(harness, before=lose_first_reply)
    harness.script.at(1.0, lambda: harness.board.report_error(UartError.PARITY))
    (latched,) = samples(run_for(harness, 2.0), LatchedStatus)
    assert latched.uart == UartError.PARITY


# --- Telemetry during other requests ----------------------------------------------------


def test_telemetry_continues_during_single_requests(harness: SessionHarness) -> None:
    for number in range(100):
        harness.script.at(1.0 + number / 100, packet(number, GetMode()))
    run_for(harness, 2.0)
    times = [sample.time for sample in samples(harness.reports, Currents)]
    assert len([time for time in times if 1.0 < time < 2.0]) > 60


def test_telemetry_continues_after_long_write(harness: SessionHarness) -> None:
    keys = [spec.key for spec in harness.board.memory.parameters if not spec.needs_power_cycle]
    values = tuple((key, harness.board.eeprom[key]) for key in keys if key != "factory_reset")
    harness.script.at(1.0, Write(1, values))
    run_for(harness, 3.0)
    times = [sample.time for sample in samples(harness.reports, Currents)]
    assert len([time for time in times if 2.0 < time < 3.0]) == pytest.approx(80, abs=3)


def test_mode_change_after_power_cycle_is_detected(harness: SessionHarness) -> None:
    def change_mode() -> None:
        harness.board.mode_jumper = "analog"
        harness.board.power_cycle()

    harness.script.at(1.0, change_mode)
    run_for(harness, 4.6)
    assert measured_rates(harness, 2.0)[Currents] == pytest.approx(50, rel=0.03)
    first, second = of_type(harness.reports, Connected)
    assert first.state.mode is Mode.SERIAL_RC
    assert second.state.mode is Mode.ANALOG
    assert second.occasion is ReadReason.RESTARTED
    assert second.state.calibrations != first.state.calibrations


def test_failed_write_reads_board_again_at_most_three_times(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    readings: list[float] = []
    harness, settings = create_harness()

    def fail(*_: object, **_options: object) -> DeviceState:
        readings.append(harness.line.now)
        raise BadReply("readings differ")

    def start_failing() -> None:
        error = NoReply("no reply")
        results = (WriteResult("serial_timeout", error=error),)
        monkeypatch.setattr(jobs, "write_all", lambda *_, **_options: results)
        monkeypatch.setattr(board_reader, "read_everything", fail)

    harness.script.at(1.0, start_failing).at(1.0, Write(1, (("serial_timeout", 5),)))
    reports = run_for(harness, 9.0, settings)
    assert len(readings) == 3
    assert all(later - earlier >= 2.0 for earlier, later in itertools.pairwise(readings))
    assert len([sample for sample in samples(reports, Raw) if sample.time > 8.0]) > 40


def test_write_on_a_jammed_port_reads_board_again(harness: SessionHarness) -> None:
    write = harness.transport.write

    def jam(data: bytes) -> None:
        write(data)
        if data[0] == SetParameter(0, 0).opcode:  # the board receives it nevertheless
            harness.transport.write = write  # type: ignore[method-assign]
            raise PortUnavailable("jammed")

    harness.transport.write = jam  # type: ignore[method-assign]
    harness.script.at(1.0, Write(1, (("serial_timeout", 5),)))
    reports = run_for(harness, 5.0)
    assert of_type(reports, Connected)[-1].state.parameters["serial_timeout"] == 5


def silent_change(harness: SessionHarness, **changes: int) -> Callable[[], None]:
    """Return a step that changes stored and active values without a lost reply."""

    def change() -> None:
        for key, wire in changes.items():
            harness.board.eeprom.write(key, wire)
        harness.board.power_cycle()

    return change


@pytest.mark.parametrize(
    ("key", "baud"),
    [
        ("serial_timeout", 115200),
        ("uart_error_shutdown", 19200),
        ("motor1_current_limit", 19200),
        ("motor2_current_limit", 1200),
    ],
)
def test_changed_safety_parameter_is_detected_in_two_seconds(key: str, baud: int) -> None:
    harness, settings = create_harness(baud)
    for stored in ("serial_timeout", "motor1_current_limit", "motor2_current_limit"):
        harness.board.eeprom.write(stored, 50)
    start, reading_time = (6.0, 3.5) if baud == 1200 else (2.0, 1.0)
    harness.script.at(start, silent_change(harness, **{key: 0}))
    run_for(harness, start + 1.5 + reading_time, settings)
    _, second = of_type(harness.reports, Connected)
    assert second.state.parameters[key] == 0
    assert second.occasion is ReadReason.SETTING_CHANGED


def test_changed_safety_parameter_locks_out_motors(harness: SessionHarness) -> None:
    harness.board.eeprom.write("serial_timeout", 50)
    harness.script.at(1.0, Arm()).at(1.1, SetMotor(1, Drive.at(50)))
    schedule_heartbeats(harness, 1.2, 1.4)
    harness.script.at(1.5, silent_change(harness, serial_timeout=0))
    schedule_heartbeats(harness, 1.6, 3.9)
    harness.script.at(4.0, SetMotor(1, Drive.at(60)))
    run_for(harness, 4.5)
    assert of_type(harness.reports, Connected)[-1].state.serial_timeout == 0
    assert DriveMotor(1, Drive.at(60)) not in motor_commands_in(harness.transport.sent)


def test_corrupted_reply_is_no_changed_safety_parameter(harness: SessionHarness) -> None:
    receive = harness.line.read
    corrupted: list[bytes] = []

    def read(size: int, seconds: float) -> bytes:
        reply = receive(size, seconds)
        if harness.line.now > 2.0 and harness.transport.sent[-2:-1] == b"\x9f" and not corrupted:
            corrupted.append(reply)
            return bytes([reply[0] ^ 1])
        return reply

    harness.line.read = read  # type: ignore[method-assign]
    run_for(harness, 4.0)
    assert corrupted
    assert len(of_type(harness.reports, Connected)) == 1


def test_safety_parameters_are_not_read_while_unwatched(harness: SessionHarness) -> None:
    harness.script.at(0.0, SetWatched(False))
    sizes = read_at(harness, 2.0, lambda: len(harness.transport.sent))
    run_for(harness, 5.0)
    sent = commands(harness.transport.sent[sizes[0] :])
    assert sent
    assert not any(isinstance(command, GetParameter) for command in sent)


def test_uart_errors_survive_status_read_of_another_program(
    harness: SessionHarness,
) -> None:
    harness.board.report_error(UartError.TIMEOUT)
    harness.board.serial.pop_status()
    (first, *_) = samples(run_for(harness, 1.0), LatchedStatus)
    assert (first.uart, first.is_earlier) == (UartError.TIMEOUT, True)
