"""Line whose thread is suspended for a while, or whose other end does not read."""

import os
import select
import time
from typing import Any

import pytest
from serial import serialposix

from tests.core.transport.conftest import Open
from trex_gui.core.errors import PortUnavailable

pytestmark = pytest.mark.realtime


class _Late:
    """System module with one replaced function."""

    def __init__(self, module: object, **changed: object) -> None:
        self._module = module
        vars(self).update(changed)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._module, name)


def test_write_succeeds_although_its_thread_is_late(
    terminal: tuple[int, str], opened: Open, monkeypatch: pytest.MonkeyPatch
) -> None:
    far, transport = terminal[0], opened(terminal[1])

    def write(descriptor: int, data: bytes) -> int:
        count = os.write(descriptor, data)
        time.sleep(1.1)  # another thread runs
        return count

    monkeypatch.setattr(serialposix, "os", _Late(os, write=write))
    transport.write(b"\x81\x82")
    assert os.read(far, 16) == b"\x81\x82"


def test_timely_reply_is_read_although_thread_is_late(
    terminal: tuple[int, str], opened: Open, monkeypatch: pytest.MonkeyPatch
) -> None:
    far, transport = terminal[0], opened(terminal[1])

    def wait(*arguments: Any) -> Any:
        found = select.select(*arguments)
        os.write(far, b"a reply")  # after the last check
        # A pseudo-terminal delivers bytes late: wait for them.
        select.select(arguments[0], [], [], 10)
        return found

    monkeypatch.setattr(serialposix, "select", _Late(select, select=wait))
    assert transport.read(7, 0.001) == b"a reply"


def test_write_to_blocked_port_raises_port_unavailable(
    terminal: tuple[int, str], opened: Open
) -> None:
    transport = opened(terminal[1])
    with pytest.raises(PortUnavailable):
        transport.write(bytes(1_000_000))
