"""Wire: timing, host settings, faults and cable."""

import pytest

from tests.support.aracna import BOOT, AracnaHarness
from trex_gui.core.transport.settings import Parity, SerialFormat
from trex_gui.devices.aracna.simulator.firmware import PARSING

VERSION = b".q1,8\r\n"
GOALS = b".c512,512,512,512,512,512,512,512\n"


def test_query_takes_about_three_milliseconds(harness: AracnaHarness) -> None:
    start = harness.now
    harness.line.send(b".q\n")
    assert harness.line.read(7, 1) == VERSION
    assert (harness.now - start) * 1000 == pytest.approx(2.6, abs=0.1)


def test_unpaced_bytes_take_no_time_but_servos_and_boot_do() -> None:
    harness = AracnaHarness(paced=False)
    start = harness.now
    harness.line.send(b".q\n")
    assert harness.line.read(7, 1) == VERSION
    assert harness.now == pytest.approx(start + PARSING)
    harness.line.send(b".v100,100,100,100,100,100,100,100\n.c740,512,512,512,512,512,512,512\n")
    assert harness.line.read(35, 1).startswith(b".v100,")
    harness.do("reset")
    harness.line.send(b".q\n")
    assert harness.line.read(11, 2) == b".h\r\n" + VERSION
    assert harness.now - start == pytest.approx(1.0366, abs=0.001)


@pytest.mark.parametrize("baud", [300, 19200, 115200])
@pytest.mark.parametrize("paced", [True, False])
def test_host_at_other_baud_rate_gets_no_valid_reply(baud: int, paced: bool) -> None:
    harness = AracnaHarness(paced=paced)
    harness.line.host = SerialFormat(baud)
    assert VERSION not in harness.request(b".q\n")
    harness.do("reset")
    assert harness.request(b"") != b".h\r\n"
    harness.line.host = None
    harness.do("reset")
    harness.line.advance(BOOT)
    harness.line.receive()
    assert harness.request(b".q\n") == VERSION


@pytest.mark.parametrize(
    ("parity", "stop_bits", "is_valid"),
    [(Parity.EVEN, 1, False), (Parity.ODD, 1, False), (Parity.NONE, 2, True)],
)
def test_host_needs_no_parity_and_may_send_second_stop_bit(
    harness: AracnaHarness, parity: Parity, stop_bits: int, is_valid: bool
) -> None:
    harness.line.host = SerialFormat(38400, parity, stop_bits)
    assert (VERSION in harness.request(b".q\n" * 3)) is is_valid


def test_board_receives_garbage_from_host_at_other_baud_rate(harness: AracnaHarness) -> None:
    harness.line.host = SerialFormat(9600)
    harness.request(b".l1\n" * 4)
    assert harness.line.station.firmware.led is False
    assert harness.line.faults.counters["garbled"] > 4


def test_replugged_cable_passes_rest_of_reply(harness: AracnaHarness) -> None:
    harness.line.send(b".q\n")
    harness.line.read(2, 1)
    harness.do("line unplug")
    harness.line.advance(0.0004)
    harness.do("line plug")
    assert harness.request(b"", 1) == VERSION[4:]


# --- Cut replies --------------------------------------------------------------------------


@pytest.mark.parametrize("delivered", [0, 1, 6, 7])
def test_cut_reply_ends_early_and_next_reply_is_complete(
    harness: AracnaHarness, delivered: int
) -> None:
    harness.do(f"line cut {delivered}")
    reply = harness.request(GOALS)
    assert reply == b".c512,512,"[:delivered]
    assert harness.request(b".q\n") == VERSION
    assert harness.line.faults.counters["dropped"] == 35 - delivered


def test_cut_applies_to_next_reply_until_it_is_cancelled(harness: AracnaHarness) -> None:
    harness.do("line cut 9")
    assert harness.request(b".q\n") == VERSION
    assert harness.request(b".q\n") == VERSION[:2]
    harness.do("line cut 2", "line cut off")
    assert harness.request(b".q\n") == VERSION
