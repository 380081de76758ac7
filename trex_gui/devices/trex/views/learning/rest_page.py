"""Hands off the sticks: where each channel rests, and how still."""

from collections.abc import Sequence

from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.model.learning.channel import LearnedChannel
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.views.learning.channel_rows import ChannelRow, ChannelRows
from trex_gui.devices.trex.views.learning.parts import Sign, in_words


class RestPage(ChannelRows):
    """A row a channel: its live bar, what was measured, what is wrong."""

    def __init__(self, learning: Learning, parent: QWidget | None = None) -> None:
        super().__init__(learning, parent)
        self.setObjectName("learnRestPage")

    def make_row(self, channel: LearnedChannel) -> ChannelRow:
        return _RestRow(channel, self)


class _RestRow(ChannelRow):
    """One channel."""

    def __init__(self, channel: LearnedChannel, page: RestPage) -> None:
        super().__init__(channel, page, words="learnNeutral")
        self._learning = page.learning

    def make_signs(self, beside: QWidget) -> Sequence[QWidget]:
        self._sign = Sign(beside)
        return [self._sign]

    def refresh(self) -> None:
        super().refresh()
        problems = self.channel.rest_problems
        self.problem.show_note(in_words(problems), alarming=bool(problems))
        sign = self._sign
        if problems:
            sign.show_sign("warning", "warning")
        elif self._learning.has_sampled and self.channel.is_at_rest:
            sign.show_sign("ok", "good")
        else:
            sign.show_sign("")
        self.words.setText(self._text())

    def _text(self) -> str:
        neutral = self.channel.neutral
        if neutral is None or neutral.invalid == 1:
            return self.page.tr("not sampled yet") if neutral is None else ""
        return self.page.tr("at rest: {0}, noise {1}").format(
            neutral.source.text(neutral.value), neutral.noise_text
        )
