"""Page of the log of a workspace."""

from collections.abc import Sequence

from PySide6.QtCore import Signal, Slot
from PySide6.QtGui import QTextCursor
from PySide6.QtWidgets import QPlainTextEdit, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.ui.help.messages import MessageHelp
from trex_gui.ui.log import MOST_ENTRIES, Log, LogEntry
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.view import View


class LogPage(View):
    help_wanted = Signal(str)  # the topic of the line with the cursor

    def __init__(
        self, log: Log, key: str, message_help: MessageHelp, parent: QWidget | None = None
    ) -> None:
        """Create the page. `key` is the prefix of the object names."""
        super().__init__(parent)
        self._message_help = message_help
        self.setObjectName(f"{key}LogPage")
        self._log = log
        self._problems = ui.check_box(
            self, f"{key}LogProblems", tr("O&nly problems"), on_toggle=self.refresh
        )
        self._help = ui.button(
            self,
            f"{key}LogHelp",
            tr("E&xplain"),
            icon="help",
            tip=tr("Show the help on the message in the line with the cursor"),
            on_click=lambda: self.help_wanted.emit(self._topic),
        )
        self._text = ui.named(QPlainTextEdit(self), f"{key}Log", accessible=title_of(tr("Lo&g")))
        self._text.setReadOnly(True)
        self._text.setUndoRedoEnabled(False)
        self._text.setMaximumBlockCount(MOST_ENTRIES)
        self._text.setPlaceholderText(
            tr("Messages, stops, lost connections and written settings will be listed here.")
        )
        self._text.cursorPositionChanged.connect(self._on_cursor_moved)
        above = ui.row(self._problems, 1, self._help)
        ui.column(above, (self._text, 1), into=self, margins=(0, 12, 0, 16))
        log.added.connect(self._on_added)

    def _is_shown(self, entry: LogEntry) -> bool:
        return (entry.is_problem or not self._problems.isChecked()) and self.matches(entry.line)

    def lines(self) -> Sequence[str]:
        return [entry.line for entry in self._log.entries if self._is_shown(entry)]

    @Slot()
    @only_when_visible
    def refresh(self) -> None:
        self._text.setPlainText("\n".join(self.lines()))
        self._text.moveCursor(QTextCursor.MoveOperation.End)
        self._on_cursor_moved()
        self._summarize()

    @Slot(object)
    def _on_added(self, entry: LogEntry) -> None:
        if self.isVisible() and self._is_shown(entry):
            self._text.appendPlainText(entry.line)  # scrolls if the end was in view
            self._summarize()

    def _summarize(self) -> None:
        shown, every = len(self.lines()), len(self._log.entries)
        self.summarized.emit(tr("{0} of {1} shown").format(shown, every))

    @property
    def _topic(self) -> str:
        return self._message_help.topic(self._text.textCursor().block().text())

    @Slot()
    @only_when_visible
    def _on_cursor_moved(self) -> None:
        self._help.setEnabled(bool(self._topic))
