"""Dialog that sets up a gamepad: assignment of axes and buttons, and their live state."""

from functools import partial

from PySide6.QtCore import QSignalBlocker, Qt, Signal, Slot
from PySide6.QtWidgets import QDialogButtonBox, QFormLayout, QWidget

from trex_gui.core.texts import signed_text, title_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.gamepad import Gamepad, axis_text, button_text
from trex_gui.devices.trex.model.momentary_drive import mix
from trex_gui.devices.trex.model.setup.wiring import Side
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.views.robot_view import RobotView
from trex_gui.gamepad.pads import Pad, PadState
from trex_gui.gamepad.profile import MAX_DEAD_ZONE, Axis, GamepadProfile, Style, default_profile
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.bar import NO_VALUE
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.labels import LiveLabel, Note
from trex_gui.ui.widgets.leds import Lamp

_LAMPS_PER_ROW = 6
_AXES = "first", "second"  # keys of the rows for axes; the other rows are for buttons


def _axis_names(pad: Pad | None) -> list[str]:
    return [axis_text(pad, number) for number in range(pad.axes)] if pad else []


def _button_names(pad: Pad | None) -> list[str]:
    return [button_text(pad, number) for number in range(pad.buttons)] if pad else []


class PadView(QWidget):
    def __init__(self, pad: Pad | None, parent: QWidget | None) -> None:
        super().__init__(parent)
        self.pad = pad
        axes = ui.grid(stretch=[(1, 1)])
        for number, name in enumerate(_axis_names(pad)):
            axes.addWidget(ui.label(self, text=name), number, 0)
            axes.addWidget(LiveLabel(f"gamepadAxisValue{number}", name, self), number, 1)
        buttons = ui.grid(spacing=(12, -1))
        buttons.setAlignment(Qt.AlignmentFlag.AlignLeft)
        for number, name in enumerate(_button_names(pad)):
            lamp = ui.named(Lamp("led_green", self), f"gamepadLamp{number}", accessible=name)
            label = ui.label(self, text=str(number + 1))
            for widget in (lamp, label):
                widget.setToolTip(ui.plain(name))
            cell = ui.row(lamp, (label, 1), spacing=4)
            buttons.addLayout(cell, number // _LAMPS_PER_ROW, number % _LAMPS_PER_ROW)
        ui.column(axes, buttons, into=self, margins=0, spacing=14)

    def show_state(self, state: PadState | None) -> None:
        for number, value in enumerate(self.findChildren(LiveLabel)):
            percent = None if state is None else round(100 * state.axis(number))
            value.setText(NO_VALUE if percent is None else f"{signed_text(percent)} %")
        for number, lamp in enumerate(self.findChildren(Lamp)):
            lamp.set_lit(state is not None and state.is_pressed(number))
            lamp.setAccessibleDescription(tr("pressed") if lamp.lit else "")


class AssignmentRow(QWidget):
    """Row that assigns an axis or a button of the gamepad to a function."""

    chosen = Signal()  # the user has selected an axis, its direction or a button

    def __init__(self, name: str, parent: QWidget, *, is_axis: bool) -> None:
        super().__init__(parent)
        self._combo = ui.combo_box(self, f"gamepad{name}Combo", "", on_activate=self.chosen)
        self.label = ui.label(parent, buddy=self._combo)
        self._combo.setSizeAdjustPolicy(self._combo.SizeAdjustPolicy.AdjustToContents)
        check_box = partial(ui.check_box, self, on_toggle=self.chosen)
        self._invert = check_box(f"gamepad{name}Invert", tr("Invert"))
        self._invert.setVisible(is_axis)
        self.setFocusProxy(self._combo)
        ui.row((self._combo, 1), self._invert, into=self, margins=0)

    def set_function(self, title: str) -> None:
        self.label.setText(tr("{0}: {1}").format(title, "").rstrip())
        name = title.replace("&", "")
        self._combo.setAccessibleName(name)
        self._invert.setAccessibleName(tr("{0}: inverted").format(name))

    def set_inputs(self, names: list[str], none_text: str = "") -> None:
        """List the names of axes or buttons. `none_text` is the item for no selection."""
        items: list[tuple[str, int | None]] = [(none_text, None)] if none_text else []
        items += [(name, number) for number, name in enumerate(names)]
        shown = [self._combo.itemText(row) for row in range(self._combo.count())]
        if shown != [text for text, _ in items]:
            self._combo.clear()
            for item in items:
                self._combo.addItem(*item)

    @property
    def number(self) -> int | None:
        number = self._combo.currentData()
        return number if isinstance(number, int) else None

    @property
    def axis(self) -> Axis:
        return Axis(self.number or 0, self._invert.isChecked())

    def show_input(self, number: int | None, *, inverted: bool = False) -> None:
        """Show the selected axis or button without emitting `chosen`."""
        numbers = [self._combo.itemData(row) for row in range(self._combo.count())]
        self._combo.setCurrentIndex(numbers.index(number) if number in numbers else -1)
        with QSignalBlocker(self._invert):
            self._invert.setChecked(inverted)


class GamepadDialog(ReusedDialog):
    """Dialog that applies changes at once. The owner prevents driving while the dialog is open."""

    def __init__(self, gamepad: Gamepad, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("gamepadDialog")
        self.setWindowTitle(tr("Set up the gamepad"))
        self._gamepad = gamepad
        self._name = ui.label(self, "gamepadName")
        live = ui.named(ui.Card(tr("Live state"), self), "gamepadLive")
        self._live = PadView(None, live)
        self._robot = RobotView(live)
        self._live_layout = ui.column(self._live, (self._robot, 1), into=live)
        uses = ui.Card(tr("Assignment"), self)
        mixed, tank = tr("One axis drives, the other turns"), tr("One axis for each motor")
        self._style = ui.combo_box(
            uses,
            "gamepadStyleCombo",
            title_of(tr("St&icks:")),
            items=[(mixed, Style.MIXED), (tank, Style.TANK)],
            on_activate=self._on_edited,
        )
        self._rows = {
            key: AssignmentRow(key.capitalize(), uses, is_axis=key in _AXES)
            for key in (*_AXES, "hold", "stop")
        }
        self._rows["hold"].set_function(tr("&Hold to drive"))
        self._rows["stop"].set_function(tr("&Stop everything"))
        percent = partial(ui.spin_box, uses, lowest=0, suffix=" %", on_change=self._on_edited)
        self._dead_zone = percent(
            "gamepadDeadZoneSpin",
            title_of(tr("&Dead zone:")),
            highest=round(100 * MAX_DEAD_ZONE),
            tip=tr("Travel around the centre that has no effect"),
        )
        self._expo = percent(
            "gamepadExpoSpin",
            title_of(tr("&Expo:")),
            highest=100,
            tip=tr("0 %: linear. 100 %: cubic, finest around the centre"),
        )
        self._note = ui.named(Note(2, self), "gamepadSetUpNote")
        standard = QDialogButtonBox.StandardButton
        buttons = QDialogButtonBox(standard.RestoreDefaults | standard.Close, self)
        ui.named(buttons.button(standard.Close), "gamepadCloseButton")
        self._defaults = ui.named(buttons.button(standard.RestoreDefaults), "gamepadDefaultsButton")
        self._defaults.setText(tr("&Restore defaults"))
        self._defaults.setAutoDefault(False)

        self._lay_out_assignment(uses)
        halves = ui.row((live, 2), (uses, 3))
        ui.column(self._name, (halves, 1), self._note, buttons, into=self)

        for row in self._rows.values():
            row.chosen.connect(self._on_edited)
        self._defaults.clicked.connect(self._on_defaults_clicked)
        buttons.rejected.connect(self.reject)
        gamepad.changed.connect(self._on_gamepad_changed)
        gamepad.moved.connect(self._on_gamepad_moved)
        self._on_gamepad_changed()
        self._on_gamepad_moved()

    def _lay_out_assignment(self, uses: ui.Card) -> None:
        form = QFormLayout(uses)
        first, second, *buttons = self._rows.values()
        form.addRow(tr("St&icks:"), self._style)
        for row in (first, second):
            form.addRow(row.label, row)
        form.addRow(tr("&Dead zone:"), self._dead_zone)
        form.addRow(tr("&Expo:"), self._expo)
        for row in buttons:
            form.addRow(row.label, row)
        ui.tab_order(self._style, first, second, self._dead_zone, self._expo, *buttons)

    @Slot()
    def _on_edited(self) -> None:
        hold, stop = self._rows["hold"].number, self._rows["stop"].number
        if hold is not None and hold == stop:  # only the new assignment of the button remains
            hold, stop = (None, stop) if stop != self._gamepad.profile.stop else (hold, None)
        profile = GamepadProfile(
            style=Style(self._style.currentData()),
            first=self._rows["first"].axis,
            second=self._rows["second"].axis,
            dead_zone=self._dead_zone.value() / 100,
            expo=self._expo.value() / 100,
            hold=hold,
            stop=stop,
        )
        self._gamepad.set_profile(profile)
        self._on_gamepad_changed()

    @Slot()
    def _on_defaults_clicked(self) -> None:
        if self._gamepad.pad is not None:
            self._gamepad.set_profile(default_profile(self._gamepad.pad))

    @Slot()
    def _on_gamepad_changed(self) -> None:
        pad, profile = self._gamepad.pad, self._gamepad.profile
        is_tank = profile.style is Style.TANK
        self._rows["first"].set_function(tr("&Left motor") if is_tank else tr("&Forward"))
        self._rows["second"].set_function(tr("Right &motor") if is_tank else tr("&Turn"))
        if pad != self._live.pad:
            old, self._live = self._live, PadView(pad, self._live.parentWidget())
            self._live_layout.replaceWidget(old, self._live)
            old.hide()
            old.deleteLater()
            self._live.show()
        absent = tr("No gamepad is connected. Plug in or switch on a gamepad.")
        self._name.setText(absent if pad is None else pad.name)
        for widget in (*self._rows.values(), self._style, self._dead_zone, self._expo):
            widget.setEnabled(pad is not None)
        self._defaults.setEnabled(pad is not None and profile != default_profile(pad))
        if pad is not None:
            self._show_profile(pad, profile)
        text = tr("The gamepad cannot drive while this window is open, but its stop button works.")
        if profile.hold is None:
            text = tr(
                "Without a hold button, bumping a stick drives the motors. The gamepad "
                "cannot drive while this window is open."
            )
        self._note.show_note(text)
        self._note.setAccessibleName(text)

    def _show_profile(self, pad: Pad, profile: GamepadProfile) -> None:
        first, second, hold, stop = self._rows.values()
        for row, axis in ((first, profile.first), (second, profile.second)):
            row.set_inputs(_axis_names(pad))
            row.show_input(axis.number, inverted=axis.inverted)
        hold.set_inputs(_button_names(pad), tr("none: moving a stick drives"))
        hold.show_input(profile.hold)
        stop.set_inputs(_button_names(pad), tr("none"))
        stop.show_input(profile.stop)
        self._style.setCurrentIndex(self._style.findData(profile.style))
        for spin, fraction in ((self._dead_zone, profile.dead_zone), (self._expo, profile.expo)):
            with QSignalBlocker(spin):
                spin.setValue(round(100 * fraction))

    @Slot()
    def _on_gamepad_moved(self) -> None:
        state = self._gamepad.state
        if self.isVisible():
            self._live.show_state(state)
            left, right = mix(self._gamepad.request.forward, self._gamepad.request.turn)
            self._robot.show_wheel(Side.LEFT, left / FULL_SCALE, "motor1")
            self._robot.show_wheel(Side.RIGHT, right / FULL_SCALE, "motor2")
