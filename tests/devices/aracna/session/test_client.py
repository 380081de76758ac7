"""Client with one command in flight."""

from unittest.mock import Mock

import pytest

from tests.support.aracna import AracnaHarness
from trex_gui.core.errors import BadReply, BadRequest
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.protocol.replies import Positions, Version
from trex_gui.devices.aracna.session.client import (
    QUERY_RETRY,
    SAVED_BYTES,
    Answered,
    AracnaClient,
    CommandEvent,
    ReplyLost,
)
from trex_gui.devices.aracna.session.errors import printable
from trex_gui.devices.aracna.session.messages import Progress, Stuck

THERE = (600,) * 8


def client_of(harness: AracnaHarness, motors: int = 8) -> AracnaClient:
    client = AracnaClient(harness.transport, PortSettings("virtual"))
    client.motors = motors
    return client


def received(client: AracnaClient, seconds: float) -> list[CommandEvent]:
    """Listen for some seconds. Return the events."""
    end = client.transport.clock() + seconds
    events: list[CommandEvent] = []
    while client.transport.clock() < end:
        events += client.listen(0.01)
    return events


def test_second_command_is_rejected_until_first_is_answered() -> None:
    harness = AracnaHarness()
    client = client_of(harness)
    client.query()
    with pytest.raises(BadRequest, match="not yet replied to the last command"):
        client.move(THERE, 5.0)
    [answered] = received(client, 0.1)
    assert isinstance(answered, Answered)
    assert answered.reply == Version(1, 8)
    client.move(THERE, 5.0)
    assert bytes(harness.transport.sent).count(b"\n") == 2


def test_move_is_not_sent_before_motor_count_is_known() -> None:
    harness = AracnaHarness()
    with pytest.raises(BadRequest):
        client_of(harness, 0).move(THERE, 5.0)
    assert not harness.transport.sent


def test_only_queries_follow_late_move_until_it_is_answered() -> None:
    harness = AracnaHarness()
    harness.do("servo 1 block")
    client = client_of(harness)
    client.move(THERE, 1.0)
    events = received(client, 30.0)
    assert [type(event) for event in events if not isinstance(event, Progress)] == [Stuck]
    assert client.awaited_motor == 1
    following = bytes(harness.transport.sent).partition(b"600\n")[2]
    assert following == b".q\n" * following.count(b".q\n")
    assert 1 < following.count(b".q\n") <= 2 + 29 / QUERY_RETRY
    harness.do("servo 1 free")
    events = received(client, 2.0)
    first, second = [event for event in events if not isinstance(event, Progress)]
    assert isinstance(first, Answered)
    assert isinstance(first.reply, Positions)
    assert isinstance(second, Answered)
    assert second.reply == Version(1, 8)
    assert client.pending is None


def test_line_is_busy_until_query_after_late_move_is_answered() -> None:
    harness = AracnaHarness()
    harness.do("servo 1 block")
    client = client_of(harness)
    client.move(THERE, 0.5)
    received(client, 2.0)
    harness.do("servo 1 free")
    end = harness.now + 2
    while not any(isinstance(event, Answered) for event in client.listen(0.001)):
        assert harness.now < end
    with pytest.raises(BadRequest):
        client.move(THERE, 5.0)
    received(client, 0.1)
    client.move(THERE, 5.0)


def test_lost_move_ends_when_following_query_is_answered() -> None:
    harness = AracnaHarness()
    harness.do("line drop 50 sent")
    client = client_of(harness)
    client.move(THERE, 0.5)
    harness.line.advance(0.2)
    harness.do("line drop 0 sent")
    late, lost = received(client, 2.0)
    assert isinstance(late, Stuck)
    assert late.motor is None
    assert isinstance(lost, ReplyLost)
    assert lost.robot_free


def test_first_bytes_of_endless_noise_are_saved(monkeypatch: pytest.MonkeyPatch) -> None:
    harness = AracnaHarness()
    client = client_of(harness)
    harness.line.inject(b"x" * 100)
    endless = Mock(side_effect=BadReply("bytes keep arriving"))
    monkeypatch.setattr(harness.transport, "discard", endless)
    assert received(client, 0.1) == []
    assert client.received == b"x" * SAVED_BYTES


def test_printable_bytes_are_shown_as_text_and_others_as_hex() -> None:
    assert printable(b"\r\nERR 7\r\n") == "ERR 7"
    assert printable(bytes(range(0x80, 0x90))) == "80 81 82 83 84 85 86 87 88 89 8A 8B …"
