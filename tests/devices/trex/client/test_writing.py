"""Writes of settings and their confirmation by reading back."""

import re
from collections.abc import Callable
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QLocale
from PySide6.QtWidgets import QApplication

from tests.devices.trex.client.corruption import corrupt_packet
from tests.devices.trex.session.helpers import commands, create_harness, fake_requester
from tests.support.catalogs import in_language
from tests.support.matrix import examples
from tests.support.virtual import SessionHarness
from trex_gui.core.errors import BadReply, BadRequest, NoReply
from trex_gui.devices.trex.client.reading import ATTEMPTS, DeviceState, read_everything
from trex_gui.devices.trex.client.write_once import write_calibration, write_parameter
from trex_gui.devices.trex.client.writing import WriteResult, write_all
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.commands import (
    Command,
    GetMode,
    GetParameter,
    GetSignature,
    ReplyT_co,
    SetCalibration,
    SetParameter,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import Rejected, ResultCode, Skipped
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.protocol.line_settings import Detection
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.simulator.firmware import Board

few_examples = examples(40)

SPECS = parameters_of("trex", "1.2")
TIMEOUT = SPECS["serial_timeout"]
FIRST, SECOND = SPECS["motor1_acceleration"], SPECS["motor2_acceleration"]
LEARNED = Calibration(2400, 3700, 5100, 80)


# --- One parameter ----------------------------------------------------------------------


@pytest.mark.parametrize("has_crc", [False, True])
def test_write_is_confirmed_by_two_readings_or_one_with_crc(*, has_crc: bool) -> None:
    harness, settings = create_harness(detection=Detection.CRC7 if has_crc else Detection.NONE)
    write_parameter(harness.client(settings).request, TIMEOUT, 20, has_crc=has_crc)
    polynomial, read = settings.polynomial if has_crc else None, GetParameter(TIMEOUT.number)
    readings = [read] if has_crc else [read, GetMode(), read]
    sent = commands(harness.transport.sent, polynomial)
    assert sent == [SetParameter(TIMEOUT.number, 20), *readings]


def test_read_back_that_differs_each_time_fails_a_write(harness: SessionHarness) -> None:
    with pytest.raises(BadReply, match="replies to 9F 07 differ each time"):
        write_parameter(fake_requester(harness, GetParameter, [20, 21, 20, 21]), TIMEOUT, 20)


def test_invalid_value_is_not_sent(harness: SessionHarness) -> None:
    with pytest.raises(BadRequest, match="Motor Mode"):
        write_parameter(harness.client().request, SPECS["motor_mode"], 2)
    assert harness.transport.sent == b""


def test_factory_reset_is_not_read_back(harness: SessionHarness) -> None:
    assert write_parameter(harness.client().request, SPECS["factory_reset"], 0x7F) == 0x7F
    assert harness.board.eeprom.reset_pending
    reset = SetParameter(0x7F, 0x7F)
    assert commands(harness.transport.sent) == [reset, GetMode(), reset]


def test_rejected_factory_reset_fails(harness: SessionHarness) -> None:
    request = fake_requester(harness, SetParameter, map(ResultCode, [0, 3, 3]))
    with pytest.raises(Rejected):
        write_parameter(request, SPECS["factory_reset"], 0x7F)


def test_unanswered_factory_reset_fails(harness: SessionHarness) -> None:
    harness.line.faults.mute = True
    with pytest.raises(NoReply):
        write_parameter(harness.client().request, SPECS["factory_reset"], 0x7F)


# --- Rejections -------------------------------------------------------------------------


def test_rejection_with_crc_is_not_confirmed_by_a_retry() -> None:
    harness, settings = create_harness(mode="rc", detection=Detection.CRC7)
    client = harness.client(settings)
    with pytest.raises(Rejected):
        write_parameter(client.request, TIMEOUT, 5, has_crc=True)
    assert client.counters.requests == 1


def test_rejection_counts_when_the_board_repeats_it() -> None:
    harness, settings = create_harness(mode="rc")
    with pytest.raises(Rejected, match=r"Serial Timeout: .*\(code 3\)"):
        write_parameter(harness.client(settings).request, TIMEOUT, 5)
    write = SetParameter(TIMEOUT.number, 5)
    assert commands(harness.transport.sent) == [write, GetMode(), write]


@pytest.mark.parametrize(
    ("key", "wire", "codes"),
    [
        ("serial_timeout", 5, [1, 0]),
        ("serial_timeout", 5, [1, 2, 3]),
        ("factory_reset", 0x7F, [1, 0, 0]),
        ("factory_reset", 0x7F, [0, 2, 0, 0]),
    ],
)
def test_corrupted_result_code_does_not_fail_a_write(
    harness: SessionHarness, key: str, wire: int, codes: list[int]
) -> None:
    request = fake_requester(harness, SetParameter, map(ResultCode, codes))
    assert write_parameter(request, SPECS[key], wire) == wire


# --- Corrupted bytes --------------------------------------------------------------------


@pytest.mark.parametrize("lost", [1, 3])
def test_write_without_replies_is_confirmed_by_read_back(
    harness: SessionHarness, lost: int
) -> None:
    harness.line.faults.to_drop = lost
    client = harness.client()
    assert write_parameter(client.request, TIMEOUT, 33) == 33
    assert harness.board.eeprom["serial_timeout"] == 33
    assert client.counters.missing == lost


def test_lost_write_is_resent(harness: SessionHarness) -> None:
    harness.line.faults.to_drop_sent = 5
    assert write_parameter(harness.client().request, TIMEOUT, 33) == 33
    assert harness.board.memory.writes == 1


def test_wrong_read_back_of_value_is_reported_and_stored(harness: SessionHarness) -> None:
    client = harness.client()
    stored: list[WriteResult] = []

    def overwrite(command: Command[ReplyT_co]) -> ReplyT_co:
        reply = client.request(command)
        harness.board.eeprom.write("serial_timeout", 7)
        return reply

    (result,) = write_all(overwrite, SPECS, [(TIMEOUT.key, 15)], on_stored=stored.append)
    assert isinstance(result.error, BadReply)
    assert re.search(r"could not be verified: wrote 1\.5 s.*read back 0\.7 s", str(result.error))
    assert stored == [WriteResult(TIMEOUT.key, 7)]


def test_wrong_read_back_of_calibration_is_reported(harness: SessionHarness) -> None:
    client = harness.client()

    def overwrite(command: Command[ReplyT_co]) -> ReplyT_co:
        reply = client.request(command)
        harness.board.eeprom.write_calibration(InputSource.RC, 2, Calibration(1, 2, 3, 0))
        return reply

    with pytest.raises(BadReply, match="Calibration of channel 2 could not be verified"):
        write_calibration(overwrite, CalibrationKey.RC_CHANNEL_2, LEARNED)


@few_examples
@given(
    seed=st.integers(0, 2**32 - 1),
    noise=st.sampled_from([0.0, 0.02, 0.1, 0.3]),
    drop=st.integers(0, 4),
    lost=st.integers(0, 8),
    wire=st.integers(0, 127),
)
def test_successful_write_with_crc_is_stored(
    *, seed: int, noise: float, drop: int, lost: int, wire: int
) -> None:
    harness, settings = create_harness(detection=Detection.CRC7)
    faults = harness.line.faults
    faults._random.seed(seed)
    faults.noise, faults.to_drop, faults.to_drop_sent = noise, drop, lost
    try:
        assert write_parameter(harness.client(settings).request, TIMEOUT, wire) == wire
    except (NoReply, BadReply, Rejected):
        return
    assert harness.board.eeprom["serial_timeout"] == wire or faults.counters["corrupted"] > 2


# --- Calibrations -----------------------------------------------------------------------


def test_invalid_calibration_is_not_sent(harness: SessionHarness) -> None:
    with pytest.raises(BadRequest, match="minimum 5000 is above neutral"):
        write_calibration(
            harness.client().request, CalibrationKey.RC_CHANNEL_1, Calibration(5000, 3750, 2500, 75)
        )
    assert harness.transport.sent == b""


def test_rejected_input_source_is_named_in_french(qapp: QApplication) -> None:
    board = Board()
    board.eeprom.write("channel_input_source", 1)
    board.power_cycle()
    request = SessionHarness(board).client().request
    with in_language(qapp, QLocale("fr")), pytest.raises(BadReply) as caught:
        write_calibration(request, CalibrationKey.RC_CHANNEL_1, LEARNED)
    assert "is for RC inputs, but the board now reads analogique inputs" in str(caught.value)


# --- Several settings -------------------------------------------------------------------


def written_keys(sent: bytes | bytearray) -> list[str]:
    """Return the keys of the written parameters in order."""
    written = [command for command in commands(sent) if isinstance(command, SetParameter)]
    specs = [SPECS.number(command.number) for command in written]
    return [spec.key for spec in specs if spec is not None]


def test_settings_needing_power_cycle_are_written_last(harness: SessionHarness) -> None:
    changes = [(spec.key, harness.board.eeprom[spec.key]) for spec in SPECS.readable]
    changes.reverse()
    results = write_all(
        harness.client().request, SPECS, changes, [(CalibrationKey.RC_CHANNEL_1, LEARNED)]
    )
    order = written_keys(harness.transport.sent)
    assert order[-4:] == ["motor_mode", "channel_input_source", "crc7_polynomial", "uart_settings"]
    at_once = [SPECS[key] for key in order[:-4]]
    assert not any(spec.needs_power_cycle for spec in at_once)
    sent = commands(harness.transport.sent)
    written = [type(command) for command in sent]
    assert written.index(SetCalibration) < written.index(SetParameter)
    assert [result.error for result in results] == [None] * len(results)


def test_serial_settings_are_written_after_motor_settings(harness: SessionHarness) -> None:
    changes = [("device_number", 9), ("serial_timeout", 1), ("motor1_acceleration", 1)]
    write_all(harness.client().request, SPECS, changes)
    assert written_keys(harness.transport.sent)[0] == "motor1_acceleration"


def test_invalid_values_do_not_block_valid_ones(harness: SessionHarness) -> None:
    results = write_all(
        harness.client().request,
        SPECS,
        [("motor_mode", 9), ("serial_timeout", 5), ("serial_timout", 5)],
        [
            (CalibrationKey.RC_CHANNEL_1, Calibration(9, 5, 1, 0)),
            (CalibrationKey.RC_CHANNEL_2, LEARNED),
        ],
    )
    assert [(result.key, type(result.error)) for result in results] == [
        ("rc_channel_1", BadRequest),
        ("rc_channel_2", type(None)),
        ("serial_timout", BadRequest),  # the first parameter, because it is unknown
        ("serial_timeout", type(None)),
        ("motor_mode", BadRequest),
    ]
    assert "did you mean serial_timeout?" in str(results[2].error)


def test_write_ends_when_board_is_not_in_serial_mode() -> None:
    harness, settings = create_harness(mode="analog")
    changes = [(spec.key, spec.default) for spec in SPECS.readable]
    results = write_all(
        harness.client(settings).request, SPECS, changes, [(CalibrationKey.RC_CHANNEL_1, LEARNED)]
    )
    assert len(results) == len(changes) + 1
    assert all(isinstance(result.error, Rejected) for result in results)
    assert set(commands(harness.transport.sent)) == {GetMode()}


def test_write_ends_when_board_stops_responding(harness: SessionHarness) -> None:
    client = harness.client()
    changes = [(spec.key, spec.default) for spec in SPECS.readable]

    def switch_off(done: int, _total: int, _name: str) -> None:
        if done == 5:
            harness.board.power_off()

    results = write_all(client.request, SPECS, changes, [], switch_off)
    assert [result.error is None for result in results[:5]] == [True] * 5
    assert all(isinstance(result.error, NoReply) for result in results[5:])
    assert len(results) == len(changes)
    assert client.counters.missing <= 6


def test_rejected_value_does_not_end_write(harness: SessionHarness) -> None:
    specs = replace(
        SPECS,
        specs=tuple(
            replace(spec, valid=frozenset(range(128))) if spec.key == "motor_mode" else spec
            for spec in SPECS
        ),
    )
    changes = [("motor_mode", 99), ("uart_settings", 0x0A)]
    first, second = write_all(harness.client().request, specs, changes)
    assert isinstance(first.error, Rejected)
    assert second == WriteResult("uart_settings", 0x0A)


def test_progress_counts_each_write(harness: SessionHarness) -> None:
    steps: list[tuple[int, int, str]] = []
    write_all(
        harness.client().request,
        SPECS,
        [("serial_timeout", 5), ("motor_mode", 1)],
        [(CalibrationKey.RC_CHANNEL_4, LEARNED)],
        lambda *step: steps.append(step),
    )
    assert steps == [
        (0, 3, "calibration of channel 4"),
        (1, 3, "Serial Timeout"),
        (2, 3, "Motor Mode"),
        (3, 3, "done"),
    ]


def test_new_device_number_is_used_despite_lost_reply(harness: SessionHarness) -> None:
    client = harness.client(ConnectionSettings("virtual", device_number=7))
    harness.line.faults.to_drop = 1
    assert write_parameter(client.request, SPECS["device_number"], 42) == 42


@few_examples
@given(
    keys=st.lists(st.sampled_from([*(spec.key for spec in SPECS), "nonsense"]), max_size=12),
    channels=st.lists(st.sampled_from(CHANNELS), max_size=4),
    wire=st.integers(0, 127),
    off_after=st.integers(0, 20),
    mode=st.sampled_from(["serial", "rc"]),
)
def test_each_requested_setting_gets_one_result(
    *, keys: list[str], channels: list[int], wire: int, off_after: int, mode: str
) -> None:
    harness, settings = create_harness(mode=mode)
    client = harness.client(settings)

    def failing(command: Command[ReplyT_co]) -> ReplyT_co:
        if client.counters.requests >= off_after:
            harness.board.power_off()
        return client.request(command)

    parameters = [(key, wire) for key in keys]
    calibrations = [(CalibrationKey.of(InputSource.RC, channel), LEARNED) for channel in channels]
    results = write_all(failing, SPECS, parameters, calibrations)
    expected = [*keys, *(key for key, _ in calibrations)]
    assert sorted(result.key for result in results) == sorted(expected)
    assert all((result.stored is None) is (result.error is not None) for result in results)


# --- Stray writes -----------------------------------------------------------------------


@pytest.mark.parametrize("bit", range(3))
def test_parameter_changed_by_stray_write_is_restored(harness: SessionHarness, bit: int) -> None:
    before = read_everything(harness.client().request)
    corrupted = bytes([0xAF, TIMEOUT.number ^ 1 << bit])
    corrupt_packet(harness, bytes([0xAF, TIMEOUT.number]), corrupted)
    (result,) = write_all(harness.client().request, SPECS, [(TIMEOUT.key, 1)], before=before)
    assert result == WriteResult(TIMEOUT.key, 1)
    assert corrupted in harness.transport.sent
    assert harness.board.memory.stored() == {**before.parameters, TIMEOUT.key: 1}


@pytest.mark.parametrize("command", [b"\xa1", b"\xa2", b"\xa4"])
def test_calibration_changed_by_stray_write_is_restored(
    harness: SessionHarness, command: bytes
) -> None:
    before = read_everything(harness.client().request)
    corrupt_packet(harness, b"\xa0", command)
    (result,) = write_all(
        harness.client().request, SPECS, [], [(CalibrationKey.RC_CHANNEL_1, LEARNED)], before=before
    )
    assert result.error is None
    after = read_everything(harness.client().request)
    assert after.calibrations == {**before.calibrations, 1: LEARNED}


def test_written_setting_changed_by_stray_write_is_restored(harness: SessionHarness) -> None:
    before = read_everything(harness.client().request)
    corrupt_packet(harness, bytes([0xAF, SECOND.number]), bytes([0xAF, FIRST.number]))
    changes = [(FIRST.key, 3), (SECOND.key, 9)]
    results = write_all(harness.client().request, SPECS, changes, before=before)
    assert results == (WriteResult(FIRST.key, 3), WriteResult(SECOND.key, 9))
    assert harness.board.memory.stored() == {**before.parameters, **dict(changes)}


def test_failed_restore_after_stray_write_fails_the_write(harness: SessionHarness) -> None:
    before = read_everything(harness.client().request)
    corrupt_packet(harness, bytes([0xAF, TIMEOUT.number]), bytes([0xAF, 0x06]))
    client = harness.client()

    def request(command: Command[ReplyT_co]) -> ReplyT_co:
        if isinstance(command, SetParameter) and command.number == 0x06:
            harness.board.power_off()
        return client.request(command)

    (result,) = write_all(request, SPECS, [(TIMEOUT.key, 1)], before=before)
    assert "another setting may have been changed" in str(result.error)


def write_two_settings(
    harness: SessionHarness, before: DeviceState, *, action: Callable[[], object]
) -> tuple[WriteResult, ...]:
    """Corrupt the first write into a write of another setting. Call `action` before the second."""
    corrupt_packet(harness, bytes([0xAF, FIRST.number]), bytes([0xAF, TIMEOUT.number]))
    client = harness.client()
    is_done = False

    def request(command: Command[ReplyT_co]) -> ReplyT_co:
        nonlocal is_done
        if command == SetParameter(SECOND.number, 9) and not is_done:
            is_done = True
            action()
        return client.request(command)

    return write_all(request, SPECS, [(FIRST.key, 3), (SECOND.key, 9)], before=before)


def test_stray_write_is_restored_when_apply_is_cancelled(harness: SessionHarness) -> None:
    before = read_everything(harness.client().request)
    corrupt_packet(harness, bytes([0xAF, FIRST.number]), bytes([0xAF, TIMEOUT.number]))
    stored: list[WriteResult] = []
    first, second = write_all(
        harness.client().request,
        SPECS,
        [(FIRST.key, 3), (SECOND.key, 9)],
        before=before,
        cancelled=lambda: bool(stored),
        on_stored=stored.append,
    )
    assert first == WriteResult(FIRST.key, 3)
    assert isinstance(second.error, Skipped)
    assert harness.board.memory.stored() == {**before.parameters, FIRST.key: 3}


def test_stray_write_is_restored_after_board_was_silent(harness: SessionHarness) -> None:
    before = read_everything(harness.client().request)
    write, lost = harness.transport.write, 0

    def lose_requests() -> None:
        def lose(data: bytes) -> None:
            nonlocal lost
            lost += 1
            if lost > 1 + 3 * ATTEMPTS:  # the write, two comparisons, and its read-back
                harness.transport.write = write  # type: ignore[method-assign]
                write(data)

        harness.transport.write = lose  # type: ignore[method-assign]

    first, second = write_two_settings(harness, before, action=lose_requests)
    assert first == WriteResult(FIRST.key, 3)
    assert isinstance(second.error, NoReply)
    assert harness.board.memory.stored() == {**before.parameters, FIRST.key: 3}


def test_stray_write_is_reported_when_board_is_gone(harness: SessionHarness) -> None:
    before = read_everything(harness.client().request)
    first, second = write_two_settings(harness, before, action=harness.board.power_off)
    assert "another setting may have been changed" in str(first.error)
    assert isinstance(second.error, NoReply)


def test_too_many_differences_are_not_restored(harness: SessionHarness) -> None:
    """The settings of another board must not change."""
    before = read_everything(harness.client().request)
    different = {FIRST.key: 3, SECOND.key: 4}

    def exchange() -> None:
        for key, wire in different.items():
            harness.board.eeprom.write(key, wire)
        harness.board.memory.load()

    corrupt_packet(harness, bytes([0xAF, TIMEOUT.number]), bytes([0xAF, 0x7E]), exchange)
    (result,) = write_all(harness.client().request, SPECS, [(TIMEOUT.key, 1)], before=before)
    assert "none was restored: another board may be connected" in str(result.error)
    assert different.items() <= harness.board.memory.stored().items()


def test_undisturbed_write_compares_no_other_settings(harness: SessionHarness) -> None:
    before = read_everything(harness.client().request)
    harness.transport.sent.clear()
    write_all(harness.client().request, SPECS, [(TIMEOUT.key, 1)], before=before)
    sent = commands(harness.transport.sent)
    write = sent.index(SetParameter(TIMEOUT.number, 1))
    read_back = GetParameter(TIMEOUT.number)
    assert sent[write + 1 :] == [
        *(read_back, GetMode(), read_back),
        *(GetSignature(), GetParameter(SPECS["device_number"].number)),
    ]
