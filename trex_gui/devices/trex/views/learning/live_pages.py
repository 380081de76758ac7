"""The pages that show live inputs: at rest, in motion, and in the test of the sticks."""

from collections.abc import Sequence
from enum import Enum

from PySide6.QtCore import QMargins, QSize, Qt, Slot
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QWidget

from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.calibration.neutral import no_signal
from trex_gui.devices.trex.calibration.travel import Task, Travel, Way
from trex_gui.devices.trex.model.learning.channels import LearnedChannel
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.model.learning.problem_text import problem_text, problems_text
from trex_gui.devices.trex.model.learning.stick_tests import StickTest, StickTests
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.descriptions import CHANNEL_ROLES
from trex_gui.devices.trex.views.bars import ChannelBar, OutputBar
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import keep_room
from trex_gui.ui.widgets.labels import Muted, Note, Sign

_GAP = 12
_MARGINS = QMargins(0, 0, 8, 0)
_BAR_GROWS = 0.5  # of its least width, before text gets a place beside a bar
_TEXT_WIDTH = 26
_TEST_TEXT_WIDTH = 20  # characters of the text beside a bar before it wraps


def _channel_label(channel: int, parent: QWidget) -> QLabel:
    name = tr("Channel {0}").format(channel)
    text = f"<b>{name}</b><br><small>{tr(CHANNEL_ROLES[channel])}</small>"
    return ui.label(parent, text=text, rich=True)


def _text_label(parent: QWidget, name: str, characters: int) -> QLabel:
    label = ui.label(parent, name, wrap=True)
    label.setMinimumWidth(characters * label.fontMetrics().averageCharWidth())
    return label


class ChannelRow:
    """One channel: its name and live bar, signs and text beside or below it, then a problem."""

    text_name = ""

    def __init__(self, learning: Learning, channel: LearnedChannel, page: QWidget) -> None:
        self.learning = learning
        self.channel = channel
        self.page = page
        self._narrow = False
        number = channel.number
        self._name = _channel_label(number, page)
        self.bar = ChannelBar(page)
        self.bar.setAccessibleName(tr("Raw input of channel {0}").format(number))
        self.bar.set_connected(True)
        self.bar.set_source(channel.source)
        self._beside = QWidget(page)
        self.text = _text_label(self._beside, f"{self.text_name}{number}", _TEXT_WIDTH)
        self.problem = ui.named(Note(1, page), f"learnProblem{number}")

        row = ui.row(*self.make_signs(self._beside), into=self._beside, margins=0)
        row.addSpacing(4)
        row.addWidget(self.text, 1)

    def make_signs(self, parent: QWidget) -> Sequence[QWidget]:
        raise NotImplementedError

    def put_into(self, grid: QGridLayout, row: int, *, narrow: bool) -> None:
        """Fill three rows of a grid: name, bar and text; the text if `narrow`; a problem."""
        for widget in (self._name, self.bar, self._beside, self.problem):
            grid.removeWidget(widget)
        self._narrow = narrow
        self._align()
        grid.addWidget(self._name, row, 0)
        grid.addWidget(self.bar, row, 1)
        grid.addWidget(self._beside, row + narrow, 1 if narrow else 2)
        # Qt works out a height too low for text that wraps across a column without a width.
        grid.addWidget(self.problem, row + 2, 1, 1, 1 if narrow else 2)

    def least_width(self, *, narrow: bool) -> int:
        """Return the width in pixels, without the gaps between name, bar and text."""
        bar, text = (widget.minimumSizeHint().width() for widget in (self.bar, self._beside))
        both = max(bar, text) if narrow else bar + round(_BAR_GROWS * bar) + text
        return self._name.minimumSizeHint().width() + both

    def least_height(self) -> int:
        """Return the height with the text below the bar, and a problem of three lines."""
        lines = 3 * self.problem.fontMetrics().lineSpacing()
        return self.bar.minimumSizeHint().height() + self._beside.minimumSizeHint().height() + lines

    def refresh(self) -> None:
        self.bar.set_raw(self.channel.raw)
        self._align()

    def _align(self) -> None:
        """Align the problem and the text with the track of the bar."""
        inset = self.bar.inset
        self.problem.setContentsMargins(inset, 0, 0, 0)
        self._beside.setContentsMargins(inset if self._narrow else 0, 0, 0, 0)


class ChannelRows(QWidget):
    """A page with a row for each channel that is learned."""

    def __init__(self, learning: Learning, name: str, row: type[ChannelRow]) -> None:
        super().__init__()
        self.setObjectName(name)
        self._rows = [row(learning, channel, self) for channel in learning.channels]
        self._narrow = False
        self._grid = ui.grid(spacing=(_GAP, 2))
        ui.column(self._grid, 1, into=self).setContentsMargins(_MARGINS)

        for changed in (learning.changed, learning.measured):
            changed.connect(self._on_changed)
        self._arrange()
        self._on_changed()

    def minimumSizeHint(self) -> QSize:
        """As wide as it has to be with the text below the bars."""
        return QSize(self._least_width(narrow=True), super().minimumSizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        narrow = self.width() < self._least_width(narrow=False)
        if narrow != self._narrow:
            self._narrow = narrow
            self._arrange()

    @property
    def least_seen(self) -> int:
        """How many pixels of the page have to be visible: a whole row."""
        return max(row.least_height() for row in self._rows)

    def _least_width(self, *, narrow: bool) -> int:
        widest = max(row.least_width(narrow=narrow) for row in self._rows)
        return widest + (_GAP if narrow else 2 * _GAP) + _MARGINS.left() + _MARGINS.right()

    def _arrange(self) -> None:
        self._grid.setColumnStretch(1, 3)
        self._grid.setColumnStretch(2, 0 if self._narrow else 2)
        for number, row in enumerate(self._rows):
            row.put_into(self._grid, 3 * number, narrow=self._narrow)

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
        self.problem.show_note(problems_text(problems), alarming=bool(problems))
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
    """State of an end: its icon and the colour."""

    OPEN = "todo", "muted"
    HOLD = "run", "icon"
    DONE = "ok", "good"
    NEEDLESS = "", "icon"  # a switch or a throttle that has shown its other end


class EndSign(QWidget):
    """The name of an end and whether it was reached; its place never changes."""

    def __init__(self, name: str, object_name: str, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName(object_name)
        self._name = name
        self._label = ui.label(self, text=name)
        self._sign = Sign(self)
        keep_room(self._label)
        ui.row(self._label, self._sign, into=self, margins=(0, 0, 4, 0), spacing=2)
        self.show_state(EndState.OPEN)

    def show_state(self, state: EndState) -> None:
        self._sign.show_sign(*state.value)
        self._label.setVisible(state is not EndState.NEEDLESS)
        texts = {
            EndState.OPEN: tr("{0} end: not reached yet"),
            EndState.HOLD: tr("{0} end: hold it there"),
            EndState.DONE: tr("{0} end: reached"),
            EndState.NEEDLESS: tr("{0} end: not needed"),
        }
        text = texts[state].format(self._name)
        if text != self.accessibleName():
            self.setAccessibleName(text)
            self.setToolTip(ui.plain(text))


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
            self.problem.show_note("")
            return
        self._show_ends(travel)
        self.text.setText(self._text(travel))
        silent = self.channel.is_silent
        problem = problem_text(no_signal(travel.source)) if silent else ""
        self.problem.show_note(problem, alarming=silent)

    def _show_ends(self, travel: Travel) -> None:
        reached = {way: travel.reached(way) for way in Way}
        low, high = (travel.end(way) if reached[way] else travel.neutral for way in Way)
        marks = Calibration(low, travel.neutral, high, travel.deadband)
        self.bar.set_calibration(marks, minimum=reached[Way.DOWN], maximum=reached[Way.UP])
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
        low, high = (travel.source.text(travel.end(way)) for way in Way)
        passed_low = tr("The low end was not held. Push it there again and hold it for {0:.1f} s.")
        passed_high = tr(
            "The high end was not held. Push it there again and hold it for {0:.1f} s."
        )
        for way, text in ((Way.DOWN, passed_low), (Way.UP, passed_high)):
            if travel.reached(way) and not travel.held(way):
                return text.format(Number(travel.hold_seconds))
        match travel.held(Way.DOWN), travel.held(Way.UP):
            case True, True:
                return tr("Both ends reached: {0} and {1}.").format(low, high)
            case down, up if (down or up) and travel.task is not Task.STICK:
                return tr("Reached: {0}.").format(low if down else high)
            case True, False:
                return tr("Low end reached: {0}. Now the other way.").format(low)
            case False, True:
                return tr("High end reached: {0}. Now the other way.").format(high)
        if travel.task is Task.SWITCH:
            return tr("Not moved yet. Move the switch to every position.")
        return tr("No end reached yet.")


class TestPage(QWidget):
    """A row for each channel that is tested; below them, what safe-start would do."""

    __test__ = False

    def __init__(self, learning: Learning, tests: StickTests) -> None:
        super().__init__()
        self.setObjectName("learnTestPage")
        self._tests = tests
        self._rows: list[tuple[StickTest, OutputBar, Sign, QLabel]] = []
        self._safe_sign = Sign(self)
        self._safe_start = ui.named(Note(2, self), "learnSafeStart")
        explanation = tr(
            "Calculated from the values in the board, for each channel by itself. From the "
            "manual: full output at and beyond the ends, 0 in the deadband, and what "
            "safe-start waits for. Assumed: up to 8 of 127 counts as neutral; the switching "
            "points of switches."
        )

        grid = ui.grid(spacing=(_GAP, _GAP), stretch=[(1, 3), (3, 3)])
        for row, test in enumerate(tests.tests):
            number = test.channel
            bar = OutputBar(self)
            bar.setAccessibleName(tr("Output of channel {0}").format(number))
            bar.set_connected(True)
            sign, text = Sign(self), _text_label(self, f"learnTest{number}", _TEST_TEXT_WIDTH)
            for column, widget in enumerate((_channel_label(number, self), bar, sign, text)):
                grid.addWidget(widget, row, column)
            self._rows.append((test, bar, sign, text))
        safe_start = ui.row((self._safe_sign, 0, Qt.AlignmentFlag.AlignTop), (self._safe_start, 1))
        items = grid, 1, safe_start, Muted(explanation, self)
        ui.column(*items, into=self).setContentsMargins(_MARGINS)

        for changed in (learning.changed, learning.measured):
            changed.connect(self._on_changed)
        self._on_changed()

    @property
    def least_seen(self) -> int:
        """How many pixels of the page have to be visible: a whole row."""
        text = 3 * self.fontMetrics().lineSpacing()
        return max([text, *(bar.minimumSizeHint().height() for _, bar, _, _ in self._rows)])

    @Slot()
    def _on_changed(self) -> None:
        for test, bar, sign, text in self._rows:
            bar.set_value(test.output)
            text.setText(test.text)
            sign.show_sign(*_sign_of(test))
        held = bool(self._tests.safe_start_reasons)
        self._safe_start.show_note(self._tests.safe_start_text, alarming=held)
        good = "ok" if self._tests.heard else ""
        self._safe_sign.show_sign(*(("warning", "warning") if held else (good, "good")))


def _sign_of(test: StickTest) -> tuple[str, str]:
    """Return the icon of a channel and its colour; the text beside it says the same."""
    if test.ignored:
        return "info", "muted"
    if test.output is None:
        return "warning", "warning"
    return ("ok", "good") if test.passed else ("todo", "muted")
