"""Dialog that shows and saves the support report."""

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path

from PySide6.QtCore import QLocale, Qt, Slot
from PySide6.QtWidgets import QListWidget, QListWidgetItem, QPlainTextEdit, QWidget

from trex_gui.core.report import ReportFile, create_report, save_report, suggested_name
from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.ui.files import in_background
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.theme.theme import fixed_font, follow_theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.labels import Muted
from trex_gui.ui.widgets.placement import resize_with_font

_FILE = Qt.ItemDataRole.UserRole
_ROW_PADDING = 4  # pixels, as in the style sheet


class ReportDialog(ReusedDialog):
    def __init__(self, notifier: Notifier, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._notifier = notifier
        self.setObjectName("reportDialog")
        self.setWindowTitle(title_of(tr("&Save report for support…")))
        resize_with_font(self, 860, 520)
        about = Muted(
            tr(
                "The report contains only what is shown here. It is only saved as a file, "
                "never sent. Names of users and computers, network addresses and serial numbers "
                "of adapters are masked. Clear the check box of a file to leave it out."
            ),
            self,
        )
        self._list = ui.named(
            QListWidget(self), "reportFiles", accessible=tr("Files of the report")
        )
        self._text = ui.named(
            QPlainTextEdit(self), "reportText", accessible=tr("Content of the file")
        )
        self._text.setReadOnly(True)
        self._text.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        self._text.setTabChangesFocus(True)
        self._text.setPlaceholderText(tr("Collecting …"))
        files = ui.label(self, text=tr("&Files:"), buddy=self._list)
        content = ui.label(self, text=tr("Con&tent:"), buddy=self._text)
        self._save = ui.button(
            self, "reportSave", tr("&Save…"), icon="save", on_click=self._prompt_and_save
        )
        self._save.setDefault(True)
        close = ui.button(self, "reportClose", tr("&Close"), on_click=self.close)
        left, right = ui.column(files, (self._list, 1)), ui.column(content, (self._text, 1))
        heading = ui.label(self, text=self.windowTitle(), size="title")
        ui.column(
            heading,
            about,
            (ui.row((left, 1), (right, 3)), 1),
            ui.row(1, self._save, close),
            into=self,
        )
        follow_theme(self, "font", lambda: self._text.setFont(fixed_font()))
        self._list.currentItemChanged.connect(self._show_current)
        self._list.itemChanged.connect(self._update_button)

    def open_report(self, parts: Mapping[str, Callable[[], str]]) -> None:
        """Collect the files in another thread.

        `parts`: file name → function that returns the content of the file.
        """
        self._list.clear()
        self._text.clear()
        self._update_button()
        self.show_in_front()
        in_background(self, partial(create_report, parts), self._show, self._notifier.report_error)

    def _show(self, files: tuple[ReportFile, ...]) -> None:
        self._list.clear()
        for file in files:
            size = QLocale().toString(len(file.data))
            item = QListWidgetItem(tr("{0} ({1} bytes)").format(file.name, size))
            item.setData(_FILE, file)
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            item.setCheckState(Qt.CheckState.Checked)
            self._list.addItem(item)
        padding = 2 * (self._list.frameWidth() + _ROW_PADDING)
        self._list.setMinimumWidth(self._list.sizeHintForColumn(0) + padding)
        self._list.setCurrentRow(0)
        self._update_button()
        self._save.setFocus()

    @property
    def _selected(self) -> tuple[ReportFile, ...]:
        items = (self._list.item(row) for row in range(self._list.count()))
        return tuple(
            item.data(_FILE) for item in items if item.checkState() is Qt.CheckState.Checked
        )

    @Slot()
    def _update_button(self) -> None:
        self._save.setEnabled(bool(self._selected))

    @Slot()
    def _show_current(self) -> None:
        item = self._list.currentItem()
        file = item.data(_FILE) if item is not None else None
        self._text.setPlainText(file.text if isinstance(file, ReportFile) else "")

    @Slot()
    def _prompt_and_save(self) -> None:
        suggested = file_questions.last_folder() / suggested_name()
        title, filters = tr("&Save report for support…"), tr("Zip archives (*.zip)")
        path = file_questions.prompt_to_save(self, title, suggested, filters, ".zip")
        if path is not None:
            self.save(path)

    def save(self, path: Path) -> None:
        file_questions.remember_folder(path)
        saved = tr("The report was written to {0}.").format(path)
        work = partial(save_report, path, self._selected)
        in_background(self, work, lambda _: self._on_saved(saved), self._notifier.report_error)

    def _on_saved(self, text: str) -> None:
        self.close()
        self._notifier.info.emit(text)
