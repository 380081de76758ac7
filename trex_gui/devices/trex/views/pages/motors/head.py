"""The head of the Motors page: what the motors would do now and why, and Run motor."""

from html import escape

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from trex_gui.devices.trex.model.driving.drive_status import (
    DriveBlocker,
    DriveInputs,
    find_blocker,
    status_text,
)
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
        self._blocker = DriveBlocker.NO_BOARD
        self._shown = ("", "")
        self._sign = QLabel(self)
        self._text = ui.label(self, "motorsReason", wrap=True)
        self._text.setTextFormat(Qt.TextFormat.RichText)
        self._text.setMinimumHeight(_LINES * self._text.fontMetrics().lineSpacing())
        self._text.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Minimum)
        self._run = ui.button(
            self,
            "motorsRunButton",
            self.tr("Run motor"),
            tip=self.tr("Let what you do on this page move the motors"),
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
        shown = status_text(inputs)
        if shown == self._shown:
            return
        self._shown, self._blocker = shown, find_blocker(inputs)
        text, remedy = shown
        self._text.setText(f"<b>{escape(text)}</b> {escape(remedy)}".rstrip())
        self._text.setAccessibleName(f"{text} {remedy}".strip())
        self._on_theme_changed()

    @Slot()
    def _on_theme_changed(self) -> None:
        alarming = self._blocker.is_alarming
        name = "warning" if alarming else "ok" if self._blocker.is_obeyed else "info"
        size = self.fontMetrics().height() + 6
        self._sign.setPixmap(icon(name, "good" if name == "ok" else name).pixmap(size, size))
        palette = self.palette()
        if alarming:
            palette.setColor(self._text.foregroundRole(), theme().color("warning"))
        self._text.setPalette(palette)
