"""Receiver at the sender's rate and at other rates."""

from itertools import pairwise, permutations

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.core.simulator.sampling import ReceiveError, Receiver, SampledByte, levels
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates

PLAIN = LineSettings()
few_examples = examples(40)
settings = st.builds(
    LineSettings, st.sampled_from(baud_rates()), st.sampled_from(Detection), st.sampled_from((1, 2))
)


def receive_all(
    receiver: Receiver, data: bytes, sender: LineSettings, gap: float = 0.0, at: float = 0.0
) -> list[SampledByte]:
    """Send bytes with gaps in units of the time of a byte. Return the received bytes."""
    result: list[SampledByte] = []
    for byte in data:
        result += receiver.receive(at, byte, sender, sender.baud)
        at += sender.seconds(1) * (1 + gap)
    result += receiver.idle(at + 1)
    return result


def decoded(sender: LineSettings, own: LineSettings, data: bytes) -> list[tuple[int, str | None]]:
    """Return value and error of each byte that a receiver with its own settings decodes."""
    receiver = Receiver(own, own.baud)
    return [
        (each.value, each.error.name if each.error else None)
        for each in receive_all(receiver, data, sender)
    ]


@pytest.mark.parametrize(
    ("line", "bits"),
    [
        (LineSettings(), "0 1000 0011 1"),
        (LineSettings(stop_bits=2), "0 1000 0011 11"),
        (LineSettings(detection=Detection.CRC7), "0 1000 0011 1"),
        (LineSettings(detection=Detection.EVEN), "0 1000 0011 1 1"),
        (LineSettings(detection=Detection.ODD), "0 1000 0011 0 1"),
        (LineSettings(detection=Detection.ODD, stop_bits=2), "0 1000 0011 0 11"),
    ],
)
def test_byte_has_start_data_parity_and_stop_bits(line: LineSettings, bits: str) -> None:
    assert levels(0xC1, line) == [int(bit) for bit in bits if bit != " "]


@few_examples
@given(
    line=settings,
    data=st.binary(max_size=20),
    rate_error=st.one_of(st.just(0.0), st.floats(-0.03, 0.03)),
    gap=st.sampled_from([0.0, 0.05, 3.0]),
)
def test_receiver_decodes_bytes_at_three_percent_rate_error(
    line: LineSettings, data: bytes, rate_error: float, gap: float
) -> None:
    sender = LineSettings(round(line.baud * (1 + rate_error)), line.detection, line.stop_bits)
    received = receive_all(Receiver(line, line.baud), data, sender, gap)
    assert bytes(each.value for each in received) == data
    assert all(each.error is None for each in received)


@few_examples
@given(data=st.binary(min_size=1, max_size=20), line=settings)
def test_byte_is_complete_just_after_middle_of_stop_bit(data: bytes, line: LineSettings) -> None:
    bit = 1 / line.baud
    first_stop = line.bits_per_byte - line.stop_bits
    for index, each in enumerate(receive_all(Receiver(line, line.baud), data, line)):
        begin = index * line.seconds(1)
        assert each.at == pytest.approx(begin + (first_stop + 0.55) * bit)


@pytest.mark.parametrize(
    ("sender", "own", "data", "result"),
    [
        # At half the rate, each bit is received twice, including the start bit.
        (9600, 19200, "FF", [(0xFE, None)]),
        (9600, 19200, "00", [(0x00, "FRAMING")]),
        (4800, 19200, "FF", [(0xF8, None)]),
        (14400, 115200, "FF", [(0x80, None)]),
        (1200, 115200, "FF", [(0x00, "FRAMING")]),
        # At one and a half times the rate, a third of the bits is not received.
        (28800, 19200, "81", [(0xF0, None)]),
        (28800, 19200, "81 48", [(0x30, None), (0xFD, None)]),
        # At six times the rate, the byte ends before the first received data bit.
        (115200, 19200, "00", [(0xFF, None)]),
    ],
)
def test_byte_at_another_rate_is_decoded_differently(
    sender: int, own: int, data: str, result: list[tuple[int, str | None]]
) -> None:
    received = decoded(LineSettings(sender), LineSettings(own), bytes.fromhex(data))
    assert received == result


def test_too_short_start_bit_is_ignored() -> None:
    assert decoded(LineSettings(115200), LineSettings(9600), b"\xff\xff") == []


def test_break_is_one_framing_error() -> None:
    for slow, fast in permutations(baud_rates(), 2):
        if fast > 2 * slow:
            received = decoded(LineSettings(slow), LineSettings(fast), b"\x00")
            assert received == [(0x00, "FRAMING")]


@pytest.mark.parametrize(
    ("sender", "own"), [(Detection.EVEN, Detection.ODD), (Detection.ODD, Detection.EVEN)]
)
def test_opposite_parity_is_detected_in_every_byte(sender: Detection, own: Detection) -> None:
    data = bytes(range(256))
    received = receive_all(
        Receiver(LineSettings(detection=own), 19200), data, LineSettings(detection=sender)
    )
    assert bytes(each.value for each in received) == data
    assert {each.error for each in received} == {ReceiveError.PARITY}


def test_receiver_does_not_wait_for_second_stop_bit() -> None:
    own = LineSettings(stop_bits=2)
    assert decoded(PLAIN, own, bytes(range(256))) == [(value, None) for value in range(256)]


@few_examples
@given(sender=settings, own=settings, data=st.binary(max_size=20), gap=st.floats(0, 3))
def test_received_bytes_are_valid_and_spaced_in_time(
    sender: LineSettings, own: LineSettings, data: bytes, gap: float
) -> None:
    receiver = Receiver(own, own.baud)
    received = receive_all(receiver, data, sender, gap)
    assert receiver.due is None
    assert all(0 <= each.value <= 255 for each in received)
    assert all(each.error in {None, ReceiveError.FRAMING, ReceiveError.PARITY} for each in received)
    length = 9.4 / own.baud  # all bits of a byte, except half of the stop bit
    assert all(after.at - before.at > length for before, after in pairwise(received))


@few_examples
@given(sender=settings, own=settings, byte=st.integers(0, 255))
def test_due_time_of_incomplete_byte_is_correct(
    sender: LineSettings, own: LineSettings, byte: int
) -> None:
    receiver = Receiver(own, own.baud)
    early = list(receiver.receive(0.0, byte, sender, sender.baud))
    due = receiver.due
    if due is None:
        assert list(receiver.idle(10.0)) == []
    else:
        assert list(receiver.idle(due - 1e-9)) == []
        last = list(receiver.idle(due + 1e-9))
        assert [each.at for each in last] in ([], [pytest.approx(due)])  # []: no start bit
        assert receiver.due is None
    assert all(each.at < receiver.known_until for each in early)


def samples_an_edge(sender: LineSettings, own: LineSettings) -> bool:
    """True if a sampling time is exactly between two bits of the sender."""
    return any((2 * bit + 1) * sender.baud % (2 * own.baud) == 0 for bit in range(12))


@few_examples
@given(sender=settings, own=settings, data=st.binary(max_size=6))
def test_isolated_byte_is_decoded_as_by_a_new_receiver(
    sender: LineSettings, own: LineSettings, data: bytes
) -> None:
    assume(not samples_an_edge(sender, own))
    receiver = Receiver(own, own.baud)
    for byte in data * 2:
        alone = receiver.receive_isolated(byte, sender, sender.baud)
        fresh = Receiver(own, own.baud).receive_isolated(byte, sender, sender.baud)
        assert [(each.value, each.error) for each in alone] == [
            (each.value, each.error) for each in fresh
        ]
        assert receiver.due is None


@few_examples
@given(
    data=st.binary(min_size=1, max_size=8),
    rates=st.sampled_from(list(permutations(baud_rates(), 2))),
    begin=st.floats(0, 1000),
)
def test_decoding_does_not_depend_on_send_time(
    data: bytes, rates: tuple[int, int], begin: float
) -> None:
    def sent_at(at: float) -> list[tuple[int, ReceiveError | None]]:
        sender, own = LineSettings(rates[0]), LineSettings(rates[1])
        received = receive_all(Receiver(own, own.baud), data, sender, at=at)
        return [(each.value, each.error) for each in received]

    assert sent_at(begin) == sent_at(0)
