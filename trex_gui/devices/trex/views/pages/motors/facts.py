"""What the board itself does to a speed, in a line: ramp, brake time, limit, serial timeout."""

from html import escape

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QLabel, QWidget

from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey
from trex_gui.ui.theme.theme import theme

_OF_A_MOTOR = ("acceleration", "brake_duration", "current_limit")


class Facts(QLabel):
    """Each value is a link to its parameter.

    Signals:
        parameter_wanted: the key of the parameter whose value was clicked.
    """

    parameter_wanted = Signal(str)

    def __init__(self, parameters: ParameterModel, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("motorsFacts")
        self._parameters = parameters
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setTextInteractionFlags(
            Qt.TextInteractionFlag.LinksAccessibleByMouse
            | Qt.TextInteractionFlag.LinksAccessibleByKeyboard
        )
        self.setToolTip(self.tr("What the board stores; a click opens the parameter"))

        self._name()
        self.linkActivated.connect(self.parameter_wanted)

    def refresh(self, *, joint: bool) -> None:
        """Tell it as it is stored now; nothing where that was not read.

        A motor that has the same as the other, or is one with it, is not told of twice.
        """
        words = {
            "acceleration": self.tr("acceleration"),
            "brake_duration": self.tr("brake duration"),
            "current_limit": self.tr("current limit"),
        }
        stored = self._parameters.stored_of
        same = all(stored(f"motor1_{what}") == stored(f"motor2_{what}") for what in _OF_A_MOTOR)
        parts = []
        for motor in (1,) if same or joint else (1, 2):
            facts = [
                f"{words[what]}: {value}"
                for what in _OF_A_MOTOR
                if (value := self._link(f"motor{motor}_{what}"))
            ]
            name = self.tr("Both motors") if same else self.tr("Motor {0}").format(motor)
            if joint:
                name = self.tr("Motor (joint)")
            if facts:
                parts.append(f"<b>{name}</b> \u2013 {', '.join(facts)}.")
        if timeout := self._link(ParameterKey.SERIAL_TIMEOUT):
            parts.append(f"<b>{self.tr('Serial timeout')}</b> \u2013 {timeout}.")
        text = " ".join(parts)
        if text != self.text():
            self.setText(text)
            self._name()

    def _name(self) -> None:
        """Let a screen reader say what stands there, or what would."""
        nothing = self.tr("What the board stores of the motors: not known")
        self.setAccessibleName("" if self.text() else nothing)

    def _link(self, key: str) -> str:
        wire = self._parameters.stored_of(key)
        if wire is None:
            return ""
        value = self._parameters.text.physical(self._parameters.spec_of(key), wire)
        color = theme().color("link").name()
        return f'<a href="{key}" style="color:{color}">{escape(value)}</a>'
