"""The steps of a wizard in a row."""

from collections.abc import Collection, Sequence

from PySide6.QtCore import QSize, Qt, Slot
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.theme.theme import theme


class StepStrip(QLabel):
    """The steps of a wizard in a row, or the current one alone if there is no room for all."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._steps: Sequence[str] = ()
        self._now = 0
        self._undone: Collection[str] = ()
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

        theme().changed.connect(self._fit)

    def show_steps(self, steps: Sequence[str], now: int, undone: Collection[str] = ()) -> None:
        """`undone`: steps that are not done although a later one is shown."""
        if (steps, now, undone) != (self._steps, self._now, self._undone):
            self._steps, self._now, self._undone = steps, now, undone
            passed = [step for step in steps[:now] if step in undone]
            text = tr("{0}. Not done: {1}.").format(steps[now], ", ".join(passed))
            self.setAccessibleName(text if passed else steps[now])
            self._fit()

    def minimumSizeHint(self) -> QSize:
        texts = [f"0/0: {step}" for step in self._steps]
        widest = max(map(self.fontMetrics().horizontalAdvance, texts), default=0)
        return QSize(round(1.2 * widest), super().minimumSizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    @Slot()
    def _fit(self) -> None:
        muted = theme().color("muted").name()
        steps = [
            f"{'–' if step in self._undone else '✓'} {step}"
            if number < self._now
            else f"<b>▸ {step}</b>"
            if number == self._now
            else f'<span style="color:{muted}">{step}</span>'
            for number, step in enumerate(self._steps)
        ]
        self.setText("&nbsp;&nbsp;&nbsp; ".join(steps))
        if steps and self.sizeHint().width() > self.width():
            self.setText(f"<b>{self._now + 1}/{len(steps)}: {self._steps[self._now]}</b>")
