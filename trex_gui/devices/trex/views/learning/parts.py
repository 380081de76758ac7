"""What the steps of learning share: the name of a channel, a sign, muted text."""

from PySide6.QtCore import QCoreApplication, Qt, Slot
from PySide6.QtWidgets import QLabel, QWidget

from trex_gui.devices.trex.calibration.problems import Problem
from trex_gui.devices.trex.client.explanations import CHANNEL_ROLES
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme


def channel_label(channel: int, parent: QWidget) -> QLabel:
    """Make the label of a channel: its number, and what it does."""
    words = QCoreApplication.translate("learning", "Channel {0}").format(channel)
    label = QLabel(f"<b>{words}</b><br><small>{CHANNEL_ROLES[channel]}</small>", parent)
    label.setTextFormat(Qt.TextFormat.RichText)
    return label


def in_words(problems: tuple[Problem, ...]) -> str:
    """All that is wrong, one sentence after the other."""
    return " ".join(problem.text for problem in problems)


class Sign(QLabel):
    """A small icon that follows the theme; without a name it keeps its room."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._shown = ("", "icon")
        size = self.fontMetrics().height() + 2
        self.setFixedSize(size, size)
        theme().changed.connect(self._on_theme_changed)

    def show_sign(self, name: str, color: str = "icon") -> None:
        """Show an icon in a colour of the theme; an empty name shows none."""
        if (name, color) != self._shown:
            self._shown = (name, color)
            self._on_theme_changed()

    @Slot()
    def _on_theme_changed(self) -> None:
        name, color = self._shown
        if name:
            self.setPixmap(icon(name, color).pixmap(self.size()))
        else:
            self.clear()


class Muted(QLabel):
    """Wrapped text that is there for those who want to know more."""

    def __init__(self, text: str = "", parent: QWidget | None = None) -> None:
        super().__init__(text, parent)
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.PlainText)
        theme().changed.connect(self._on_theme_changed)
        self._on_theme_changed()

    @Slot()
    def _on_theme_changed(self) -> None:
        palette = self.palette()
        palette.setColor(self.foregroundRole(), theme().color("muted"))
        self.setPalette(palette)
