"""Supported baud rates, and changes of an open port."""

import array
import errno
import os
import sys

import pytest
import serial

from tests.core.transport.conftest import Open
from tests.support.simulator import SimulatedDevice
from trex_gui.core.errors import BadRequest, PortUnavailable
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport import linux_ports
from trex_gui.core.transport.linux_ports import rates_of
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.protocol.commands import GetSignature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates

pytestmark = pytest.mark.realtime

if sys.platform == "win32":
    pytest.skip("needs pseudo-terminals", allow_module_level=True)

linux = pytest.mark.skipif(sys.platform != "linux", reason="only Linux shows the rates")


def no_time() -> float:
    """Return a constant time, so that no driver is too slow."""
    return 0.0


@linux
def test_pseudo_terminal_supports_every_rate_and_sends_nothing(
    terminal: tuple[int, str], opened: Open
) -> None:
    master, url = terminal
    transport = opened(url, LineSettings(14400))
    assert rates_of(transport._port, baud_rates(), no_time) == frozenset(baud_rates())
    os.set_blocking(master, False)
    with pytest.raises(BlockingIOError):
        os.read(master, 1)


@linux
def test_rates_query_restores_port_settings(quick_simulator: SimulatedDevice, opened: Open) -> None:
    transport = opened(quick_simulator.url)
    before = linux_ports.termios2(transport._port.fileno())
    transport.rates(baud_rates())
    assert linux_ports.termios2(transport._port.fileno()) == before
    settings = ConnectionSettings(quick_simulator.url, timeouts=Timeouts(extra=15))
    client = TrexClient(transport, settings)
    assert str(client.request(GetSignature())) == "TReX 1.2"


@linux
def test_pseudo_terminal_can_be_reconfigured_repeatedly(
    terminal: tuple[int, str], opened: Open
) -> None:
    for line in (
        LineSettings(57600, Detection.EVEN, 2),
        LineSettings(57600, Detection.ODD, 2),
        LineSettings(1200),
        LineSettings(1200, Detection.EVEN),
    ):
        for _ in range(2):
            transport = opened(terminal[1], line)
            transport.reconfigure(LineSettings(1200))
            transport.reconfigure(line)
            transport.close()


class Adapter:
    """Port whose driver uses the nearest possible rate."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, *possible: int) -> None:
        self.words = array.array("I", [0] * 11)
        self.possible = possible
        self.failure: OSError | None = None
        monkeypatch.setattr("fcntl.ioctl", self._ioctl)

    def fileno(self) -> int:
        return 3

    def _ioctl(self, handle: int, request: int, words: "array.array[int]") -> None:
        if request == linux_ports._TCGETS2:
            words[:] = self.words
            return
        if self.failure is not None:
            raise self.failure
        self.words = words[:]
        wanted = words[-1]
        self.words[-1] = min(self.possible, key=lambda rate: abs(rate - wanted))


@linux
def test_rate_far_from_driver_rate_is_unsupported(monkeypatch: pytest.MonkeyPatch) -> None:
    adapter = Adapter(monkeypatch, 9600, 19200, 57143, 75000)
    assert rates_of(adapter, [9600, 38400, 57600, 76800], no_time) == frozenset(
        {9600, 57600, 76800}
    )
    adapter.possible = (19200, 57600, 115200)
    assert rates_of(adapter, [19200, 76800, 115200], no_time) == frozenset({19200, 115200})


@linux
def test_rates_are_unknown_when_driver_rejects_settings_or_is_slow(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    adapter = Adapter(monkeypatch, 9600)
    times = iter((0.0, 0.05, 0.11, 0.2))
    assert rates_of(adapter, [9600, 19200, 38400], lambda: next(times)) is None
    adapter.failure = OSError(errno.EINVAL, "Invalid argument")
    assert rates_of(adapter, [9600]) is None  # restoring also fails


def test_rates_of_closed_port_and_other_systems_are_unknown(
    monkeypatch: pytest.MonkeyPatch, terminal: tuple[int, str], opened: Open
) -> None:
    transport = opened(terminal[1])
    with monkeypatch.context() as patched:
        patched.setattr("platform.machine", lambda: "mips64")
        assert transport.rates(baud_rates()) is None
        patched.setattr(sys, "platform", "darwin")
        assert transport.rates(baud_rates()) is None
    transport.close()
    assert transport.rates(baud_rates()) is None


def test_failed_reconfiguration_raises_matching_error(
    terminal: tuple[int, str], opened: Open, monkeypatch: pytest.MonkeyPatch
) -> None:
    transport = opened(terminal[1])
    for failure, kind in (
        (ValueError("no such rate"), BadRequest),
        (serial.SerialException(errno.EINVAL, "Invalid argument"), BadRequest),
        (serial.SerialException(errno.EIO, "Input/output error"), PortUnavailable),
    ):

        def fail(*_: object, failure: Exception = failure, **__: object) -> None:
            raise failure

        with monkeypatch.context() as patched:
            patched.setattr(transport._port, "_reconfigure_port", fail)
            with pytest.raises(kind):
                transport.reconfigure(LineSettings(76800))
        transport.reconfigure(LineSettings())
