"""A few words that stand out when they matter, in weight as well as in colour."""

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from trex_gui.ui.theme.theme import theme


class Note(QLabel):
    """Wrapped text that keeps the room of `lines` lines, so that nothing jumps below it."""

    def __init__(self, lines: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._alarming = False
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Minimum)
        self.setMinimumHeight(lines * self.fontMetrics().lineSpacing())
        theme().changed.connect(self._on_theme_changed)

    def show_note(self, text: str, *, alarming: bool = False) -> None:
        """Show a text; an alarming one is bold, in the theme's colour of warnings."""
        if self.text() != text:
            self.setText(text)
        if alarming != self._alarming:
            self._alarming = alarming
            font = self.font()
            font.setBold(alarming)
            self.setFont(font)
            self._on_theme_changed()

    @Slot()
    def _on_theme_changed(self) -> None:
        name = "warning" if self._alarming else "window_text"
        palette = self.palette()
        palette.setColor(self.foregroundRole(), theme().color(name))
        self.setPalette(palette)
