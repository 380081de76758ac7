"""A gamepad that drives: which one, its profile, and what it waits for."""

from PySide6.QtCore import QObject, QSettings, Signal, Slot

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.driving.momentary_drive import MomentaryDrive
from trex_gui.gamepad.pads import GamepadUnavailable, Pad, PadSource, PadState
from trex_gui.gamepad.pilot import Pilot, PilotRequest, Waits
from trex_gui.gamepad.profile import GamepadProfile, default_profile, read_profile
from trex_gui.ui.runtime import runtime


class GamepadWords(QObject):
    """User-visible sentences and names."""

    def button(self, pad: Pad, number: int | None) -> str:
        """A button as it is named or numbered; people count from 1."""
        if number is None:
            return self.tr("none")
        name = self._part(pad.part_name("b", number))
        return (
            self.tr("button {0} ({1})").format(number + 1, name)
            if name
            else self.tr("button {0}").format(number + 1)
        )

    def axis(self, pad: Pad, number: int) -> str:
        """An axis as it is named or numbered; people count from 1."""
        name = self._part(pad.part_name("a", number))
        return (
            self.tr("axis {0} ({1})").format(number + 1, name)
            if name
            else self.tr("axis {0}").format(number + 1)
        )

    def none_there(self) -> str:
        """No gamepad is there yet."""
        return self.tr("No gamepad is connected. Plug one in or switch it on.")

    def gone(self, name: str) -> str:
        """The one that was read has gone."""
        return self.tr("The gamepad “{0}” was disconnected. Plug it in again to continue.").format(
            name
        )

    def taken(self) -> str:
        """Another control is held."""
        return self.tr("Another control drives now.")

    def not_armed(self, pad: Pad, profile: GamepadProfile) -> str:
        if profile.hold is None:
            return self.tr("Press Run motor, then move a stick.")
        return self.tr("Press Run motor, then hold {0} and move a stick.").format(
            self.button(pad, profile.hold)
        )

    def waits(self, waits: Waits, pad: Pad, profile: GamepadProfile) -> str:
        """What it takes for the gamepad to drive, or how it is made to stop."""
        held = self.button(pad, profile.hold)
        match waits:
            case Waits.REST:
                return self.tr(
                    "Let go of the sticks: nothing drives before both axes were at rest. "
                    "A worn stick may need a wider dead zone."
                )
            case Waits.RELEASE:
                return self.tr("Let go of {0}, then hold it to drive.").format(held)
            case Waits.HOLD:
                return self.tr("Hold {0} and move a stick to drive.").format(held)
            case Waits.MOVE:
                return self.tr("Move a stick to drive.")
            case Waits.NOTHING if profile.hold is None:
                return self.tr("Driving. Let go of the sticks to stop.")
            case Waits.NOTHING:
                return self.tr("Driving. Let go of {0} to stop.").format(held)

    def _part(self, part: str) -> str:
        """SDL's name of a part in words; as SDL has it where there is no better one."""
        return {
            "leftx": self.tr("left stick, sideways"),
            "lefty": self.tr("left stick, up and down"),
            "rightx": self.tr("right stick, sideways"),
            "righty": self.tr("right stick, up and down"),
            "lefttrigger": self.tr("left trigger"),
            "righttrigger": self.tr("right trigger"),
            "leftshoulder": self.tr("left shoulder"),
            "rightshoulder": self.tr("right shoulder"),
            "leftstick": self.tr("left stick pressed"),
            "rightstick": self.tr("right stick pressed"),
            "dpup": self.tr("cross up"),
            "dpdown": self.tr("cross down"),
            "dpleft": self.tr("cross left"),
            "dpright": self.tr("cross right"),
            "a": self.tr("A, the lowest of four"),
            "b": self.tr("B, the right one of four"),
            "x": self.tr("X, the left one of four"),
            "y": self.tr("Y, the highest of four"),
        }.get(part, part)


HOLDER = "gamepad"
"""The name under which a gamepad holds the motors."""

STEP_MS = 17
"""How often it is looked at: some 59 times a second, as often as a screen shows anything."""

_NOTHING = PilotRequest(0.0, 0.0, Waits.REST, stop=False)


class Gamepad(QObject):
    """Reads gamepads while it is switched on, and sets speeds in their name.

    It drives while `attended`; its stop button works all the while that it is switched on.
    One gamepad is read at a time. What its parts are for is remembered for each kind.

    Signals:
        changed: which gamepads there are, which is read, its profile, an option, or `text`.
        moved: `state` and `ask`; many times a second while it is touched.
    """

    changed = Signal()
    moved = Signal()

    def __init__(self, device: Device, source: PadSource, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._motors = device.motors
        self._drive_with = MomentaryDrive(device.motors, HOLDER, self)
        self._source = source
        self._store = QSettings(self)
        self._words = GamepadWords(self)
        self._on = False
        self._failure = ""
        self._gone = ""
        self._pads: tuple[Pad, ...] = ()
        self._pad: Pad | None = None
        self._profile = GamepadProfile()
        self._pilot = Pilot(self._profile)
        self._state: PadState | None = None
        self._ask = _NOTHING
        self._looked = False  # since the pilot began
        self._unattended = ""
        self._armed = self._motors.armed
        self._text = ""
        self._timer = runtime().timer(self)
        self._timer.setInterval(STEP_MS)
        self._timer.timeout.connect(self._on_step)
        self._motors.arming_changed.connect(self._on_arming_changed)
        self.destroyed.connect(source.close)
        self._report()

    # --- What is known ------------------------------------------------------------------

    @property
    def on(self) -> bool:
        """Whether gamepads are read."""
        return self._on

    @property
    def failure(self) -> str:
        """Why gamepads could not be switched on, and what helps; empty when they could."""
        return self._failure

    @property
    def has_gone(self) -> bool:
        """Whether the gamepad that was read has gone, and no other has come."""
        return bool(self._gone)

    @property
    def pads(self) -> tuple[Pad, ...]:
        return self._pads

    @property
    def pad(self) -> Pad | None:
        return self._pad

    @property
    def profile(self) -> GamepadProfile:
        return self._profile

    @property
    def state(self) -> PadState | None:
        """What it shows; `None` while none is read."""
        return self._state

    @property
    def ask(self) -> PilotRequest:
        """Its setpoints, whether the motors follow or not."""
        return self._ask

    @property
    def drives(self) -> bool:
        """Whether the motors follow it now."""
        return self._drive_with.held

    @property
    def text(self) -> str:
        """What it does or waits for, as a sentence; empty while it is switched off."""
        return self._text

    @property
    def stops_unfocused(self) -> bool:
        """Whether motors that it drives stop when the window loses the focus."""
        return bool(self._store.value("gamepad/stops_unfocused", defaultValue=True, type=bool))

    # --- User actions -------------------------------------------------------------------

    def switch_on(self) -> None:
        """Begin to read gamepads; `failure` says why if that is impossible."""
        if self._on:
            return
        try:
            self._source.open()
        except GamepadUnavailable as unavailable:
            self._failure = str(unavailable)
        else:
            self._failure = self._gone = ""
            self._on = True
            self._timer.start()
            self._look()
        self._report()
        self.changed.emit()

    def switch_off(self) -> None:
        """Read none any more; motors that one drives stop."""
        self._failure = ""
        if self._on:
            self._on = False
            self._gone = ""
            self._timer.stop()
            self._lose(self.tr("Driving with a gamepad was switched off."))
            self._pads = ()
            self._take(None)
            self._source.close()
        self._report()
        self.changed.emit()

    def choose(self, pad: Pad) -> None:
        """Read this one from now on; motors that another drives stop."""
        if pad in self._pads and pad != self._pad:
            self._store.setValue("gamepad/last", pad.guid)
            self._lose(self.tr("Another gamepad was chosen."))
            self._take(pad)
            self._report()
            self.changed.emit()

    def set_profile(self, profile: GamepadProfile) -> None:
        """Use the parts of this kind of gamepad so, now and later; motors that it drives stop."""
        if self._pad is not None and profile != self._profile:
            self._lose(self.tr("The gamepad was set up anew."))
            self._store.setValue(f"gamepad/profiles/{self._pad.guid}", profile.to_text())
            self._use(profile)
            self._report()
            self.changed.emit()

    def set_stops_unfocused(self, stops: bool) -> None:
        """Let motors that a gamepad drives stop, or not, when the window loses the focus."""
        self._store.setValue("gamepad/stops_unfocused", stops)
        self.changed.emit()

    def attend(self, reason: str) -> None:
        """Set why the user cannot see what the gamepad drives; empty: they can.

        Motors that it drives stop with that reason, and none can be driven until it is empty.
        """
        if reason != self._unattended:
            self._unattended = reason
            if reason:
                self._lose(reason)
            self._begin()
            self._report()
            self.changed.emit()

    # --- As time goes -------------------------------------------------------------------

    @Slot()
    def _on_step(self) -> None:
        self._look()
        pad = self._pad
        if pad is None:
            self._report()
            return
        state = self._source.read(pad)
        if state is None:  # gone since the last scan, or silent
            self._miss(pad)
            self.changed.emit()
            self._report()
            return
        self._ask = self._pilot.take(state)
        self._looked = True
        if self._ask.stop:
            self._motors.press_stop()
        else:
            self._drive()
        if state != self._state:
            self._state = state
            self.moved.emit()
        self._report()

    def _look(self) -> None:
        """Take notice of gamepads that came or went."""
        pads = self._source.pads()
        if pads == self._pads:
            return
        self._pads = pads
        if self._pad is not None and self._pad not in pads:
            self._miss(self._pad)
        if self._pad is None and pads:
            last = str(self._store.value("gamepad/last", ""))
            self._gone = ""
            self._take(next((pad for pad in pads if pad.guid == last), pads[0]))
        self.changed.emit()

    def _miss(self, pad: Pad) -> None:
        """Stop what this one drives, and read it no more; the next look may find another."""
        self._gone = pad.name
        self._take(None)
        self._lose(self.tr("The gamepad “{0}” was disconnected.").format(self._gone))

    def _drive(self) -> None:
        if self._unattended or not self._motors.armed:
            return
        self._drive_with.joint = self._device.is_joint
        if not self._ask.drives:
            self._drive_with.let_go()
        elif not self._drive_with.steer(self._ask.forward, self._ask.turn):
            self._begin()  # it is another's turn: later, the button has to be pressed anew

    @Slot()
    def _on_arming_changed(self) -> None:
        if self._motors.armed != self._armed:
            self._armed = self._motors.armed
            self._begin()
            self._report()

    def _begin(self) -> None:
        """Require sticks at rest and the button released again."""
        self._pilot.begin()
        self._looked = False

    def _lose(self, reason: str) -> None:
        self._drive_with.lose(reason)

    def _take(self, pad: Pad | None) -> None:
        self._pad = pad
        self._state, self._ask = None, _NOTHING
        if pad is not None:
            stored = read_profile(str(self._store.value(f"gamepad/profiles/{pad.guid}", "")))
            fits = stored is not None and stored.fits(pad)
            self._use(stored if stored is not None and fits else default_profile(pad))
        self.moved.emit()

    def _use(self, profile: GamepadProfile) -> None:
        self._profile = profile
        self._pilot = Pilot(profile)
        self._looked = False

    def _report(self) -> None:
        text = self._say()
        if text != self._text:
            self._text = text
            self.changed.emit()

    def _say(self) -> str:
        words = self._words
        if not self._on:
            return self._failure
        if self._pad is None:
            return words.gone(self._gone) if self._gone else words.none_there()
        if self._unattended:
            return self._unattended
        if not self._motors.armed:
            return words.not_armed(self._pad, self._profile)
        if self._motors.holder and not self.drives:
            return words.taken()
        if not self._looked:
            return self._text
        return words.waits(self._ask.waits, self._pad, self._profile)
