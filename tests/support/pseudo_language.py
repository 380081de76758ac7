"""Pseudo-language: English with accents, a third longer, and between brackets.

Untranslated texts stand out, because only texts that `packaging/translations.py` extracts are
translated.
"""

import re
from collections.abc import Iterator

from PySide6.QtCore import (
    QAbstractItemModel,
    QAbstractListModel,
    QModelIndex,
    QRect,
    QSize,
    Qt,
    QTranslator,
)
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractScrollArea,
    QAbstractSpinBox,
    QCheckBox,
    QComboBox,
    QDockWidget,
    QDoubleSpinBox,
    QGroupBox,
    QHeaderView,
    QLabel,
    QLineEdit,
    QMenu,
    QMenuBar,
    QPlainTextEdit,
    QPushButton,
    QRadioButton,
    QScrollArea,
    QSpinBox,
    QStyle,
    QStyleOptionButton,
    QStyleOptionComboBox,
    QTabBar,
    QTextBrowser,
    QToolButton,
    QWidget,
)

from tests.support.scripts import program_texts
from trex_gui.ui.frame.places import PlaceBar
from trex_gui.ui.widgets.labels import ElidedLabel

BEGIN, END = "⟦", "⟧"
_ACCENTS = str.maketrans("aceinouyACEINOUY", "áçéíñóúýÁÇÉÍÑÓÚÝ")
_UNCHANGED = re.compile(
    r"\{[^{}]*\}|%n|%L?\d|&\w|<[^>]*>|\*\.\w+|;;|&lt;|&gt;|&amp;|&nbsp;|https?://\S+|style='[^']*'"
)
_WORD_LENGTH = 8  # of added words, which can be wrapped like other words
_HTML = re.compile(r"<[^>]*>|&#?\w+;")
_WORD = re.compile(r"[A-Za-z]{2,}")
_NOT_TRANSLATED = re.compile(
    r"TReX|Jr|Demo|DMC0\d|Aracna|Pololu|Studio|UART|CRC|PWM|RS|TTL|SI|SO|TX|RX|GND|Mix|LED|RC|SO–G"
    r"|[kmM]?(?:Hz|s|ms|V|A|Ah|mAh|mA|min|h|µs)|MiB|Ctrl|Alt|Shift|Esc|Enter|baud|max|min|[A-F0-9]{2}|0x[0-9a-fA-F]+"
    r"|/[\w./-]+|[a-z0-9]+_[a-z0-9_]+|\S+\.(?:txt|log|trexrec|csv|ppr|toml|yaml)|(?:socket|rfc2217)://\S+"
)


_NOT_TRANSLATED_WIDGETS = {
    "languageBox",  # shows each language in its own words
    "helpText",  # the help is in English
    "helpPages",
    "aracnaPoses",  # shows names from a file
    "aracnaSteps",
}


def pseudo(text: str) -> str:
    """Translate a text, but not its placeholders, tags and mnemonics."""
    parts, end = [], 0
    for match in _UNCHANGED.finditer(text):
        parts += [text[end : match.start()].translate(_ACCENTS), match[0]]
        end = match.end()
    parts.append(text[end:].translate(_ACCENTS))
    added = "~" * (len(text) // 3 - len(BEGIN + END))
    if len(added) > _WORD_LENGTH:
        added = " " + " ".join(re.findall(f"~{{1,{_WORD_LENGTH}}}", added))
    return f"{BEGIN}{''.join(parts)}{added}{END}"


class PseudoTranslator(QTranslator):
    """Translator for all texts that a language file would contain."""

    def isEmpty(self) -> bool:  # noqa: N802
        return False

    def translate(
        self, context: str, source: str, disambiguation: str | None = None, n: int = -1
    ) -> str | None:
        del context
        if (source, disambiguation or "") not in program_texts():
            return None
        translated = pseudo(source)
        return translated.replace("%n", str(n)) if n >= 0 else translated


def untranslated(text: str) -> str:
    """Return the part of a text that is not translated. Empty if it is only names and numbers."""
    plain = _HTML.sub(" ", text).replace("&", "")
    while BEGIN in plain and (inner := re.search(rf"{BEGIN}[^{BEGIN}{END}]*{END}", plain)):
        plain = plain.replace(inner[0], " ")
    words = [word for word in plain.split() if not _NOT_TRANSLATED.fullmatch(word.strip(".,:;()…"))]
    return plain.strip() if any(map(_WORD.search, words)) else ""


def shown_texts(root: QWidget) -> Iterator[tuple[str, str]]:
    """Yield the place and the text of `root` and of each visible widget below it."""
    for widget in [root, *root.findChildren(QWidget)]:
        is_of_qt = widget.objectName().startswith(("qt_", "Scroll"))  # translated by Qt
        if not widget.isVisible() or is_of_qt or widget.objectName() in _NOT_TRANSLATED_WIDGETS:
            continue
        where = widget.objectName() or widget.metaObject().className()
        for kind, text in _texts_of(widget):
            if text:
                yield f"{where} {kind}", text


def _texts_of(widget: QWidget) -> Iterator[tuple[str, str]]:
    yield "tool tip", widget.toolTip()
    yield "name", widget.accessibleName()
    yield "description", widget.accessibleDescription()
    if widget.isWindow() or isinstance(widget, QDockWidget):
        yield "title", widget.windowTitle()
    match widget:
        case QLabel() | QAbstractButton():
            yield "text", widget.text()
        case QGroupBox():
            yield "title", widget.title()
        case QComboBox():
            yield from (("entry", widget.itemText(index)) for index in range(widget.count()))
        case QTabBar():
            yield from (("tab", widget.tabText(index)) for index in range(widget.count()))
        case QTextBrowser():
            yield "text", widget.toPlainText()
        case QLineEdit() | QPlainTextEdit():
            yield "placeholder", widget.placeholderText()
        case QSpinBox() | QDoubleSpinBox():
            yield "suffix", widget.suffix()
        case QMenuBar():
            for menu in widget.actions():
                yield "menu", menu.text()
                if isinstance(inner := menu.menu(), QMenu):
                    yield from (("entry", each.text()) for each in inner.actions())
        case QAbstractItemView() if not isinstance(widget, QHeaderView):
            yield from _texts_of_model(widget.model())


def _texts_of_model(model: QAbstractItemModel | None) -> Iterator[tuple[str, str]]:
    if model is None:
        return
    if isinstance(model, QAbstractListModel):
        columns = 1
    else:
        columns = model.columnCount()
        for section in range(columns):
            header = model.headerData(section, Qt.Orientation.Horizontal)
            yield "header", header if isinstance(header, str) else ""
    yield from _texts_of_rows(model, QModelIndex(), columns)


def _texts_of_rows(
    model: QAbstractItemModel, parent: QModelIndex, columns: int
) -> Iterator[tuple[str, str]]:
    for row in range(model.rowCount(parent)):
        for column in range(columns):
            index = model.index(row, column, parent)
            for role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.ToolTipRole):
                text = model.data(index, role)
                yield f"cell {role.name}", text if isinstance(text, str) else ""
        if columns > 1:
            yield from _texts_of_rows(model, model.index(row, 0, parent), columns)


def cut_texts(root: QWidget) -> Iterator[str]:
    """Yield a sentence for each visible widget below `root` whose text is cut off."""
    for widget in root.findChildren(QWidget):
        if not widget.isVisible() or widget.objectName().startswith("qt_"):
            continue
        where = widget.objectName() or widget.metaObject().className()
        is_area = isinstance(widget, QScrollArea) and widget.horizontalScrollBar().isVisible()
        if is_area and not isinstance(widget.parent(), QDockWidget):  # users may narrow a dock
            yield f"{where} scrolls sideways"
        for text, needed, available in _space_needs(widget):
            if not text:
                continue
            if needed.width() > available.width() or needed.height() > available.height():
                yield f"{where}: {text!r} needs {needed.toTuple()}, has {available.toTuple()}"
            elif not _is_inside(widget):
                yield f"{where}: {text!r} is outside"


def _is_inside(widget: QWidget) -> bool:
    """Return whether the whole widget is visible, if necessary after scrolling."""
    rect, inner = widget.rect(), widget
    while (outer := inner.parentWidget()) is not None and not inner.isWindow():
        rect.translate(inner.pos())
        area = outer.parentWidget()
        if isinstance(area, QAbstractScrollArea) and outer is area.viewport():
            no_bar = area.horizontalScrollBarPolicy() is Qt.ScrollBarPolicy.ScrollBarAlwaysOff
            if isinstance(area, QScrollArea) and no_bar and not _fits_width(outer.rect(), rect):
                return False
            rect = outer.rect()
        elif not outer.rect().contains(rect):
            return False
        inner = outer
    return True


def _fits_width(view: QRect, rect: QRect) -> bool:
    return view.left() <= rect.left() and rect.right() <= view.right()


def _space_needs(widget: QWidget) -> Iterator[tuple[str, QSize, QSize]]:
    """Yield the texts of a widget, each with its required and its available size."""
    style = widget.style()
    match widget:
        case ElidedLabel() if not widget.wordWrap():
            pass  # the tool tip contains the whole text
        case QLabel():
            yield _need_of_label(widget)
        case QPushButton() | QCheckBox() | QRadioButton():
            yield _need_of_button(widget)
        case QToolButton() if widget.toolButtonStyle() != Qt.ToolButtonStyle.ToolButtonIconOnly:
            yield widget.text(), widget.sizeHint(), widget.size()
        case QComboBox() if widget.toolTip() != widget.currentText():  # otherwise elided
            box = QStyleOptionComboBox()
            widget.initStyleOption(box)
            field, combo = QStyle.SubControl.SC_ComboBoxEditField, QStyle.ComplexControl.CC_ComboBox
            available = style.subControlRect(combo, box, field, widget).size()
            yield widget.currentText(), _size(widget, widget.currentText()), available
        case QAbstractSpinBox():
            (edit,) = widget.findChildren(QLineEdit)
            longest = max(_spin_box_texts(widget), key=len)
            yield longest, QSize(_size(widget, longest).width(), 0), edit.contentsRect().size()
        case QGroupBox():
            check = style.pixelMetric(QStyle.PixelMetric.PM_IndicatorWidth, None, widget)
            extra = 2 * check if widget.isCheckable() else check // 2
            yield widget.title(), _size(widget, widget.title(), extra), widget.size()
        case PlaceBar() if widget.is_narrow:
            pass  # the texts are in tool tips
        case QTabBar():
            for index in filter(widget.isTabVisible, range(widget.count())):
                place = widget.tabRect(index)
                if not widget.usesScrollButtons():
                    place = place.intersected(widget.rect())
                yield widget.tabText(index), _size(widget, widget.tabText(index)), place.size()
        case QHeaderView() if widget.orientation() is Qt.Orientation.Horizontal:
            yield from _needs_of_header(widget)


def _spin_box_texts(box: QAbstractSpinBox) -> Iterator[str]:
    """Yield the text of a spin box and its special value text."""
    yield box.text()
    yield box.specialValueText()


def _size(widget: QWidget, text: str, extra: int = 0) -> QSize:
    """Return the size of a text, with `extra` pixels of width."""
    return widget.fontMetrics().size(Qt.TextFlag.TextShowMnemonic, text) + QSize(extra, 0)


def _need_of_button(button: QAbstractButton) -> tuple[str, QSize, QSize]:
    contents = QStyle.SubElement.SE_PushButtonContents
    if isinstance(button, QCheckBox):
        contents = QStyle.SubElement.SE_CheckBoxContents
    elif isinstance(button, QRadioButton):
        contents = QStyle.SubElement.SE_RadioButtonContents
    option = QStyleOptionButton()
    option.initFrom(button)
    icon = 0 if button.icon().isNull() else button.iconSize().width() + 4
    available = button.style().subElementRect(contents, option, button).size()
    return button.text(), _size(button, button.text(), icon), available


def _needs_of_header(header: QHeaderView) -> Iterator[tuple[str, QSize, QSize]]:
    margin = header.style().pixelMetric(QStyle.PixelMetric.PM_HeaderMargin, None, header)
    for section in range(header.count()):
        text = header.model().headerData(section, header.orientation())
        if isinstance(text, str) and not header.isSectionHidden(section):
            available = QSize(header.sectionSize(section), header.height())
            yield text, _size(header, text, 2 * margin), available


def _need_of_label(label: QLabel) -> tuple[str, QSize, QSize]:
    text, size = label.text(), label.size()
    if not label.wordWrap():
        return text, label.sizeHint(), size
    is_rich = label.textFormat() is not Qt.TextFormat.PlainText and "<" in text
    words = [] if is_rich else text.split()
    widest = max(map(label.fontMetrics().horizontalAdvance, words), default=0)
    return text, QSize(widest, label.heightForWidth(size.width())), size
