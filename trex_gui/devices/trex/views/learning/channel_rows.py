"""What the steps with live bars share: a row a channel, with words beside and below it."""

from collections.abc import Sequence

from PySide6.QtCore import QMargins, QSize, Slot
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QGridLayout, QVBoxLayout, QWidget

from trex_gui.devices.trex.model.learning.channel import LearnedChannel
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.views.learning.parts import channel_label
from trex_gui.devices.trex.views.pages.channels.channel_bar import ChannelBar
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.note import Note

_ROWS = 3
_GAP = 12

_BAR_GROWS = 0.5
"""Share of its least width by which a bar is longer before words get a place beside it."""

_WORDS_WIDE = 26
"""Characters that words beside a bar have room for before they wrap."""


class ChannelRow:
    """One channel: its name, its live bar, signs and words beside it, a problem below.

    Attributes:
        bar: the live bar.
        beside: what is beside it: the signs, then `words`.
        problem: what is wrong.
    """

    def __init__(self, channel: LearnedChannel, page: QWidget, *, words: str) -> None:
        self.channel = channel
        self.page = page
        self._narrow = False
        number = channel.number
        self._name = channel_label(number, page)
        self.bar = ChannelBar(page)
        self.bar.setAccessibleName(page.tr("Raw input of channel {0}").format(number))
        self.bar.set_connected(True)
        self.bar.set_source(channel.source)
        self.beside = QWidget(page)
        self.words = ui.label(self.beside, f"{words}{number}", wrap=True)
        self.words.setMinimumWidth(_WORDS_WIDE * self.words.fontMetrics().averageCharWidth())
        self.problem = ui.named(Note(1, page), f"learnProblem{number}")

        told = ui.row(*self.make_signs(self.beside), into=self.beside, margins=0)
        told.addSpacing(4)
        told.addWidget(self.words, 1)

    def make_signs(self, beside: QWidget) -> Sequence[QWidget]:
        """Make what stands before the words."""
        raise NotImplementedError

    def put_into(self, grid: QGridLayout, row: int, *, narrow: bool) -> None:
        """Take three rows of a grid: name, bar and words; words where it is narrow; a problem."""
        for widget in (self._name, self.bar, self.beside, self.problem):
            grid.removeWidget(widget)
        self._narrow = narrow
        self._align()
        grid.addWidget(self._name, row, 0)
        grid.addWidget(self.bar, row, 1)
        if narrow:
            grid.addWidget(self.beside, row + 1, 1)
        else:
            grid.addWidget(self.beside, row, 2)
        # Qt works out a height too low for text that wraps across a column without a width.
        grid.addWidget(self.problem, row + 2, 1, 1, 1 if narrow else 2)

    def least_width(self, *, narrow: bool) -> int:
        """How wide it has to be in pixels, without what is between name, bar and words."""
        bar, words = self.bar.minimumSizeHint().width(), self.beside.minimumSizeHint().width()
        both = max(bar, words) if narrow else bar + round(_BAR_GROWS * bar) + words
        return self._name.minimumSizeHint().width() + both

    def least_height(self) -> int:
        """How high it is with the words below the bar, and a problem of three lines."""
        lines = 3 * self.problem.fontMetrics().lineSpacing()
        return self.bar.minimumSizeHint().height() + self.beside.minimumSizeHint().height() + lines

    def refresh(self) -> None:
        """Show the channel as it is now."""
        self.bar.set_raw(self.channel.raw)
        self._align()

    def _align(self) -> None:
        """Let what stands below the bar begin where its track does."""
        inset = self.bar.inset
        self.problem.setContentsMargins(inset, 0, 0, 0)
        self.beside.setContentsMargins(inset if self._narrow else 0, 0, 0, 0)


class ChannelRows(QWidget):
    """A page of such rows, one for each channel that is learned."""

    def __init__(self, learning: Learning, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.learning = learning
        self._rows = [self.make_row(channel) for channel in learning.channels]
        self._narrow = False
        self._margins = QMargins(0, 0, 8, 0)
        self._grid = ui.grid(spacing=(_GAP, 2))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(self._margins)
        layout.addLayout(self._grid)
        layout.addStretch(1)

        learning.changed.connect(self._on_changed)
        learning.measured.connect(self._on_changed)
        self._arrange()
        self._on_changed()

    def minimumSizeHint(self) -> QSize:
        """As wide as it needs with the words below the bars."""
        least = super().minimumSizeHint()
        least.setWidth(self._least_width(narrow=True))
        return least

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        narrow = self.width() < self._least_width(narrow=False)
        if narrow != self._narrow:
            self._narrow = narrow
            self._arrange()

    @property
    def least_seen(self) -> int:
        """How many pixels of the page have to be in sight: a whole row."""
        return max((row.least_height() for row in self._rows), default=0)

    def _least_width(self, *, narrow: bool) -> int:
        widest = max((row.least_width(narrow=narrow) for row in self._rows), default=0)
        margins = self._margins
        return widest + (_GAP if narrow else 2 * _GAP) + margins.left() + margins.right()

    def _arrange(self) -> None:
        self._grid.setColumnStretch(1, 3)
        self._grid.setColumnStretch(2, 0 if self._narrow else 2)
        for number, row in enumerate(self._rows):
            row.put_into(self._grid, _ROWS * number, narrow=self._narrow)

    def make_row(self, channel: LearnedChannel) -> ChannelRow:
        """Make the row of one channel."""
        raise NotImplementedError

    @Slot()
    def _on_changed(self) -> None:
        for row in self._rows:
            row.refresh()
