"""Reading of everything that a board stores."""

from collections.abc import Callable

import pytest

from tests.devices.trex.client.corruption import corrupt_packet
from tests.devices.trex.session.helpers import commands, create_harness, fake_requester
from tests.support.virtual import SessionHarness
from trex_gui.core.errors import BadReply, NoReply, PortUnavailable
from trex_gui.devices.trex.client.client import Requester
from trex_gui.devices.trex.client.reading import DeviceState, query, read_everything, read_reliably
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.commands import Command, GetMode, GetParameter, ReplyT_co
from trex_gui.devices.trex.protocol.errors import readings_differ
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.protocol.line_settings import Detection
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.simulator.firmware import Board

_GET_TIMEOUT = GetParameter(0x07)


@pytest.mark.parametrize(
    ("model", "firmware"), [("trex", "1.0"), ("trex", "1.2"), ("trexjr", "1.0"), ("trexjr", "1.2")]
)
@pytest.mark.parametrize("mode", ["serial", "rc", "analog"])
def test_every_board_is_read_completely(model: str, firmware: str, mode: str) -> None:
    harness, settings = create_harness(model=model, firmware=firmware, mode=mode)
    state = read_everything(harness.client(settings).request)
    board = harness.board
    assert state.signature.model.key == model
    assert state.signature.firmware == firmware
    assert state.mode is board.mode
    assert state.serial_controls is (mode == "serial")
    assert state.parameters == board.memory.stored()
    assert set(state.parameters) == {spec.key for spec in state.specs.readable}
    assert state.unread == {}
    assert state.calibrations == {channel: board.calibration(channel) for channel in CHANNELS}
    assert state.source is board.mode.source


@pytest.mark.parametrize("reply", [b"", b"\xff"])
def test_unknown_parameter_is_omitted_after_any_reply(
    harness: SessionHarness, reply: bytes
) -> None:
    """A board may lack a parameter of its firmware. The qik 2s12v10 replies FF."""
    board = harness.board
    board.unknown_reply, board.memory.parameters = reply, parameters_of("trex", "1.1")
    state = read_everything(harness.client().request)
    assert set(state.unread) == {"uart_response_delay"}
    assert state.parameters == board.memory.stored()


def test_learned_channels_are_reported(harness: SessionHarness) -> None:
    learned = Calibration(2400, 3750, 5000, 75)
    harness.board.eeprom.write_calibration(InputSource.RC, 3, learned)
    state = read_everything(harness.client().request)
    assert state.calibrated == 0b00100
    assert state.calibrations[3] == learned


def test_progress_increases_to_total(harness: SessionHarness) -> None:
    steps: list[tuple[int, int, str]] = []
    read_everything(harness.client().request, lambda *step: steps.append(step))
    done = [step[0] for step in steps]
    assert done == sorted(set(done))
    assert steps[-1][0] == steps[-1][1]
    assert {total for _, total, _ in steps[1:]} == {steps[-1][1]}
    assert "Serial Timeout" in [name for _, _, name in steps]


def test_lost_reply_costs_one_retry(harness: SessionHarness) -> None:
    harness.line.faults.to_drop = 1
    client = harness.client()
    state = read_everything(client.request)
    assert state.parameters == harness.board.memory.stored()
    assert client.counters.missing == 1


@pytest.mark.parametrize(
    ("readings", "value"), [([5, 5], 5), ([9, 5, 5], 5), ([5, 9, 5, 5], 5), ([9, 8, 5, 5], 5)]
)
def test_value_counts_when_two_readings_in_a_row_agree(
    harness: SessionHarness, readings: list[int], value: int
) -> None:
    request = fake_requester(harness, GetParameter, readings)
    assert read_reliably(request, _GET_TIMEOUT) == value


def test_readings_that_never_agree_are_an_error(harness: SessionHarness) -> None:
    request = fake_requester(harness, GetParameter, [5, 9, 5, 9, 9])
    with pytest.raises(BadReply, match="replies to 9F 07 differ each time") as caught:
        read_reliably(request, _GET_TIMEOUT)
    assert readings_differ(caught.value)


def test_one_reading_suffices_with_crc() -> None:
    harness, settings = create_harness(detection=Detection.CRC7)
    client = harness.client(settings)
    state = read_everything(client.request, has_crc=True)
    assert client.counters.requests == 4 + len(state.specs.readable) + len(CHANNELS)


def test_corrupted_reply_is_read_again() -> None:
    """Each run corrupts one reply: one of the first eight, every fifth later, or the last."""
    undisturbed = SessionHarness(Board())
    stored = read_everything(undisturbed.client().request)
    count = len(commands(undisturbed.transport.sent))

    def read_with_corrupted_reply(number: int) -> DeviceState:
        harness = SessionHarness(Board())
        client = harness.client()

        def corrupt(command: Command[ReplyT_co]) -> ReplyT_co:
            harness.line.faults.to_corrupt = int(client.counters.requests == number)
            return client.request(command)

        state = read_everything(corrupt)
        assert harness.line.faults.counters["corrupted"] == 1
        return state

    for number in (*range(8), *range(8, count, 5), count - 1):
        assert read_with_corrupted_reply(number) == stored, number


@pytest.mark.parametrize(
    "read", [read_everything, lambda request: read_reliably(request, _GET_TIMEOUT)]
)
def test_request_corrupted_into_other_request_changes_no_value(
    harness: SessionHarness, read: Callable[[Requester], DeviceState | int]
) -> None:
    """9F 07 becomes 8F, which requests both currents. The second byte looks like the next reply."""
    harness.board.eeprom.write("serial_timeout", 5)
    corrupt_packet(harness, b"\x9f\x07", b"\x8f\x07")
    result = read(harness.client().request)
    assert b"\x8f\x07" in harness.transport.sent
    assert (result if isinstance(result, int) else result.parameters["serial_timeout"]) == 5


def test_unreadable_parameter_does_not_block_remaining_ones(harness: SessionHarness) -> None:
    client = harness.client()

    def mute_timeout(command: Command[ReplyT_co]) -> ReplyT_co:
        harness.line.faults.mute = command == GetParameter(0x07)
        return client.request(command)

    state = read_everything(mute_timeout)
    assert set(state.unread) == {"serial_timeout"}
    assert "No reply to 9F 07" in state.unread["serial_timeout"]
    assert "serial_timeout" not in state.parameters
    assert len(state.parameters) == len(state.specs.readable) - 1


def test_power_loss_while_reading_raises_no_reply(harness: SessionHarness) -> None:
    def switch_off(done: int, _total: int, _name: str) -> None:
        if done == 10:
            harness.board.power_off()

    with pytest.raises(NoReply):
        read_everything(harness.client().request, switch_off)


def test_request_without_reply_is_sent_three_times(harness: SessionHarness) -> None:
    harness.board.power_off()
    client = harness.client()
    with pytest.raises(NoReply):
        query(client.request, GetMode())
    assert client.counters.requests == 3


def test_request_on_lost_port_is_not_retried(harness: SessionHarness) -> None:
    client = harness.client()
    harness.transport.fail = PortUnavailable("gone")
    with pytest.raises(PortUnavailable):
        query(client.request, GetMode())
    assert client.counters.requests == 1
