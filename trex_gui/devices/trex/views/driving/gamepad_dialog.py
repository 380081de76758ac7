"""Setting a gamepad up: what its sticks and buttons are for, with what it shows beside it."""

from functools import partial

from PySide6.QtCore import QSignalBlocker, Slot
from PySide6.QtGui import QHideEvent
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QGroupBox,
    QLabel,
    QSpinBox,
    QWidget,
)

from trex_gui.devices.trex.model.gamepad import Gamepad, axis_text, button_text
from trex_gui.devices.trex.model.motors import mix
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.views.driving.gamepad_parts import GamepadLive, PartBar, PartRow
from trex_gui.gamepad.pads import Pad
from trex_gui.gamepad.profile import (
    WIDEST_DEAD_ZONE,
    GamepadProfile,
    InputDetector,
    Style,
    default_profile,
)
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Note


class GamepadDialog(QDialog):
    """Beside the window; what is chosen counts at once and is remembered for this kind.

    Whoever shows it sees to it that the gamepad drives nothing meanwhile.
    """

    def __init__(self, gamepad: Gamepad, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("gamepadDialog")
        self.setWindowTitle(self.tr("Set up the gamepad"))
        self._gamepad = gamepad
        self._detection: InputDetector | None = None
        self._detecting = ""

        self._name = ui.label(self, "gamepadName")
        self._live = GamepadLive(self)
        uses = QGroupBox(self.tr("What it is for"), self)
        self._style = ui.combo_box(
            uses,
            "gamepadStyleCombo",
            self.tr("How two axes drive two motors"),
            on_activate=self._on_edited,
        )
        self._style.addItem(self.tr("One axis drives, one turns"), Style.MIXED)
        self._style.addItem(self.tr("An axis for each motor"), Style.TANK)
        move, press = self.tr("Move it…"), self.tr("Press it…")
        self._rows = {
            "first": PartRow("First", "", move, uses, inverts=True),
            "second": PartRow("Second", "", move, uses, inverts=True),
            "hold": PartRow("Hold", self.tr("Button to hold while driving"), press, uses),
            "stop": PartRow("Stop", self.tr("Button that stops everything"), press, uses),
        }
        self._labels = {name: QLabel(uses) for name in self._rows}
        self._labels["hold"].setText(self.tr("Hold to drive:"))
        self._labels["stop"].setText(self.tr("Stops everything:"))
        self._dead_zone = _percent("gamepadDeadZoneSpin", round(100 * WIDEST_DEAD_ZONE), uses)
        self._dead_zone.setAccessibleName(self.tr("Dead zone, per cent of the way"))
        self._dead_zone.setToolTip(self.tr("How far from its middle an axis counts for nothing"))
        self._expo = _percent("gamepadExpoSpin", 100, uses)
        self._expo.setAccessibleName(self.tr("Finer in the middle, per cent"))
        self._expo.setToolTip(self.tr("0 %: in proportion. 100 %: slow in the middle (the cube)"))
        self._motors = (PartBar(self.tr("Motor 1"), uses), PartBar(self.tr("Motor 2"), uses))
        for number, bar in enumerate(self._motors, 1):
            bar.setObjectName(f"gamepadMotor{number}Bar")
        self._note = ui.named(Note(2, self), "gamepadSetUpNote")
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.RestoreDefaults | QDialogButtonBox.StandardButton.Close,
            self,
        )
        self._defaults = buttons.button(QDialogButtonBox.StandardButton.RestoreDefaults)
        self._defaults.setObjectName("gamepadDefaultsButton")
        self._defaults.setAutoDefault(False)
        buttons.button(QDialogButtonBox.StandardButton.Close).setObjectName("gamepadCloseButton")

        form = QFormLayout(uses)
        form.addRow(self.tr("Sticks:"), self._style)
        for name in ("first", "second"):
            form.addRow(self._labels[name], self._rows[name])
        form.addRow(self.tr("Dead zone:"), self._dead_zone)
        form.addRow(self.tr("Finer in the middle:"), self._expo)
        for name in ("hold", "stop"):
            form.addRow(self._labels[name], self._rows[name])
        form.addRow(self.tr("Setpoints:"), self._motors[0])
        form.addRow("", self._motors[1])
        halves = ui.row((self._live, 2), (uses, 3))
        ui.column(self._name, (halves, 1), self._note, buttons, into=self)

        self._dead_zone.valueChanged.connect(self._on_edited)
        self._expo.valueChanged.connect(self._on_edited)
        for name, row in self._rows.items():
            row.chosen.connect(self._on_edited)
            row.detect_toggled.connect(partial(self._on_detect_toggled, name))
        self._defaults.clicked.connect(self._on_defaults_clicked)
        buttons.rejected.connect(self.reject)
        gamepad.changed.connect(self._on_gamepad_changed)
        gamepad.moved.connect(self._on_gamepad_moved)
        self._on_gamepad_changed()
        self._on_gamepad_moved()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._detect("")

    # --- User actions -------------------------------------------------------------------

    @Slot()
    def _on_edited(self) -> None:
        hold, stop = self._rows["hold"].number, self._rows["stop"].number
        before = self._gamepad.profile
        if hold is not None and hold == stop:  # the button that was chosen last has one use
            hold, stop = (None, stop) if stop != before.stop else (hold, None)
        self._detect("")
        self._gamepad.set_profile(
            GamepadProfile(
                style=Style(self._style.currentData()),
                first=self._rows["first"].axis,
                second=self._rows["second"].axis,
                dead_zone=self._dead_zone.value() / 100,
                expo=self._expo.value() / 100,
                hold=hold,
                stop=stop,
            )
        )
        self._on_gamepad_changed()

    @Slot()
    def _on_defaults_clicked(self) -> None:
        self._detect("")
        if self._gamepad.pad is not None:
            self._gamepad.set_profile(default_profile(self._gamepad.pad))

    def _on_detect_toggled(self, name: str, detecting: bool) -> None:
        self._detect(name if detecting else "")

    # --- Finding a part by moving it ----------------------------------------------------

    def _detect(self, name: str) -> None:
        """Look for the part that is moved from now on; empty: do not look any more."""
        state = self._gamepad.state
        self._detecting = name if state is not None else ""
        self._detection = InputDetector(state) if name and state is not None else None
        for each, row in self._rows.items():
            row.show_detecting(detecting=each == self._detecting)
        self._show_note()

    def _look(self, detection: InputDetector) -> None:
        state, name = self._gamepad.state, self._detecting
        if state is None:
            return
        if name in {"first", "second"}:
            axis = detection.axis(state)
            if axis is not None:
                self._rows[name].show_part(axis.number, inverted=axis.inverted)
                self._on_edited()
        else:
            button = detection.button(state)
            if button is not None:
                self._rows[name].show_part(button)
                self._on_edited()

    # --- What is shown ------------------------------------------------------------------

    @Slot()
    def _on_gamepad_changed(self) -> None:
        pad, profile = self._gamepad.pad, self._gamepad.profile
        self._live.show_pad(pad)
        self._name.setText(pad.name if pad is not None else self.tr("No gamepad is there."))
        for widget in (*self._rows.values(), self._style, self._dead_zone, self._expo):
            widget.setEnabled(pad is not None)
        self._defaults.setEnabled(pad is not None and profile != default_profile(pad))
        if pad is None:
            self._detect("")
        else:
            self._show_profile(pad, profile)
        self._show_note()

    def _show_profile(self, pad: Pad, profile: GamepadProfile) -> None:
        tank = profile.style is Style.TANK
        uses = {
            "first": self.tr("Left motor") if tank else self.tr("Forward"),
            "second": self.tr("Right motor") if tank else self.tr("Turn"),
        }
        axes: list[tuple[str, int | None]] = [
            (axis_text(pad, number), number) for number in range(pad.axes)
        ]
        buttons: list[tuple[str, int | None]] = [
            (button_text(pad, number), number) for number in range(pad.buttons)
        ]
        for name, use in uses.items():
            axis = profile.first if name == "first" else profile.second
            self._labels[name].setText(f"{use}:")
            self._rows[name].set_spoken(use)
            self._rows[name].set_parts(axes)
            self._rows[name].show_part(axis.number, inverted=axis.inverted)
        self._rows["hold"].set_parts(
            [(self.tr("none: a stick that is moved drives"), None), *buttons]
        )
        self._rows["hold"].show_part(profile.hold)
        self._rows["stop"].set_parts([(self.tr("none"), None), *buttons])
        self._rows["stop"].show_part(profile.stop)
        self._style.setCurrentIndex(self._style.findData(profile.style))
        for spin, part in ((self._dead_zone, profile.dead_zone), (self._expo, profile.expo)):
            with QSignalBlocker(spin):
                spin.setValue(round(100 * part))

    @Slot()
    def _on_gamepad_moved(self) -> None:
        if self._detection is not None:
            self._look(self._detection)
        if self.isVisible():
            state, ask = self._gamepad.state, self._gamepad.ask
            self._live.show_state(state)
            for bar, speed in zip(self._motors, mix(ask.forward, ask.turn), strict=True):
                bar.set_part(None if state is None else speed / FULL_SCALE)

    def _show_note(self) -> None:
        text = self._prompt()
        self._note.show_note(text, alarming=bool(self._detecting))
        self._note.setAccessibleName(text)

    def _prompt(self) -> str:
        profile = self._gamepad.profile
        tank = profile.style is Style.TANK
        match self._detecting:
            case "first" if tank:
                return self.tr("Move the stick for the left motor forward, as far as it goes.")
            case "second" if tank:
                return self.tr("Move the stick for the right motor forward, as far as it goes.")
            case "first":
                return self.tr("Move the stick that shall drive forward, as far as it goes.")
            case "second":
                return self.tr("Move the stick that shall turn to the right, as far as it goes.")
            case "hold":
                return self.tr("Press the button that shall be held while driving.")
            case "stop":
                return self.tr("Press the button that shall stop everything.")
        if profile.hold is None:
            return self.tr(
                "Without a button to hold, a stick that is bumped drives the motors. "
                "Nothing drives while this window is open."
            )
        return self.tr("Nothing drives while this window is open. The stop button stops always.")


def _percent(name: str, most: int, parent: QWidget) -> QSpinBox:
    spin = QSpinBox(parent)
    spin.setObjectName(name)
    spin.setRange(0, most)
    spin.setSuffix(" %")
    spin.setKeyboardTracking(False)
    return spin
