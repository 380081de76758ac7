"""The log of a workspace: messages and events with their times, and the page of it."""

import logging
import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtGui import QGuiApplication, QShowEvent, QTextCursor
from PySide6.QtWidgets import QPlainTextEdit, QWidget

from trex_gui.core.events import Event
from trex_gui.core.files import save
from trex_gui.core.translation import tr
from trex_gui.ui.event_log import EventLog
from trex_gui.ui.files import save_in_background
from trex_gui.ui.help.messages import MessageHelp
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.runtime import now
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.behaviour import only_when_visible

log = logging.getLogger(__name__)

MOST_ENTRIES = 2000  # kept; the oldest are dropped
_LONGEST = 2000  # characters of one entry
_REPEATED = 1.0  # seconds in which the same text again is the same entry: event and message
_SIGN = "⚠"


@dataclass(frozen=True, slots=True)
class LogEntry:
    time: datetime  # local
    text: str  # one line, for the user
    is_problem: bool
    line: str  # as it is shown, copied and saved: time, sign of a problem, text


class Log(QObject):
    """The newest entries, over the end of connections."""

    added = Signal(object)  # the new `LogEntry`

    def __init__(
        self,
        parent: QObject | None = None,
        *,
        clock: Callable[[], float] = now,
        wall_clock: Callable[[], float] = time.time,
    ) -> None:
        """`clock` is that of events, `wall_clock` gives seconds since 1970."""
        super().__init__(parent)
        self._clock = clock
        self._wall_clock = wall_clock
        self.entries = deque[LogEntry](maxlen=MOST_ENTRIES)  # in the order of their arrival

    def follow(self, events: EventLog) -> None:
        """Log every event from now on."""
        events.happened.connect(self._on_happened)

    def add(self, text: str, *, is_problem: bool = False, at: float | None = None) -> None:
        """Log a message, now or at a time of `clock`."""
        line = " ".join(text.split())
        line = line if len(line) <= _LONGEST else f"{line[:_LONGEST]} …"
        age = 0.0 if at is None else self._clock() - at
        moment = datetime.fromtimestamp(self._wall_clock() - age).astimezone()
        last = self.entries[-1] if self.entries else None
        if last is not None and last.text == line:
            is_repeated = (moment - last.time).total_seconds() < _REPEATED
            if is_repeated and last.is_problem >= is_problem:
                return
        sign = f"{_SIGN} " if is_problem else ""
        whole = f"{moment:%Y-%m-%d %H:%M:%S}  {sign}{line}"
        self.entries.append(LogEntry(moment, line, is_problem, whole))
        log.info("%s%s", sign, line)
        self.added.emit(self.entries[-1])

    @Slot(object)
    def _on_happened(self, event: Event) -> None:
        self.add(event.text, is_problem=event.is_problem, at=event.time)


class LogPage(QWidget):
    """The entries, newest at the bottom; can be searched, copied and saved."""

    help_wanted = Signal(str)  # the topic of the line with the cursor

    def __init__(
        self,
        log: Log,
        key: str,
        notifier: Notifier,
        message_help: MessageHelp,
        parent: QWidget | None = None,
    ) -> None:
        """`key` begins the object names and the proposed file name."""
        super().__init__(parent)
        self._message_help = message_help
        self.setObjectName(f"{key}LogPage")
        self._log = log
        self._key = key
        self._notifier = notifier
        self._search = ui.search_field(
            self, f"{key}LogSearch", tr("Search the log"), tr("Search the log (Ctrl+F)")
        )
        self._problems = ui.check_box(
            self, f"{key}LogProblems", tr("O&nly problems"), on_toggle=self._fill
        )
        self._help = ui.button(
            self,
            f"{key}LogHelp",
            tr("E&xplain"),
            icon="help",
            tip=tr("Show the help on the message in the line with the cursor"),
            on_click=lambda: self.help_wanted.emit(self._topic),
        )
        copy = ui.button(
            self,
            f"{key}LogCopy",
            tr("Cop&y"),
            icon="copy",
            tip=tr("Copy the lines shown"),
            on_click=self._copy,
        )
        save_button = ui.button(
            self,
            f"{key}LogSave",
            tr("Sa&ve…"),
            icon="save",
            tip=tr("Save the lines shown as text"),
            on_click=self._ask_and_save,
        )
        self._text = ui.named(QPlainTextEdit(self), f"{key}Log", accessible=tr("Log"))
        self._text.setReadOnly(True)
        self._text.setUndoRedoEnabled(False)
        self._text.setMaximumBlockCount(MOST_ENTRIES)
        self._text.setPlaceholderText(
            tr("Messages, stops, lost connections and written settings will be listed here.")
        )
        self._text.cursorPositionChanged.connect(self._on_cursor_moved)
        above = ui.row((self._search, 1), self._problems, self._help, copy, save_button)
        self.rows = ui.column(above, (self._text, 1), into=self)

        self._search.textChanged.connect(self._fill)
        log.added.connect(self._on_added)

    def _is_shown(self, entry: LogEntry) -> bool:
        if self._problems.isChecked() and not entry.is_problem:
            return False
        return self._search.text().strip().casefold() in entry.line.casefold()

    @property
    def _lines(self) -> list[str]:
        return [entry.line for entry in self._log.entries if self._is_shown(entry)]

    @Slot()
    @only_when_visible
    def _fill(self) -> None:
        self._text.setPlainText("\n".join(self._lines))
        self._text.moveCursor(QTextCursor.MoveOperation.End)
        self._on_cursor_moved()

    @Slot(object)
    def _on_added(self, entry: LogEntry) -> None:
        if self.isVisible() and self._is_shown(entry):
            self._text.appendPlainText(entry.line)  # scrolls if the end was in view

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._fill()

    @property
    def _topic(self) -> str:
        return self._message_help.topic(self._text.textCursor().block().text())

    @Slot()
    @only_when_visible
    def _on_cursor_moved(self) -> None:
        self._help.setEnabled(bool(self._topic))

    @Slot()
    def _copy(self) -> None:
        lines = self._lines
        QGuiApplication.clipboard().setText("".join(f"{line}\n" for line in lines))
        self._notifier.info.emit(tr("%n line(s) copied.", "", len(lines)))

    @Slot()
    def _ask_and_save(self) -> None:
        name = f"{self._key}_log_{datetime.now().astimezone():%Y-%m-%d_%H-%M-%S}.txt"
        path = file_questions.ask_to_save(
            self,
            tr("Save the log"),
            file_questions.last_folder() / name,
            tr("Text (*.txt)"),
            ".txt",
        )
        if path is not None:
            self.save(path)

    def save(self, path: Path) -> None:
        """Write the lines shown to a file, beside the window's thread."""
        file_questions.remember_folder(path)
        text = "".join(f"{line}\n" for line in self._lines)
        saved = tr("The log was written to {0}.").format(path)
        save_in_background(self, partial(save, path, text), self._notifier, saved)
