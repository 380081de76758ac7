"""What a desk offers, to be read beside the window."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QTextBrowser, QVBoxLayout, QWidget


class HelpDialog(QDialog):
    """Never in the way: what is explained can be tried while it is read."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("helpDialog")
        self.resize(560, 620)
        self._shown = ""
        self._text = QTextBrowser(self)
        self._text.setObjectName("helpText")
        self._text.setAccessibleName(self.tr("Help"))
        self._text.setOpenExternalLinks(True)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close, self)
        close = buttons.button(QDialogButtonBox.StandardButton.Close)
        close.setObjectName("helpClose")

        layout = QVBoxLayout(self)
        layout.addWidget(self._text, 1)
        layout.addWidget(buttons)

        buttons.rejected.connect(self.close)

    def show_text(self, title: str, text: str) -> None:
        """Show rich text; `title` as a menu names it."""
        title = title.replace("&", "").removesuffix("…")
        self.setWindowTitle(title)
        if text != self._shown:  # else it stays where somebody has scrolled it to
            self._text.setHtml(text)
            self._shown = text
        self.show()
        self.activateWindow()
        self._text.setFocus(Qt.FocusReason.PopupFocusReason)
