"""USB adapters, recognized even if the name of their port changes."""

import os
import re
from dataclasses import dataclass

from serial.tools import list_ports
from serial.tools.list_ports_common import ListPortInfo

_SHARED = 4
"""Maximum length of a serial number that several adapters may share.

CP2102 adapters are sold with the number 0001. Such adapters, and adapters without a number, are
identified by their USB socket."""


@dataclass(frozen=True, slots=True)
class Adapter:
    """USB adapter, as the system reports it.

    Attributes:
        product: IDs of vendor and product, such as `0403:6001`.
        number: serial number, or an empty string.
        location: USB socket, such as `1-2.3`. If the adapter has more than one port, the USB
            interface follows, as in `1-2:1.1`. Empty if the system does not report the socket.
    """

    product: str
    number: str = ""
    location: str = ""

    @classmethod
    def of(cls, port: ListPortInfo) -> "Adapter | None":
        """Return the adapter of a port. `None` if the port is not on USB."""
        if port.vid is None:
            return None
        product = f"{port.vid:04x}:{port.pid or 0:04x}"
        return cls(product, port.serial_number or "", port.location or "")

    @property
    def key(self) -> str:
        """Key for saved data, without spaces. If `is_same` is true, the keys are equal."""
        location = self.location if len(self.number) <= _SHARED else _interface(self)
        return re.sub(r"[/\s]+", "-", "-".join(filter(None, (self.product, self.number, location))))

    def is_same(self, other: "Adapter") -> bool:
        """Return whether `other` is the same adapter, perhaps in another USB socket."""
        if (self.product, self.number) != (other.product, other.number):
            return False
        if len(self.number) <= _SHARED:
            return self.location == other.location
        return _interface(self) == _interface(other)


def _interface(adapter: Adapter) -> str:
    return adapter.location.partition(":")[2]


def adapter_key(url: str) -> str:
    """Return the key of the adapter at a port. Empty if unknown."""
    if "://" in url:
        return ""
    path = os.path.realpath(url.replace("\0", ""))  # no file name contains NUL
    ports = (port for port in list_ports.comports() if os.path.realpath(port.device) == path)
    return next((adapter.key for port in ports if (adapter := Adapter.of(port)) is not None), "")
