"""The lines above and below the controls: why motors move or not, and the stored limits."""

from html import escape

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from trex_gui.devices.trex.model.drive_status import (
    DriveBlocker,
    DriveInputs,
    DriveStatus,
    drive_status,
)
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.ui.theme.icons import icon, set_icon
from trex_gui.ui.theme.theme import theme, tint
from trex_gui.ui.widgets import builders as ui

_LINES = 2


class Head(QWidget):
    """One reason, what to do about it, and the button that arms.

    Signals:
        run_wanted: the button was pressed.
    """

    run_wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._status = DriveStatus(DriveBlocker.NO_BOARD, "", "")
        self._sign = QLabel(self)
        self._text = ui.label(self, "motorsReason", wrap=True)
        self._text.setTextFormat(Qt.TextFormat.RichText)
        self._text.setMinimumHeight(_LINES * self._text.fontMetrics().lineSpacing())
        self._text.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Minimum)
        self._run = ui.button(
            self,
            "motorsRunButton",
            self.tr("Run motor"),
            tip=self.tr("Let the controls of this page move the motors"),
            on_click=self.run_wanted,
        )
        ui.set_bold(self._run)
        tint(self._run, "run")
        set_icon(self._run, "run", "run_text")

        ui.row(self._sign, (self._text, 1), self._run, into=self, margins=0, spacing=10)

        theme().changed.connect(self._on_theme_changed)
        self._on_theme_changed()

    def show_status(self, inputs: DriveInputs, *, can_run: bool) -> None:
        """Show what the motors do and why."""
        self._run.setEnabled(can_run)
        status = drive_status(inputs)
        if status == self._status:
            return
        self._status = status
        text, remedy = status.text, status.remedy
        self._text.setText(f"<b>{escape(text)}</b> {escape(remedy)}".rstrip())
        self._text.setAccessibleName(f"{text} {remedy}".strip())
        self._on_theme_changed()

    @Slot()
    def _on_theme_changed(self) -> None:
        alarming = self._status.blocker.is_alarming
        name = "warning" if alarming else "ok" if self._status.blocker.is_obeyed else "info"
        size = self.fontMetrics().height() + 6
        self._sign.setPixmap(icon(name, "good" if name == "ok" else name).pixmap(size, size))
        palette = self.palette()
        if alarming:
            palette.setColor(self._text.foregroundRole(), theme().color("warning"))
        self._text.setPalette(palette)


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

        Equal values of both motors, and those in joint mode, are shown once.
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
        """Give screen readers a name while there is no text."""
        nothing = self.tr("What the board stores of the motors: not known")
        self.setAccessibleName("" if self.text() else nothing)

    def _link(self, key: str) -> str:
        wire = self._parameters.stored_of(key)
        if wire is None:
            return ""
        value = self._parameters.text.physical(self._parameters.spec_of(key), wire)
        color = theme().color("link").name()
        return f'<a href="{key}" style="color:{color}">{escape(value)}</a>'
