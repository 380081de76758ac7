"""What is odd about the settings shown, taken together, and what would mend it."""

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.settings.rules import Context, LintFinding, advise
from trex_gui.ui.devices.connection_state import ConnectionState


class SettingsLinter(QObject):
    """Looks at stored values and edits after each change; takes nothing into its own hands.

    Signals:
        changed: `advice` is another.
    """

    changed = Signal()

    def __init__(self, draft: SettingsDraft, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._draft = draft
        self._advice: tuple[LintFinding, ...] = ()
        self._context: Context | None = Context()

        draft.loaded.connect(self._on_changed)
        draft.pending_changed.connect(self._on_changed)
        self._on_changed()

    @property
    def advice(self) -> tuple[LintFinding, ...]:
        """What is odd now."""
        return self._advice

    def set_context(self, context: Context | None) -> None:
        """Say what is known beside the settings; `None`: nothing is to be said of them now."""
        if context != self._context:
            self._context = context
            self._on_changed()

    def accept(self, advice: LintFinding) -> None:
        """Make the proposed values edits that wait for Apply; one step to undo."""
        if advice.change:
            with self._draft.one_edit(advice.proposal):
                for key, wire in advice.change.items():
                    self._draft.parameters.edit(key, wire)

    @Slot()
    def _on_changed(self) -> None:
        advice: tuple[LintFinding, ...] = ()
        shown = self._draft.shown
        if shown is not None and self._context is not None:
            advice = advise(shown, self._context)
        if advice != self._advice:
            self._advice = advice
            self.changed.emit()


class BoardAdviser(SettingsLinter):
    """Knows of the line and of the motors; has nothing to say while no board answers."""

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(device.draft, parent)
        self._device = device
        self._drove = False

        device.link_changed.connect(self._on_board_changed)
        device.motors.arming_changed.connect(self._on_board_changed)
        self._on_board_changed()

    @Slot()
    def _on_board_changed(self) -> None:
        settings = self._device.settings
        if settings is None or self._device.link is not ConnectionState.CONNECTED:
            self._drove = False
            self.set_context(None)
            return
        self._drove |= self._device.motors.armed
        self.set_context(Context(self._drove, self._device.port_rates, settings.line))
