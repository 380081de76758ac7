"""Every stick to all its ends: how far each channel went, to each side."""

from PySide6.QtWidgets import QWidget

from trex_gui.learning.neutral import no_signal
from trex_gui.learning.travel import Task, Travel, Way
from trex_gui.model.learned_channel import LearnedChannel
from trex_gui.model.learning import Learning
from trex_gui.protocol.calibration import Calibration
from trex_gui.views.learning.channel_rows import ChannelRow, ChannelRows


class TravelPage(ChannelRows):
    """A row a channel: the live bar with the ends so far as marks, a tick a direction."""

    def __init__(self, learning: Learning, parent: QWidget | None = None) -> None:
        super().__init__(learning, parent)
        self.setObjectName("learnTravelPage")

    def make_row(self, channel: LearnedChannel) -> ChannelRow:
        return _TravelRow(channel, self, words="learnTravel", signs=len(Way))


class _TravelRow(ChannelRow):
    """One channel."""

    def refresh(self) -> None:
        super().refresh()
        travel = self.channel.travel
        if travel is None:
            self.words.setText(self.page.tr("Left out: where it rests is not known."))
            self.problem.show_note("")
            return
        if travel.low is not None and travel.high is not None:
            low, high = min(travel.low, travel.neutral), max(travel.high, travel.neutral)
            self.bar.set_calibration(Calibration(low, travel.neutral, high, travel.deadband))
        for way, sign in zip((Way.DOWN, Way.UP), self.signs, strict=True):
            if travel.held(way):
                sign.show_sign("ok", "good")
            else:
                sign.show_sign("run" if way is travel.to_hold else "")
        self.words.setText(self._text(travel))
        silent = travel.is_silent
        self.problem.show_note(no_signal(travel.source).text if silent else "", alarming=silent)

    def _text(self, travel: Travel) -> str:
        if travel.to_hold is not None:
            return self.page.tr("Hold it there …")
        down, up = travel.held(Way.DOWN), travel.held(Way.UP)
        low, high = (travel.source.text(end or 0) for end in (travel.low, travel.high))
        if down and up:
            return self.page.tr("Both ends reached: {0} and {1}.").format(low, high)
        for way in Way:
            if travel.reached(way) and not travel.held(way):
                return self._passed_text(travel, way)
        if (down or up) and travel.task is not Task.STICK:
            return self.page.tr("Reached: {0}.").format(low if down else high)
        if down:
            return self.page.tr("Low end reached: {0}. Now the other way.").format(low)
        if up:
            return self.page.tr("High end reached: {0}. Now the other way.").format(high)
        if travel.task is Task.SWITCH:
            return self.page.tr("Not moved yet. Use every position.")
        return self.page.tr("No end reached yet.")

    def _passed_text(self, travel: Travel, way: Way) -> str:
        if way is Way.DOWN:
            text = self.page.tr("Low end only passed: push it there again, hold it for {0:.1f} s.")
        else:
            text = self.page.tr("High end only passed: push it there again, hold it for {0:.1f} s.")
        return text.format(travel.hold_seconds)
