"""Places of a workspace: a column of tabs on the left, with icons and names."""

from collections.abc import Sequence

from PySide6.QtCore import QPoint, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QFont, QFontMetrics, QKeyEvent, QPainter, QPaintEvent, QPen, QResizeEvent
from PySide6.QtWidgets import QTabBar, QTabWidget, QWidget

from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import follow_theme, scaled_font, theme
from trex_gui.ui.widgets.builders import column, named
from trex_gui.ui.widgets.painted import Painter

_NARROW = 1100  # pixels; narrower workspaces show only icons
_ICON, _PADDING = 20, 8  # pixels
_KEYS = {Qt.Key.Key_Up: -1, Qt.Key.Key_Left: -1, Qt.Key.Key_Down: 1, Qt.Key.Key_Right: 1}


class PlaceBar(QTabBar):
    is_narrow = False

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.icons: Sequence[str] = ()  # icon names, in the order of the tabs
        self._counts: dict[int, int] = {}  # index of a tab → displayed count
        self.setMouseTracking(True)
        self.setExpanding(False)
        self.setUsesScrollButtons(False)
        self.setElideMode(Qt.TextElideMode.ElideNone)
        follow_theme(self, "sizes", self.show_names)

    def set_narrow(self, narrow: bool) -> None:
        if narrow != self.is_narrow:
            self.is_narrow = narrow
            self.show_names()

    def show_names(self) -> None:
        """Update the names in the tabs or in their tool tips."""
        for index in range(self.count()):
            self.setTabText(index, self.tabText(index))  # makes Qt update the size of the tab
            self._update_name(index)

    def set_count(self, index: int, count: int) -> None:
        """Show a count on a tab without moving the tabs. A count of 0 is hidden."""
        if count != self._counts.get(index, 0):
            self._counts[index] = count
            self._update_name(index)
            self.update()

    def _update_name(self, index: int) -> None:
        name = title_with_count(self.tabText(index), self._counts.get(index, 0))
        self.setAccessibleTabName(index, name)
        self.setTabToolTip(index, name if self.is_narrow else "")

    def tabSizeHint(self, index: int) -> QSize:  # noqa: N802 - Qt's name
        metrics = self.fontMetrics()
        height = max(round(1.6 * metrics.height()), _ICON + 12)
        if self.is_narrow:
            return QSize(_ICON + 3 * _PADDING, height)
        name = metrics.horizontalAdvance(self.tabText(index))
        padding = _ICON + 6 * _PADDING + metrics.height()  # includes space for a count
        return QSize(round(1.1 * name) + padding, height)  # Qt gives all tabs the largest width

    def minimumTabSizeHint(self, index: int) -> QSize:  # noqa: N802 - Qt's name
        return self.tabSizeHint(index)

    def minimumSizeHint(self) -> QSize:
        """Return the size of the tabs without names, which allows a narrow window."""
        height = sum(self.tabSizeHint(index).height() for index in range(self.count()))
        return QSize(_ICON + 3 * _PADDING, height)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        step = _KEYS.get(Qt.Key(event.key()))
        if step is None:
            super().keyPressEvent(event)
            return
        index = self.currentIndex() + step
        while 0 <= index < self.count() and not self.isTabVisible(index):
            index += step
        if 0 <= index < self.count():
            self.setCurrentIndex(index)

    def paintEvent(self, _event: QPaintEvent) -> None:
        hovered = self.tabAt(self.mapFromGlobal(self.cursor().pos()))
        with Painter(self) as painter:
            for index in filter(self.isTabVisible, range(self.count())):
                is_current = index == self.currentIndex()
                rect = self.tabRect(index).adjusted(_PADDING, 2, -_PADDING, -2)
                if is_current or index == hovered:
                    painter.setPen(Qt.PenStyle.NoPen)
                    painter.setBrush(theme().color("selected" if is_current else "window"))
                    painter.drawRoundedRect(rect, 6, 6)
                if is_current:
                    painter.setBrush(theme().color("accent"))
                    bar = QRectF(rect.left(), rect.top() + 6, 3, rect.height() - 12)
                    painter.drawRoundedRect(bar, 1.5, 1.5)
                left = rect.left() + _PADDING + 4
                icon_rect = QRect(left, rect.center().y() - _ICON // 2 + 1, _ICON, _ICON)
                if self.is_narrow:
                    icon_rect.moveCenter(rect.center())
                color = "accent" if is_current else "muted"
                icon(self.icons[index], color).paint(painter, icon_rect)
                if count := self._counts.get(index):
                    self._paint_count(painter, rect, count)
                if self.is_narrow:
                    continue
                font = QFont(self.font())
                font.setWeight(QFont.Weight.DemiBold if is_current else QFont.Weight.Normal)
                painter.setFont(font)
                painter.setPen(theme().color("window_text" if is_current else "muted"))
                text = QRect(icon_rect.right() + 12, rect.top(), rect.width(), rect.height())
                painter.drawText(text, Qt.AlignmentFlag.AlignVCenter, self.tabText(index))

    def _paint_count(self, painter: QPainter, rect: QRect, count: int) -> None:
        font = scaled_font(self.font(), 0.8)
        side = QFontMetrics(font).height()
        badge = QRect(rect.right() - side - 2, 0, side + 2, side)
        badge.moveCenter(QPoint(badge.center().x(), rect.center().y()))
        if self.is_narrow:
            badge.moveTop(rect.top())
        painter.setFont(font)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme().color("accent"))
        painter.drawRoundedRect(badge, side / 2, side / 2)
        painter.setPen(theme().color("primary_text"))
        text = str(count) if count < 10 else "9+"
        painter.drawText(badge, Qt.AlignmentFlag.AlignCenter, text)


def title_with_count(title: str, count: int) -> str:
    """Return a title with its count, such as `Problems (2)`."""
    return f"{title} ({count})" if count else title


class Places(QTabWidget):
    """Tabs in a column. A narrow window shows only icons."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.bar = PlaceBar(self)
        self.setTabBar(self.bar)
        self.setTabPosition(QTabWidget.TabPosition.West)
        self.setDocumentMode(True)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.bar.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        theme().changed.connect(self.update)

    def resizeEvent(self, event: QResizeEvent) -> None:
        self.bar.set_narrow(self.width() < _NARROW)
        super().resizeEvent(event)

    def paintEvent(self, _event: QPaintEvent) -> None:
        column = QRect(self.bar.x(), 0, self.bar.width(), self.height())
        with Painter(self) as painter:
            painter.fillRect(column, theme().color("base"))
            painter.setPen(QPen(theme().color("hairline"), 1))
            painter.drawLine(column.topRight(), column.bottomRight())


class Place(QWidget):
    """Place that shows several pages on tabs."""

    tabs: QTabWidget

    def __init__(self, name: str, title: str, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        self.title = title

    def add_tabs(self, *above: QWidget) -> None:
        """Add the tabs below the widgets `above`, which the Tab key visits first."""
        name = self.objectName().replace("Page", "Tabs")
        self.tabs = named(QTabWidget(self), name, accessible=self.title)
        self.tabs.setDocumentMode(True)
        column(*above, (self.tabs, 1), into=self, margins=(16, 16, 16, 0), spacing=8)
