"""Wire: timing, host settings, faults and cable."""

import pytest

from tests.support.aracna import BOOT, AracnaStage
from trex_gui.core.transport.settings import Parity, SerialFormat
from trex_gui.devices.aracna.simulator.firmware import PARSING

VERSION = b".q1,8\r\n"
GOALS = b".c512,512,512,512,512,512,512,512\n"


def test_query_takes_about_three_milliseconds(stage: AracnaStage) -> None:
    begun = stage.now
    stage.line.send(b".q\n")
    assert stage.line.read(7, 1) == VERSION
    assert (stage.now - begun) * 1000 == pytest.approx(2.6, abs=0.1)


def test_unpaced_bytes_take_no_time_but_servos_and_boot_do() -> None:
    stage = AracnaStage(paced=False)
    begun = stage.now
    stage.line.send(b".q\n")
    assert stage.line.read(7, 1) == VERSION
    assert stage.now == pytest.approx(begun + PARSING)
    stage.line.send(b".v100,100,100,100,100,100,100,100\n.c740,512,512,512,512,512,512,512\n")
    assert stage.line.read(35, 1).startswith(b".v100,")
    stage.do("reset")
    stage.line.send(b".q\n")
    assert stage.line.read(11, 2) == b".h\r\n" + VERSION
    assert stage.now - begun == pytest.approx(1.0366, abs=0.001)


@pytest.mark.parametrize("baud", [300, 19200, 115200])
@pytest.mark.parametrize("paced", [True, False])
def test_host_at_other_baud_rate_gets_no_valid_reply(baud: int, paced: bool) -> None:
    stage = AracnaStage(paced=paced)
    stage.line.host = SerialFormat(baud)
    assert VERSION not in stage.request(b".q\n")
    stage.do("reset")
    assert stage.request(b"") != b".h\r\n"
    stage.line.host = None
    stage.do("reset")
    stage.line.advance(BOOT)
    stage.line.receive()
    assert stage.request(b".q\n") == VERSION


def test_board_receives_garbage_from_host_at_other_baud_rate(stage: AracnaStage) -> None:
    stage.line.host = SerialFormat(9600)
    stage.request(b".l1\n" * 4)
    assert stage.line.station.firmware.led is False
    assert stage.line.faults.counters["garbled"] > 4


@pytest.mark.parametrize("detection", [Parity.EVEN, Parity.ODD])
def test_host_with_parity_gets_no_valid_reply(stage: AracnaStage, detection: Parity) -> None:
    stage.line.host = SerialFormat(38400, detection)
    assert VERSION not in stage.request(b".q\n" * 3)


def test_second_stop_bit_is_accepted(stage: AracnaStage) -> None:
    stage.line.host = SerialFormat(38400, stop_bits=2)
    assert stage.request(b".q\n") == VERSION


def test_replugged_cable_passes_rest_of_reply(stage: AracnaStage) -> None:
    stage.line.send(b".q\n")
    stage.line.read(2, 1)
    stage.do("line unplug")
    stage.line.advance(0.0004)
    stage.do("line plug")
    assert stage.request(b"", 1) == VERSION[4:]


def test_drop_unsent_discards_queued_bytes(stage: AracnaStage) -> None:
    stage.line.send(b".l1\n" * 10)
    assert stage.line.backlog == pytest.approx(40 * stage.line.byte_time)
    stage.line.advance(2.5 * stage.line.byte_time)
    stage.line.drop_unsent()
    assert stage.line.backlog == 0
    assert stage.request(b"") == b""
    assert stage.request(b"\n.q\n").endswith(VERSION)


# --- Cut replies --------------------------------------------------------------------------


@pytest.mark.parametrize("passing", [0, 1, 6, 7])
def test_cut_reply_ends_early_and_next_reply_is_complete(stage: AracnaStage, passing: int) -> None:
    stage.do(f"line cut {passing}")
    answer = stage.request(GOALS)
    assert answer == b".c512,512,"[:passing]
    assert stage.request(b".q\n") == VERSION
    assert stage.line.faults.counters["dropped"] == 35 - passing


def test_cut_applies_to_next_reply_until_it_is_cancelled(stage: AracnaStage) -> None:
    stage.do("line cut 9")
    assert stage.request(b".q\n") == VERSION
    assert stage.request(b".q\n") == VERSION[:2]
    stage.do("line cut 2", "line cut off")
    assert stage.request(b".q\n") == VERSION
