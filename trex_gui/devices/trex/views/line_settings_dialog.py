"""Dialog for the line settings of this computer."""

from dataclasses import replace

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtGui import QRegularExpressionValidator
from PySide6.QtWidgets import QDialogButtonBox, QFormLayout, QLineEdit, QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.connection_settings import (
    FACTORY_NUMBER,
    ConnectionSettings,
    numbers_in,
)
from trex_gui.devices.trex.protocol.line_settings import Detection
from trex_gui.devices.trex.views.pages.parameters.editors import LineSettingsEditor
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.labels import Note

_NUMBERS = r"((\d|[1-9]\d|1[01]\d|12[0-7])(, *|$))*"  # 0 to 127, separated by commas


class LineSettingsDialog(ReusedDialog):
    chosen = Signal(object)  # `ConnectionSettings` that the user has accepted

    def __init__(self, settings: ConnectionSettings, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("lineSettingsDialog")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(title_of(tr("&Line settings…")))
        text = tr(
            "These settings must match those of the board. A new board uses 19200 baud, no "
            "error detection and one stop bit. Changing them here does not change the board."
        )
        intro = ui.label(self, "", text, wrap=True)
        self._line = ui.named(LineSettingsEditor(self), "lineEditor")
        self._polynomial = ui.spin_box(self, "polynomialField", "", 0x80, 0xFF)
        self._polynomial.setDisplayIntegerBase(16)
        self._polynomial.setPrefix("0x")
        text = tr("&Address one board by its device number (Pololu protocol)")
        self._addressed = ui.check_box(self, "addressedBox", text)
        self._number = ui.spin_box(self, "deviceNumberField", "", 0, 127)
        tip = tr(
            "Device numbers of other devices on this line, such as 0,1 (older Pololu motor "
            "and servo controllers). If you enter numbers, every packet has an address, no "
            "packet is sent to these numbers, and no other baud rate is tried."
        )
        self._reserved = ui.named(QLineEdit(self), "reservedField", tip=tip)
        self._reserved.setValidator(QRegularExpressionValidator(_NUMBERS, self))
        standard = QDialogButtonBox.StandardButton
        buttons = QDialogButtonBox(standard.Ok | standard.Cancel | standard.RestoreDefaults, self)

        form = QFormLayout()
        form.addRow(tr("&Line:"), self._line)
        form.addRow(tr("CRC-7 &polynomial:"), self._polynomial)
        form.addRow(self._addressed)
        form.addRow(tr("&Device number:"), self._number)
        form.addRow(tr("Nu&mbers of other devices:"), self._reserved)
        self._clash = ui.named(Note(2, self), "lineClash")
        ui.column(intro, form, self._clash, 1, buttons, into=self)

        line, reserved = self._line.valueChanged, self._reserved.textChanged
        for changed in (line, self._addressed.toggled, reserved):
            changed.connect(self._on_changed)
        buttons.accepted.connect(self._on_accepted)
        buttons.rejected.connect(self.reject)
        buttons.button(standard.Ok).setDefault(True)
        restore = buttons.button(standard.RestoreDefaults)
        restore.setText(tr("&Restore defaults"))
        restore.clicked.connect(self._on_restore_clicked)
        self.show_settings(settings)

    @Slot(object)
    def show_settings(self, settings: ConnectionSettings) -> None:
        """Show the settings and discard edits."""
        self._settings = settings
        self._line.set_settings(settings.line)
        self._polynomial.setValue(settings.polynomial)
        number = settings.device_number
        self._addressed.setChecked(number is not None)
        self._number.setValue(FACTORY_NUMBER if number is None else number)
        self._reserved.setText(settings.reserved_text)
        self._on_changed()

    @Slot()
    def _on_accepted(self) -> None:
        number = self._number.value() if self._addressed.isChecked() else None
        settings = replace(
            self._settings,
            line=self._line.settings(),
            polynomial=self._polynomial.value(),
            device_number=number,
            group=self._settings.group if number == self._settings.device_number else (),
            reserved=numbers_in(self._reserved.text()),
        )
        try:
            _ = settings.framing
        except BadRequest as error:
            self._clash.show_note(str(error), alarming=True)
            return
        self.chosen.emit(settings)
        self.accept()

    @Slot()
    def _on_changed(self) -> None:
        self._polynomial.setEnabled(self._line.settings().detection is Detection.CRC7)
        is_shared = bool(numbers_in(self._reserved.text()))
        self._addressed.setChecked(is_shared or self._addressed.isChecked())
        self._addressed.setEnabled(not is_shared)
        self._number.setEnabled(self._addressed.isChecked())

    @Slot()
    def _on_restore_clicked(self) -> None:
        self.show_settings(replace(ConnectionSettings(""), timeouts=self._settings.timeouts))
