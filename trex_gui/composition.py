"""The list of devices. A line registers one."""

from typing import TYPE_CHECKING

from trex_gui.core.plugin import DevicePlugin
from trex_gui.core.timing import Timeouts
from trex_gui.devices.aracna.plugin import ARACNA
from trex_gui.devices.trex.plugin import TREX

if TYPE_CHECKING:
    from trex_gui.ui.program import Program

PLUGINS: tuple[DevicePlugin, ...] = (TREX, ARACNA)
"""Every kind of device; the first is the default of a port until another one is found."""


def build(timeouts: Timeouts | None = None) -> "Program":
    """Build models and window. Nothing is connected yet."""
    from trex_gui.ui.program import Program  # noqa: PLC0415 - trexcmd starts without Qt

    return Program(PLUGINS, timeouts)
