"""What is kept of a line, and what is told of it."""

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.link.transcript import Piece, Way
from trex_gui.link.trex_wording import TrexWording
from trex_gui.model import transcript as model
from trex_gui.model.session_thread import SessionThread
from trex_gui.model.transcript import Transcript
from trex_gui.model.transcript_saver import TranscriptSaver
from trex_gui.protocol.commands import Signature
from trex_gui.protocol.device_table import device_table

POLL, ANSWER = b"\x8f", b"\x02\x00"
WRITE, STORED = b"\xaf\x07\x0f\x55\x2a", b"\x00"


class Wire:
    """A thread of sessions whose tape a test writes on."""

    def __init__(self) -> None:
        self.line = SessionThread()
        self.wording = TrexWording()
        self.transcript = Transcript(self.line, self.wording)
        self._now = 0.0

    def say(self, sent: bytes, received: bytes = b"") -> None:
        self._now += 0.01
        self.line.tape.note(Piece(self._now, Way.SENT, sent))
        if received:
            self.line.tape.note(Piece(self._now + 0.005, Way.RECEIVED, received))

    @property
    def told(self) -> list[str]:
        self.transcript.pull()
        return [self.transcript.words_of(row).text for row in self.transcript.telling.rows]


@pytest.fixture
def wire(qtbot: QtBot) -> Wire:
    del qtbot
    return Wire()


def test_what_is_polled_stands_apart_from_what_is_asked(wire: Wire) -> None:
    wire.say(POLL, ANSWER)
    wire.say(WRITE, STORED)
    wire.say(POLL, ANSWER)
    assert wire.told == ["set Serial Timeout to 1.5 s (15) → stored"]
    assert wire.transcript.everything.count == 3
    assert wire.transcript.faults == 0


def test_a_poll_that_fails_is_told_in_its_place(wire: Wire) -> None:
    wire.say(WRITE, STORED)
    wire.say(POLL)
    wire.say(POLL, ANSWER)
    wire.say(WRITE, STORED)
    told = wire.told
    assert told[1] == "get currents of both motors → no answer"
    assert [text.startswith("set") for text in told] == [True, False, True]
    assert wire.transcript.faults == 1


def test_a_poll_that_fails_between_two_looks_is_told_once(wire: Wire) -> None:
    wire.say(POLL)
    assert wire.told == []
    wire.say(POLL, ANSWER)
    assert wire.told == ["get currents of both motors → no answer"]
    wire.say(POLL, ANSWER)
    assert len(wire.told) == 1


def test_telemetry_does_not_push_out_a_write(wire: Wire, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(model, "MOST_KEPT", 100)
    monkeypatch.setattr(model, "_TRIMMED", 90)
    wire.say(WRITE, STORED)
    for _ in range(500):
        wire.say(POLL, ANSWER)
    assert wire.told == ["set Serial Timeout to 1.5 s (15) → stored"]
    everything = wire.transcript.everything
    assert 90 <= len(everything.rows) <= 100
    assert everything.count == 501
    assert [row.number for row in everything.since(499)] == [500, 501]
    assert len(everything.since(0)) == len(everything.rows)


def test_units_follow_the_board_that_answers(wire: Wire) -> None:
    wire.say(POLL, ANSWER)
    wire.say(POLL, ANSWER)
    wire.transcript.pull()
    row = wire.transcript.everything.rows[0]
    assert "2 counts" in wire.transcript.words_of(row).text
    wire.wording.board = Signature(device_table().model("trex"), "1.2")
    wire.transcript.forget_words()
    assert " A," in wire.transcript.words_of(row).text


def test_who_clears_begins_anew(wire: Wire, qtbot: QtBot) -> None:
    wire.say(POLL)
    wire.say(WRITE, STORED)
    wire.transcript.pull()
    with qtbot.waitSignal(wire.transcript.cleared):
        wire.transcript.clear()
    assert wire.told == []
    assert wire.transcript.faults == 0
    wire.say(WRITE, STORED)
    assert len(wire.told) == 1


def test_rows_are_written_whole_with_what_they_mean(
    wire: Wire, qtbot: QtBot, tmp_path: Path
) -> None:
    wire.say(WRITE, STORED)
    wire.say(POLL)
    wire.say(POLL, ANSWER)
    wire.transcript.pull()
    saver, path = TranscriptSaver(wire.transcript), tmp_path / "line.txt"
    with qtbot.waitSignal(saver.saved, timeout=15_000) as saved:
        saver.save(path, wire.transcript.everything.rows)
    assert saved.args == [3, path]
    lines = path.read_text(encoding="utf-8").splitlines()
    body = [line.split("\t") for line in lines if not line.startswith("#")]
    assert body[0] == ["time", "fault", "sent", "received", "took_ms", "meaning"]
    assert body[1][1:] == [
        "", "AF 07 0F 55 2A", "00", "5.0", "set Serial Timeout to 1.5 s (15) → stored",
    ]  # fmt: skip
    assert body[2][1:] == ["!", "8F", "", "", "get currents of both motors → no answer"]
    assert len(body) == 4


def test_a_file_that_cannot_be_written_is_told_and_leaves_nothing(
    wire: Wire, qtbot: QtBot, tmp_path: Path
) -> None:
    wire.say(WRITE, STORED)
    wire.transcript.pull()
    saver = TranscriptSaver(wire.transcript)
    with qtbot.waitSignal(saver.failed, timeout=15_000) as failed:
        saver.save(tmp_path / "no such folder" / "line.txt", wire.transcript.everything.rows)
    assert "line.txt: It was not written: No such file or directory." in failed.args
    assert not saver.is_saving
    assert list(tmp_path.iterdir()) == []
