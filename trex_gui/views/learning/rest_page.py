"""Hands off the sticks: where each channel rests, and how still."""

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QGridLayout, QLabel, QProgressBar, QVBoxLayout, QWidget

from trex_gui.learning.neutral import SAMPLING_SECONDS
from trex_gui.model.learned_channel import LearnedChannel
from trex_gui.model.learning import Learning
from trex_gui.views.learning.parts import Sign, channel_label, in_words
from trex_gui.views.widgets.channel_bar import ChannelBar
from trex_gui.views.widgets.note import Note


class RestPage(QWidget):
    """A row a channel: its live bar, what was measured, what is wrong."""

    def __init__(self, learning: Learning, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._learning = learning

        self._rows = [_RestRow(channel, self) for channel in learning.channels]
        self._progress = QProgressBar(self)
        self._progress.setObjectName("learnProgress")
        self._progress.setAccessibleName(self.tr("Progress of sampling"))
        self._progress.setRange(0, round(1000 * SAMPLING_SECONDS))
        self._progress.setTextVisible(False)

        grid = QGridLayout()
        grid.setHorizontalSpacing(12)
        grid.setColumnStretch(1, 3)
        grid.setColumnStretch(3, 2)
        for number, row in enumerate(self._rows):
            row.put_into(grid, 2 * number)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(grid)
        layout.addStretch(1)
        layout.addWidget(self._progress)

        learning.changed.connect(self._on_changed)
        learning.measured.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        left = self._learning.seconds_left if self._learning.sampling else SAMPLING_SECONDS
        done = SAMPLING_SECONDS - left
        self._progress.setValue(round(1000 * done))
        self._progress.setEnabled(self._learning.sampling)
        for row in self._rows:
            row.refresh(ended=self._learning.has_sampled)


class _RestRow:
    """One channel."""

    def __init__(self, channel: LearnedChannel, page: QWidget) -> None:
        self._channel = channel
        self._page = page
        number = channel.number
        self._name = channel_label(number, page)
        self._bar = ChannelBar(page)
        self._bar.setAccessibleName(page.tr("Raw input of channel {0}").format(number))
        self._bar.set_connected(True)
        self._bar.set_source(channel.source)
        self._sign = Sign(page)
        self._measured = QLabel(page)
        self._measured.setObjectName(f"learnNeutral{number}")
        self._problem = Note(1, page)
        self._problem.setObjectName(f"learnProblem{number}")

    def put_into(self, grid: QGridLayout, row: int) -> None:
        grid.addWidget(self._name, row, 0)
        grid.addWidget(self._bar, row, 1)
        grid.addWidget(self._sign, row, 2)
        grid.addWidget(self._measured, row, 3)
        grid.addWidget(self._problem, row + 1, 1, 1, 3)

    def refresh(self, *, ended: bool) -> None:
        channel = self._channel
        self._bar.set_raw(channel.raw)
        problems = channel.rest_problems
        self._problem.show_note(in_words(problems), alarming=bool(problems))
        if problems:
            self._sign.show_sign("warning", "warning")
        elif ended and channel.is_at_rest:
            self._sign.show_sign("ok", "good")
        else:
            self._sign.show_sign("")
        self._measured.setText(self._text())

    def _text(self) -> str:
        neutral = self._channel.neutral
        if neutral is None or neutral.invalid == 1:
            return self._page.tr("not sampled yet") if neutral is None else ""
        return self._page.tr("rests at {0}, wavers by {1}").format(
            neutral.source.text(neutral.value), neutral.noise_text
        )
