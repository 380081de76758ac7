"""What is odd about the settings shown, taken together, and what would mend it."""

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.model.device import Device, Link
from trex_gui.model.exchange import shown_settings
from trex_gui.settings.rules import Advice, Context, advise


class Adviser(QObject):
    """Looks at stored values and edits after each change; takes nothing into its own hands.

    Signals:
        changed: `advice` is another.
    """

    changed = Signal()

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._advice: tuple[Advice, ...] = ()
        self._drove = False

        device.state_changed.connect(self._on_changed)
        device.link_changed.connect(self._on_changed)
        device.pending_changed.connect(self._on_changed)
        device.motors.changed.connect(self._on_motors_changed)

    @property
    def advice(self) -> tuple[Advice, ...]:
        """What is odd now; nothing while no board answers."""
        return self._advice

    def accept(self, advice: Advice) -> None:
        """Make the proposed values edits that wait for Apply; one step to undo."""
        if advice.change:
            with self._device.one_edit(advice.proposal):
                for key, wire in advice.change.items():
                    self._device.parameters.edit(key, wire)

    @Slot()
    def _on_motors_changed(self) -> None:
        """Only that they are driven matters, not each move of a slider."""
        if self._device.motors.armed and not self._drove:
            self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        state, settings = self._device.state, self._device.settings
        advice: tuple[Advice, ...] = ()
        if state is not None and settings is not None and self._device.link is Link.UP:
            self._drove |= self._device.motors.armed
            context = Context(drives_from_computer=self._drove)
            advice = advise(shown_settings(self._device, state), context)
        else:
            self._drove = False
        if advice != self._advice:
            self._advice = advice
            self.changed.emit()
