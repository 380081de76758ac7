"""The steps of a wizard in a row: those behind ticked, the present one bold."""

from collections.abc import Sequence

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QHBoxLayout, QLabel, QWidget

from trex_gui.views.icons import icon
from trex_gui.views.theme import theme


class StepStrip(QWidget):
    """Shows how far it is; told, it decides nothing."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._signs: list[QLabel] = []
        self._names: list[QLabel] = []
        self._now = 0
        self._row = QHBoxLayout(self)
        self._row.setContentsMargins(0, 0, 0, 0)
        self._row.setSpacing(6)

        theme().changed.connect(self._on_theme_changed)

    def set_steps(self, names: Sequence[str]) -> None:
        """Show these steps, in this order."""
        if [label.text() for label in self._names] == list(names):
            return
        while (item := self._row.takeAt(0)) is not None:
            if (widget := item.widget()) is not None:
                widget.setParent(None)
                widget.deleteLater()
        self._signs, self._names = [], []
        for name in names:
            sign, label = QLabel(self), QLabel(name, self)
            self._row.addWidget(sign)
            self._row.addWidget(label)
            self._row.addSpacing(2 * self.fontMetrics().averageCharWidth())
            self._signs.append(sign)
            self._names.append(label)
        self._row.addStretch(1)
        self.show_step(self._now)

    def show_step(self, now: int) -> None:
        """Say which step it is, from 0 on."""
        self._now = now
        size = self.fontMetrics().height() + 2
        for number, (sign, label) in enumerate(zip(self._signs, self._names, strict=True)):
            name = "ok" if number < now else "run" if number == now else ""
            sign.setFixedSize(size, size)
            sign.setAlignment(Qt.AlignmentFlag.AlignCenter)
            if name:
                sign.setPixmap(icon(name).pixmap(size, size))
            else:
                sign.clear()
            font = label.font()
            font.setBold(number == now)
            label.setFont(font)
            palette = self.palette()
            if number > now:
                palette.setColor(label.foregroundRole(), theme().color("muted"))
            label.setPalette(palette)
        self.setAccessibleName(self._names[now].text() if now < len(self._names) else "")

    @Slot()
    def _on_theme_changed(self) -> None:
        self.show_step(self._now)
