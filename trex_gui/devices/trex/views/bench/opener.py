"""Opens the window of bench tests; it is made when it is first wanted."""

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.model.bench.bench import Bench
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.views.bench.dialog import BenchDialog


class BenchOpener(QObject):
    """Keeps the one window of bench tests.

    Signals:
        apply_requested: a person wants the edits written.
    """

    apply_requested = Signal()

    def __init__(self, device: Device, window: QWidget) -> None:
        super().__init__(window)
        self._device = device
        self._window = window
        self._dialog: BenchDialog | None = None
        self.bench = Bench(device, self)

    def open(self) -> None:
        """Show the window, or bring it forward."""
        if self._dialog is None:
            self._dialog = BenchDialog(self._device, self.bench, self._window)
            self._dialog.apply_requested.connect(self.apply_requested)
        self._dialog.open_bench()

    def close(self) -> None:
        """Close it; a test that runs is aborted."""
        if self._dialog is not None:
            self._dialog.close()
