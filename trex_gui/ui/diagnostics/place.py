"""The place *Diagnostics* of a device."""

from collections.abc import Callable
from typing import TYPE_CHECKING, TypeVar

from PySide6.QtCore import QSignalBlocker, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.frame.places import Place
from trex_gui.ui.frame.workspace import PageInfo, Workspace
from trex_gui.ui.theme.theme import follow_theme, set_look
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import PageHead
from trex_gui.ui.widgets.scroll_box import ScrollBox
from trex_gui.ui.widgets.view import View, copy_lines

if TYPE_CHECKING:
    from trex_gui.ui.diagnostics.problems import Problem, ProblemsPage

_SEARCH = 26  # average characters


ViewT = TypeVar("ViewT", bound=View)


class Diagnostics(Place):
    """Problems, log and traffic, with common search, copy and save."""

    def __init__(self, workspace: Workspace, name: str, show_help: Callable[[str], object]) -> None:
        """`name` begins the object names. `show_help` opens a topic of the help."""
        super().__init__(f"{name}Page", tr("Diagnostics"), workspace)
        self._workspace, self._show_help = workspace, show_help
        hint = tr("Search (Ctrl+F)")
        self._search = ui.search_field(self, f"{name}Search", hint, hint)
        copy = ui.button(
            self,
            f"{name}Copy",
            tr("Cop&y"),
            icon="copy",
            tip=tr("Copy the selected rows, or all that is shown"),
            on_click=self._copy,
        )
        report = ui.button(
            self,
            f"{name}Report",
            tr("Sa&ve report…"),
            icon="save",
            tip=tr("Save a report for support; it is shown before it is written"),
            on_click=lambda: workspace.trigger("report"),
        )
        head = PageHead(tr("Diagnostics"), self, self._search, copy, report)
        self._head = ui.named(head, f"{name}Head")
        self.add_tabs(self._head)
        set_look(self.tabs.tabBar(), "choices")
        self.tabs.tabBar().setDrawBase(False)
        follow_theme(self._search, "room", self._free_space)
        self._search.textChanged.connect(self._on_searched)
        workspace.page_changed.connect(self._on_page_changed)

    def _free_space(self) -> None:
        width = _SEARCH * self._search.fontMetrics().averageCharWidth()
        self._search.setMinimumWidth(width)

    def pages(
        self, problems: "Callable[[QWidget], ProblemsPage]", traffic: Callable[[QWidget], View]
    ) -> tuple[PageInfo, ...]:
        """Return the three pages. The arguments create the first and the last page."""
        owner = self._workspace

        def create_problems(parent: QWidget) -> QWidget:
            page = self._joined(problems(parent))
            page.page_wanted.connect(self._show_more)
            page.help_wanted.connect(self._show_help)
            page.counted.connect(self._show_count)
            page.show_problems()
            return page

        def create_log(parent: QWidget) -> QWidget:
            from trex_gui.ui.diagnostics.log_page import LogPage  # noqa: PLC0415 - later

            page = self._joined(LogPage(owner.log, owner.key, owner.message_help, parent))
            page.help_wanted.connect(self._show_help)
            return page

        return (
            PageInfo("errors", tr("Prob&lems"), create_problems, "pulse", self),
            PageInfo("log", tr("Lo&g"), create_log, "", self),
            PageInfo(
                "transcript", tr("T&raffic"), lambda parent: self._joined(traffic(parent)), "", self
            ),
        )

    def _joined(self, page: ViewT) -> ViewT:
        page.summarized.connect(self._head.show_state)
        return page

    @property
    def _view(self) -> View | None:
        box = self.tabs.currentWidget()
        view = box.widget() if isinstance(box, ScrollBox) else None
        return view if isinstance(view, View) else None

    @Slot()
    def _on_page_changed(self) -> None:
        """Show the search text of this page."""
        if self._view is not None:
            with QSignalBlocker(self._search):
                self._search.setText(self._view.searched)

    @Slot(str)
    def _on_searched(self, text: str) -> None:
        if self._view is not None:
            self._view.search(text)

    @Slot(object)
    def _show_more(self, problem: "Problem") -> None:
        from trex_gui.ui.plotting.page import PlotPage  # noqa: PLC0415 - later
        from trex_gui.ui.traffic.page import TrafficPage  # noqa: PLC0415 - later

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
