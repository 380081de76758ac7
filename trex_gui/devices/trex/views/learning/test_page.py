"""Every stick to its end once more: does what is stored give full output, and none at rest?"""

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QLabel, QWidget

from trex_gui.devices.trex.calibration.proof import Tested
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.model.learning.stick_tests import StickTests
from trex_gui.devices.trex.views.bars import OutputBar
from trex_gui.devices.trex.views.learning.measuring_pages import channel_label
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Muted, Note, Sign

_WORDS_WIDE = 20
"""Characters that the words beside a bar have room for before they wrap."""

_LINES = 3


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
        self._safe_sign = Sign(self)
        self._safe_start = ui.named(Note(2, self), "learnSafeStart")
        self._inferred = Muted(
            self.tr(
                "Calculated here for each channel alone, from the values in the board. From the "
                "manual: full output at and beyond the ends, 0 in the deadband, and what "
                "safe-start waits for. Assumed: up to 8 of 127 counts as neutral; where a "
                "switch switches."
            ),
            self,
        )

        grid = ui.grid(spacing=(12, 12), stretch=[(1, 3), (3, 3)])
        for row, tested in enumerate(self._tested):
            number = tested.channel
            bar = OutputBar(self)
            bar.setAccessibleName(self.tr("Output of channel {0}").format(number))
            bar.set_connected(True)
            sign, words = Sign(self), QLabel(self)
            words.setObjectName(f"learnTest{number}")
            words.setWordWrap(True)
            words.setMinimumWidth(_WORDS_WIDE * words.fontMetrics().averageCharWidth())
            for column, widget in enumerate((channel_label(number, self), bar, sign, words)):
                grid.addWidget(widget, row, column)
            self._bars[number], self._signs[number], self._words[number] = bar, sign, words
        safe_start = ui.row((self._safe_sign, 0, Qt.AlignmentFlag.AlignTop), (self._safe_start, 1))
        ui.column(grid, 1, safe_start, self._inferred, into=self, margins=(0, 0, 8, 0))

        learning.changed.connect(self._on_changed)
        learning.measured.connect(self._on_changed)
        self._on_changed()

    @property
    def least_seen(self) -> int:
        """How many pixels of the page have to be in sight: a whole row."""
        words = _LINES * self.fontMetrics().lineSpacing()
        return max([words, *(bar.minimumSizeHint().height() for bar in self._bars.values())])

    @property
    def _tested(self) -> tuple[Tested, ...]:
        tests = self._learning.tests
        return () if tests is None else tests.tested

    @Slot()
    def _on_changed(self) -> None:
        for tested in self._tested:
            self._bars[tested.channel].set_value(tested.output)
            self._words[tested.channel].setText(tested.text)
            self._signs[tested.channel].show_sign(*_sign_of(tested))
        if self._learning.tests is not None:
            self._show_safe_start(self._learning.tests)

    def _show_safe_start(self, tests: StickTests) -> None:
        held = bool(tests.safe_start_reasons)
        self._safe_start.show_note(tests.safe_start_text, alarming=held)
        if not tests.heard:
            self._safe_sign.show_sign("")
        elif held:
            self._safe_sign.show_sign("warning", "warning")
        else:
            self._safe_sign.show_sign("ok", "good")


def _sign_of(tested: Tested) -> tuple[str, str]:
    """Return the icon of a channel and its colour; the words beside it say the same."""
    if tested.ignored:
        return "info", "muted"
    if tested.output is None:
        return "warning", "warning"
    return ("ok", "good") if tested.passed else ("todo", "muted")
