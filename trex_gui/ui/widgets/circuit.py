"""Painting of boards and robots, not to scale: bodies, header blocks, jumpers, texts."""

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRect, QRectF, QSizeF, Qt
from PySide6.QtGui import QFont, QFontMetrics, QPainter, QPen, QPolygonF

from trex_gui.ui.theme.theme import scaled_font, theme

_HOLE, _INSET = 5, 12  # pixels: radius of a hole, distance from its centre to the edges
_ROW = 2.4  # line heights from one jumper to the next
_UNLIMITED = 10_000  # pixels, more than any text needs
_LEFT = Qt.AlignmentFlag.AlignLeft
_CENTER = Qt.AlignmentFlag.AlignHCenter


def _paint_plate(painter: QPainter, plate: QRectF, radius: float) -> None:
    painter.setPen(QPen(theme().color("board_edge"), 2))
    painter.setBrush(theme().color("board"))
    painter.drawRoundedRect(plate, radius, radius)


def paint_chassis(painter: QPainter, chassis: QRectF) -> None:
    unit = chassis.width() / 220
    _paint_plate(painter, chassis, 34 * unit)
    tip = QPointF(chassis.center().x(), chassis.top() + 7 * unit)
    half_width, height = 14 * unit, 15 * unit
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(theme().color("mark"))
    right, left = tip + QPointF(half_width, height), tip + QPointF(-half_width, height)
    painter.drawPolygon(QPolygonF([tip, right, left]))


def paint_body(painter: QPainter, body: QRectF, name: str) -> None:
    _paint_plate(painter, body, 10)
    painter.setBrush(theme().color("base"))
    holes = body.adjusted(_INSET, _INSET, -_INSET, -_INSET)
    for hole in (holes.topLeft(), holes.topRight(), holes.bottomLeft(), holes.bottomRight()):
        painter.drawEllipse(hole, _HOLE, _HOLE)
    painter.save()
    line = painter.fontMetrics().height()
    painter.setFont(scaled_font(painter.font(), 1.3))
    title = QRectF(body.left(), body.top() + 0.8 * line, body.width(), 1.6 * line)
    write(painter, title, name, "window_text", bold=True, align=_CENTER)
    painter.restore()


def paint_block(painter: QPainter, rect: QRectF, pins: Sequence[str] = ()) -> None:
    painter.setPen(QPen(theme().color("outline"), 1))
    painter.setBrush(theme().color("base"))
    painter.drawRoundedRect(rect, 4, 4)
    for number, pin in enumerate(pins):
        width = rect.width() / len(pins)
        pin_rect = QRectF(rect.left() + number * width, rect.top(), width, rect.height())
        write(painter, pin_rect, pin, "window_text", bold=True, align=_CENTER)


def jumper_size(line: float) -> tuple[float, float]:
    """Return the width and height of a jumper. `line`: line height of the text."""
    return 3.6 * line, 1.8 * line


def paint_jumper(painter: QPainter, rect: QRectF, is_on: bool | None) -> None:
    """Paint two pins with or without a jumper. An unknown state (`None`) has a dashed outline."""
    style = Qt.PenStyle.DashLine if is_on is None else Qt.PenStyle.SolidLine
    painter.setPen(QPen(theme().color("outline"), 1.5, style))
    painter.setBrush(theme().color("mark") if is_on else Qt.BrushStyle.NoBrush)
    painter.drawRoundedRect(rect, 5, 5)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(theme().color("base" if is_on else "outline"))
    for fraction in (0.3, 0.7):
        pin = rect.topLeft() + QPointF(fraction * rect.width(), rect.height() / 2)
        painter.drawEllipse(pin, 3.5, 3.5)


Jumper = tuple[str, bool | None]  # text of a jumper, and its state: on, off or unknown (`None`)


def jumpers_size(font: QFont, jumpers: Sequence[Jumper]) -> QSizeF:
    line = QFontMetrics(font).height()
    widest = text_width(font, *(text for text, _ in jumpers)) if jumpers else 0
    return QSizeF(jumper_size(line)[0] + line + widest, _ROW * line * len(jumpers))


def paint_jumpers(painter: QPainter, at: QPointF, jumpers: Sequence[Jumper], line: float) -> None:
    """Paint a column of jumpers with their texts. `line`: line height of the text."""
    width, height = jumper_size(line)
    for number, (text, is_on) in enumerate(jumpers):
        rect = QRectF(at.x(), at.y() + number * _ROW * line, width, height)
        paint_jumper(painter, rect, is_on)
        text_rect = QRectF(rect.right() + 0.6 * line, rect.top(), _UNLIMITED, height)
        write(painter, text_rect, text, "window_text", bold=True)


def write(
    painter: QPainter,
    rect: QRectF,
    text: str,
    color: str,
    *,
    bold: bool = False,
    align: Qt.AlignmentFlag = _LEFT,
) -> None:
    """Write one line in a theme colour, elided to the width of `rect`."""
    painter.save()
    painter.setFont(_font(painter.font(), bold=bold))
    painter.setPen(theme().color(color))
    elide = Qt.TextElideMode.ElideRight
    elided = painter.fontMetrics().elidedText(text, elide, round(rect.width()))
    painter.drawText(rect, align | Qt.AlignmentFlag.AlignVCenter, elided)
    painter.restore()


def write_lines(painter: QPainter, rect: QRectF, lines: Sequence[str], *, alarm: str = "") -> None:
    """Write wrapped lines, vertically centred. `alarm`: theme colour of a bold last line."""
    wrap = Qt.TextFlag.TextWordWrap | Qt.AlignmentFlag.AlignTop
    rows = []
    for number, text in enumerate(lines):
        is_alarm = bool(alarm) and number == len(lines) - 1
        font = _font(painter.font(), bold=not number or is_alarm)
        color = alarm if is_alarm else "muted" if number else "window_text"
        box = QRect(0, 0, int(rect.width()), _UNLIMITED)
        rows.append((text, font, color, QFontMetrics(font).boundingRect(box, wrap, text).height()))
    top = rect.center().y() - sum(height for *_, height in rows) / 2
    painter.save()
    for text, font, color, height in rows:
        painter.setFont(font)
        painter.setPen(theme().color(color))
        painter.drawText(QRectF(rect.left(), top, int(rect.width()), height), wrap, text)
        top += height
    painter.restore()


def text_width(font: QFont, *texts: str) -> int:
    """Return the width of the widest text in bold type."""
    return max(map(QFontMetrics(_font(font, bold=True)).horizontalAdvance, texts))


def _font(font: QFont, *, bold: bool) -> QFont:
    weighted = QFont(font)
    weighted.setWeight(QFont.Weight.DemiBold if bold else QFont.Weight.Normal)
    return weighted
