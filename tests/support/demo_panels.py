"""Simulator that records the control lines of a demo panel."""

from collections.abc import Callable

from trex_gui.core.plugin import DevicePlugin
from trex_gui.devices.trex.plugin import TREX
from trex_gui.ui.devices.simulator import Simulator


class RecordingSimulator(Simulator):
    def __init__(self, plugin: DevicePlugin = TREX) -> None:
        super().__init__(plugin)
        self.lines: list[str] = []

    def send(self, line: str, then: Callable[[str], None] | None = None) -> None:
        self.lines.append(line)
        super().send(line, then)

    def changes(self) -> list[str]:
        """Return the control lines, except for those that read the state."""
        return [line for line in self.lines if line != "show"]
