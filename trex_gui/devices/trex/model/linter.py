"""Settings check that runs after edits and connection changes."""

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.rules import Context, LintFinding, lint


class SettingsLinter(QObject):
    changed = Signal()  # `findings` has changed

    def __init__(self, draft: SettingsDraft, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.findings: tuple[LintFinding, ...] = ()
        self._draft = draft
        self._context: Context | None = Context()

        draft.loaded.connect(self._on_changed)
        draft.pending_changed.connect(self._on_changed)
        self._on_changed()

    def set_context(self, context: Context | None) -> None:
        """Set facts about the board. `None` disables the check."""
        if context != self._context:
            self._context = context
            self._on_changed()

    def accept(self, finding: LintFinding) -> None:
        if finding.change:
            with self._draft.one_edit(finding.proposal):
                for key, wire in finding.change.items():
                    self._draft.parameters.edit(key, wire)

    def check(self, settings: Settings | None) -> tuple[LintFinding, ...]:
        if settings is None or self._context is None:
            return ()
        return lint(settings, self._context)

    @Slot()
    def _on_changed(self) -> None:
        findings = self.check(self._draft.shown)
        if findings != self.findings:
            self.findings = findings
            self.changed.emit()


class BoardLinter(SettingsLinter):
    """Checks the settings of a connected board, considering its line and its driver."""

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(device.draft, parent)
        self._device = device
        self._computer_drives = False

        device.link_changed.connect(self._on_board_changed)
        device.motors.arming_changed.connect(self._on_board_changed)
        device.draft.loaded.connect(self._on_board_changed)
        self._on_board_changed()

    @Slot()
    def _on_board_changed(self) -> None:
        settings = self._device.settings
        if settings is None or not self._device.is_connected:
            self._computer_drives = False
            self.set_context(None)
            return
        stored = self._device.parameters.values.stored.get(ParameterKey.SERIAL_TIMEOUT)
        self._computer_drives |= self._device.motors.armed or bool(stored)
        self.set_context(
            Context(self._computer_drives, self._device.connection.port_rates, settings.line)
        )
