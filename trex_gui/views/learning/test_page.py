"""Every stick to its end once more: does what is stored give full output, and none at rest?"""

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QGridLayout, QLabel, QVBoxLayout, QWidget

from trex_gui.learning.proof import Tested
from trex_gui.model.learning import Learning
from trex_gui.views.learning.parts import Muted, Sign, channel_label
from trex_gui.views.widgets.note import Note
from trex_gui.views.widgets.output_bar import OutputBar


class TestPage(QWidget):
    """A row a channel: its output, what was reached; below them, what safe-start would do."""

    __test__ = False

    def __init__(self, learning: Learning, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("learnTestPage")
        self._learning = learning

        self._bars: dict[int, OutputBar] = {}
        self._signs: dict[int, Sign] = {}
        self._words: dict[int, QLabel] = {}
        self._safe_start = Note(2, self)
        self._safe_start.setObjectName("learnSafeStart")
        self._inferred = Muted(
            self.tr(
                "Worked out here, each channel by itself, from what the board stores. Sourced: "
                "full output beyond the ends, none in the deadband, and what safe-start waits "
                "for. Inferred: that up to 8 of 127 counts as neutral, and where a switch switches."
            ),
            self,
        )

        grid = QGridLayout()
        grid.setHorizontalSpacing(12)
        grid.setVerticalSpacing(12)
        grid.setColumnStretch(1, 3)
        grid.setColumnStretch(3, 3)
        for row, tested in enumerate(self._tested):
            number = tested.channel
            bar = OutputBar(self)
            bar.setAccessibleName(self.tr("Output of channel {0}").format(number))
            bar.set_connected(True)
            sign, words = Sign(self), QLabel(self)
            words.setObjectName(f"learnTest{number}")
            words.setWordWrap(True)
            for column, widget in enumerate((channel_label(number, self), bar, sign, words)):
                grid.addWidget(widget, row, column)
            self._bars[number], self._signs[number], self._words[number] = bar, sign, words
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 8, 0)
        layout.addLayout(grid)
        layout.addStretch(1)
        layout.addWidget(self._safe_start)
        layout.addWidget(self._inferred)

        learning.changed.connect(self._on_changed)
        learning.measured.connect(self._on_changed)
        self._on_changed()

    @property
    def _tested(self) -> tuple[Tested, ...]:
        tests = self._learning.tests
        return () if tests is None else tests.tested

    @Slot()
    def _on_changed(self) -> None:
        for tested in self._tested:
            self._bars[tested.channel].set_value(tested.output)
            self._words[tested.channel].setText(tested.text)
            name, color = ("ok", "good") if tested.passed else ("", "icon")
            if tested.output is None:
                name, color = "warning", "warning"
            self._signs[tested.channel].show_sign(name, color)
        if self._learning.tests is not None:
            self._safe_start.show_note(self._learning.tests.safe_start_text)
