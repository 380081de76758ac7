"""How many snapshots are kept, and the question before fewer are."""

from PySide6.QtCore import Signal, Slot
from PySide6.QtWidgets import QLabel, QSpinBox, QWidget

from trex_gui.core.files import SettingsError
from trex_gui.devices.trex.settings.history import KEPT, SettingsHistory
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.widgets.builders import NoWheelComboBox, button, row
from trex_gui.ui.widgets.inline_prompt import InlinePrompt, PromptAnswer

_MOST = 999_999


class BoundField(QWidget):
    """`Keep the newest 500 snapshots`; what is shown counts once Set was pressed.

    Signals:
        changed: another bound is set; snapshots may be gone.
    """

    changed = Signal()

    def __init__(
        self,
        history: SettingsHistory,
        question: InlinePrompt,
        notifier: Notifier,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._notifier = notifier
        self._history = history
        self._question = question
        self._problem = ""
        self._stored: int | None = KEPT

        self._which = NoWheelComboBox(self)
        self._which.setObjectName("keptCombo")
        self._which.setAccessibleName(self.tr("Which snapshots are kept"))
        self._which.addItems([self.tr("the newest"), self.tr("all")])
        self._count = QSpinBox(self)
        self._count.setObjectName("keptField")
        self._count.setAccessibleName(self.tr("How many snapshots are kept"))
        self._count.setRange(1, _MOST)
        self._count.setValue(KEPT)
        self._set = button(self, "keptButton", self.tr("&Set"), default=False)
        label = QLabel(self.tr("&Keep"), self)
        label.setBuddy(self._which)

        row(
            label,
            self._which,
            self._count,
            QLabel(self.tr("snapshots"), self),
            self._set,
            into=self,
            margins=0,
        )

        self._which.currentIndexChanged.connect(self._on_edited)
        self._count.valueChanged.connect(self._on_edited)
        self._set.clicked.connect(self._on_set_clicked)
        self.refresh()

    @property
    def problem(self) -> str:
        """Why the bound is not known, as a sentence; empty while it is."""
        return self._problem

    def refresh(self) -> None:
        """Read the limit again; an edit in progress stays."""
        untouched = self._wanted == self._stored
        bound = self._history.bound()
        self._problem = bound.problem
        self._stored = bound.kept
        if untouched:
            self._show(bound.kept)
        self._on_edited()

    def _show(self, kept: int | None) -> None:
        self._which.setCurrentIndex(int(kept is None))
        if kept is not None:
            self._count.setValue(kept)

    @property
    def _wanted(self) -> int | None:
        return None if self._which.currentIndex() else self._count.value()

    @Slot()
    def _on_edited(self) -> None:
        self._count.setEnabled(self._which.currentIndex() == 0)
        self._set.setEnabled(bool(self._problem) or self._wanted != self._stored)

    @Slot()
    def _on_set_clicked(self) -> None:
        wanted = self._wanted
        gone = self._history.beyond(wanted)
        if not gone:
            self._keep(wanted)
            return
        there = len(self._history.snapshots())
        text = self.tr("Remove {0}").format(len(gone))
        self._question.ask(
            self.tr("Remove the oldest {0} of {1} snapshots for good?").format(len(gone), there),
            PromptAnswer("historyQuestionYes", text, lambda: self._keep(wanted)),
            otherwise=self._take_back,
        )
        self._show(wanted)
        self._set.setEnabled(False)

    def _take_back(self) -> None:
        self._show(self._stored)
        self._on_edited()

    def _keep(self, kept: int | None) -> None:
        try:
            self._history.keep(kept)
        except SettingsError as error:
            self._notifier.error.emit(str(error))
            self._on_edited()
            return
        self.refresh()
        self.changed.emit()
