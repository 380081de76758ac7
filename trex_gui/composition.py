"""Supported kinds of device."""

from typing import TYPE_CHECKING

from trex_gui.core.plugin import DevicePlugin
from trex_gui.core.timing import Timeouts
from trex_gui.devices.aracna.plugin import ARACNA
from trex_gui.devices.trex.plugin import TREX

if TYPE_CHECKING:
    from trex_gui.ui.program import Program

PLUGINS: tuple[DevicePlugin, ...] = (TREX, ARACNA)
"""All supported kinds. The first kind is the default for a port."""


def build(timeouts: Timeouts | None = None) -> "Program":
    """Create the models and the window, without connecting to a device."""
    from trex_gui.ui.program import Program  # noqa: PLC0415 - trexcmd starts without Qt

    return Program(PLUGINS, timeouts)
