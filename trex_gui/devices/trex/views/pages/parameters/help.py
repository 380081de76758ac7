"""All that is known of the selected parameter, below the table."""

from html import escape
from typing import cast

from PySide6.QtCore import QModelIndex, Qt
from PySide6.QtWidgets import QFrame, QLabel, QSizePolicy, QWidget

from trex_gui.devices.trex.model.parameters.parameters import Role
from trex_gui.devices.trex.model.parameters.text import ParameterText
from trex_gui.devices.trex.protocol.parameters import ParameterSpec

_LINES = 6


class ParameterHelp(QLabel):
    """Keeps the room of a few lines, so that nothing jumps above it."""

    def __init__(self, text: ParameterText, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._text = text
        self.setObjectName("parameterHelp")
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Minimum)
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setMargin(8)
        self.setMinimumHeight(_LINES * self.fontMetrics().lineSpacing() + 2 * self.margin())
        self._show_lines([])

    def show_help_of(self, index: QModelIndex) -> None:
        """Explain the parameter of a row, or what a heading is good for."""
        spec = cast("ParameterSpec | None", index.data(Role.SPEC))
        if spec is not None:
            self._show_lines(self._lines(spec, index))
        elif index.data(Role.GROUP) is not None:
            hint = self.tr("Enter, or a click on the arrow, closes or opens the group.")
            self._show_lines([f"<b>{escape(str(index.data()))}</b>", hint])
        else:
            self._show_lines([])

    def _show_lines(self, lines: list[str]) -> None:
        self.setText("<br>".join(lines))
        self.setAccessibleName("" if lines else self.tr("No parameter is selected"))

    def _lines(self, spec: ParameterSpec, index: QModelIndex) -> list[str]:
        lines = [
            f"<b>{escape(spec.name)}</b> ({spec.number:#04x}, <code>{spec.key}</code>)",
            escape(spec.description),
            escape(f"{self._text.limits(spec)} {self._text.origin(spec)}"),
        ]
        if spec.needs_power_cycle:
            lines.append(self.tr("Takes effect when the board is switched off and on."))
        told = [index.data(Role.STORED_TEXT), index.data(Role.TWIN), index.data(Role.PROBLEM)]
        waiting = index.data(Role.WAITING)
        if waiting is not None:
            told.append(self.tr("Still active: {0}.").format(spec.text(waiting)))
        if stand_out := " ".join(escape(text) for text in told if text):
            lines.append(f"<b>{stand_out}</b>")
        return lines
