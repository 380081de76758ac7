"""USB adapters, recognised again when their port has another name."""

import os
import re
from dataclasses import dataclass

from serial.tools import list_ports
from serial.tools.list_ports_common import ListPortInfo

_SHARED = 4
"""Longest serial number, in characters, that several adapters may share: CP2102 are sold with 0001.
The socket identifies such adapters, like adapters without a number."""


@dataclass(frozen=True, slots=True)
class Adapter:
    """A USB adapter as far as the system knows it.

    Attributes:
        product: numbers of vendor and product: `0403:6001`.
        number: the serial number; empty if it has none.
        location: the socket, and the interface of an adapter with several ports: `1-2.3`,
            `1-2:1.1`; empty where the system does not tell.
    """

    product: str
    number: str = ""
    location: str = ""

    @classmethod
    def of(cls, port: ListPortInfo) -> "Adapter | None":
        """Return the adapter of a port. `None` for a port that is not on USB."""
        if port.vid is None:
            return None
        product = f"{port.vid:04x}:{port.pid or 0:04x}"
        return cls(product, port.serial_number or "", port.location or "")

    @property
    def key(self) -> str:
        """Key of saved data about the adapter, as one word. Equal if `is_same`."""
        place = self.location if len(self.number) <= _SHARED else _interface(self)
        return re.sub(r"[/\s]+", "-", "-".join(filter(None, (self.product, self.number, place))))

    def is_same(self, other: "Adapter") -> bool:
        """True if both are the same adapter, perhaps in another socket."""
        if (self.product, self.number) != (other.product, other.number):
            return False
        if len(self.number) <= _SHARED:
            return self.location == other.location
        return _interface(self) == _interface(other)


def _interface(adapter: Adapter) -> str:
    return adapter.location.partition(":")[2]


def adapter_key(url: str) -> str:
    """Return the key of the adapter that has a port now. Empty if unknown."""
    if "://" in url:
        return ""
    place = os.path.realpath(url.replace("\0", ""))  # no file name contains NUL
    ports = (port for port in list_ports.comports() if os.path.realpath(port.device) == place)
    return next((adapter.key for port in ports if (adapter := Adapter.of(port)) is not None), "")
