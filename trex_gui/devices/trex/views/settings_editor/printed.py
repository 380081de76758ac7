"""Settings on paper: all in tables, changes from the default in bold."""

from collections.abc import Callable, Iterable, Mapping
from datetime import datetime
from html import escape
from itertools import groupby

from PySide6.QtCore import QBuffer, QIODevice, QMarginsF, QObject, QRectF, Qt
from PySide6.QtGui import (
    QFont,
    QFontMetricsF,
    QPagedPaintDevice,
    QPageLayout,
    QPageSize,
    QPainter,
    QPdfWriter,
    QTextDocument,
)
from PySide6.QtWidgets import QDialog, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.calibration import CALIBRATION_FIELDS
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.ui.widgets.placement import keep_on_screen

_DOTS_PER_INCH = 300
_MARGINS = QMarginsF(18, 15, 15, 12)


class PrintedSettings(QObject):
    """A print-out of settings, to show, print or save."""

    def __init__(self, settings: Settings, name: str, remarks: Iterable[str] = ()) -> None:
        """`name`: the file or the board; remarks are printed below."""
        super().__init__()
        self._settings = settings
        self._name = name
        self._remarks = tuple(remarks)
        self._now = datetime.now().astimezone()
        self._printer: object = None

    def html(self) -> str:
        """Return plain tables that a `QTextDocument` can lay out."""
        board = self._settings.product.name
        if self._settings.firmware is not None:
            board = tr("{0}, firmware {1}").format(board, self._settings.firmware)
        printed = tr("Printed {0} by TReX Studio.").format(f"{self._now:%Y-%m-%d %H:%M}")
        about = (board, printed, tr("Bold: differs from the factory default."))
        items = "".join(f"<li>{escape(remark)}</li>" for remark in self._remarks)
        findings = f"<h3>{escape(tr('Findings'))}</h3><ul>{items}</ul>"
        parts = (
            f"<h2>{escape(self._name)}</h2>",
            f"<p>{'<br>'.join(map(escape, about))}</p><br>",
            self._parameters(),
            f"<h3>{escape(tr('Calibrations'))}</h3>",
            self._calibrations(),
            findings if items else "",
        )
        return "".join(parts)

    def _parameters(self) -> str:
        titles = {
            tr("Parameter"): 29,
            tr("Key"): 29,
            tr("Value"): 20,
            tr("Wire"): 6,
            tr("Default"): 16,
        }
        rows = []
        specs = sorted(self._settings.specs.readable, key=lambda spec: spec.group)
        for group, members in groupby(specs, key=lambda spec: spec.group):
            title = escape(group.capitalize())
            rows.append(f'<tr><td colspan="{len(titles)}"><br><i>{title}</i></td></tr>')
            for spec in members:
                wire = self._settings.parameters.get(spec.key)
                value = tr("not given") if wire is None else spec.text(wire)
                cells = (spec.name, spec.key, value, "" if wire is None else str(wire))
                is_changed = wire not in {None, spec.default}
                rows.append(_row((*cells, spec.text(spec.default)), bold=is_changed))
                rows += self._note_row(spec.key, len(titles))
        return _table(titles, rows)

    def _calibrations(self) -> str:
        rows = []
        for key, found in self._settings.calibration_items():
            counts = [getattr(found, field) for field in CALIBRATION_FIELDS]
            values = (f"{key.source.text(count)} ({count})" for count in counts)
            rows.append(_row((key.label, key, *values)))
            rows += self._note_row(key, 6)
        titles = {
            tr("Channel"): 18,
            tr("Key"): 18,
            tr("Minimum"): 16,
            tr("Neutral"): 16,
            tr("Maximum"): 16,
            tr("Deadband"): 16,
        }
        return _table(titles, rows) if rows else f"<p>{escape(tr('None are given.'))}</p>"

    def _note_row(self, key: str, columns: int) -> list[str]:
        """Return the note on a setting as a row below it; empty without one."""
        note = self._settings.notes.get(key, "")
        text = escape(tr("Note: {0}").format(note)).replace("\n", "<br>")
        return [f'<tr><td colspan="{columns}"><i>{text}</i></td></tr>'] if note else []

    def document(self) -> QTextDocument:
        """Return the print-out without pages; `print_to` adds them."""
        document = QTextDocument()
        font = document.defaultFont()
        font.setPointSizeF(9)
        document.setDefaultFont(font)
        document.setDocumentMargin(0)
        document.setMetaInformation(QTextDocument.MetaInformation.DocumentTitle, self._name)
        # Paper is white, whatever the colours of the theme.
        document.setDefaultStyleSheet("body { color: black }")
        document.setHtml(f"<body>{self.html()}</body>")
        return document

    def print_to(self, device: QPagedPaintDevice) -> None:
        """Draw every page with its number below."""
        document = self.document()
        painter = QPainter()
        if not painter.begin(device):
            return
        painter.setPen(Qt.GlobalColor.black)
        document.documentLayout().setPaintDevice(device)
        font = QFont(document.defaultFont())
        foot = QFontMetricsF(font, device).height() * 2
        page = QRectF(0, 0, device.width(), device.height() - foot)
        document.setPageSize(page.size())
        count = document.pageCount()
        for number in range(count):
            if number:
                device.newPage()
            painter.save()
            painter.translate(0, -number * page.height())
            document.drawContents(painter, page.translated(0, number * page.height()))
            painter.restore()
            painter.setFont(font)
            text = tr("{0}, page {1} of {2}").format(self._name, number + 1, count)
            below = QRectF(0, page.height(), page.width(), foot)
            corner = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignBottom
            painter.drawText(below, corner, text)
        painter.end()

    def pdf(self) -> bytes:
        """Return the pages as the content of a PDF file."""
        buffer = QBuffer()
        buffer.open(QIODevice.OpenModeFlag.WriteOnly)
        writer = QPdfWriter(buffer)
        writer.setResolution(_DOTS_PER_INCH)
        writer.setPageSize(QPageSize(QPageSize.PageSizeId.A4))
        writer.setPageMargins(_MARGINS, QPageLayout.Unit.Millimeter)
        writer.setTitle(self._name)
        self.print_to(writer)
        del writer  # ends the file
        return bytes(buffer.data().data())

    def preview(self, window: QWidget, report: Callable[[str], object]) -> QDialog | None:
        """Show the pages in a dialog that can print them; report if Qt cannot print here."""
        # Not installed everywhere, and only needed for printing.
        try:
            from PySide6.QtPrintSupport import QPrinter, QPrintPreviewDialog  # noqa: PLC0415
        except ImportError as error:
            text = tr("Qt's printing is not installed here ({0}); save a PDF file instead.")
            report(text.format(error))
            return None
        printer = QPrinter(QPrinter.PrinterMode.HighResolution)
        printer.setPageMargins(_MARGINS, QPageLayout.Unit.Millimeter)
        printer.setDocName(self._name)
        self._printer = printer  # the dialog only borrows it
        dialog = QPrintPreviewDialog(printer, window)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setObjectName("printPreviewDialog")
        keep_on_screen(dialog)
        dialog.paintRequested.connect(self.print_to)
        self.setParent(dialog)
        dialog.show()
        return dialog


def _row(cells: Iterable[str], *, bold: bool = False) -> str:
    texts = (f"<b>{escape(cell)}</b>" if bold else escape(cell) for cell in cells)
    return "<tr>" + "".join(f"<td>{text}</td>" for text in texts) + "</tr>"


def _table(titles: Mapping[str, int], rows: Iterable[str]) -> str:
    """Return a table with the titles on each page; titles have their widths in per cent."""
    head = "".join(
        f'<th align="left" width="{width}%">{escape(title)}</th>' for title, width in titles.items()
    )
    start = '<table width="100%" cellspacing="0" cellpadding="2">'
    return f"{start}<thead><tr>{head}</tr></thead><tbody>{''.join(rows)}</tbody></table>"
