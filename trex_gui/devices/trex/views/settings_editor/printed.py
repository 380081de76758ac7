"""Settings on paper: a table of everything, what differs from the default in bold."""

from collections.abc import Iterable, Sequence
from datetime import datetime
from html import escape
from itertools import groupby
from pathlib import Path

from PySide6.QtCore import QBuffer, QIODevice, QMarginsF, QObject, QRectF, Qt
from PySide6.QtGui import (
    QFont,
    QFontMetricsF,
    QPagedPaintDevice,
    QPageLayout,
    QPageSize,
    QPainter,
    QPdfWriter,
    QTextCharFormat,
    QTextCursor,
    QTextDocument,
)
from PySide6.QtWidgets import QDialog, QWidget

from trex_gui.core.files import Finding, SettingsError
from trex_gui.devices.trex.protocol.calibration import CALIBRATION_FIELDS, CalibrationKey
from trex_gui.devices.trex.settings.document import Settings

_DOTS_PER_INCH = 300
_MARGINS = QMarginsF(18, 15, 15, 12)


class PrintedSettings(QObject):
    """One print-out: made once, then shown, printed or saved."""

    def __init__(
        self,
        settings: Settings,
        name: str,
        remarks: Iterable[str] = (),
        parent: QObject | None = None,
    ) -> None:
        """Print settings that a file called `name`, or a board, gives, with remarks below."""
        super().__init__(parent)
        self._settings = settings
        self._name = name
        self._remarks = tuple(remarks)
        self._now = datetime.now().astimezone()
        self._printer: object = None

    # --- What it looks like -------------------------------------------------------------

    def html(self) -> str:
        """The whole print-out; plain tables that a `QTextDocument` can lay out."""
        board = self._settings.product.name
        if self._settings.firmware is not None:
            board = self.tr("{0}, firmware {1}").format(board, self._settings.firmware)
        parts = [
            f"<h2>{escape(self._name)}</h2>",
            f"<p>{escape(board)}<br>",
            escape(self.tr("Printed {0} by TReX Studio.").format(f"{self._now:%Y-%m-%d %H:%M}")),
            "<br>" + escape(self.tr("Bold: not as from the factory.")) + "</p><br>",
            self._parameters(),
            self._calibrations(),
            self._remark_list(),
        ]
        return "".join(parts)

    def _parameters(self) -> str:
        titles = (
            self.tr("Parameter"),
            self.tr("Key"),
            self.tr("Value"),
            self.tr("Wire"),
            self.tr("Default"),
        )
        rows = []
        specs = sorted(self._settings.specs.readable, key=lambda spec: spec.group)
        for group, members in groupby(specs, key=lambda spec: spec.group):
            title = escape(group.capitalize())
            rows.append(f'<tr><td colspan="{len(titles)}"><br><i>{title}</i></td></tr>')
            for spec in members:
                wire = self._settings.parameters.get(spec.key)
                value = self.tr("not given") if wire is None else spec.text(wire)
                cells = (spec.name, spec.key, value, "" if wire is None else str(wire))
                is_other = wire is not None and wire != spec.default
                rows.append(_row((*cells, spec.text(spec.default)), bold=is_other))
        return _table(titles, (29, 29, 20, 6, 16), rows)

    def _calibrations(self) -> str:
        rows = []
        for key in CalibrationKey:
            found = self._settings.calibrations.get(key)
            if found is not None:
                source, channel = key.source, key.channel
                counts = [getattr(found, field) for field in CALIBRATION_FIELDS]
                cells = [self.tr("{0} channel {1}").format(source.value, channel), key]
                cells += [f"{source.text(count)} ({count})" for count in counts]
                rows.append(_row(cells))
        title = f"<h3>{escape(self.tr('Calibrations'))}</h3>"
        if not rows:
            return title + f"<p>{escape(self.tr('None are given.'))}</p>"
        titles = (
            self.tr("Channel"),
            self.tr("Key"),
            self.tr("Minimum"),
            self.tr("Neutral"),
            self.tr("Maximum"),
            self.tr("Deadband"),
        )
        return title + _table(titles, (18, 18, 16, 16, 16, 16), rows)

    def _remark_list(self) -> str:
        if not self._remarks:
            return ""
        items = "".join(f"<li>{escape(remark)}</li>" for remark in self._remarks)
        return f"<h3>{escape(self.tr('Findings'))}</h3><ul>{items}</ul>"

    def document(self) -> QTextDocument:
        """The print-out; pages and their numbers come with printing."""
        document = QTextDocument()
        font = document.defaultFont()
        font.setPointSizeF(9)
        document.setDefaultFont(font)
        document.setDocumentMargin(0)
        document.setMetaInformation(QTextDocument.MetaInformation.DocumentTitle, self._name)
        document.setHtml(self.html())
        # Paper is white, whatever the colours of the window are.
        black = QTextCharFormat()
        black.setForeground(Qt.GlobalColor.black)
        everything = QTextCursor(document)
        everything.select(QTextCursor.SelectionType.Document)
        everything.mergeCharFormat(black)
        return document

    # --- Where it goes ------------------------------------------------------------------

    def print_to(self, device: QPagedPaintDevice) -> int:
        """Draw every page, a line with its number below; return how many there are."""
        document = self.document()
        painter = QPainter()
        if not painter.begin(device):
            return 0
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
            words = self.tr("{0}, page {1} of {2}").format(self._name, number + 1, count)
            below = QRectF(0, page.height(), page.width(), foot)
            how = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignBottom
            painter.drawText(below, how, words)
        painter.end()
        return count

    def save_pdf(self, path: Path) -> None:
        """Write the pages into a PDF file.

        Raises:
            SettingsError: it cannot be written; says why.
        """
        buffer = QBuffer()
        buffer.open(QIODevice.OpenModeFlag.WriteOnly)
        writer = QPdfWriter(buffer)
        writer.setResolution(_DOTS_PER_INCH)
        writer.setPageSize(QPageSize(QPageSize.PageSizeId.A4))
        writer.setPageMargins(_MARGINS, QPageLayout.Unit.Millimeter)
        writer.setTitle(self._name)
        self.print_to(writer)
        del writer  # ends the file
        try:
            path.write_bytes(bytes(buffer.data().data()))
        except OSError as error:
            why = f"it cannot be written: {error.strerror or error}"
            raise SettingsError(str(path), [Finding(None, None, why)]) from error

    def preview(self, window: QWidget) -> QDialog:
        """Show the pages, from where they can be printed.

        Raises:
            SettingsError: this system's Qt cannot print.
        """
        # Not everywhere installed, and never needed before somebody prints.
        try:
            from PySide6.QtPrintSupport import QPrinter, QPrintPreviewDialog  # noqa: PLC0415
        except ImportError as error:
            why = f"Qt's printing is not installed here ({error}); save a PDF file instead"
            raise SettingsError(self._name, [Finding(None, None, why)]) from error
        printer = QPrinter(QPrinter.PrinterMode.HighResolution)
        printer.setPageMargins(_MARGINS, QPageLayout.Unit.Millimeter)
        printer.setDocName(self._name)
        self._printer = printer  # the dialog only borrows it
        dialog = QPrintPreviewDialog(printer, window)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setObjectName("printPreviewDialog")
        dialog.paintRequested.connect(self.print_to)
        self.setParent(dialog)
        return dialog


def _row(cells: Iterable[str], *, bold: bool = False) -> str:
    texts = (f"<b>{escape(cell)}</b>" if bold else escape(cell) for cell in cells)
    return "<tr>" + "".join(f"<td>{text}</td>" for text in texts) + "</tr>"


def _table(titles: Sequence[str], widths: Sequence[int], rows: Iterable[str]) -> str:
    """Return a table whose titles stand on each page; widths are in per cent."""
    head = "".join(
        f'<th align="left" width="{width}%">{escape(title)}</th>'
        for title, width in zip(titles, widths, strict=True)
    )
    body = "".join(rows)
    start = '<table width="100%" cellspacing="0" cellpadding="2">'
    return f"{start}<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
