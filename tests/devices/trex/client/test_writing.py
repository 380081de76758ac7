"""Writing of settings, which are read back."""

import re
from collections.abc import Callable
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QLocale
from PySide6.QtWidgets import QApplication

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
from trex_gui.devices.trex.protocol.parameters import ParameterSpec, parameters_of
from trex_gui.devices.trex.simulator.firmware import Board

modest = examples(40)


SPECS = parameters_of("trex", "1.2")
TIMEOUT = SPECS["serial_timeout"]
LEARNED = Calibration(2400, 3700, 5100, 80)


# --- One parameter ----------------------------------------------------------------------


@pytest.mark.parametrize("spec", SPECS.readable, ids=lambda spec: spec.key)
def test_every_parameter_accepts_its_limits(spec: ParameterSpec) -> None:
    harness = SessionHarness(Board())
    client = harness.client()
    for wire in (min(spec.valid), max(spec.valid)):
        assert write_parameter(client.request, spec, wire) == wire
        assert harness.board.eeprom[spec.key] == wire


def test_write_is_confirmed_by_two_equal_readings(harness: SessionHarness) -> None:
    write_parameter(harness.client().request, TIMEOUT, 20)
    assert commands(harness.transport.sent) == [
        SetParameter(TIMEOUT.number, 20),
        GetParameter(TIMEOUT.number),
        GetMode(),
        GetParameter(TIMEOUT.number),
    ]


def test_write_with_crc_is_confirmed_by_one_reading() -> None:
    harness, settings = create_harness(detection=Detection.CRC7)
    write_parameter(harness.client(settings).request, TIMEOUT, 20, has_crc=True)
    assert commands(harness.transport.sent, settings.polynomial) == [
        SetParameter(TIMEOUT.number, 20),
        GetParameter(TIMEOUT.number),
    ]


def test_corrupted_read_back_does_not_fail_a_write(harness: SessionHarness) -> None:
    assert write_parameter(fake_requester(harness, GetParameter, [19, 20, 20]), TIMEOUT, 20) == 20
    assert harness.board.memory.writes == 1


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


@pytest.mark.parametrize("codes", [[1, 0, 0], [0, 2, 0, 0]])
def test_corrupted_result_code_does_not_fail_a_factory_reset(
    harness: SessionHarness, codes: list[int]
) -> None:
    request = fake_requester(harness, SetParameter, map(ResultCode, codes))
    assert write_parameter(request, SPECS["factory_reset"], 0x7F) == 0x7F


def test_rejected_factory_reset_is_no_success(harness: SessionHarness) -> None:
    request = fake_requester(harness, SetParameter, map(ResultCode, [0, 3, 3]))
    with pytest.raises(Rejected):
        write_parameter(request, SPECS["factory_reset"], 0x7F)


def test_unanswered_factory_reset_fails(harness: SessionHarness) -> None:
    harness.line.faults.mute = True
    with pytest.raises(NoReply):
        write_parameter(harness.client().request, SPECS["factory_reset"], 0x7F)


# --- Rejections ---------------------------------------------------------------------------


@pytest.mark.parametrize("mode", ["rc", "analog"])
def test_write_outside_serial_mode_explains_what_to_do(mode: str) -> None:
    harness, settings = create_harness(mode=mode)
    with pytest.raises(Rejected) as caught:
        write_parameter(harness.client(settings).request, TIMEOUT, 5)
    assert caught.value.result is ResultCode.NOT_SERIAL_MODE
    for words in ("Serial Timeout", "serial mode", "code 3", "remove the mode jumper"):
        assert words in str(caught.value)


def test_rejected_value_is_reported_with_result_code(harness: SessionHarness) -> None:
    generous = replace(SPECS["motor_mode"], valid=frozenset(range(128)))
    with pytest.raises(Rejected) as caught:
        write_parameter(harness.client().request, generous, 99)
    assert caught.value.result is ResultCode.BAD_VALUE
    assert "Motor Mode: the board rejects this value (code 2)" in str(caught.value)


def test_unknown_parameter_error_mentions_firmware() -> None:
    harness, settings = create_harness(firmware="1.0")
    with pytest.raises(Rejected, match=r"code 1.*firmware") as caught:
        write_parameter(harness.client(settings).request, SPECS["uart_response_delay"], 1)
    assert caught.value.result is ResultCode.BAD_PARAMETER


def test_rejected_write_is_not_retried_with_crc() -> None:
    harness, settings = create_harness(mode="rc", detection=Detection.CRC7)
    client = harness.client(settings)
    with pytest.raises(Rejected):
        write_parameter(client.request, TIMEOUT, 5, has_crc=True)
    assert client.counters.requests == 1


def test_rejection_counts_when_the_board_repeats_it() -> None:
    harness, settings = create_harness(mode="rc")
    with pytest.raises(Rejected):
        write_parameter(harness.client(settings).request, TIMEOUT, 5)
    write = SetParameter(TIMEOUT.number, 5)
    assert commands(harness.transport.sent) == [write, GetMode(), write]


@pytest.mark.parametrize("codes", [[1, 0], [1, 2, 3]])
def test_corrupted_result_code_does_not_fail_a_write(
    harness: SessionHarness, codes: list[int]
) -> None:
    request = fake_requester(harness, SetParameter, map(ResultCode, codes))
    assert write_parameter(request, TIMEOUT, 5) == 5


# --- Corrupted bytes -------------------------------------------------------------------------


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


def test_wrong_read_back_of_value_is_reported_and_known(harness: SessionHarness) -> None:
    client = harness.client()
    known: list[WriteResult] = []

    def forgetful(command: Command[ReplyT_co]) -> ReplyT_co:
        reply = client.request(command)
        harness.board.eeprom.write("serial_timeout", 7)
        return reply

    (result,) = write_all(forgetful, SPECS, [(TIMEOUT.key, 15)], stored=known.append)
    assert isinstance(result.error, BadReply)
    assert re.search(r"could not be verified: wrote 1\.5 s.*reads back 0\.7 s", str(result.error))
    assert known == [WriteResult(TIMEOUT.key, 7)]


def test_wrong_read_back_of_calibration_is_reported(harness: SessionHarness) -> None:
    client = harness.client()

    def forgetful(command: Command[ReplyT_co]) -> ReplyT_co:
        reply = client.request(command)
        harness.board.eeprom.write_calibration(InputSource.RC, 2, Calibration(1, 2, 3, 0))
        return reply

    with pytest.raises(BadReply, match="Calibration of channel 2 could not be verified"):
        write_calibration(forgetful, CalibrationKey.RC_CHANNEL_2, LEARNED)


@modest
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
    harness.line.faults._random.seed(seed)
    harness.line.faults.noise, harness.line.faults.to_drop, harness.line.faults.to_drop_sent = (
        noise,
        drop,
        lost,
    )
    try:
        assert write_parameter(harness.client(settings).request, TIMEOUT, wire) == wire
    except (NoReply, BadReply, Rejected):
        return
    assert (
        harness.board.eeprom["serial_timeout"] == wire
        or harness.line.faults.counters["corrupted"] > 2
    )


# --- Calibrations -----------------------------------------------------------------------


def test_invalid_calibration_is_not_sent(harness: SessionHarness) -> None:
    with pytest.raises(BadRequest, match="minimum 5000 is above neutral"):
        write_calibration(
            harness.client().request, CalibrationKey.RC_CHANNEL_1, Calibration(5000, 3750, 2500, 75)
        )
    assert harness.transport.sent == b""


def test_calibration_write_needs_serial_mode() -> None:
    harness, settings = create_harness(mode="rc")
    with pytest.raises(Rejected, match="Calibration of channel 1"):
        write_calibration(harness.client(settings).request, CalibrationKey.RC_CHANNEL_1, LEARNED)


def test_other_input_source_is_named_in_the_language(qapp: QApplication) -> None:
    board = Board()
    board.eeprom.write("channel_input_source", 1)
    board.power_cycle()
    request = SessionHarness(board).client().request
    with in_language(qapp, QLocale("fr")), pytest.raises(BadReply) as caught:
        write_calibration(request, CalibrationKey.RC_CHANNEL_1, LEARNED)
    assert "is for RC inputs, but the board reads analogique now" in str(caught.value)


# --- Several at once --------------------------------------------------------------------


def written_keys(sent: bytes | bytearray) -> list[str]:
    """Return the keys of the written parameters in order."""
    numbers = [one.number for one in commands(sent) if isinstance(one, SetParameter)]
    specs = [SPECS.number(number) for number in numbers]
    return [spec.key for spec in specs if spec is not None]


def test_settings_needing_power_cycle_are_written_last(harness: SessionHarness) -> None:
    wanted = [(spec.key, harness.board.eeprom[spec.key]) for spec in SPECS.readable]
    wanted.reverse()
    results = write_all(
        harness.client().request, SPECS, wanted, [(CalibrationKey.RC_CHANNEL_1, LEARNED)]
    )
    order = written_keys(harness.transport.sent)
    assert order[-4:] == ["motor_mode", "channel_input_source", "crc7_polynomial", "uart_settings"]
    at_once = [SPECS[key] for key in order[:-4]]
    assert not any(spec.needs_power_cycle for spec in at_once)
    sent = commands(harness.transport.sent)
    writes = [one for one in sent if isinstance(one, (SetCalibration, SetParameter))]
    assert isinstance(writes[0], SetCalibration)
    assert [result.error for result in results] == [None] * len(results)


def test_serial_settings_are_written_after_motor_settings(harness: SessionHarness) -> None:
    wanted = [("device_number", 9), ("serial_timeout", 1), ("motor1_acceleration", 1)]
    write_all(harness.client().request, SPECS, wanted)
    assert written_keys(harness.transport.sent)[0] == "motor1_acceleration"


def test_unknown_setting_is_reported_first(harness: SessionHarness) -> None:
    wanted = [("motor1_acceleration", 1), ("serial_timeout", 1), ("colour", 1)]
    results = write_all(harness.client().request, SPECS, wanted)
    assert [result.key for result in results if result.error] == ["colour"]
    assert results[0].key == "colour"


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
    errors = {result.key: type(result.error) for result in results}
    assert errors == {
        "rc_channel_1": BadRequest,
        "rc_channel_2": type(None),
        "motor_mode": BadRequest,
        "serial_timeout": type(None),
        "serial_timout": BadRequest,
    }
    (misspelt,) = [one.error for one in results if one.key == "serial_timout"]
    assert "did you mean serial_timeout?" in str(misspelt)


def test_write_ends_when_board_is_not_in_serial_mode() -> None:
    harness, settings = create_harness(mode="analog")
    wanted = [(spec.key, spec.default) for spec in SPECS.readable]
    results = write_all(
        harness.client(settings).request, SPECS, wanted, [(CalibrationKey.RC_CHANNEL_1, LEARNED)]
    )
    assert len(results) == len(wanted) + 1
    assert all(isinstance(result.error, Rejected) for result in results)
    assert set(commands(harness.transport.sent)) == {GetMode()}


def test_write_ends_when_board_stops_responding(harness: SessionHarness) -> None:
    client = harness.client()
    wanted = [(spec.key, spec.default) for spec in SPECS.readable]

    def switch_off(done: int, _total: int, _what: str) -> None:
        if done == 5:
            harness.board.power_off()

    results = write_all(client.request, SPECS, wanted, [], switch_off)
    assert [result.error is None for result in results[:5]] == [True] * 5
    assert all(isinstance(result.error, NoReply) for result in results[5:])
    assert len(results) == len(wanted)
    assert client.counters.missing <= 6


def test_rejected_value_does_not_end_write(harness: SessionHarness) -> None:
    specs = replace(
        SPECS,
        specs=tuple(
            replace(spec, valid=frozenset(range(128))) if spec.key == "motor_mode" else spec
            for spec in SPECS
        ),
    )
    wanted = [("motor_mode", 99), ("uart_settings", 0x0A)]
    first, second = write_all(harness.client().request, specs, wanted)
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


@modest
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


# --- Stray writes --------------------------------------


@pytest.mark.parametrize("bit", range(3))
def test_parameter_changed_by_stray_write_is_restored(harness: SessionHarness, bit: int) -> None:
    before = read_everything(harness.client().request)
    hit = bytes([0xAF, TIMEOUT.number ^ 1 << bit])
    divert(harness, bytes([0xAF, TIMEOUT.number]), hit)
    (result,) = write_all(harness.client().request, SPECS, [(TIMEOUT.key, 1)], before=before)
    assert result == WriteResult(TIMEOUT.key, 1)
    assert hit in harness.transport.sent
    assert harness.board.memory.stored() == {**before.parameters, TIMEOUT.key: 1}


@pytest.mark.parametrize("hit", [0xA1, 0xA2, 0xA4])
def test_calibration_changed_by_stray_write_is_restored(harness: SessionHarness, hit: int) -> None:
    before = read_everything(harness.client().request)
    divert(harness, b"\xa0", bytes([hit]))
    (result,) = write_all(
        harness.client().request, SPECS, [], [(CalibrationKey.RC_CHANNEL_1, LEARNED)], before=before
    )
    assert result.error is None
    after = read_everything(harness.client().request)
    assert after.calibrations == {**before.calibrations, 1: LEARNED}


def test_written_setting_changed_by_stray_write_is_restored(harness: SessionHarness) -> None:
    before = read_everything(harness.client().request)
    first, second = SPECS["motor1_acceleration"], SPECS["motor2_acceleration"]
    divert(harness, bytes([0xAF, second.number]), bytes([0xAF, first.number]))
    wanted = [(first.key, 3), (second.key, 9)]
    results = write_all(harness.client().request, SPECS, wanted, before=before)
    assert results == (WriteResult(first.key, 3), WriteResult(second.key, 9))
    assert harness.board.memory.stored() == {**before.parameters, **dict(wanted)}


def test_failed_restore_after_stray_write_fails_the_write(harness: SessionHarness) -> None:
    before = read_everything(harness.client().request)
    divert(harness, bytes([0xAF, TIMEOUT.number]), bytes([0xAF, 0x06]))
    client = harness.client()

    def request(command: Command[ReplyT_co]) -> ReplyT_co:
        if isinstance(command, SetParameter) and command.number == 0x06:
            harness.board.power_off()
        return client.request(command)

    (result,) = write_all(request, SPECS, [(TIMEOUT.key, 1)], before=before)
    assert "another setting may have been changed" in str(result.error)


FIRST, SECOND = SPECS["motor1_acceleration"], SPECS["motor2_acceleration"]


def write_two_and_corrupt_one(
    harness: SessionHarness, before: DeviceState, *, ends: Callable[[], object]
) -> tuple[WriteResult, ...]:
    """Turn the first write into a write of another setting. Call `ends` before the second."""
    divert(harness, bytes([0xAF, FIRST.number]), bytes([0xAF, TIMEOUT.number]))
    client = harness.client()
    has_ended = False

    def request(command: Command[ReplyT_co]) -> ReplyT_co:
        nonlocal has_ended
        if command == SetParameter(SECOND.number, 9) and not has_ended:
            has_ended = True
            ends()
        return client.request(command)

    return write_all(request, SPECS, [(FIRST.key, 3), (SECOND.key, 9)], before=before)


def test_stray_write_is_restored_when_apply_is_cancelled(harness: SessionHarness) -> None:
    before = read_everything(harness.client().request)
    divert(harness, bytes([0xAF, FIRST.number]), bytes([0xAF, TIMEOUT.number]))
    known: list[WriteResult] = []
    first, second = write_all(
        harness.client().request,
        SPECS,
        [(FIRST.key, 3), (SECOND.key, 9)],
        before=before,
        cancelled=lambda: bool(known),
        stored=known.append,
    )
    assert first == WriteResult(FIRST.key, 3)
    assert isinstance(second.error, Skipped)
    assert harness.board.memory.stored() == {**before.parameters, FIRST.key: 3}


def test_stray_write_is_restored_after_board_was_silent(harness: SessionHarness) -> None:
    before = read_everything(harness.client().request)
    write, swallowed = harness.transport.write, 0

    def lose_replies() -> None:
        def swallow(data: bytes) -> None:
            nonlocal swallowed
            swallowed += 1
            if swallowed > 1 + 3 * ATTEMPTS:  # the write, two comparisons, and its read-back
                harness.transport.write = write  # type: ignore[method-assign]
                write(data)

        harness.transport.write = swallow  # type: ignore[method-assign]

    first, second = write_two_and_corrupt_one(harness, before, ends=lose_replies)
    assert first == WriteResult(FIRST.key, 3)
    assert isinstance(second.error, NoReply)
    assert harness.board.memory.stored() == {**before.parameters, FIRST.key: 3}


def test_stray_write_is_reported_when_board_is_gone(harness: SessionHarness) -> None:
    before = read_everything(harness.client().request)
    first, second = write_two_and_corrupt_one(harness, before, ends=harness.board.power_off)
    assert "another setting may have been changed" in str(first.error)
    assert isinstance(second.error, NoReply)


def test_too_many_differences_are_not_restored(harness: SessionHarness) -> None:
    """Another board may be connected, whose settings must not change."""
    before = read_everything(harness.client().request)
    others = {"motor1_acceleration": 3, "motor2_acceleration": 4}

    def exchange() -> None:
        for key, wire in others.items():
            harness.board.eeprom.write(key, wire)
        harness.board.memory.load()

    divert(harness, bytes([0xAF, TIMEOUT.number]), bytes([0xAF, 0x7E]), exchange)
    (result,) = write_all(harness.client().request, SPECS, [(TIMEOUT.key, 1)], before=before)
    assert "none was restored: another board may be connected" in str(result.error)
    assert others.items() <= harness.board.memory.stored().items()


def test_write_without_repeats_reads_nothing_else(harness: SessionHarness) -> None:
    before = read_everything(harness.client().request)
    harness.transport.sent.clear()
    write_all(harness.client().request, SPECS, [(TIMEOUT.key, 1)], before=before)
    sent = commands(harness.transport.sent)
    write = sent.index(SetParameter(TIMEOUT.number, 1))
    verified = GetParameter(TIMEOUT.number)
    assert sent[write + 1 :] == [
        *(verified, GetMode(), verified),
        *(GetSignature(), GetParameter(SPECS["device_number"].number)),
    ]


def divert(
    harness: SessionHarness, head: bytes, hit: bytes, after: Callable[[], None] = lambda: None
) -> None:
    """Turn the first packet that starts with `head` into a packet that starts with `hit`."""
    write, pending = harness.transport.write, [head]

    def corrupt(data: bytes) -> None:
        if pending and data.startswith(head):
            write(hit + data[len(pending.pop()) :])
            after()
        else:
            write(data)

    harness.transport.write = corrupt  # type: ignore[method-assign]
