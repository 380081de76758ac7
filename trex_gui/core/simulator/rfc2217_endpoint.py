"""Serial port over TCP (RFC 2217), which receives the host's parity setting."""

import struct
from collections.abc import Container, Iterable
from types import SimpleNamespace

import serial
from serial.rfc2217 import PortManager

from trex_gui.core.simulator.endpoint import Arrival, HostSettings, TcpEndpoint
from trex_gui.core.transport.settings import Parity

_PARITIES = {parity.value: parity for parity in Parity}
_SUPPORTED: dict[str, Container[object]] = {
    "bytesize": {serial.EIGHTBITS},
    "parity": _PARITIES,
    "stopbits": {serial.STOPBITS_ONE, serial.STOPBITS_TWO},
}


class _Port:
    """Serial port for pyserial's `PortManager`, without hardware. Its modem lines are active."""

    cts = dsr = cd = True
    ri = False
    xonxoff = rtscts = dtr = rts = break_condition = False

    def __init__(self, baud: int) -> None:
        self.baudrate = baud
        self.bytesize = serial.EIGHTBITS
        self.parity = serial.PARITY_NONE
        self.stopbits = serial.STOPBITS_ONE

    def __setattr__(self, name: str, value: object) -> None:
        if name in _SUPPORTED and value not in _SUPPORTED[name]:
            raise ValueError(f"{name} cannot be {value}")
        super().__setattr__(name, value)

    def reset_input_buffer(self) -> None:
        """Do nothing, because there is no buffer."""

    reset_output_buffer = reset_input_buffer

    def settings(self) -> HostSettings:
        return HostSettings(self.baudrate, int(self.stopbits), _PARITIES[self.parity])


class Rfc2217Endpoint(TcpEndpoint):
    scheme = "rfc2217"

    def __init__(self, host: str, port: int, baud: int) -> None:
        self._baud = baud
        self._port_settings = _Port(baud)
        self._manager: PortManager | None = None
        super().__init__(host, port)

    def on_connected(self) -> None:
        self._port_settings = _Port(self._baud)
        self._manager = PortManager(
            self._port_settings,  # type: ignore[arg-type] # the stubs require a real port
            SimpleNamespace(write=super().write),  # type: ignore[arg-type] # likewise
        )

    def arrivals(self, data: bytes) -> Iterable[Arrival]:
        if self._manager is None:
            return
        try:
            for byte in self._manager.filter(data):
                yield self._port_settings.settings(), byte
        except (struct.error, KeyError, TypeError):
            self.drop_client()  # the host does not use RFC 2217

    def write(self, data: bytes) -> None:
        if self._manager is not None:
            super().write(b"".join(self._manager.escape(data)))

    def drop_client(self) -> None:
        self._manager = None
        super().drop_client()
