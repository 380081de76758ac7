"""What was learned, beside what was there: a tab a channel, its values and its curve."""

from PySide6.QtCore import QSize, Slot
from PySide6.QtGui import QIcon, QResizeEvent
from PySide6.QtWidgets import QBoxLayout, QTabBar, QVBoxLayout, QWidget

from trex_gui.devices.trex.calibration.neutral import deadband_floor
from trex_gui.devices.trex.calibration.proposal import WHY_THESE_VALUES
from trex_gui.devices.trex.model.learning.channel import LearnedChannel
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.views.learning.channel_form import ChannelForm
from trex_gui.devices.trex.views.learning.parts import Muted
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.note import Note

_GAP = 16
_MARGIN = 8


class ReviewPage(QWidget):
    """One channel at a time, to be chosen above: numbers and curve change together.

    The curve stands beside the numbers; where there is no room for that, below them.
    """

    def __init__(self, learning: Learning, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        # The plotting library takes as long to load as Qt: only when it is to be seen.
        from trex_gui.devices.trex.views.learning.curve_pane import CurvePane  # noqa: PLC0415

        self.setObjectName("learnReviewPage")
        self._learning = learning

        self._tabs = ui.named(QTabBar(self), "learnChannelTabs", accessible=self.tr("Channels"))
        self._tabs.setExpanding(False)
        self._forms = [ChannelForm(learning, channel, self) for channel in learning.channels]
        for channel in learning.channels:
            self._tabs.addTab(self.tr("Channel {0}").format(channel.number))
        self._curve = CurvePane(learning, self)
        floor = learning.source.text(deadband_floor(learning.source))
        self._common = ui.named(Muted(WHY_THESE_VALUES.format(floor), self), "learnCommonReasons")
        self._earlier = ui.named(Note(0, self), "learnEarlierEdits")

        self._body = QBoxLayout(QBoxLayout.Direction.LeftToRight)
        self._body.setSpacing(_GAP)
        forms = QVBoxLayout()
        for form in self._forms:
            forms.addWidget(form)
        self._body.addLayout(forms, 2)
        self._body.addWidget(self._curve, 3)
        ui.column(
            self._tabs,
            (self._body, 1),
            self._common,
            self._earlier,
            into=self,
            margins=(0, 0, _MARGIN, 0),
        )

        self._tabs.currentChanged.connect(self._on_tab_changed)
        self._tabs.setVisible(len(self._forms) > 1)
        self._curve.edited.connect(self._on_wished)
        learning.changed.connect(self._on_changed)
        theme().changed.connect(self._show_signs)
        self._on_changed()
        self._choose_first_to_look_at()

    @property
    def _form(self) -> ChannelForm:
        return self._forms[max(0, self._tabs.currentIndex())]

    def minimumSizeHint(self) -> QSize:
        """As wide as numbers or curve need, whichever needs more."""
        least = super().minimumSizeHint()
        form = max(form.minimumSizeHint().width() for form in self._forms)
        least.setWidth(max(form, self._curve.minimumSizeHint().width()) + _MARGIN)
        return least

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        form = max(form.minimumSizeHint().width() for form in self._forms)
        both = form + _GAP + self._curve.minimumSizeHint().width()
        wide = self.width() - _MARGIN >= both
        direction = QBoxLayout.Direction
        self._body.setDirection(direction.LeftToRight if wide else direction.TopToBottom)

    def _choose_first_to_look_at(self) -> None:
        """Begin with a channel that has a problem, else with the first one."""
        for index, form in enumerate(self._forms):
            if form.channel.result_problems:
                self._tabs.setCurrentIndex(index)
                return

    @Slot()
    def _on_changed(self) -> None:
        for form in self._forms:
            form.setVisible(form is self._form)
            form.refresh()
        self._curve.show_channel(self._form.channel)
        self._common.setVisible(any(form.channel.choice is not None for form in self._forms))
        self._show_earlier_edits()
        self._show_signs()

    def _show_earlier_edits(self) -> None:
        """Say what else the list will hold that Apply shows."""
        count = self._learning.other_edits
        text = self.tr("1 earlier edit is in the list of Apply, too.")
        if count != 1:
            text = self.tr("{0} earlier edits are in the list of Apply, too.").format(count)
        self._earlier.show_note(text if count else "", alarming=bool(count))
        self._earlier.setVisible(bool(count))

    @Slot(int)
    def _on_tab_changed(self, _index: int) -> None:
        self._on_changed()

    @Slot(object)
    def _on_wished(self, calibration: Calibration) -> None:
        self._learning.choose(self._form.channel.number, calibration)

    @Slot()
    def _show_signs(self) -> None:
        for index, form in enumerate(self._forms):
            name, color, words = self._sign_of(form.channel)
            self._tabs.setTabIcon(index, icon(name, color) if name else QIcon())
            self._tabs.setTabToolTip(index, words)

    def _sign_of(self, channel: LearnedChannel) -> tuple[str, str, str]:
        """Return the icon, its colour and what it means."""
        if channel.choice is None:
            return "warning", "warning", self.tr("Nothing was learned.")
        if not channel.choice.included:
            return "", "", self.tr("Stays as it is.")
        if channel.result_problems:
            return "warning", "warning", self.tr("Needs a look.")
        return "ok", "good", self.tr("Is taken.")
