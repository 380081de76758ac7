"""Gamepad panel: switch, selection, set-up and state."""

from PySide6.QtCore import QEvent, QSignalBlocker, Qt, Slot
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.gamepad import Gamepad
from trex_gui.devices.trex.views.pages.motors.gamepad_dialog import GamepadDialog
from trex_gui.gamepad.pads import SdlPads
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Note


class GamepadPanel(QWidget):
    """Panel of a gamepad. The gamepad drives only while the panel is visible."""

    def __init__(self, device: Device, parent: QWidget, *, source: SdlPads | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("gamepadPanel")
        self.gamepad = Gamepad(device, source or SdlPads(), self)
        self._dialog: GamepadDialog | None = None

        text, accessible = tr("&Gamepad"), tr("Drive with a gamepad")
        self._on = ui.check_box(self, "gamepadBox", text, accessible=accessible)
        title = title_of(text)
        self._pads = ui.combo_box(self, "gamepadCombo", title, tip=title)
        policy = self._pads.SizeAdjustPolicy
        self._pads.setSizeAdjustPolicy(policy.AdjustToMinimumContentsLengthWithIcon)
        self._pads.setMinimumContentsLength(12)
        text, accessible = tr("Set &up…"), tr("Set up the gamepad")
        self._set_up = ui.button(self, "gamepadSetUpButton", text, accessible=accessible)
        self._state = ui.named(Note(0, self), "gamepadState")
        flags = Qt.TextInteractionFlag
        self._state.setTextInteractionFlags(
            flags.TextSelectableByMouse | flags.TextSelectableByKeyboard
        )
        self._unfocused = ui.check_box(
            self,
            "gamepadUnfocusedBox",
            tr("Stop when behi&nd another window"),
            accessible=tr(
                "Stop the motors that the gamepad drives when the window loses the focus"
            ),
            checked=self.gamepad.stops_unfocused,
            on_toggle=self.gamepad.set_stops_unfocused,
        )

        pad = ui.row((self._pads, 1), self._set_up)
        ui.column(self._on, pad, self._state, self._unfocused, into=self, margins=0, spacing=6)

        gamepad = self.gamepad
        self._on.toggled.connect(lambda on: gamepad.switch_on() if on else gamepad.switch_off())
        self._pads.activated.connect(lambda index: gamepad.select(gamepad.pads[index]))
        self._set_up.clicked.connect(self._on_set_up_clicked)
        gamepad.changed.connect(self._on_gamepad_changed)
        app = QGuiApplication.instance()
        if isinstance(app, QGuiApplication):
            app.focusWindowChanged.connect(self._update_blocker)
            app.applicationStateChanged.connect(self._update_blocker)
        self._on_gamepad_changed()

    @Slot()
    def _on_set_up_clicked(self) -> None:
        if self._dialog is None:
            self._dialog = GamepadDialog(self.gamepad, self)
            self._dialog.finished.connect(self._update_blocker)
        self._dialog.show_in_front()
        self._update_blocker()

    @Slot()
    def _on_gamepad_changed(self) -> None:
        gamepad = self.gamepad
        with QSignalBlocker(self._on):
            self._on.setChecked(gamepad.is_on)
        pads = gamepad.pads
        names = [pad.name for pad in pads]
        if names != [self._pads.itemText(index) for index in range(self._pads.count())]:
            self._pads.clear()
            self._pads.addItems(names)
        if gamepad.pad is not None:
            self._pads.setCurrentIndex(pads.index(gamepad.pad))
        self._pads.setEnabled(bool(pads))
        self._set_up.setEnabled(gamepad.pad is not None)
        for widget in (self._pads, self._set_up, self._unfocused):
            widget.setVisible(gamepad.is_on)
        self._state.show_note(gamepad.text, alarming=bool(gamepad.failure or gamepad.lost_pad))
        self._state.setAccessibleName(gamepad.text or title_of(tr("&Gamepad")))
        self._update_blocker()

    def event(self, event: QEvent) -> bool:
        handled = super().event(event)
        if event.type() in {QEvent.Type.Show, QEvent.Type.Hide}:
            self._update_blocker()
        return handled

    @Slot()
    def _update_blocker(self) -> None:
        self.gamepad.set_unattended(self._blocker())

    def _blocker(self) -> str:
        if self._dialog is not None and self._dialog.isVisible():
            return tr("The gamepad is being set up and cannot drive.")
        if not self.isVisible():
            return tr("The gamepad drives only while the Motors page is open.")
        if self.gamepad.stops_unfocused and not self.isActiveWindow():
            return tr("Another window is in front, so the gamepad cannot drive.")
        return ""
