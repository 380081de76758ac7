"""Port of the guardian on Windows, with fake system calls."""

# ruff: noqa: N802 - the names are those of Windows

import ctypes
import importlib.util
import sys
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

from trex_gui.core.guardian import process

HANDLE = 0x1234
SHORT = 0.005  # seconds


class Operation:
    """Overlapped read or write. It ends when it is complete or cancelled."""

    def __init__(self, data: bytes, *, is_pending: bool) -> None:
        self.event = self
        self.is_pending = is_pending
        self._data = data

    def cancel(self) -> None:
        self.is_pending = False

    def GetOverlappedResult(self, wait: bool) -> tuple[int, int]:
        assert wait
        assert not self.is_pending, "the call would wait for ever"
        return len(self._data), 0

    def getbuffer(self) -> bytes:
        return self._data


class Windows:
    """System with a port that has no timeouts.

    Attributes:
        received: bytes that the port has received.
        sent: bytes written to the port.
        capacity: maximum number of bytes that one write accepts at once.
        state: line settings of the port (a DCB).
    """

    def __init__(self) -> None:
        self.received = b""
        self.sent = b""
        self.capacity = 100
        self.state = bytes(range(28))
        self.is_closed = False

    def module(self) -> ModuleType:
        module = ModuleType("_winapi")
        for function in (self.ReadFile, self.WriteFile, self.WaitForSingleObject, self.CloseHandle):
            setattr(module, function.__name__, function)
        return module

    def ReadFile(self, handle: int, size: int, *, overlapped: bool) -> tuple[Operation, int]:
        assert (handle, overlapped) == (HANDLE, True)
        data, self.received = self.received[:size], self.received[size:]
        return Operation(data, is_pending=len(data) < size), 0

    def WriteFile(self, handle: int, data: bytes, *, overlapped: bool) -> tuple[Operation, int]:
        assert (handle, overlapped) == (HANDLE, True)
        accepted = data[: self.capacity]
        self.sent += accepted
        return Operation(accepted, is_pending=len(accepted) < len(data)), 0

    @staticmethod
    def WaitForSingleObject(_event: Operation, milliseconds: int) -> int:
        assert milliseconds >= 0
        return 0

    def CloseHandle(self, handle: int) -> None:
        assert handle == HANDLE
        self.is_closed = True

    def GetCommState(self, handle: ctypes.c_void_p, state: Any) -> int:
        assert handle.value == HANDLE
        assert state.raw[:4] == (28).to_bytes(4, "little"), "a DCB starts with its size"
        state.raw = self.state
        return 1

    def SetCommState(self, handle: ctypes.c_void_p, state: bytes) -> int:
        assert handle.value == HANDLE
        self.state = state
        return 1


@pytest.fixture
def windows() -> Windows:
    return Windows()


@pytest.fixture
def port(windows: Windows, monkeypatch: pytest.MonkeyPatch) -> Any:
    """Return an open port of the module as loaded on Windows."""
    monkeypatch.setitem(sys.modules, "_winapi", windows.module())
    monkeypatch.setattr(ctypes, "windll", SimpleNamespace(kernel32=windows), raising=False)
    monkeypatch.setattr(sys, "platform", "win32")
    spec = importlib.util.spec_from_file_location("guardian_on_windows", process.__file__)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.open_port("serial", HANDLE)


def test_read_returns_all_received_bytes(port: Any, windows: Windows) -> None:
    windows.received = b"\x07\x08"
    assert [port.receive(SHORT) for _ in range(3)] == [b"\x07", b"\x08", b""]
    port.close()
    assert windows.is_closed


def test_write_continues_until_everything_is_sent(port: Any, windows: Windows) -> None:
    windows.capacity = 3
    port.write(b"12345678")
    assert windows.sent == b"12345678"


def test_blocked_port_times_out(
    port: Any, windows: Windows, monkeypatch: pytest.MonkeyPatch
) -> None:
    windows.capacity = 0
    seconds = iter(range(100))
    monkeypatch.setattr("time.monotonic", lambda: float(next(seconds)))
    with pytest.raises(TimeoutError):
        port.write(b"1")


def test_changed_line_settings_are_restored(port: Any, windows: Windows) -> None:
    saved, windows.state = windows.state, bytes(28)
    port.restore_settings()
    assert windows.state == saved
    windows.state = bytes(28)
    port.save_settings()
    port.restore_settings()
    assert windows.state == bytes(28)
