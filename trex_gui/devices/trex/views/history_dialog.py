"""Window that lists, compares and restores snapshots."""

from functools import partial
from pathlib import Path

from PySide6.QtCore import QEvent, QItemSelectionModel, Qt, Signal, Slot
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QAbstractItemView, QStackedWidget, QTableView, QWidget

from trex_gui.core.errors import StudioError
from trex_gui.core.files import load, save
from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.snapshots import SnapshotColumn, SnapshotTable
from trex_gui.devices.trex.settings.history import Snapshot
from trex_gui.devices.trex.views.motor_controls import MotorBar
from trex_gui.devices.trex.views.snapshot_pane import SnapshotPane
from trex_gui.ui.files import in_background
from trex_gui.ui.notifier import Answer, Notifier
from trex_gui.ui.runtime import new_timer
from trex_gui.ui.theme.theme import set_look
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.messages import Banner, InlinePrompt, MessageSpace
from trex_gui.ui.widgets.placement import restore_geometry, save_geometry

_MAX_COLUMN_WIDTH = 34  # characters


class HistoryDialog(ReusedDialog):
    """Window for the saved snapshots. Restored values become edits."""

    restore_requested = Signal()  # the edits are ready for review

    def __init__(self, device: Device, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("historyDialog")
        self.setWindowTitle(title_of(tr("&History…")))
        set_look(self, "sheet")
        self.setWindowFlags(Qt.WindowType.Window)
        self._history = device.writer.history
        self._table = SnapshotTable(device.writer.history, self)
        self._newest_selected: tuple[int, Path | None] = 0, None  # row, path
        self._is_fitted = False
        self._refresh_timer = new_timer(self, 0, self._refresh_selection, single_shot=True)
        # Reading starts after the window is drawn, because the reading thread slows down drawing.
        self._read_timer = new_timer(self, 0, self.refresh, single_shot=True)

        notifier = Notifier(self)
        device.notifier.forward_log(notifier)
        self._banner = ui.named(Banner(self, notifier), "historyBanner")
        self._question = ui.named(InlinePrompt(self), "historyQuestion")
        hint = tr("Search times, boards, adapters (Ctrl+F)")
        self._search = ui.search_field(self, "snapshotSearch", tr("Search snapshots"), hint)
        self._view = self._list_view()
        self._no_match = ui.label(self, "snapshotNoMatch", tr("No snapshot matches the search."))
        self._no_match.hide()
        button = partial(ui.button, self, default=False)
        tip = tr(
            "Name the snapshot (or double-click it). A named snapshot is never deleted "
            "automatically"
        )
        self._name = button("nameSnapshotButton", tr("&Name…"), icon="edited", tip=tip)
        tip = tr("Save a copy as a settings file")
        self._save = button("saveSnapshotButton", tr("Save &as…"), icon="save", tip=tip)
        self._delete = button("deleteSnapshotButton", tr("&Delete…"), icon="clear")
        self._pane = SnapshotPane(device, self._table, notifier, self)
        bar = MotorBar(device, "historyStopButton", self)
        self._close = button("closeHistoryButton", tr("&Close"), on_click=self.close)
        text = tr(
            "There are no snapshots yet.\n\nBefore this program or trexcmd applies settings or "
            "restores defaults, all settings of the board are saved here. You can compare a "
            "snapshot with the board and restore some or all of its settings."
        )
        empty = ui.label(self, "historyEmpty", text, wrap=True)
        empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        empty.setMaximumWidth(72 * self.fontMetrics().averageCharWidth())

        left, below = QWidget(self), ui.row(self._name, self._save, self._delete, 1)
        items = self._search, (self._view, 1), self._no_match
        ui.column(*items, below, into=left, margins=(0, 0, 6, 0))
        halves = ui.splitter(self, "", Qt.Orientation.Horizontal, (left, 2), (self._pane, 3))
        empty_page = QWidget(self)
        ui.row(empty, into=empty_page)
        self._pages = QStackedWidget(self)
        self._pages.addWidget(halves)
        self._pages.addWidget(empty_page)
        bar.fill(bar.armed, 1, self._close)
        messages = MessageSpace(self, self._banner, self._question)  # messages cover the heading
        heading = ui.label(self, text=self.windowTitle(), size="title")
        parts = ui.column(heading, messages, (self._pages, 1), margins=(8, 8, 8, 0))
        ui.column((parts, 1), bar, into=self, margins=8)
        halves.setSizes([560, 620])
        restore_geometry(self, "history", 1180, 640)

        for each in (self._save, self._name, self._delete):
            each.setEnabled(False)  # until a snapshot is selected
        self._save.clicked.connect(self._on_save_clicked)
        self._name.clicked.connect(self._on_name_clicked)
        self._delete.clicked.connect(self._on_delete_clicked)
        self._search.textChanged.connect(self._table.set_search_text)
        self._table.listed.connect(self._on_listed)
        self._table.loaded.connect(self._refresh_timer.start)
        self._table.failed.connect(self._banner.show_problem)
        self._pane.restore_requested.connect(self.restore_requested)
        draft_changes = device.draft.pending_changed, device.draft.loaded
        for changed in (*draft_changes, device.state_changed, device.link_changed):
            changed.connect(self._on_board_changed)
        for ended in (device.applied, device.request_failed):
            ended.connect(self._on_written)

    def _list_view(self) -> QTableView:
        view = ui.flat_table(QTableView(self), "snapshotView", tr("Snapshots"))
        view.setModel(self._table)
        view.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        view.setWordWrap(False)
        triggers = QAbstractItemView.EditTrigger
        view.setEditTriggers(triggers.DoubleClicked | triggers.EditKeyPressed)
        header = view.horizontalHeader()
        header.setStretchLastSection(True)
        header.setResizeContentsPrecision(50)  # number of rows that are measured
        view.resizeColumnsToContents()
        keys, context = QKeySequence.StandardKey.Delete, Qt.ShortcutContext.WidgetShortcut
        QShortcut(keys, view, self._on_delete_clicked, context=context)
        view.selectionModel().selectionChanged.connect(self._on_selection_changed)
        return view

    def show_in_front(self) -> None:
        super().show_in_front()
        self._read_timer.start()

    @Slot()
    def refresh(self) -> None:
        self._table.refresh()

    # --- The list -----------------------------------------------------------------------

    @property
    def _selected(self) -> tuple[Snapshot, ...]:
        """Selected snapshots, newest first."""
        rows = sorted(index.row() for index in self._view.selectionModel().selectedRows())
        return tuple(self._table.matches[row] for row in rows)

    def _select(self, path: Path | None, fallback_row: int = 0) -> None:
        """Select a snapshot, or `fallback_row` if the snapshot is not listed."""
        listed_row = None if path is None else self._table.row_of(path)
        row = min(fallback_row, self._table.rowCount() - 1) if listed_row is None else listed_row
        index, flags = self._table.index(row, 0), QItemSelectionModel.SelectionFlag
        self._view.selectionModel().setCurrentIndex(index, flags.ClearAndSelect | flags.Rows)
        self._view.scrollTo(index)

    @Slot()
    def _on_selection_changed(self) -> None:
        if selected := self._selected:
            self._newest_selected = self._table.matches.index(selected[0]), selected[0].path
        self._refresh_timer.start()

    @Slot()
    def _on_listed(self) -> None:
        count = self._table.rowCount()
        if count and not self._selected:
            row, path = self._newest_selected
            self._select(path, row)
        self._no_match.setVisible(bool(self._table.all_snapshots) and count == 0)
        self._fit_columns()
        self._refresh_selection()

    def _fit_columns(self) -> None:
        """Fit the columns to the first list of snapshots only."""
        if self._is_fitted or not self._table.matches:
            return
        self._is_fitted = True
        self._view.resizeColumnsToContents()
        character = self.fontMetrics().averageCharWidth()
        for section in SnapshotColumn:
            size = self._view.columnWidth(section) + 2 * character
            title = self._view.horizontalHeader().sectionSizeHint(section)
            self._view.setColumnWidth(section, max(min(size, _MAX_COLUMN_WIDTH * character), title))
        minimum = self._view.horizontalHeader().minimumSectionSize()  # the last column stretches
        self._view.setColumnWidth(SnapshotColumn.ADAPTER, minimum)

    # --- The selected snapshots ---------------------------------------------------------

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.WindowActivate:
            self._read_timer.start()
        return super().event(event)

    @Slot()
    def _on_board_changed(self) -> None:
        if self.isVisible():
            self._refresh_timer.start()

    @Slot()
    def _on_written(self) -> None:
        if self.isVisible():
            self.refresh()

    @Slot()
    def _refresh_selection(self) -> None:
        self._refresh_timer.stop()
        selected = self._selected
        self._pages.setCurrentIndex(int(self._table.all_snapshots == ()))
        if self.focusWidget() is self._pages.currentWidget():  # the hidden list had the focus
            self._close.setFocus()
        self._pane.show_snapshots(selected)
        self._save.setEnabled(len(selected) == 1 and not self._table.problem_of(selected[0]))
        self._name.setEnabled(len(selected) == 1)
        self._delete.setEnabled(bool(selected))

    @Slot()
    def _on_name_clicked(self) -> None:
        row = self._table.row_of(self._selected[0].path)
        if row is not None:
            self._view.edit(self._table.index(row, SnapshotColumn.NAME))

    @Slot()
    def _on_save_clicked(self) -> None:
        selected = self._selected
        if len(selected) != 1:
            return
        source = selected[0].path
        path = file_questions.prompt_to_save(
            self, tr("Save a copy of the snapshot"), file_questions.last_folder() / source.name
        )
        if path is not None:
            in_background(
                self,
                lambda: save(path, load(source)),
                lambda _: self._on_copied(path),
                lambda error: self._banner.show_problem(tr("Nothing was saved. {0}").format(error)),
            )

    def _on_copied(self, path: Path) -> None:
        file_questions.remember_folder(path)
        self._banner.show_news(tr("A copy was saved to {0}.").format(path))

    @Slot()
    def _on_delete_clicked(self) -> None:
        selected = self._selected
        if not selected:
            return
        text = tr("Permanently delete %n snapshot(s), the newest from {0}?", "", len(selected))
        self._question.prompt(
            text.format(self._table.time_text(selected[0])),
            Answer("historyQuestionYes", title_of(tr("&Delete…")), lambda: self._remove(selected)),
        )

    def _remove(self, snapshots: tuple[Snapshot, ...]) -> None:
        def remove_all() -> None:
            for snapshot in snapshots:
                self._history.remove(snapshot)

        def on_failed(error: StudioError) -> None:
            self._banner.show_problem(str(error))
            self.refresh()

        in_background(self, remove_all, lambda _: self.refresh(), on_failed)

    def reject(self) -> None:  # Esc and the close buttons also call this
        self._refresh_timer.stop()
        self._read_timer.stop()
        save_geometry(self, "history")
        self._question.withdraw()
        super().reject()
