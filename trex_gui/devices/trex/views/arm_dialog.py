"""Offer of a serial timeout before motors are armed that nothing stops when the cable falls out."""

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QDialog, QWidget

from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_texts import timeout_warning
from trex_gui.ui.widgets.builders import button, column, label, named, row
from trex_gui.ui.widgets.labels import Note

_WIDTH = 480  # pixels


def arm(device: Device, window: QWidget) -> None:
    """Arm the motors; on a real board without a serial timeout that should stop them, ask first."""
    motors, warning = device.motors, timeout_warning(device)
    is_real = device.settings is not None and not device.settings.name
    lacks_stop = device.board.timeout_stop.may_be_mended
    can_offer = is_real and lacks_stop and motors.can_arm and not device.writer.is_rejected
    if can_offer and warning and warning.seconds and not motors.arms_without_timeout:
        ArmDialog(device, warning.text, warning.seconds, window).open()
    else:
        motors.arm()


class ArmDialog(QDialog):
    """Arms the motors once a serial timeout is written, or without one, now and later."""

    def __init__(self, device: Device, text: str, seconds: float, parent: QWidget) -> None:
        """Propose a timeout in `seconds`; `text` says what is wrong with the present one."""
        super().__init__(parent)
        self.setObjectName("armDialog")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Arm the motors"))
        self._device, self._seconds = device, seconds
        remark = tr(
            "“Arm without” is remembered for this board. Cut the power by hand then if the "
            "cable falls out."
        )
        self._note = named(Note(1, self), "armNote")
        write = tr("&Write {0:g} s and arm").format(Number(seconds))
        self._choices = (
            button(self, "writeAndArmButton", write, default=True, on_click=self._on_write),
            button(self, "armWithoutButton", tr("Arm with&out"), on_click=self._on_without),
        )
        cancel = button(self, "cancelArmButton", tr("Cancel"), on_click=self.close)
        column(
            label(self, "armWarning", text, wrap=True),
            label(self, text=remark, wrap=True),
            self._note,
            row(1, *self._choices, cancel),
            into=self,
        )
        self._choices[0].setFocus()
        if (layout := self.layout()) is not None:
            self.resize(_WIDTH, layout.totalHeightForWidth(_WIDTH))

        device.applied.connect(self._on_applied)
        device.request_failed.connect(self._on_failed)
        for lost in (device.connection.line_closed, device.connection.not_responding):
            lost.connect(self.close)

    @Slot()
    def _on_write(self) -> None:
        self._set_writing(True)
        self._note.show_note(tr("Writing …"))
        self._device.writer.set_serial_timeout(self._seconds)

    @Slot()
    def _on_without(self) -> None:
        self._device.motors.remember_arming_without_timeout()
        self._device.motors.arm()
        self.close()

    @Slot()
    def _on_applied(self) -> None:
        if not self.isVisible():
            return
        if not self._device.board.timeout_stop.may_be_mended:
            self._device.motors.arm()
            self.close()
        else:
            self._on_failed(tr("The board did not store the serial timeout."))

    @Slot(str)
    def _on_failed(self, reason: str) -> None:
        self._set_writing(False)
        self._note.show_note(reason, alarming=True)

    def _set_writing(self, writing: bool) -> None:
        for choice in self._choices:
            choice.setEnabled(not writing)
