"""The history window: list, compare and restore snapshots."""

from pathlib import Path

from PySide6.QtCore import QByteArray, QEvent, QSettings, Qt, QUrl, Signal, Slot
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import (
    QDialog,
    QFileDialog,
    QHBoxLayout,
    QSplitter,
    QStackedWidget,
    QWidget,
)

from trex_gui.core.files import SettingsError, load, save
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.snapshots import SnapshotTable
from trex_gui.devices.trex.settings.history import Snapshot
from trex_gui.devices.trex.views.action_bar import StopButton
from trex_gui.devices.trex.views.history.bound_field import BoundField
from trex_gui.devices.trex.views.history.pane import SnapshotPane
from trex_gui.devices.trex.views.history.present_choice import FILTER, FOLDER
from trex_gui.devices.trex.views.history.snapshot_list import SnapshotList
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.runtime import runtime
from trex_gui.ui.widgets.banner import Banner
from trex_gui.ui.widgets.builders import button, column, label, row
from trex_gui.ui.widgets.inline_prompt import InlinePrompt, PromptAnswer


class HistoryDialog(QDialog):
    """What boards stored before each change, against the present or each other.

    It is not modal, has its own stop button, and writes nothing: restored values become pending
    edits.

    Signals:
        restore_requested: rows of a snapshot were made edits; they are to be reviewed.
    """

    restore_requested = Signal()

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("historyDialog")
        self.setWindowTitle(self.tr("History"))
        self.setWindowFlags(Qt.WindowType.Window)
        self._device = device
        self._history = device.history
        self._table = SnapshotTable(device.history, self)
        self._store = QSettings(self)
        self._bound_problem = ""
        self._later = runtime().timer(self)
        self._later.setSingleShot(True)
        self._later.setInterval(0)

        notifier = Notifier(self)
        self._banner = Banner(self, notifier)
        self._banner.setObjectName("historyBanner")
        self._question = InlinePrompt(self)
        self._question.setObjectName("historyQuestion")
        self._list = SnapshotList(self._table, self)
        self._save = button(
            self,
            "saveSnapshotButton",
            self.tr("Save &as…"),
            icon="save",
            tip=self.tr("Save a copy as a settings file"),
            default=False,
        )
        self._delete = button(
            self, "deleteSnapshotButton", self.tr("&Delete…"), icon="clear", default=False
        )
        self._pane = SnapshotPane(device, self._table, notifier, self)
        self._bound = BoundField(self._history, self._question, notifier, self)
        self._folder = button(
            self, "openFolderButton", self.tr("&Open folder"), icon="folder", default=False
        )
        self._close = button(self, "closeHistoryButton", self.tr("&Close"), default=False)
        self._stop = StopButton(device, "historyStopButton", self)
        self._empty = label(
            self,
            "historyEmpty",
            self.tr(
                "There are no snapshots yet.\n\nBefore each Apply and each restoring of defaults, "
                "in this window or with trexcmd, everything that the board stores is saved here "
                "first. You can then compare it with the board and restore all or some "
                "of it."
            ),
            wrap=True,
        )
        self._empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._empty.setMaximumWidth(72 * self.fontMetrics().averageCharWidth())

        below_list = row(self._save, self._delete, 1)
        left = QWidget(self)
        column((self._list, 1), below_list, into=left, margins=(0, 0, 6, 0))
        self._halves = QSplitter(Qt.Orientation.Horizontal, self)
        self._halves.setObjectName("historySplitter")
        self._halves.setChildrenCollapsible(False)
        self._halves.addWidget(left)
        self._halves.addWidget(self._pane)
        self._halves.setStretchFactor(0, 2)
        self._halves.setStretchFactor(1, 3)
        self._pages = QStackedWidget(self)
        self._pages.addWidget(self._halves)
        nothing = QWidget(self)
        row(self._empty, into=nothing)
        self._pages.addWidget(nothing)
        bottom = QHBoxLayout()
        bottom.addWidget(self._stop)
        bottom.addSpacing(12)
        bottom.addWidget(self._bound)
        bottom.addStretch(1)
        bottom.addWidget(self._folder)
        bottom.addWidget(self._close)
        column(self._banner, self._question, (self._pages, 1), bottom, into=self)
        self.resize(1180, 640)
        self._halves.setSizes([510, 670])
        geometry = self._store.value("history/geometry")
        if isinstance(geometry, QByteArray):
            self.restoreGeometry(geometry)

        self._list.chosen_changed.connect(self._later.start)
        self._list.delete_requested.connect(self._on_delete_clicked)
        self._pane.present_chosen.connect(self._on_present_chosen)
        self._pane.restore_requested.connect(self.restore_requested)
        self._save.clicked.connect(self._on_save_clicked)
        self._delete.clicked.connect(self._on_delete_clicked)
        self._folder.clicked.connect(self._on_folder_clicked)
        self._close.clicked.connect(self.close)
        self._bound.changed.connect(self.refresh)
        self._later.timeout.connect(self._renew)
        device.draft.pending_changed.connect(self._on_board_changed)
        device.draft.loaded.connect(self._on_board_changed)
        device.state_changed.connect(self._on_board_changed)
        device.link_changed.connect(self._on_board_changed)
        device.applied.connect(self._on_written)
        device.request_failed.connect(self._on_written)

    def open_history(self) -> None:
        """Show the window, or bring it forward."""
        self.refresh()
        self.show()
        self.activateWindow()

    # --- What has changed ---------------------------------------------------------------

    @Slot()
    def refresh(self) -> None:
        """Look at the folder and the bound again."""
        self._list.refresh()
        self._bound.refresh()
        if self._bound.problem:
            self._banner.show_problem(self._bound.problem)
        elif self._bound_problem and self._banner.text == self._bound_problem:
            self._banner.clear()
        self._bound_problem = self._bound.problem
        self._renew()

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.WindowActivate:
            self.refresh()
        return super().event(event)

    @Slot()
    def _on_board_changed(self) -> None:
        if self.isVisible():
            self._later.start()

    @Slot()
    def _on_written(self) -> None:
        if self.isVisible():
            self.refresh()

    @Slot()
    def _renew(self) -> None:
        """Show what is chosen as it is now."""
        self._later.stop()
        chosen = self._list.chosen
        self._pages.setCurrentIndex(int(self._table.rowCount() == 0))
        self._folder.setEnabled(self._history.folder.is_dir())
        self._pane.show_chosen(chosen)
        self._save.setEnabled(len(chosen) == 1 and not self._table.problem_of(chosen[0]))
        self._delete.setEnabled(bool(chosen))

    # --- User actions -----------------------------------------------------------------

    @Slot()
    def _on_present_chosen(self) -> None:
        """Compare one snapshot with what was chosen, though two were selected."""
        chosen = self._list.chosen
        if len(chosen) == 2:
            self._list.choose(chosen[-1].path)
        self._renew()

    @Slot()
    def _on_save_clicked(self) -> None:
        chosen = self._list.chosen
        if len(chosen) != 1:
            return
        snapshot = chosen[0]
        proposal = Path(self._last_folder()) / snapshot.path.name
        name, _ = QFileDialog.getSaveFileName(
            self, self.tr("Save a copy of the snapshot"), str(proposal), FILTER
        )
        if not name:
            return
        path = Path(name)
        try:
            save(path, load(snapshot.path).decode("utf-8"))
        except (SettingsError, UnicodeDecodeError) as error:
            self._banner.show_problem(self.tr("Nothing was saved. {0}").format(error))
            return
        self._store.setValue(FOLDER, str(path.parent))
        self._banner.show_news(self.tr("A copy was saved in {0}.").format(path))

    @Slot()
    def _on_delete_clicked(self) -> None:
        chosen = self._list.chosen
        if not chosen:
            return
        if len(chosen) == 1:
            text = self.tr("Delete the snapshot of {0} for good?")
            text = text.format(self._table.time_text(chosen[0]))
        else:
            text = self.tr("Delete {0} snapshots for good?").format(len(chosen))
        self._question.ask(
            text,
            PromptAnswer("historyQuestionYes", self.tr("Delete"), lambda: self._remove(chosen)),
        )

    def _remove(self, snapshots: tuple[Snapshot, ...]) -> None:
        for snapshot in snapshots:
            try:
                self._history.remove(snapshot)
            except SettingsError as error:
                self._banner.show_problem(str(error))
                break
        self.refresh()

    @Slot()
    def _on_folder_clicked(self) -> None:
        if not QDesktopServices.openUrl(QUrl.fromLocalFile(str(self._history.folder))):
            self._banner.show_news(
                self.tr("The snapshots are in {0}.").format(self._history.folder)
            )

    def _last_folder(self) -> str:
        return str(self._store.value(FOLDER, str(Path.home())))

    # --- The end ------------------------------------------------------------------------

    def reject(self) -> None:
        """Esc, the button and the window's cross all end here; it only hides."""
        self._later.stop()
        self._store.setValue("history/geometry", self.saveGeometry())
        self._question.withdraw()
        super().reject()
