"""Driver of the bench test dialog."""

from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from tests.support.window import LEFT, WidgetDriver
from trex_gui.devices.trex.model.bench import Bench, Phase
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.views.bench.dialog import BenchDialog, FiguresTable
from trex_gui.devices.trex.views.bench.plot import BenchPlot
from trex_gui.ui.widgets.behaviour import HoldButton


class BenchTestDialog(WidgetDriver):
    """Bench test dialog, with or without a simulated board."""

    def __init__(
        self,
        dialog: BenchDialog,
        device: Device,
        bench: Bench,
        qtbot: QtBot,
        simulator: SimulatedDevice | None = None,
    ) -> None:
        super().__init__(dialog, qtbot)
        self.device, self.motors = device, device.motors
        self.bench = bench
        self.dialog = dialog
        self.wait(lambda: dialog.findChild(BenchPlot, "benchPlot") is not None)
        self.plot = self.find(BenchPlot, "benchPlot")
        self.hold_button = self.find(HoldButton, "benchHoldButton")
        self._simulator = simulator

    @property
    def shown_note(self) -> str:
        return self.text("benchNote")

    def figure(self, row: int, column: int) -> str:
        item = self.find(FiguresTable, "benchFigures").item(row, column)
        assert item is not None
        return item.text()

    def hold(self) -> None:
        """Arm the motors as soon as possible. Hold the button until the motor runs."""
        self.wait(lambda: self.is_enabled("benchRunButton"))
        self.click("benchRunButton")
        self.root.activateWindow()
        self.hold_button.setFocus()
        self.wait(self.hold_button.hasFocus)
        QTest.mousePress(self.hold_button, LEFT)
        self.wait(lambda: self.speed() == 60)

    def release(self) -> None:
        QTest.mouseRelease(self.hold_button, LEFT)

    def speed(self) -> int:
        """Return the speed of the simulated motor 1, or 0 while it brakes."""
        assert self._simulator is not None
        motor = self._simulator.show()["motors"][0]
        return 0 if motor["direction"] == "brake" else int(motor["speed"])

    def wait_for_end(self) -> None:
        """Wait until the simulated motor brakes and the test is over."""
        self.wait(lambda: self.speed() == 0)
        self.wait(lambda: self.bench.phase is Phase.IDLE)
