"""Problem cards, and the quality of the connection."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime

from PySide6.QtCore import QPointF, QSize, Qt, Signal, Slot
from PySide6.QtGui import QPaintEvent, QPen, QResizeEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QSizePolicy, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.ui.runtime import now
from trex_gui.ui.theme.theme import set_look, set_style_property, set_text_color, theme
from trex_gui.ui.traffic.model import TrafficModel
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.labels import LiveLabel, Muted, Sign
from trex_gui.ui.widgets.painted import Painted, Painter
from trex_gui.ui.widgets.view import View

_MINUTE, _SLOT = 60.0, 0.5  # seconds: time span of the plot, time span of a point
_MAX_LATENESS = 5.0  # seconds after which a request and its reply are in the log


@dataclass(frozen=True, slots=True)
class Problem:
    key: str  # identifier; prefix of the card's object names
    title: str  # including the state: "Motor 1 fault, active now"
    text: str  # meaning and remedy, for the user
    times: str  # count and time of the last occurrence, for the user
    is_active: bool = False
    is_cleared: bool = False  # True if the user has cleared the problem since it last occurred
    page: str = ""  # key of a page with details; empty if there is none
    topic: str = ""  # help topic; empty if there is none
    name: str = ""  # text of the problem in the traffic log
    seen_at: float = 0.0  # time of the last occurrence on the monotonic clock, in seconds

    @property
    def line(self) -> str:
        return " ".join(filter(None, (f"{self.title}.", self.text, self.times)))


@dataclass(frozen=True, slots=True)
class Reading:
    caption: str
    value: str
    details: str = ""  # text of the tool tip
    is_bad: bool = False

    def unknown(self) -> "Reading":
        return Reading(self.caption, "–")


class ProblemCard(ui.Card):
    def __init__(self, key: str, page: "ProblemsPage") -> None:
        super().__init__("", page)
        self.setObjectName(f"{key}Problem")
        self._sign = Sign(self)
        self._name = ui.label(self, f"{key}Title", size="heading", wrap=True)
        self._text = ui.label(self, f"{key}Text", wrap=True, selectable=True)
        self._times = ui.label(self, f"{key}Times", size="caption", wrap=True)
        self._show, self._clear, self._explain = buttons = [
            ui.button(self, f"{key}{name}", text.replace("&", ""), confirms=True)
            for name, text in (
                ("Show", tr("Show it")),
                ("Clear", title_of(tr("C&lear"))),
                ("Explain", tr("E&xplain")),
            )
        ]
        set_look(self._explain, "link")
        self._show.clicked.connect(lambda: page.page_requested.emit(self.problem))
        self._clear.clicked.connect(lambda: page.clear(self.problem.key))
        self._explain.clicked.connect(lambda: page.help_requested.emit(self.problem.topic))
        texts = ui.column(self._name, self._text, self._times, spacing=4)
        sign = self._sign, 0, Qt.AlignmentFlag.AlignTop
        ui.row(sign, (texts, 1), *buttons, into=self, spacing=12)

    def show_problem(self, problem: Problem) -> None:
        self.problem = problem
        sign = ("error", "danger") if problem.is_active else ("warning", "warning")
        self._sign.show_sign(*(("todo", "muted") if problem.is_cleared else sign))
        for label, text in (
            (self._name, problem.title),
            (self._text, problem.text),
            (self._times, problem.times),
        ):
            if label.text() != text:
                label.setText(text)
            label.setVisible(bool(text))
        self.setAccessibleName(problem.title)
        set_look(self._show, "primary" if problem.is_active else "")
        for button, is_offered in (
            (self._show, problem.page and not problem.is_cleared),
            (self._clear, not problem.is_cleared),
            (self._explain, problem.topic and not problem.is_cleared),
        ):
            button.setVisible(bool(is_offered))
            button.setAccessibleDescription(problem.title)
        self._update_height()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._update_height()

    def _update_height(self) -> None:
        # On a small page, the card must scroll instead of cutting off its text.
        self.setMinimumHeight(self.heightForWidth(self.width()))


class ConnectionCard(ui.Card):
    def __init__(self, name: str, traffic: TrafficModel, parent: QWidget) -> None:
        super().__init__(tr("Connection"), parent)
        self._name = name
        self._labels: list[tuple[QLabel, LiveLabel]] = []
        self._grid: QGridLayout = ui.grid(margins=0, spacing=(16, 0))
        self._plot = RoundTrips(traffic, self)
        self._caption = ui.label(self, f"{name}RoundTrip", size="caption")
        ui.column(self._grid, (self._plot, 1), self._caption, into=self, spacing=8)

    def show_readings(self, readings: Sequence[Reading]) -> None:
        for column in range(len(self._labels), len(readings)):
            caption = ui.label(self, size="caption", wrap=True)
            value = LiveLabel(f"{self._name}Reading{column + 1}", "", self)
            set_style_property(value, "textSize", "title")
            self._grid.addWidget(caption, 0, column, Qt.AlignmentFlag.AlignBottom)
            self._grid.addWidget(value, 1, column)
            self._grid.setColumnStretch(column, 1)
            self._labels.append((caption, value))
        for (caption, value), reading in zip(self._labels, readings, strict=True):
            caption.setText(reading.caption)
            value.setAccessibleName(reading.caption)
            value.setText(reading.value)
            set_text_color(value, "warning" if reading.is_bad else "window_text")
            for label in (caption, value):
                label.setToolTip(ui.plain(reading.details))
        self._plot.refresh()
        text = tr("Round trips in the last minute: up to {0:.0f} ms")
        self._caption.setText(text.format(1000 * self._plot.longest))
        self._caption.setVisible(self._plot.longest > 0)


class RoundTrips(Painted):
    """Plot of the slowest poll in each half second of the last minute."""

    def __init__(self, traffic: TrafficModel, parent: QWidget) -> None:
        super().__init__(parent)
        self._traffic = traffic
        self._seconds = dict[int, float]()  # slot number → longest round trip
        self._oldest = 0  # first slot in the plot
        self._refreshed = -math.inf  # time of the last refresh
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Expanding)

    @property
    def longest(self) -> float:
        return max(self._seconds.values(), default=0.0)

    def sizeHint(self) -> QSize:
        return QSize(0, 8 * self.fontMetrics().height())

    def minimumSizeHint(self) -> QSize:
        return QSize(0, 3 * self.fontMetrics().height())

    def refresh(self) -> None:
        """Add new requests, and earlier requests whose replies have arrived since then."""
        since, self._refreshed = self._refreshed - _MAX_LATENESS, now()
        self._oldest = int(self._refreshed / _SLOT) - round(_MINUTE / _SLOT) + 1
        self._seconds = {
            slot: seconds for slot, seconds in self._seconds.items() if slot >= self._oldest
        }
        for row in reversed(self._traffic.everything.rows):
            slot = int(row.time / _SLOT)
            if row.time < since or slot < self._oldest:
                break
            if row.is_routine and row.seconds is not None:
                self._seconds[slot] = max(self._seconds.get(slot, 0.0), row.seconds)
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        width, height = self.width() * _SLOT / _MINUTE, (self.height() - 3) / (self.longest or 1)
        with Painter(self) as painter:
            painter.setPen(theme().color("hairline"))
            painter.drawLine(0, self.height() - 1, self.width(), self.height() - 1)
            painter.setPen(QPen(theme().color("accent"), 1.5))
            points = [
                QPointF((slot - self._oldest + 0.5) * width, self.height() - 1.5 - seconds * height)
                for slot, seconds in sorted(self._seconds.items())
            ]
            painter.drawPolyline(points)


class ProblemsPage(View):
    page_requested = Signal(object)  # the `Problem` whose details the user wants to see
    help_requested = Signal(str)  # help topic
    counted = Signal(int)  # number of uncleared problems, after each update

    def __init__(self, name: str, traffic: TrafficModel, parent: QWidget) -> None:
        """`name`: prefix of object names."""
        super().__init__(parent)
        self.setObjectName(f"{name}Page")
        self._shown: list[Problem] = []  # in display order, including hidden problems
        self._cards = dict[str, ProblemCard]()
        self._column = ui.column(margins=0, spacing=12)
        self._note = ui.named(Muted("", self), f"{name}Note")
        self.note_row = ui.row((self._note, 1))
        self._connection = ConnectionCard(name, traffic, self)
        self._connection.hide()
        parts = self._column, self.note_row, (self._connection, 1), 0
        ui.column(*parts, into=self, margins=(0, 12, 0, 16), spacing=12)

    def problems(self) -> Sequence[Problem]:
        raise NotImplementedError

    def since(self) -> datetime | None:
        """Return the local time when monitoring started, or `None`."""
        raise NotImplementedError

    def readings(self) -> Sequence[Reading]:
        raise NotImplementedError

    def clear(self, key: str) -> None:
        """Mark a problem as cleared until it occurs again."""
        raise NotImplementedError

    @Slot()
    def show_problems(self) -> None:
        """Update the cards. Active problems come first; otherwise the order does not change."""
        newest = {problem.key: problem for problem in self.problems()}
        before = [problem.key for problem in self._shown if problem.key in newest]
        order = [*(key for key in newest if key not in before), *before]
        problems = (newest[key] for key in order)
        self._shown = sorted(problems, key=lambda problem: not problem.is_active)
        for key in self._cards.keys() - newest.keys():
            self._cards.pop(key).deleteLater()
        for index, problem in enumerate(self._shown):
            card = self._cards.get(problem.key) or ProblemCard(problem.key, self)
            self._cards[problem.key] = card
            if self._column.indexOf(card) != index:
                self._column.insertWidget(index, card)
            card.show_problem(problem)
            card.setVisible(self.matches(problem.line))
        self._note.setText(self._status_text())
        self.counted.emit(sum(not problem.is_cleared for problem in self._shown))

    @Slot()
    @only_when_visible
    def refresh(self) -> None:
        self.show_problems()
        is_watched = self.since() is not None
        self._connection.setVisible(is_watched)
        self._connection.show_readings(self.readings())
        active = sum(problem.is_active for problem in self._shown)
        self.summarized.emit(tr("%n problem(s) active now", "", active) if active else "")

    def _status_text(self) -> str:
        since = self.since()
        text = tr("Nothing has gone wrong since {0:%H:%M}.")
        if since is None:
            text = tr("Nothing is connected.")
        elif self._shown:
            text = tr("Nothing else has gone wrong since {0:%H:%M}.")
        return text.format(since)

    @staticmethod
    def times_text(count: int, last: datetime) -> str:
        return tr("%n time(s), last at {0:%H:%M:%S}", "", count).format(last)

    def lines(self) -> Sequence[str]:
        return [
            *(problem.line for problem in self._shown if self.matches(problem.line)),
            self._note.text(),
            *(tr("{0}: {1}").format(item.caption, item.value) for item in self.readings()),
        ]
