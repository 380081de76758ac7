"""PDF file with tables of settings. Values other than the default are bold."""

from collections.abc import Iterable, Mapping
from datetime import datetime
from html import escape
from itertools import groupby

from PySide6.QtCore import QBuffer, QIODevice
from PySide6.QtGui import QPageSize, QPdfWriter, QTextDocument

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.protocol.calibration import CALIBRATION_FIELDS
from trex_gui.devices.trex.settings.document import Settings


def settings_pdf(settings: Settings, name: str, remarks: Iterable[str]) -> bytes:
    """Return the content of the PDF file. `remarks` are texts below the tables."""
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    writer = QPdfWriter(buffer)
    writer.setPageSize(QPageSize(QPageSize.PageSizeId.A4))
    writer.setTitle(name)
    settings_document(settings, name, remarks).print_(writer)
    del writer  # this completes the file
    return bytes(buffer.data().data())


def settings_document(settings: Settings, name: str, remarks: Iterable[str] = ()) -> QTextDocument:
    document = QTextDocument()
    font = document.defaultFont()
    font.setPointSizeF(8)
    document.setDefaultFont(font)
    # Paper is white in every theme.
    document.setDefaultStyleSheet("body { color: black }")
    document.setHtml(f"<body>{settings_html(settings, name, remarks)}</body>")
    return document


def settings_html(settings: Settings, name: str, remarks: Iterable[str] = ()) -> str:
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
    rows, tasks = [], ParameterModel().titles
    specs = sorted(settings.specs.readable, key=lambda spec: list(tasks).index(spec.task))
    for task, members in groupby(specs, key=lambda spec: spec.task):
        title = escape(tasks[task])
        rows.append(f'<tr><td colspan="{len(titles)}"><br><i>{title}</i></td></tr>')
        for spec in members:
            wire = settings.parameters.get(spec.key)
            value = tr("not given") if wire is None else spec.text(wire)
            cells = (spec.name, spec.key, value, "" if wire is None else str(wire))
            is_changed = wire not in {None, spec.default}
            rows.append(_row((*cells, spec.text(spec.default)), bold=is_changed))
            rows += _rows_for_note(settings, spec.key, len(titles))
    return _table(titles, rows)


def _calibrations(settings: Settings) -> str:
    titles = {
        tr("Channel"): 18,
        tr("Key"): 18,
        tr("Minimum"): 16,
        tr("Neutral"): 16,
        tr("Maximum"): 16,
        title_of(tr("&Deadband")): 16,
    }
    rows = []
    for key, calibration in settings.calibration_items():
        counts = [getattr(calibration, field) for field in CALIBRATION_FIELDS]
        values = (f"{key.source.text(count)} ({count})" for count in counts)
        rows.append(_row((key.label, key, *values)))
        rows += _rows_for_note(settings, key, len(titles))
    return _table(titles, rows) if rows else f"<p>{escape(tr('None set.'))}</p>"


def _rows_for_note(settings: Settings, key: str, columns: int) -> list[str]:
    note = settings.notes.get(key, "")
    text = escape(tr("Note: {0}").format(note)).replace("\n", "<br>")
    return [f'<tr><td colspan="{columns}"><i>{text}</i></td></tr>'] if note else []


def _row(cells: Iterable[str], *, bold: bool = False) -> str:
    texts = (f"<b>{escape(cell)}</b>" if bold else escape(cell) for cell in cells)
    return "<tr>" + "".join(f"<td>{text}</td>" for text in texts) + "</tr>"


def _table(titles: Mapping[str, int], rows: Iterable[str]) -> str:
    header = "".join(
        f'<th align="left" width="{width}%">{escape(title)}</th>' for title, width in titles.items()
    )
    start = '<table width="100%" cellspacing="0" cellpadding="2">'
    return f"{start}<thead><tr>{header}</tr></thead><tbody>{''.join(rows)}</tbody></table>"
