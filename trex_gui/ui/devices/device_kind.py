"""Kinds of devices, as far as the list of ports has to know them."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class DeviceKind:
    """A kind of device that a port may lead to.

    Attributes:
        key: its name in what is remembered.
        name: what people call it.
    """

    key: str
    name: str


TREX = DeviceKind("trex", "TReX")
"""What a port leads to while nobody has said otherwise."""
