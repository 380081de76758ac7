"""Rows of the traffic model and their texts."""

from functools import partial
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.core.transport.traffic import TrafficDirection, TrafficEvent
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.session.traffic_decoder import TrexDecoder
from trex_gui.ui.files import write_in_background
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.traffic.model import MAX_ROWS, TrafficModel
from trex_gui.ui.traffic.table import TrafficTable
from trex_gui.ui.workers.session_thread import SessionThread

POLL, REPLY = b"\x8f", b"\x02\x00"
WRITE, STORED = b"\xaf\x07\x0f\x55\x2a", b"\x00"


class TrafficHarness:
    """Traffic model. The test writes its log."""

    def __init__(self) -> None:
        self.line = SessionThread()
        self.decoder = TrexDecoder()
        self.traffic = TrafficModel(self.line, self.decoder)
        self._now = 0.0

    def log(self, sent: bytes, received: bytes = b"") -> None:
        self._now += 0.01
        self.line.log.record(TrafficEvent(self._now, TrafficDirection.SENT, sent))
        if received:
            self.line.log.record(
                TrafficEvent(self._now + 0.005, TrafficDirection.RECEIVED, received)
            )

    @property
    def texts(self) -> list[str]:
        self.traffic.pull()
        return [self.traffic.decoder.decoded(row).text for row in self.traffic.without_polling.rows]


@pytest.fixture
def harness(qtbot: QtBot) -> TrafficHarness:
    del qtbot
    return TrafficHarness()


def test_polls_are_hidden_and_decoded_only_when_shown(harness: TrafficHarness) -> None:
    harness.log(POLL, REPLY)
    harness.log(WRITE, STORED)
    harness.log(POLL, REPLY)
    assert harness.texts == ["set Serial Timeout to 1.5 s (15) → stored"]
    assert harness.traffic.everything.count == 3
    assert harness.traffic.faults == 0
    polls = [row for row in harness.traffic.everything.rows if row.sent == POLL]
    assert [row.cached_meaning for row in polls] == [None] * 2


def test_typed_poll_is_shown_once(harness: TrafficHarness) -> None:
    harness.traffic.expect_typed(POLL)
    for _ in range(3):
        harness.log(POLL, REPLY)
    assert len(harness.texts) == 1
    assert harness.traffic.everything.count == 3


def test_failed_poll_is_listed_once_in_order(harness: TrafficHarness) -> None:
    harness.log(WRITE, STORED)
    harness.log(POLL)
    assert len(harness.texts) == 1
    harness.log(POLL, REPLY)
    assert harness.texts[1:] == ["get currents of both motors → no reply"]
    harness.log(POLL, REPLY)
    harness.log(WRITE, STORED)
    assert [text.startswith("set") for text in harness.texts] == [True, False, True]
    assert harness.traffic.faults == 1


def test_telemetry_does_not_displace_a_write(harness: TrafficHarness) -> None:
    harness.log(WRITE, STORED)
    for count in range(MAX_ROWS):
        harness.log(POLL, REPLY)
        if count % 100 == 0:
            harness.traffic.pull()
    assert harness.texts == ["set Serial Timeout to 1.5 s (15) → stored"]
    everything = harness.traffic.everything
    assert everything.count == MAX_ROWS + 1
    assert len(everything.rows) == 0.9 * MAX_ROWS, "the oldest tenth is dropped at once"
    newest = [row.number for row in everything.since(MAX_ROWS - 1)]
    assert newest == [MAX_ROWS, MAX_ROWS + 1]
    assert len(everything.since(0)) == len(everything.rows)


def test_faults_are_listed_with_and_without_polling(harness: TrafficHarness) -> None:
    harness.log(POLL)
    harness.log(POLL, REPLY)
    harness.traffic.pull()
    harness.traffic.everything.clear()  # as if many polls had displaced the row
    table = TrafficTable(harness.traffic)
    for polling in (False, True):
        table.set_filter(polling=polling, faults=True, text="")
        assert table.rowCount() == 1
    assert table.row_near(99, "no such text") == 0


def test_units_follow_the_identified_board(harness: TrafficHarness) -> None:
    harness.log(POLL, REPLY)
    harness.log(POLL, REPLY)
    harness.traffic.pull()
    row = harness.traffic.everything.rows[0]
    assert "2 counts" in harness.traffic.decoder.decoded(row).text
    harness.decoder.board = Signature(device_table().model("trex"), "1.2")
    harness.traffic.decode_again()
    assert " A," in harness.traffic.decoder.decoded(row).text


def test_clear_drops_every_row(harness: TrafficHarness, qtbot: QtBot) -> None:
    harness.log(POLL)
    harness.log(WRITE, STORED)
    harness.traffic.pull()
    with qtbot.waitSignal(harness.traffic.cleared):
        harness.traffic.clear()
    assert harness.texts == []
    assert harness.traffic.faults == 0
    harness.log(WRITE, STORED)
    assert len(harness.texts) == 1


def test_saved_rows_include_bytes_and_meaning(
    harness: TrafficHarness, qtbot: QtBot, tmp_path: Path
) -> None:
    harness.log(WRITE, STORED)
    harness.log(POLL)
    harness.log(POLL, REPLY)
    harness.traffic.pull()
    notifier, path = Notifier(), tmp_path / "line.txt"
    write = partial(harness.traffic.write, rows=harness.traffic.everything.rows)
    with qtbot.waitSignal(notifier.info) as saved:
        write_in_background(notifier, path, write, notifier, str)
    assert saved.args == ["3"]
    lines = path.read_text(encoding="utf-8").splitlines()
    body = [line.split("\t") for line in lines if not line.startswith("#")]
    assert body[0] == ["time", "fault", "sent", "received", "took_ms", "meaning"]
    assert body[1][1:] == [
        "", "AF 07 0F 55 2A", "00", "5.0", "set Serial Timeout to 1.5 s (15) → stored",
    ]  # fmt: skip
    assert body[2][1:] == ["!", "8F", "", "", "get currents of both motors → no reply"]
    assert len(body) == 4
