"""The place *Diagnostics* and its log page."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, TypeVar

from PySide6.QtCore import QSignalBlocker, Signal, Slot
from PySide6.QtGui import QTextCursor
from PySide6.QtWidgets import QPlainTextEdit, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.ui.frame.places import Place
from trex_gui.ui.frame.workspace import PageInfo, Workspace
from trex_gui.ui.help.messages import MessageHelp
from trex_gui.ui.log import MAX_ENTRIES, Log, LogEntry
from trex_gui.ui.plotting.page import PlotPage
from trex_gui.ui.theme.theme import follow_theme, set_look
from trex_gui.ui.traffic.page import TrafficPage
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.labels import PageHead
from trex_gui.ui.widgets.scroll_box import ScrollBox
from trex_gui.ui.widgets.view import View, copy_lines

if TYPE_CHECKING:
    from trex_gui.ui.diagnostics.problems import Problem, ProblemsPage

_SEARCH_WIDTH = 26  # average characters

ViewT = TypeVar("ViewT", bound=View)


class LogPage(View):
    help_requested = Signal(str)  # help topic of the line with the cursor

    def __init__(
        self, log: Log, key: str, message_help: MessageHelp, parent: QWidget | None = None
    ) -> None:
        """`key`: prefix of object names."""
        super().__init__(parent)
        self._message_help = message_help
        self.setObjectName(f"{key}LogPage")
        self._log = log
        self._problems = ui.check_box(
            self, f"{key}LogProblems", tr("O&nly problems"), on_toggle=self.refresh
        )
        tip = tr("Show help for the message at the cursor")
        self._help = ui.button(self, f"{key}LogHelp", tr("E&xplain"), icon="help", tip=tip)
        self._help.clicked.connect(lambda: self.help_requested.emit(self._topic))
        self._text = ui.named(QPlainTextEdit(self), f"{key}Log", accessible=title_of(tr("Lo&g")))
        self._text.setReadOnly(True)
        self._text.setUndoRedoEnabled(False)
        self._text.setMaximumBlockCount(MAX_ENTRIES)
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
            self._text.appendPlainText(entry.line)  # scrolls if the end was visible
            self._summarize()

    def _summarize(self) -> None:
        shown, total = len(self.lines()), len(self._log.entries)
        self.summarized.emit(tr("{0} of {1} shown").format(shown, total))

    @property
    def _topic(self) -> str:
        return self._message_help.topic(self._text.textCursor().block().text())

    @Slot()
    @only_when_visible
    def _on_cursor_moved(self) -> None:
        self._help.setEnabled(bool(self._topic))


class Diagnostics(Place):
    def __init__(self, workspace: Workspace, name: str, show_help: Callable[[str], object]) -> None:
        """`name`: prefix of object names. `show_help` opens a help topic."""
        super().__init__(f"{name}Page", tr("Diagnostics"), workspace)
        self._workspace, self._show_help = workspace, show_help
        hint = tr("Search (Ctrl+F)")
        self._search = ui.search_field(self, f"{name}Search", hint, hint)
        tip = tr("Copy the selected rows, or everything shown")
        copy = ui.button(self, f"{name}Copy", tr("Cop&y"), icon="copy", tip=tip)
        copy.clicked.connect(self._copy)
        tip = tr("Save a report for support; it is shown before it is written")
        report = ui.button(self, f"{name}Report", tr("Sa&ve report…"), icon="save", tip=tip)
        report.clicked.connect(lambda: workspace.trigger("report"))
        head = PageHead(tr("Diagnostics"), self, self._search, copy, report)
        self._head = ui.named(head, f"{name}Head")
        self.add_tabs(self._head)
        set_look(self.tabs.tabBar(), "choices")
        self.tabs.tabBar().setDrawBase(False)
        follow_theme(self._search, "space", self._update_width)
        self._search.textChanged.connect(self._on_searched)
        workspace.page_changed.connect(self._on_page_changed)

    def _update_width(self) -> None:
        width = _SEARCH_WIDTH * self._search.fontMetrics().averageCharWidth()
        self._search.setMinimumWidth(width)

    def pages(
        self, problems: "Callable[[QWidget], ProblemsPage]", traffic: Callable[[QWidget], View]
    ) -> tuple[PageInfo, ...]:
        workspace = self._workspace

        def create_problems(parent: QWidget) -> QWidget:
            page = self._with_summary(problems(parent))
            page.page_requested.connect(self._show_problem)
            page.help_requested.connect(self._show_help)
            page.counted.connect(self._show_count)
            page.show_problems()
            return page

        def create_log(parent: QWidget) -> QWidget:
            log, key, message_help = workspace.log, workspace.key, workspace.message_help
            page = self._with_summary(LogPage(log, key, message_help, parent))
            page.help_requested.connect(self._show_help)
            return page

        def create_traffic(parent: QWidget) -> QWidget:
            return self._with_summary(traffic(parent))

        return (
            PageInfo("errors", tr("Prob&lems"), create_problems, "pulse", self),
            PageInfo("log", tr("Lo&g"), create_log, "", self),
            PageInfo("transcript", tr("T&raffic"), create_traffic, "", self),
        )

    def _with_summary(self, page: ViewT) -> ViewT:
        page.summarized.connect(self._head.show_state)
        return page

    @property
    def _view(self) -> View | None:
        box = self.tabs.currentWidget()
        view = box.widget() if isinstance(box, ScrollBox) else None
        return view if isinstance(view, View) else None

    @Slot()
    def _on_page_changed(self) -> None:
        if self._view is not None:
            with QSignalBlocker(self._search):
                self._search.setText(self._view.searched)

    @Slot(str)
    def _on_searched(self, text: str) -> None:
        if self._view is not None:
            self._view.search(text)

    @Slot(object)
    def _show_problem(self, problem: "Problem") -> None:
        workspace = self._workspace
        workspace.show_page(problem.page)
        box = workspace.page_at(workspace.current)
        page = box.widget() if isinstance(box, ScrollBox) else None
        if isinstance(page, TrafficPage | PlotPage):
            page.show_moment(problem.seen_at, problem.name)

    @Slot()
    def _copy(self) -> None:
        if self._view is not None:
            copy_lines(self._view.lines(), self._workspace.notifier)

    @Slot(int)
    def _show_count(self, count: int) -> None:
        self._workspace.set_page_count("errors", count)
