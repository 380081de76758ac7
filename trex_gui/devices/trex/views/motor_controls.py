"""Stop and arm buttons, the bar that contains them, and the dialog before arming."""

from collections.abc import Iterable

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QDialog, QFrame, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.board.drive_status import DriveStatus, drive_statuses
from trex_gui.devices.trex.driving.blockers import DriveBlocker
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import drive_inputs, fault_text
from trex_gui.devices.trex.model.drive_texts import timeout_warning
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.theme.theme import set_look, set_style_property
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import ConfirmButton, RedButton, reserve_space
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.messages import ActionBar

_ARM_DIALOG_WIDTH = 480  # pixels
_ARROWS = {Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Down}


def arm(device: Device, window: QWidget) -> None:
    """Arm the motors. Prompt first if a real board needs a serial timeout."""
    motors, warning = device.motors, timeout_warning(device)
    if device.board.other_driver:
        motors.arm()  # this only requests permission to drive
        return
    is_real = device.settings is not None and not device.settings.name
    lacks_stop = device.board.timeout_stop.is_fixable
    can_offer = is_real and lacks_stop and motors.can_arm and not device.writer.is_rejected
    if can_offer and warning and warning.seconds and not motors.arms_without_timeout:
        ArmDialog(device, warning.text, warning.seconds, window).open()
    else:
        motors.arm()


class ArmDialog(QDialog):
    def __init__(self, device: Device, text: str, seconds: float, parent: QWidget) -> None:
        """Propose a timeout of `seconds`. `text` is the warning."""
        super().__init__(parent)
        self.setObjectName("armDialog")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Arm the motors"))
        self._device, self._seconds = device, seconds
        remark = tr(
            "Arming without a timeout is remembered for this board. If the cable falls out, cut "
            "the power by hand."
        )
        self._note = ui.named(Note(1, self), "armNote")
        write = tr("&Write {0:g} s and arm").format(Number(seconds))
        without = tr("Arm with&out a timeout")
        self._choices = (
            ui.button(self, "writeAndArmButton", write, default=True, on_click=self._on_write),
            ui.button(self, "armWithoutButton", without, on_click=self._on_without),
        )
        cancel = ui.button(self, "cancelArmButton", tr("Cancel"), on_click=self.close)
        warning = ui.label(self, "armWarning", text, wrap=True)
        about = ui.label(self, text=remark, wrap=True)
        ui.column(warning, about, self._note, ui.row(1, *self._choices, cancel), into=self)
        self._choices[0].setFocus()
        if (layout := self.layout()) is not None:
            self.resize(_ARM_DIALOG_WIDTH, layout.totalHeightForWidth(_ARM_DIALOG_WIDTH))

        device.applied.connect(self._on_applied)
        device.request_failed.connect(self._show_state)
        for lost in (device.connection.line_closed, device.connection.not_responding):
            lost.connect(self.close)

    @Slot()
    def _on_write(self) -> None:
        self._show_state(tr("Writing …"), is_writing=True)
        self._device.writer.set_serial_timeout(self._seconds)

    @Slot()
    def _on_without(self) -> None:
        self._device.motors.accept_arming_without_timeout()
        self._device.motors.arm()
        self.close()

    @Slot()
    def _on_applied(self) -> None:
        if not self.isVisible():
            return
        if self._device.board.timeout_stop.is_fixable:
            self._show_state(tr("The board did not store the serial timeout."))
        else:
            self._device.motors.arm()
            self.close()

    @Slot(str)
    def _show_state(self, text: str, *, is_writing: bool = False) -> None:
        self._note.show_note(text, alarming=not is_writing)
        for choice in self._choices:
            choice.setEnabled(not is_writing)


class TimeoutNotice(QWidget):
    def __init__(self, device: Device, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("timeoutNotice")
        self._device = device
        self._seconds: float | None = None  # proposed timeout
        self._text = ui.named(Note(3, self), "timeoutLabel")
        self._button = ui.button(self, "timeoutButton", on_click=self._on_clicked)
        reserve_space(self._button)
        ui.column(
            (self._text, 1), (self._button, 0, Qt.AlignmentFlag.AlignLeft), into=self, margins=0
        )
        guardian_changed = device.connection.guardian_changed
        for changed in (device.link_changed, device.state_changed, guardian_changed):
            changed.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        warning = timeout_warning(self._device)
        self._button.setEnabled(not self._device.writer.running)
        self._seconds = seconds = None if warning is None else warning.seconds
        can_write = seconds is not None and not self._device.writer.is_rejected
        self._button.setVisible(can_write)
        text = self._device.board.silence_remedy if warning is None else warning.text
        self._text.show_note(text, alarming=warning is not None)
        number = f"{Number(seconds or 0):g}"  # 0 while the button is hidden
        self._button.setText(tr("Write &{0} s").format(number))
        tip = tr(
            "Writes Serial Timeout and UART-Error Shutdown now: the board should stop its "
            "motors {0} s after the last byte. Other changes stay pending."
        )
        self._button.setToolTip(ui.plain(tip.format(number)))

    @Slot()
    def _on_clicked(self) -> None:
        if self._seconds is not None:
            self._device.writer.set_serial_timeout(self._seconds)


class LostPanel(QFrame):
    """Panel that is visible while motors may be turning and the board is out of reach."""

    def __init__(self, device: Device, name: str, parent: QWidget) -> None:
        super().__init__(parent)
        self._device = device
        set_look(self, "message")
        set_style_property(self, "danger", True)
        set_style_property(self, "large", True)
        center = Qt.AlignmentFlag.AlignCenter
        self._text = ui.label(self, name, wrap=True, size="heading")
        self._text.setAlignment(center)
        text, press = tr("Reconnect and stop"), device.press_stop
        self._button = ui.button(self, "reconnectAndStop", text, default=False, on_click=press)
        parts = 1, self._text, (self._button, 0, center), 1
        ui.column(*parts, into=self, margins=24, spacing=16)
        self.hide()

    def show_loss(self, text: str) -> bool:
        """Show `text` and return true if motors may be turning and the board is out of reach."""
        device = self._device
        is_lost = device.stop_may_matter and not device.is_connected
        if is_lost:
            self._text.setText(text)
        can_reconnect = is_lost and device.link is ConnectionState.DISCONNECTED
        changes = can_reconnect != self._button.isEnabled()
        if changes and self._button.hasFocus():
            focus_stop(self)
        self._button.setEnabled(can_reconnect)
        self.setVisible(is_lost)
        if changes and can_reconnect and self.isVisible():
            self._button.setFocus()
        return is_lost


class StopButton(RedButton):
    """Stop button for any window. Esc also stops the motors."""

    def __init__(self, device: Device, name: str) -> None:
        super().__init__(name, title_of(tr("&Stop motors")), device.press_stop, None)
        self.setToolTip(tr("Stop both motors and the auxiliary now (Esc, anywhere)"))
        self._device = device
        device.link_changed.connect(self._on_link_changed)
        self._on_link_changed()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Discard arrow keys. Qt would move the focus, and the next key could drive a motor."""
        if event.key() not in _ARROWS:
            super().keyPressEvent(event)

    @Slot()
    def _on_link_changed(self) -> None:
        inactive = {ConnectionState.DISCONNECTED, ConnectionState.DISCONNECTING}
        self.setEnabled(self._device.link not in inactive or self._device.stop_may_matter)


def focus_stop(widget: QWidget) -> None:
    """Focus the stop button. Otherwise arrow keys could change the next field."""
    window = widget.window()
    for stop in window.findChildren(StopButton):
        if stop.window() is window:
            stop.setFocus()


class MotorBar(ActionBar):
    """Bar with the stop button. The bar is amber while motors are armed."""

    def __init__(self, device: Device, stop_name: str, parent: QWidget) -> None:
        super().__init__(StopButton(device, stop_name), parent)
        self._motors = device.motors
        self.armed = ui.label(self, "armedLabel", tr("Armed"), bold=True)
        self._motors.arming_changed.connect(self._show_armed)
        self._show_armed()

    @Slot()
    def _show_armed(self) -> None:
        set_style_property(self, "armed", self._motors.armed)
        self.armed.setVisible(self._motors.armed)


class ArmButton(ConfirmButton):
    """Button that arms and disarms the motors. Unlike Stop, disarming does not lock them out."""

    def __init__(self, device: Device, name: str, parent: QWidget) -> None:
        super().__init__("", parent)
        self._device = device
        self._motors = motors = device.motors
        ui.named(self, name)
        self.clicked.connect(self._on_clicked)
        motors.arming_changed.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_clicked(self) -> None:
        if self._motors.armed:
            self._motors.stop()
            focus_stop(self)
        elif self.accepts_clicks:  # false for a short time after disarming
            arm(self._device, self.window())

    @Slot()
    def _on_changed(self) -> None:
        armed = self._motors.armed
        if armed and self.window().focusWidget() is self:  # also true while a dialog has the focus
            focus_stop(self)
        text = tr("Disa&rm") if armed else tr("A&rm motors")
        if text != self.text():
            self.setText(text)
            self.setDown(False)  # the button under the mouse now has another effect
            self.hold_off()
        tip = tr("Stops the motors and sends them no command until they are armed again")
        if not armed:
            tip = tr("Allows both motors and the auxiliary to be driven. Nothing moves yet")
        self.setToolTip(tip)
        self.setAccessibleDescription(tip)
        self.setEnabled(armed or self._motors.can_arm)


_MANY_CHANGES = 88  # number of changes with the longest text


def apply_text(pending: int) -> str:
    return tr("Review %n ch&ange(s)…", "", pending) if pending else tr("No ch&anges")


class ControlBar(MotorBar):
    apply_requested = Signal()

    _page_shows_state = True  # the window opens on the board page

    def __init__(self, device: Device, recording: QWidget, parent: QWidget) -> None:
        super().__init__(device, "stopButton", parent)
        self._device = device

        stop, arm_button = self.stop, ArmButton(device, "runButton", self)
        self._state = ui.named(Note(1, self), "motorStateLabel")
        self._state.setAlignment(Qt.AlignmentFlag.AlignVCenter)
        reserve_space(self._state)
        tip = tr("Write the changed parameters into the board (Ctrl+Enter)")
        text = apply_text(_MANY_CHANGES)
        self._apply = ui.button(self, "applyButton", text, tip=tip, default=False)
        ui.set_large(stop, arm_button, self._apply)
        self._apply.setMinimumWidth(self._apply.sizeHint().width())

        self.fill(arm_button, self.armed, (self._state, 1), recording, self._apply)

        self._apply.clicked.connect(self.apply_requested)
        motors = device.motors
        for signal in (
            device.link_changed,
            device.notifier.shown_changed,
            device.draft.pending_changed,
            device.errors_changed,
            device.telemetry.text_due,  # a fault may have ended
            motors.arming_changed,
            motors.setpoints_changed,
        ):
            signal.connect(self._on_changed)
        self._on_changed()

    @Slot(str)
    def set_page(self, key: str) -> None:
        """Hide the motor state if the page header already shows it."""
        self._page_shows_state = key in {"board", "motors"}
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        motors, pending = self._device.motors, self._device.draft.pending
        statuses = drive_statuses(drive_inputs(self._device))
        fault = fault_text(statuses)
        may_matter = self._device.stop_may_matter
        alarming = bool(fault) or motors.armed or may_matter or self._stop_has_no_effect
        self._state.show_note(
            " ".join(filter(None, (fault, self._state_text(statuses)))),
            alarming=alarming,
            color="danger" if self._is_out_of_reach else "warning",
        )
        # The page describes the connected board, not a board that was lost earlier.
        on_page = self._page_shows_state and not self._device.driving.lost_board
        is_shown = on_page or self._state.text() in self._device.notifier.shown
        self._state.setVisible(motors.armed or self._stop_has_no_effect or not is_shown)
        self._apply.setText(apply_text(pending))
        set_look(self._apply, "primary" if pending else "")
        self._apply.setEnabled(pending > 0 and self._device.writer.can_apply)

    @property
    def _is_out_of_reach(self) -> bool:
        """True if motors may be turning and cannot be stopped."""
        reached = {ConnectionState.CONNECTED, ConnectionState.DISCONNECTING}
        return self._device.stop_may_matter and self._device.link not in reached

    @property
    def _stop_has_no_effect(self) -> bool:
        """True if the user pressed Stop while channels control the motors."""
        motors = self._device.motors
        is_locked_out = not motors.is_available and not self._device.driving.reaches_several
        return self._device.is_connected and is_locked_out and motors.locked_for > 0

    def _state_text(self, statuses: Iterable[DriveStatus]) -> str:
        """Return the state of the motors, or the first status other than a fault."""
        device, motors = self._device, self._device.motors
        if motors.armed:
            return motors.text
        if self._is_out_of_reach and device.may_move:
            return device.loss_text
        if device.driving.lost_board:
            return device.driving.lost_board
        if self._stop_has_no_effect:
            return tr("Channels control the motors: Stop does not affect them.")
        texts = (status.text for status in statuses if status.blocker is not DriveBlocker.FAULT)
        return next(texts, "")
