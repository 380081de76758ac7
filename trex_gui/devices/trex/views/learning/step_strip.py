"""The steps of a wizard in a row: those behind ticked, the present one bold."""

from collections.abc import Sequence

from PySide6.QtCore import QSize, Qt, Slot
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders as ui

_SPACING = 6


class StepStrip(QWidget):
    """Shows the steps and the present one.

    If there is no room for all names, only the present one is shown, with its number.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._steps: tuple[str, ...] = ()
        self._signs: list[QLabel] = []
        self._names: list[QLabel] = []
        self._now = 0
        self._shown: tuple[int, tuple[str, ...]] | None = None
        self._row = ui.row(into=self, margins=0, spacing=_SPACING)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

        theme().changed.connect(self._on_theme_changed)

    def set_steps(self, names: Sequence[str]) -> None:
        """Show these steps, in this order."""
        if self._steps == tuple(names):
            return
        self._steps = tuple(names)
        while (item := self._row.takeAt(0)) is not None:
            if (widget := item.widget()) is not None:
                widget.setParent(None)
                widget.deleteLater()
        self._signs, self._names = [], []
        for name in names:
            sign, label = QLabel(self), QLabel(name, self)
            label.setContentsMargins(0, 0, self.fontMetrics().averageCharWidth(), 0)
            self._row.addWidget(sign)
            self._row.addWidget(label)
            self._signs.append(sign)
            self._names.append(label)
        self._row.addStretch(1)
        self._show()

    def show_step(self, now: int) -> None:
        """Say which step it is, from 0 on."""
        if (now, self._steps) != self._shown:
            self._now = now
            self._show()

    def _show(self) -> None:
        now, self._shown = self._now, (self._now, self._steps)
        size = self.fontMetrics().height() + 2
        for number, (sign, label) in enumerate(zip(self._signs, self._names, strict=True)):
            name = "ok" if number < now else "run" if number == now else ""
            sign.setFixedSize(size, size)
            sign.setAlignment(Qt.AlignmentFlag.AlignCenter)
            if name:
                sign.setPixmap(icon(name).pixmap(size, size))
            else:
                sign.clear()
            font = self.font()
            font.setBold(number == now)
            label.setFont(font)
            palette = self.palette()
            if number > now:
                palette.setColor(label.foregroundRole(), theme().color("muted"))
            label.setPalette(palette)
        self.setAccessibleName(self._steps[now] if now < len(self._steps) else "")
        self._fit()

    def minimumSizeHint(self) -> QSize:
        """As wide as the present step alone needs."""
        hint = super().minimumSizeHint()
        metrics = self.fontMetrics()
        widest = max((metrics.horizontalAdvance(name) for name in self._steps), default=0)
        hint.setWidth(round(1.3 * widest) + metrics.horizontalAdvance("2/4: ") + metrics.height())
        return hint

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        """Show as many names as there is room for: all, or the present one."""
        sign = self.fontMetrics().height() + 2
        needed = 0
        for label, name in zip(self._names, self._steps, strict=True):
            margins = label.contentsMargins()
            needed += sign + label.fontMetrics().horizontalAdvance(name) + margins.right()
            needed += 2 * _SPACING
        has_room = needed <= self.width()
        for number, (label, name) in enumerate(zip(self._names, self._steps, strict=True)):
            is_now = number == self._now
            label.setVisible(has_room or is_now)
            self._signs[number].setVisible(has_room or is_now)
            label.setText(name if has_room else f"{number + 1}/{len(self._steps)}: {name}")

    @Slot()
    def _on_theme_changed(self) -> None:
        self._show()
