"""Pages with live inputs: sticks at rest, sticks in motion, and the stick test."""

import math
from collections.abc import Callable, Sequence
from enum import Enum
from typing import Any, Generic, TypeVar

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QGridLayout, QLabel, QWidget

from trex_gui.core.texts import signed_text
from trex_gui.core.translation import Number, tr, tr_noop
from trex_gui.devices.trex.calibration.neutral import no_signal
from trex_gui.devices.trex.calibration.travel import Travel, Way
from trex_gui.devices.trex.model.learning.channels import LearnedChannel
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.model.learning.problem_text import problem_text, problems_text
from trex_gui.devices.trex.model.learning.stick_tests import StickTest, StickTests
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.views.pages.channels.strips import ChannelStrip
from trex_gui.devices.trex.views.steps import Page
from trex_gui.ui.theme.theme import follow_theme, set_text_color
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Muted, Note, Sign

ChannelT = TypeVar("ChannelT", bound=LearnedChannel | StickTest)

_TEXT_WIDTH = 24  # width of the text beside a strip, in characters
_MIN_LINES = 3.2  # minimum height of a strip, in lines of text


class InputStrip(ChannelStrip):
    """Channel strip that cannot be selected."""

    spoken_role = QAccessible.Role.Graphic

    def __init__(self, name: str, channel: int, parent: QWidget | None = None) -> None:
        super().__init__(channel, parent)
        self.setObjectName(f"{name}{channel}Strip")
        self.setToolTip(ui.plain(self._name))
        self.setCheckable(False)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._scale: tuple[InputSource, Calibration | None] | None = None
        follow_theme(self, "space", self._update_space)

    def _update_space(self) -> None:
        self.setMinimumHeight(round(_MIN_LINES * self.fontMetrics().height()))

    def show_input(
        self,
        time: float,
        source: InputSource,
        marks: Calibration | None,
        raw: int | None,
        output: int | None = None,
    ) -> None:
        """Add a sample if its `time` is new. `raw` is `None` if there is no signal."""
        if (source, marks) != self._scale:
            self._scale = source, marks
            self.set_scale(source, marks)
        if time > self._newest:
            self.add_samples((time,), (math.nan if raw is None else raw,))
        text = tr("no signal") if raw is None else source.text(raw)
        self.show_texts(text, "" if output is None else signed_text(output), text)


class ChannelRow(Generic[ChannelT]):
    text_name = ""

    def __init__(
        self, learning: Learning, channel: ChannelT, page: QWidget, grid: QGridLayout
    ) -> None:
        self.learning = learning
        self.channel: ChannelT = channel
        number, row = channel.number, grid.rowCount()
        self.strip = InputStrip("learn", number, page)
        self.text = ui.named(Note(1, page), f"{self.text_name}{number}")
        self.text.setMinimumWidth(_TEXT_WIDTH * self.text.fontMetrics().averageCharWidth())
        grid.addWidget(self.strip, row, 0)
        grid.addLayout(ui.row(*self.create_signs(page), margins=0), row, 1)
        grid.addWidget(self.text, row, 2, Qt.AlignmentFlag.AlignVCenter)
        grid.setRowStretch(row, 1)

    def create_signs(self, page: QWidget) -> Sequence[QWidget]:
        self.sign = Sign(page)
        return [self.sign]

    def refresh(self) -> None:
        raise NotImplementedError


class ChannelRows(Page):
    def __init__(
        self,
        learning: Learning,
        name: str,
        row: Callable[[Learning, ChannelT, QWidget, QGridLayout], ChannelRow[ChannelT]],
        channels: Sequence[ChannelT],
    ) -> None:
        super().__init__(name)
        grid = ui.grid(self, margins=0, spacing=(12, 8), stretch=[(0, 3), (2, 2)])
        self._rows: list[ChannelRow[Any]] = [
            row(learning, channel, self, grid) for channel in channels
        ]
        for changed in (learning.changed, learning.measured):
            changed.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        for row in self._rows:
            row.refresh()


class RestRow(ChannelRow[LearnedChannel]):
    text_name = "learnNeutral"

    def refresh(self) -> None:
        channel, neutral = self.channel, self.channel.neutral
        self.strip.show_input(channel.time, channel.source, None, channel.raw)
        problems = channel.rest_problems
        is_good = self.learning.has_sampled and channel.is_at_rest
        sign = ("ok", "good") if is_good else ("", "")
        self.sign.show_sign(*(("warning", "warning") if problems else sign))
        text = problems_text(problems)
        if neutral is None:
            text = text or tr("not sampled yet")
        elif not text and neutral.invalid < 1:
            position = neutral.source.text(neutral.value)
            text = tr("at rest: {0}, noise {1}").format(position, neutral.noise_text)
        self.text.show_note(text, alarming=bool(problems))


class EndState(Enum):
    OPEN = "○", "muted", tr_noop("{0} end: not reached yet")
    HOLD = "▸", "window_text", tr_noop("{0} end: hold this position")
    DONE = "✓", "good", tr_noop("{0} end: reached")
    NOT_NEEDED = "", "muted", tr_noop("{0} end: not needed")  # a switch reached its other end


class EndSign(QLabel):
    def __init__(self, name: str, object_name: str, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName(object_name)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self._name = name
        self._state: EndState | None = None
        widest = f"{name} MM"
        follow_theme(
            self, "space", lambda: self.setFixedWidth(self.fontMetrics().horizontalAdvance(widest))
        )
        self.show_state(EndState.OPEN)

    def show_state(self, state: EndState) -> None:
        if state is self._state:
            return
        self._state, (sign, color, text) = state, state.value
        self.setText(sign and f"{self._name} {sign}")
        set_text_color(self, color)
        self.setToolTip(ui.plain(tr(text).format(self._name)))  # also for screen readers


class TravelRow(ChannelRow[LearnedChannel]):
    text_name = "learnTravel"

    def create_signs(self, page: QWidget) -> Sequence[QWidget]:
        number = self.channel.number
        self._ends = {
            Way.DOWN: EndSign(tr("low"), f"learnEndDown{number}", page),
            Way.UP: EndSign(tr("high"), f"learnEndUp{number}", page),
        }
        return list(self._ends.values())

    def refresh(self) -> None:
        channel, travel = self.channel, self.channel.travel
        for sign in self._ends.values():
            sign.setVisible(travel is not None)
        if travel is None:
            self.strip.show_input(channel.time, channel.source, None, channel.raw)
            self.text.show_note(tr("Left out: the rest position is unknown."))
            return
        self._show_ends(travel)
        text = problem_text(no_signal(travel.source)) if channel.is_silent else self._text(travel)
        self.text.show_note(text, alarming=channel.is_silent)

    def _show_ends(self, travel: Travel) -> None:
        reached = {way: travel.has_reached(way) for way in Way}
        low, high = (travel.end(way) if reached[way] else travel.neutral for way in Way)
        marks = Calibration(low, travel.neutral, high, travel.deadband)
        self.strip.show_input(self.channel.time, travel.source, marks, self.channel.raw)
        for way, sign in self._ends.items():
            if travel.is_held(way):
                sign.show_state(EndState.DONE)
            elif way is travel.hold_direction:
                sign.show_state(EndState.HOLD)
            elif travel.is_enough and not reached[way]:
                sign.show_state(EndState.NOT_NEEDED)
            else:
                sign.show_state(EndState.OPEN)

    def _text(self, travel: Travel) -> str:
        if travel.hold_direction is not None:
            return tr("Hold this position …")
        if any(travel.has_reached(way) and not travel.is_held(way) for way in Way):
            return tr("Not held. Hold this position for {0:.1f} s.").format(
                Number(travel.hold_seconds)
            )
        held = [travel.source.text(travel.end(way)) for way in Way if travel.is_held(way)]
        return tr("Reached: {0}.").format(", ".join(held)) if held else tr("No end reached yet.")


class TestRow(ChannelRow[StickTest]):
    __test__ = False
    text_name = "learnTest"

    def refresh(self) -> None:
        test = self.channel
        self.strip.show_input(test.time, test.source, test.calibration, test.raw, test.output)
        self.text.show_note(test.text)
        self.sign.show_sign(*_sign_of(test))


class TestPage(ChannelRows):
    __test__ = False

    def __init__(self, learning: Learning, tests: StickTests) -> None:
        super().__init__(learning, "learnTestPage", TestRow, tests.tests)
        self._tests = tests
        self._safe_start = ui.named(Note(3, self.side), "learnSafeStart")
        explanation = tr(
            "Calculated from the values in the board, separately for each channel. Two "
            "assumptions: outputs of up to 8 of 127 are neutral, and switches change halfway "
            "between neutral and the end (inferred)."
        )
        ui.column(self._safe_start, Muted(explanation, self.side), into=self.side, margins=0)

    def refresh(self) -> None:
        held = bool(self._tests.safe_start_reasons)
        self._safe_start.show_note(self._tests.safe_start_text, alarming=held)


def _sign_of(test: StickTest) -> tuple[str, str]:
    if test.ignored:
        return "info", "muted"
    if test.output is None:
        return "warning", "warning"
    return ("ok", "good") if test.passed else ("todo", "muted")
