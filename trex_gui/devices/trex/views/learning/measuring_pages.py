"""The pages that measure: a row for each channel with a live bar, at rest and in motion."""

from collections.abc import Sequence
from enum import Enum, auto

from PySide6.QtCore import QCoreApplication, QMargins, QSize, Qt, Slot
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QVBoxLayout, QWidget

from trex_gui.devices.trex.calibration.neutral import no_signal
from trex_gui.devices.trex.calibration.travel import Task, Travel, Way
from trex_gui.devices.trex.client.explanations import CHANNEL_ROLES
from trex_gui.devices.trex.model.learning.channels import LearnedChannel
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.model.learning.problem_text import problem_text, problems_text
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.views.bars import ChannelBar
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Note, Sign

_ROWS = 3
_GAP = 12

_BAR_GROWS = 0.5
"""Share of its least width by which a bar is longer before words get a place beside it."""

_WORDS_WIDE = 26
"""Characters that words beside a bar have room for before they wrap."""


def channel_label(channel: int, parent: QWidget) -> QLabel:
    """Make the label of a channel: its number, and what it does."""
    words = QCoreApplication.translate("learning", "Channel {0}").format(channel)
    label = QLabel(f"<b>{words}</b><br><small>{CHANNEL_ROLES[channel]}</small>", parent)
    label.setTextFormat(Qt.TextFormat.RichText)
    return label


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

        row = ui.row(*self.make_signs(self.beside), into=self.beside, margins=0)
        row.addSpacing(4)
        row.addWidget(self.words, 1)

    def make_signs(self, beside: QWidget) -> Sequence[QWidget]:
        """Create the signs before the words."""
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
        self.bar.set_raw(self.channel.raw)
        self._align()

    def _align(self) -> None:
        """Align the problem and the words with the track of the bar."""
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
        raise NotImplementedError

    @Slot()
    def _on_changed(self) -> None:
        for row in self._rows:
            row.refresh()


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
        self.problem.show_note(problems_text(problems), alarming=bool(problems))
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


class TravelPage(ChannelRows):
    """A row a channel: the live bar with the ends so far as marks, a tick a direction."""

    def __init__(self, learning: Learning, parent: QWidget | None = None) -> None:
        super().__init__(learning, parent)
        self.setObjectName("learnTravelPage")

    def make_row(self, channel: LearnedChannel) -> ChannelRow:
        return _TravelRow(channel, self, words="learnTravel")


class EndState(Enum):
    """The state of one end of a channel."""

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
        """Show the state, also to screen readers."""
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
        self.problem.show_note(
            problem_text(no_signal(travel.source)) if silent else "", alarming=silent
        )

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
