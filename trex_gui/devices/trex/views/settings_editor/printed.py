"""Printed settings, as tables with changes from the default in bold."""

from collections.abc import Callable, Iterable, Mapping
from datetime import datetime
from html import escape
from itertools import groupby

from PySide6.QtCore import QBuffer, QIODevice, Qt
from PySide6.QtGui import QPageSize, QPdfWriter, QTextDocument
from PySide6.QtWidgets import QDialog, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.calibration import CALIBRATION_FIELDS
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.ui.widgets.placement import fit_on_screen


class PrintedSettings(QTextDocument):
    def __init__(self, settings: Settings, name: str, remarks: Iterable[str] = ()) -> None:
        """`name`: the file or the board. `remarks` are printed below the tables."""
        super().__init__()
        self._name = name
        font = self.defaultFont()
        font.setPointSizeF(8)
        self.setDefaultFont(font)
        self.setMetaInformation(QTextDocument.MetaInformation.DocumentTitle, name)
        # Paper is white, whatever the colours of the theme.
        self.setDefaultStyleSheet("body { color: black }")
        self.setHtml(f"<body>{settings_html(settings, name, remarks)}</body>")

    def pdf(self) -> bytes:
        """Return the pages as the content of a PDF file."""
        buffer = QBuffer()
        buffer.open(QIODevice.OpenModeFlag.WriteOnly)
        writer = QPdfWriter(buffer)
        writer.setPageSize(QPageSize(QPageSize.PageSizeId.A4))
        writer.setTitle(self._name)
        self.print_(writer)
        del writer  # ends the file
        return bytes(buffer.data().data())

    def preview(self, window: QWidget, report: Callable[[str], object]) -> QDialog | None:
        """Show the pages in a dialog that can print them. Report if Qt cannot print here."""
        # Qt's print module is not installed everywhere. Only printing needs it.
        try:
            from PySide6.QtPrintSupport import QPrintPreviewDialog  # noqa: PLC0415
        except ImportError as error:
            text = tr("Qt's printing is not installed here ({0}); save a PDF file instead.")
            report(text.format(error))
            return None
        dialog = QPrintPreviewDialog(window)
        dialog.printer().setDocName(self._name)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setObjectName("printPreviewDialog")
        fit_on_screen(dialog)
        dialog.paintRequested.connect(self.print_)
        self.setParent(dialog)
        dialog.show()
        return dialog


def settings_html(settings: Settings, name: str, remarks: Iterable[str] = ()) -> str:
    """Return plain tables that a `QTextDocument` can lay out."""
    board = settings.product.name
    if settings.firmware is not None:
        board = tr("{0}, firmware {1}").format(board, settings.firmware)
    now = datetime.now().astimezone()
    printed = tr("Printed {0} by TReX Studio.").format(f"{now:%Y-%m-%d %H:%M}")
    about = (board, printed, tr("Bold: differs from the factory default."))
    items = "".join(f"<li>{escape(remark)}</li>" for remark in remarks)
    findings = f"<h3>{escape(tr('Findings'))}</h3><ul>{items}</ul>"
    parts = (
        f"<h2>{escape(name)}</h2>",
        f"<p>{'<br>'.join(map(escape, about))}</p><br>",
        _parameters(settings),
        f"<h3>{escape(tr('Calibrations'))}</h3>",
        _calibrations(settings),
        findings if items else "",
    )
    return "".join(parts)


def _parameters(settings: Settings) -> str:
    titles = {
        tr("Parameter"): 29,
        tr("Key"): 29,
        tr("Value"): 20,
        tr("Wire"): 6,
        title_of(tr("Defa&ult")): 16,
    }
    rows = []
    specs = sorted(settings.specs.readable, key=lambda spec: spec.group)
    for group, members in groupby(specs, key=lambda spec: spec.group):
        title = escape(group.capitalize())
        rows.append(f'<tr><td colspan="{len(titles)}"><br><i>{title}</i></td></tr>')
        for spec in members:
            wire = settings.parameters.get(spec.key)
            value = tr("not given") if wire is None else spec.text(wire)
            cells = (spec.name, spec.key, value, "" if wire is None else str(wire))
            is_changed = wire not in {None, spec.default}
            rows.append(_row((*cells, spec.text(spec.default)), bold=is_changed))
            rows += _note_row(settings, spec.key, len(titles))
    return _table(titles, rows)


def _calibrations(settings: Settings) -> str:
    rows = []
    for key, found in settings.calibration_items():
        counts = [getattr(found, field) for field in CALIBRATION_FIELDS]
        values = (f"{key.source.text(count)} ({count})" for count in counts)
        rows.append(_row((key.label, key, *values)))
        rows += _note_row(settings, key, 6)
    titles = {
        tr("Channel"): 18,
        tr("Key"): 18,
        tr("Minimum"): 16,
        tr("Neutral"): 16,
        tr("Maximum"): 16,
        title_of(tr("&Deadband")): 16,
    }
    return _table(titles, rows) if rows else f"<p>{escape(tr('None are given.'))}</p>"


def _note_row(settings: Settings, key: str, columns: int) -> list[str]:
    """Return the note on a setting as a row below it. Empty without a note."""
    note = settings.notes.get(key, "")
    text = escape(tr("Note: {0}").format(note)).replace("\n", "<br>")
    return [f'<tr><td colspan="{columns}"><i>{text}</i></td></tr>'] if note else []


def _row(cells: Iterable[str], *, bold: bool = False) -> str:
    texts = (f"<b>{escape(cell)}</b>" if bold else escape(cell) for cell in cells)
    return "<tr>" + "".join(f"<td>{text}</td>" for text in texts) + "</tr>"


def _table(titles: Mapping[str, int], rows: Iterable[str]) -> str:
    """Return a table with its titles on each page. `titles`: column title → width in per cent."""
    head = "".join(
        f'<th align="left" width="{width}%">{escape(title)}</th>' for title, width in titles.items()
    )
    start = '<table width="100%" cellspacing="0" cellpadding="2">'
    return f"{start}<thead><tr>{head}</tr></thead><tbody>{''.join(rows)}</tbody></table>"
