"""Gamepad that drives the motors: selection, profile and state."""

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.momentary_drive import MomentaryDrive
from trex_gui.gamepad.pads import GamepadUnavailable, Pad, PadState, SdlPads
from trex_gui.gamepad.profile import (
    DriveCondition,
    GamepadProfile,
    Pilot,
    PilotRequest,
    default_profile,
    read_profile,
)
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.runtime import new_timer

HOLDER = "gamepad"  # holder name for `Motors.acquire`
STEP_MS = 17  # about the duration of a screen frame

_NOTHING = PilotRequest(0.0, 0.0, DriveCondition.REST, stop=False)


class Gamepad(QObject):
    """Reads a gamepad, and sets speeds from its sticks.

    `set_unattended` prevents driving, but does not disable the stop button of the gamepad. One
    gamepad is read at a time. Each kind of gamepad has its own saved profile.
    """

    changed = Signal()  # any attribute except `state` and `request`
    moved = Signal()  # `state` and `request`, many times a second

    def __init__(self, device: Device, source: SdlPads, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._motors = device.motors
        self._control = MomentaryDrive(device.motors, HOLDER)
        self._source = source
        self._store = Preferences()
        self.is_on = False
        self.failure = ""  # reason and remedy if gamepads cannot be read
        self.pads: tuple[Pad, ...] = ()  # connected gamepads
        self.pad: Pad | None = None  # gamepad being read
        self.lost_pad = ""  # name of the gamepad that was disconnected
        self.profile = GamepadProfile()
        self.state: PadState | None = None  # state of `pad`; `None` while no gamepad is read
        self.request = _NOTHING  # setpoints of `pad`, even if they are not sent
        self.text = ""  # state or failure in sentences; may be empty
        self._pilot = Pilot(self.profile)
        self._has_read = False  # the gamepad was read since the last reset of the pilot
        self._unattended = ""
        self._timer = new_timer(self, STEP_MS, self._on_step)
        self._motors.arming_changed.connect(self._on_arming_changed)
        self._motors.board_changed.connect(self.switch_off)
        self.destroyed.connect(source.close)

    @property
    def is_driving(self) -> bool:
        return self._control.held

    @property
    def stops_unfocused(self) -> bool:
        """True if driving stops when the window loses focus."""
        return self._store.flag("gamepad/stops_unfocused", default=True)

    # --- User actions -------------------------------------------------------------------

    def switch_on(self) -> None:
        if self.is_on:
            return
        try:
            self._source.open()
        except GamepadUnavailable as error:
            self.failure = str(error)
        else:
            self.failure = self.lost_pad = ""
            self.is_on = True
            self._timer.start()
            self._update_pads()
        self._refresh()

    @Slot()
    def switch_off(self) -> None:
        self.failure = ""
        if self.is_on:
            self.is_on = False
            self.lost_pad = ""
            self._timer.stop()
            self._control.abort(tr("Driving with a gamepad was switched off."))
            self.pads = ()
            self._set_pad(None)
            self._source.close()
        self._refresh()

    def select(self, pad: Pad) -> None:
        if pad in self.pads and pad != self.pad:
            self._store.set("gamepad/last", pad.guid)
            self._control.abort(tr("Another gamepad was selected."))
            self._set_pad(pad)
            self._refresh()

    def set_profile(self, profile: GamepadProfile) -> None:
        if self.pad is not None and profile != self.profile:
            self._control.abort(tr("The gamepad settings were changed."))
            self._store.set(f"gamepad/profiles/{self.pad.guid}", profile.to_text())
            self._apply_profile(profile)
            self._refresh()

    def set_stops_unfocused(self, stops: bool) -> None:
        self._store.set("gamepad/stops_unfocused", stops)
        self.changed.emit()

    def set_unattended(self, reason: str) -> None:
        """Prevent driving for this reason. An empty reason allows driving."""
        if reason != self._unattended:
            self._unattended = reason
            if reason:
                self._control.abort(reason)
            self._reset_pilot()
            self._refresh()

    # --- Reading ------------------------------------------------------------------------

    @Slot()
    def _on_step(self) -> None:
        self._update_pads()
        pad = self.pad
        if pad is None:
            self._report()
            return
        state = self._source.read(pad)
        if state is None:  # disconnected since the last scan, or silent
            self._on_pad_lost(pad)
            self._refresh()
            return
        self.request = self._pilot.update(state)
        self._has_read = True
        if self.request.stop:
            self._motors.press_stop()
        else:
            self._drive()
        if state != self.state:
            self.state = state
            self.moved.emit()
        self._report()

    def _update_pads(self) -> None:
        pads = self._source.pads()
        if pads == self.pads:
            return
        self.pads = pads
        if self.pad is not None and self.pad not in pads:
            self._on_pad_lost(self.pad)
        if self.pad is None and pads:
            last = self._store.text("gamepad/last")
            self.lost_pad = ""
            self._set_pad(next((pad for pad in pads if pad.guid == last), pads[0]))
        self.changed.emit()

    def _on_pad_lost(self, pad: Pad) -> None:
        self.lost_pad = pad.name
        self._set_pad(None)
        self._control.abort(tr("The gamepad “{0}” was disconnected.").format(pad.name))

    def _drive(self) -> None:
        if self._unattended or not self._motors.armed:
            return
        self._control.joint = self._device.board.is_joint
        if not self.request.drives:
            self._control.release()
        elif not self._control.steer(self.request.forward, self.request.turn):
            self._reset_pilot()  # another control is driving: the button must be pressed again

    @Slot()
    def _on_arming_changed(self) -> None:
        self._reset_pilot()
        self._report()

    def _reset_pilot(self) -> None:
        self._pilot.reset()
        self._has_read = False

    def _set_pad(self, pad: Pad | None) -> None:
        self.pad = pad
        self.state, self.request = None, _NOTHING
        if pad is not None:
            stored = read_profile(self._store.text(f"gamepad/profiles/{pad.guid}"))
            self._apply_profile(stored if stored and stored.fits(pad) else default_profile(pad))
        self.moved.emit()

    def _apply_profile(self, profile: GamepadProfile) -> None:
        self.profile = profile
        self._pilot = Pilot(profile)
        self._has_read = False

    # --- Text ---------------------------------------------------------------------------

    def _report(self) -> None:
        if self._current_text() != self.text:
            self._refresh()

    def _refresh(self) -> None:
        self.text = self._current_text()
        self.changed.emit()

    def _current_text(self) -> str:
        if not self.is_on:
            return self.failure
        if self.pad is None:
            if not self.lost_pad:
                return tr("No gamepad is connected. Plug in or switch on a gamepad.")
            return tr("The gamepad “{0}” was disconnected.").format(self.lost_pad)
        if self._unattended:
            return self._unattended
        if not self._motors.armed:
            return tr("Arm the motors first.")
        if self._motors.holder and not self.is_driving:
            return tr("Another control is driving now.")
        held = button_text(self.pad, self.profile.hold)
        return self._condition_text().format(held) if self._has_read else self.text

    def _condition_text(self) -> str:
        match self.request.waits_for:
            case DriveCondition.REST:
                return tr(
                    "Release the sticks: driving starts only once both axes have been at "
                    "rest. A worn stick may need a wider dead zone."
                )
            case DriveCondition.RELEASE:
                return tr("Release {0}, then hold it to drive.")
            case DriveCondition.HOLD:
                return tr("Hold {0} and move a stick to drive.")
            case DriveCondition.MOVE:
                return tr("Move a stick to drive.")
            case DriveCondition.NOTHING if self.profile.hold is None:
                return tr("Driving. Release the sticks to stop.")
            case DriveCondition.NOTHING:
                return tr("Driving. Release {0} to stop.")


def button_text(pad: Pad, number: int | None) -> str:
    if number is None:
        return tr("none")
    return _with_part(tr("button {0}").format(number + 1), pad.part_name("b", number))


def axis_text(pad: Pad, number: int) -> str:
    return _with_part(tr("axis {0}").format(number + 1), pad.part_name("a", number))


def _with_part(text: str, part: str) -> str:
    """Append the name of a part. Unknown parts keep the name from SDL."""
    words = {
        "leftx": tr("left stick, sideways"),
        "lefty": tr("left stick, up and down"),
        "rightx": tr("right stick, sideways"),
        "righty": tr("right stick, up and down"),
        "lefttrigger": tr("left trigger"),
        "righttrigger": tr("right trigger"),
        "leftshoulder": tr("left shoulder"),
        "rightshoulder": tr("right shoulder"),
        "leftstick": tr("left stick pressed"),
        "rightstick": tr("right stick pressed"),
        "dpup": tr("D-pad up"),
        "dpdown": tr("D-pad down"),
        "dpleft": tr("D-pad left"),
        "dpright": tr("D-pad right"),
        "a": tr("A (the bottom button)"),
        "b": tr("B (the right button)"),
        "x": tr("X (the left button)"),
        "y": tr("Y (the top button)"),
    }
    return f"{text} ({words.get(part, part)})" if part else text
