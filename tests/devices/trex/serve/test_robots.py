"""Replies of served boards, which any computer on the network may forge."""

import json
from typing import Any

import pytest

from trex_gui.core.transport.urls import Address
from trex_gui.devices.trex.serve.robots import Robots, _row_of

ROW: dict[str, Any] = {"name": "arm", "board": None, "driver": None, "problems": []}


@pytest.mark.parametrize(
    "reply",
    [
        b"[1]",
        b"{}",
        b"\xff",
        *(
            json.dumps(ROW | change).encode()
            for change in ({"name": "a\x1b"}, {"driver": "a\x1b"}, {"problems": ["\x1b"]})
        ),
    ],
)
def test_malformed_reply_is_no_robot(reply: bytes) -> None:
    assert _row_of(json.dumps(ROW).encode()) == ROW
    assert _row_of(reply) is None


@pytest.mark.parametrize("forged", [b"\xff", b"[]", b"{}"])
def test_malformed_reply_does_not_hide_other_confirmations(
    forged: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    def reply(_robots: Robots, address: Address, *_parts: str, seconds: float) -> list[bytes]:
        del seconds
        return [forged if address.name == "leg" else b'{"name": "arm", "error": ""}']

    monkeypatch.setattr(Robots, "_get", reply)
    names = ["trex://robot/arm", "trex://robot/leg"]
    with Robots() as robots:
        results = robots.stop(names)
    assert [bool(error) for error in results.values()] == [False, True]
