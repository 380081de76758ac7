"""Every stick to all its ends: how far each channel went, to each side."""

from collections.abc import Sequence
from enum import Enum, auto

from PySide6.QtWidgets import QLabel, QWidget

from trex_gui.devices.trex.calibration.neutral import no_signal
from trex_gui.devices.trex.calibration.travel import Task, Travel, Way
from trex_gui.devices.trex.model.learning.channel import LearnedChannel
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.views.learning.channel_rows import ChannelRow, ChannelRows
from trex_gui.devices.trex.views.learning.parts import Sign
from trex_gui.ui.widgets import builders as ui


class TravelPage(ChannelRows):
    """A row a channel: the live bar with the ends so far as marks, a tick a direction."""

    def __init__(self, learning: Learning, parent: QWidget | None = None) -> None:
        super().__init__(learning, parent)
        self.setObjectName("learnTravelPage")

    def make_row(self, channel: LearnedChannel) -> ChannelRow:
        return _TravelRow(channel, self, words="learnTravel")


class EndState(Enum):
    """How it stands with one end of a channel."""

    OPEN = auto()
    HOLD = auto()
    DONE = auto()
    NEEDLESS = auto()  # a switch or a throttle that has shown its other end


_ICONS = {
    EndState.OPEN: ("todo", "muted"),
    EndState.HOLD: ("run", "icon"),
    EndState.DONE: ("ok", "good"),
    EndState.NEEDLESS: ("", "icon"),
}


class EndSign(QWidget):
    """The name of an end and whether it was reached; there from the start, always in its place."""

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._name = name
        self._label = QLabel(name, self)
        self._sign = Sign(self)
        policy = self._label.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        self._label.setSizePolicy(policy)

        ui.row(self._label, self._sign, into=self, margins=(0, 0, 4, 0), spacing=2)

        self.show_state(EndState.OPEN)

    def show_state(self, state: EndState) -> None:
        """Show how it stands, to screen readers, too."""
        self._sign.show_sign(*_ICONS[state])
        self._label.setVisible(state is not EndState.NEEDLESS)
        texts = {
            EndState.OPEN: self.tr("{0} end: not reached yet"),
            EndState.HOLD: self.tr("{0} end: hold it there"),
            EndState.DONE: self.tr("{0} end: reached"),
            EndState.NEEDLESS: self.tr("{0} end: not needed"),
        }
        text = texts[state].format(self._name)
        if text != self.accessibleName():
            self.setAccessibleName(text)
            self.setToolTip(text)


class _TravelRow(ChannelRow):
    """One channel."""

    def make_signs(self, beside: QWidget) -> Sequence[QWidget]:
        names = {Way.DOWN: self.page.tr("low"), Way.UP: self.page.tr("high")}
        self._ends = {way: EndSign(name, beside) for way, name in names.items()}
        for way, sign in self._ends.items():
            sign.setObjectName(f"learnEnd{way.name.capitalize()}{self.channel.number}")
        return list(self._ends.values())

    def refresh(self) -> None:
        super().refresh()
        travel = self.channel.travel
        for sign in self._ends.values():
            sign.setVisible(travel is not None)
        if travel is None:
            self.words.setText(self.page.tr("Left out: its rest position is not known."))
            self.problem.show_note("")
            return
        self._show_ends(travel)
        self.words.setText(self._text(travel))
        silent = travel.is_silent
        self.problem.show_note(no_signal(travel.source).text if silent else "", alarming=silent)

    def _show_ends(self, travel: Travel) -> None:
        """Mark and tick the ends that were reached; others are only named."""
        down, up = travel.reached(Way.DOWN), travel.reached(Way.UP)
        low = travel.low if down and travel.low is not None else travel.neutral
        high = travel.high if up and travel.high is not None else travel.neutral
        marks = Calibration(low, travel.neutral, high, travel.deadband)
        self.bar.set_calibration(marks, minimum=down, maximum=up)
        for way, sign in self._ends.items():
            if travel.held(way):
                sign.show_state(EndState.DONE)
            elif way is travel.to_hold:
                sign.show_state(EndState.HOLD)
            elif travel.is_enough and not travel.reached(way):
                sign.show_state(EndState.NEEDLESS)
            else:
                sign.show_state(EndState.OPEN)

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
            return self.page.tr("Not moved yet. Move the switch to every position.")
        return self.page.tr("No end reached yet.")

    def _passed_text(self, travel: Travel, way: Way) -> str:
        if way is Way.DOWN:
            text = self.page.tr(
                "The low end was not held. Push it there again and hold it for {0:.1f} s."
            )
        else:
            text = self.page.tr(
                "The high end was not held. Push it there again and hold it for {0:.1f} s."
            )
        return text.format(travel.hold_seconds)
