"""What there is to say of a gamepad: its parts by name, what it waits for."""

from PySide6.QtCore import QObject

from trex_gui.gamepad.pads import Pad
from trex_gui.gamepad.pilot import Waits
from trex_gui.gamepad.profile import GamepadProfile


class GamepadWords(QObject):
    """Sentences and names for people."""

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
        return self.tr("No gamepad is there. Plug one in or switch it on; it is noticed at once.")

    def gone(self, name: str) -> str:
        """The one that was read has gone."""
        return self.tr(
            "The gamepad “{0}” has gone. Plug it in again; it is noticed at once."
        ).format(name)

    def taken(self) -> str:
        """Another control is held."""
        return self.tr("Another control drives now.")

    def not_armed(self, pad: Pad, profile: GamepadProfile) -> str:
        """The motors are not armed."""
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
