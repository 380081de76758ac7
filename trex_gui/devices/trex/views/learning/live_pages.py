"""The pages that show live inputs: at rest, in motion, and in the test of the sticks."""

from collections.abc import Sequence
from enum import Enum

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QGridLayout, QLabel, QWidget

from trex_gui.core.translation import Number, tr, tr_noop
from trex_gui.devices.trex.calibration.neutral import no_signal
from trex_gui.devices.trex.calibration.travel import Travel, Way
from trex_gui.devices.trex.model.learning.channels import LearnedChannel
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.model.learning.problem_text import problem_text, problems_text
from trex_gui.devices.trex.model.learning.stick_tests import StickTest, StickTests
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.descriptions import CHANNEL_ROLES
from trex_gui.devices.trex.views.bars import ChannelBar, OutputBar
from trex_gui.devices.trex.views.steps import Page
from trex_gui.ui.theme.theme import follow_theme, set_text_color
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Muted, Note, Sign

_GAP = 12
_TEXT_WIDTH = 20  # characters of the text beside a bar before it wraps


def _channel_label(channel: int, parent: QWidget) -> QLabel:
    name = tr("Channel {0}").format(channel)
    text = f"<b>{name}</b><br><small>{tr(CHANNEL_ROLES[channel])}</small>"
    return ui.label(parent, text=text, rich=True)


class ChannelRow:
    """One channel: its name and live bar, below the bar signs and text, or a problem."""

    text_name = ""

    def __init__(
        self, learning: Learning, channel: LearnedChannel, page: QWidget, grid: QGridLayout
    ) -> None:
        self.learning = learning
        self.channel = channel
        number = channel.number
        self.bar = ChannelBar(page)
        self.bar.setAccessibleName(tr("Raw input of channel {0}").format(number))
        self.bar.set_connected(True)
        self.bar.set_scale(channel.source, None)
        self.text = ui.label(page, f"{self.text_name}{number}", wrap=True)
        self._problem = ui.named(Note(1, page), f"learnProblem{number}")
        signs = self.make_signs(page)
        below = ui.row(*signs, (self.text, 1), (self._problem, 1), margins=0, spacing=4)
        row = grid.rowCount()
        grid.addWidget(_channel_label(number, page), row, 0)
        grid.addWidget(self.bar, row, 1)
        # Qt works out a height too low for text that wraps across a column without a width.
        grid.addLayout(below, row + 1, 1)

    def make_signs(self, parent: QWidget) -> Sequence[QWidget]:
        raise NotImplementedError

    def refresh(self) -> None:
        self.bar.set_value(self.channel.raw)

    def show_problem(self, problem: str) -> None:
        """Show a problem instead of the text, if there is any."""
        self._problem.show_note(problem, alarming=bool(problem))
        self._problem.setVisible(bool(problem))
        self.text.setVisible(not problem)


class ChannelRows(Page):
    def __init__(self, learning: Learning, name: str, row: type[ChannelRow]) -> None:
        super().__init__(name)
        grid = ui.grid(spacing=(_GAP, 2), stretch=[(1, 1)])
        self._rows = [row(learning, channel, self, grid) for channel in learning.channels]
        ui.column(grid, 1, into=self, margins=0)

        for changed in (learning.changed, learning.measured):
            changed.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        for row in self._rows:
            row.refresh()


class RestRow(ChannelRow):
    """The rest position of a channel and its noise."""

    text_name = "learnNeutral"

    def make_signs(self, parent: QWidget) -> Sequence[QWidget]:
        self._sign = Sign(parent)
        return [self._sign]

    def refresh(self) -> None:
        super().refresh()
        problems = self.channel.rest_problems
        self.show_problem(problems_text(problems))
        if problems:
            self._sign.show_sign("warning", "warning")
        elif self.learning.has_sampled and self.channel.is_at_rest:
            self._sign.show_sign("ok", "good")
        else:
            self._sign.show_sign("")
        neutral = self.channel.neutral
        text = ""
        if neutral is None:
            text = tr("not sampled yet")
        elif neutral.invalid < 1:
            place = neutral.source.text(neutral.value)
            text = tr("at rest: {0}, noise {1}").format(place, neutral.noise_text)
        self.text.setText(text)


class EndState(Enum):
    """State of an end: its sign, the colour, and words."""

    OPEN = "○", "muted", tr_noop("{0} end: not reached yet")
    HOLD = "▸", "window_text", tr_noop("{0} end: hold it there")
    DONE = "✓", "good", tr_noop("{0} end: reached")
    NEEDLESS = "", "muted", tr_noop("{0} end: not needed")  # a switch has shown its other end


class EndSign(QLabel):
    """The name of an end and its sign; its width never changes."""

    def __init__(self, name: str, object_name: str, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName(object_name)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self._name = name
        self._state: EndState | None = None
        widest = f"{name} MM"
        follow_theme(
            self, "room", lambda: self.setFixedWidth(self.fontMetrics().horizontalAdvance(widest))
        )
        self.show_state(EndState.OPEN)

    def show_state(self, state: EndState) -> None:
        if state is self._state:
            return
        self._state, (sign, color, text) = state, state.value
        self.setText(sign and f"{self._name} {sign}")
        set_text_color(self, color)
        self.setToolTip(ui.plain(tr(text).format(self._name)))  # also read by screen readers


class TravelRow(ChannelRow):
    """The ends of a channel so far as marks on its bar, with a sign for each."""

    text_name = "learnTravel"

    def make_signs(self, parent: QWidget) -> Sequence[QWidget]:
        number = self.channel.number
        self._ends = {
            Way.DOWN: EndSign(tr("low"), f"learnEndDown{number}", parent),
            Way.UP: EndSign(tr("high"), f"learnEndUp{number}", parent),
        }
        return list(self._ends.values())

    def refresh(self) -> None:
        super().refresh()
        travel = self.channel.travel
        for sign in self._ends.values():
            sign.setVisible(travel is not None)
        if travel is None:
            self.text.setText(tr("Left out: its rest position is not known."))
            self.show_problem("")
            return
        self._show_ends(travel)
        self.text.setText(self._text(travel))
        is_silent = self.channel.is_silent
        self.show_problem(problem_text(no_signal(travel.source)) if is_silent else "")

    def _show_ends(self, travel: Travel) -> None:
        reached = {way: travel.reached(way) for way in Way}
        low, high = (travel.end(way) if reached[way] else travel.neutral for way in Way)
        marks = Calibration(low, travel.neutral, high, travel.deadband)
        self.bar.set_scale(travel.source, marks)
        for way, sign in self._ends.items():
            if travel.held(way):
                sign.show_state(EndState.DONE)
            elif way is travel.to_hold:
                sign.show_state(EndState.HOLD)
            elif travel.is_enough and not reached[way]:
                sign.show_state(EndState.NEEDLESS)
            else:
                sign.show_state(EndState.OPEN)

    def _text(self, travel: Travel) -> str:
        if travel.to_hold is not None:
            return tr("Hold it there …")
        if any(travel.reached(way) and not travel.held(way) for way in Way):
            return tr("Not held. Hold it there for {0:.1f} s.").format(Number(travel.hold_seconds))
        held = [travel.source.text(travel.end(way)) for way in Way if travel.held(way)]
        return tr("Reached: {0}.").format(", ".join(held)) if held else tr("No end reached yet.")


class TestPage(Page):
    """A row for each channel that is tested; below them, what safe-start would do."""

    __test__ = False

    def __init__(self, learning: Learning, tests: StickTests) -> None:
        super().__init__("learnTestPage")
        self._tests = tests
        self._rows: list[tuple[StickTest, OutputBar, Sign, QLabel]] = []
        self._safe_start = ui.named(Note(3, self.side), "learnSafeStart")
        explanation = tr(
            "Calculated from the values in the board, for each channel by itself. Assumed: up to "
            "8 of 127 counts as neutral; the switching points of switches."
        )

        grid = ui.grid(spacing=(_GAP, _GAP), stretch=[(1, 3), (3, 3)])
        for row, test in enumerate(tests.tests):
            number = test.channel
            bar = OutputBar(self)
            bar.setAccessibleName(tr("Output of channel {0}").format(number))
            bar.set_connected(True)
            sign, text = Sign(self), ui.label(self, f"learnTest{number}", wrap=True)
            text.setMinimumWidth(_TEXT_WIDTH * text.fontMetrics().averageCharWidth())
            for column, widget in enumerate((_channel_label(number, self), bar, sign, text)):
                grid.addWidget(widget, row, column)
            self._rows.append((test, bar, sign, text))
        ui.column(grid, 1, into=self, margins=0)
        ui.column(self._safe_start, Muted(explanation, self.side), into=self.side, margins=0)

        for changed in (learning.changed, learning.measured):
            changed.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        for test, bar, sign, text in self._rows:
            bar.set_value(test.output)
            text.setText(test.text)
            sign.show_sign(*_sign_of(test))
        held = bool(self._tests.safe_start_reasons)
        self._safe_start.show_note(self._tests.safe_start_text, alarming=held)


def _sign_of(test: StickTest) -> tuple[str, str]:
    """Return the icon of a channel and its colour; the text beside it says the same."""
    if test.ignored:
        return "info", "muted"
    if test.output is None:
        return "warning", "warning"
    return ("ok", "good") if test.passed else ("todo", "muted")
