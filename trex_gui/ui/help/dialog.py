"""Help window, separate from the main window so that both stay visible."""

import re
from html import escape, unescape
from pathlib import Path
from typing import Any

from PySide6.QtCore import QPointF, QRectF, QSignalBlocker, Qt, QUrl, Slot
from PySide6.QtGui import QDesktopServices, QImage, QPainter, QPen, QResizeEvent, QTextDocument
from PySide6.QtWidgets import QListWidget, QTextBrowser, QWidget

from trex_gui.core.resource_files import resource
from trex_gui.core.translation import tr
from trex_gui.ui.help.pages import anchor_of, pages
from trex_gui.ui.runtime import new_timer
from trex_gui.ui.theme.icons import application_icon
from trex_gui.ui.theme.theme import follow_theme, theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.placement import resize_with_font
from trex_gui.version import __version__

_RESIZED_MS = 150  # delay before the pictures are fitted to a new width
_HEADING_MARGIN = "margin-top:14px"

_TAG = re.compile(r"<[^>]*>")
_HEADING = re.compile(r"(<h[1-6][^>]*>)(.*?)(</h[1-6]>)", re.DOTALL)  # in Qt's HTML

# Files shown in this window. The desktop opens all other files, and might run a Python file.
_SHOWN_SUFFIXES = {".md", ".py"}


def page_url(topic: str) -> QUrl:
    name, _, anchor = topic.partition("#")
    url = QUrl.fromLocalFile(str(resource(f"help/{name}")))
    url.setFragment(anchor)
    return url


class HelpDialog(ReusedDialog):
    def __init__(self) -> None:
        super().__init__()  # no parent, because Windows keeps a dialog above its parent
        self.setWindowFlags(Qt.WindowType.Window)  # can be maximized
        self.setWindowIcon(application_icon())
        self.setObjectName("helpDialog")
        self.setWindowTitle(f"{tr('Help')} – {tr('TReX Studio')} {__version__}")
        resize_with_font(self, 1180, 800)
        self._list = ui.named(QListWidget(self), "helpPages", accessible=tr("Pages of the help"))
        self._list.setWordWrap(True)
        self._list.setSpacing(2)
        self._names = [page.name for page in pages()]
        self._list.addItems([page.title for page in pages()])
        self._text = text = _Browser(self)
        steps = []
        for name, title, icon, step, available in (
            ("helpBack", tr("&Back"), "undo", text.backward, text.backwardAvailable),
            ("helpForward", tr("&Forward"), "redo", text.forward, text.forwardAvailable),
        ):
            button = ui.button(self, name, title, icon=icon, default=False, on_click=step)
            button.setEnabled(False)
            available.connect(button.setEnabled)
            steps.append(button)
        close = ui.button(self, "helpClose", tr("&Close"), on_click=self.close)
        splitter = ui.splitter(self, "", Qt.Orientation.Horizontal, (self._list, 0), (text, 1))
        splitter.setSizes([230, 950])
        heading = ui.label(self, text=tr("Help"), size="title")
        ui.column(heading, (splitter, 1), ui.row(*steps, 1, close, margins=0), into=self)
        self._list.currentRowChanged.connect(self._on_page_selected)
        text.sourceChanged.connect(self._select)

    def show_topic(self, topic: str) -> None:
        """Show a page or a section, such as `page.md#anchor`."""
        self.show_in_front()
        self._text.setSource(page_url(topic))
        self._text.setFocus(Qt.FocusReason.PopupFocusReason)

    @Slot(int)
    def _on_page_selected(self, row: int) -> None:
        if row >= 0:
            self._text.setSource(page_url(self._names[row]))

    @Slot(QUrl)
    def _select(self, url: QUrl) -> None:
        name = url.fileName()  # `source` still returns the previous page
        with QSignalBlocker(self._list):
            self._list.setCurrentRow(self._names.index(name) if name in self._names else -1)


class _Browser(QTextBrowser):
    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        ui.named(self, "helpText", accessible=tr("Help"))
        # Always visible, since pictures are scaled to the remaining width.
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOn)
        self._resized = new_timer(self, _RESIZED_MS, self.reload, single_shot=True)
        follow_theme(self, "help", self.reload)

    def doSetSource(  # noqa: N802 - Qt's name
        self,
        name: QUrl | str,
        type: QTextDocument.ResourceType = QTextDocument.ResourceType.UnknownResource,  # noqa: A002
    ) -> None:
        del type  # everything is shown as HTML
        url = QUrl(name)
        if url.isEmpty():
            return
        full_url = self.source().resolved(url)
        if Path(full_url.toLocalFile()).suffix in _SHOWN_SUFFIXES:
            super().doSetSource(full_url, QTextDocument.ResourceType.HtmlResource)
        else:
            QDesktopServices.openUrl(full_url)

    def loadResource(self, kind: int, name: QUrl | str) -> Any:  # noqa: N802 - Qt's name
        full_url = self.source().resolved(QUrl(name))
        if kind == QTextDocument.ResourceType.HtmlResource.value:
            return self._html(full_url)
        if kind == QTextDocument.ResourceType.ImageResource.value:
            return self._picture(full_url)
        return super().loadResource(kind, name)

    def _html(self, url: QUrl) -> str:
        path = Path(url.toLocalFile())
        if path.suffix == ".py":
            return f"<pre>{escape(path.read_text(encoding='utf-8'))}</pre>"
        (page,) = (page for page in pages() if page.name == path.name)
        document = QTextDocument()
        document.setDefaultFont(self.font())
        document.setMarkdown(page.text, QTextDocument.MarkdownFeature.MarkdownDialectGitHub)
        color = theme().color("muted").name()
        table = f'style="border-color: {color}; margin-top: 7px; margin-bottom: 7px;'
        html = document.toHtml().replace('<table border="1" style="', f'<table border="1" {table}')
        return _HEADING.sub(_with_anchor, html)

    def _picture(self, url: QUrl) -> QImage:
        dark = theme().color("window").lightness() < 128
        path = url.toLocalFile()
        image = QImage(path.replace("-light.", "-dark.") if dark else path)
        if image.isNull():  # Qt also requests invalid addresses
            return image
        image = image.convertToFormat(QImage.Format.Format_RGB32)
        width = self.viewport().width() - 2 * round(self.document().documentMargin())
        ratio = self.devicePixelRatioF()
        if image.width() > width * ratio > 0:
            image = image.scaledToWidth(
                round(width * ratio), Qt.TransformationMode.SmoothTransformation
            )
            image.setDevicePixelRatio(ratio)
        with QPainter(image) as painter:  # the frame sets the picture apart from real controls
            painter.setPen(QPen(theme().color("muted"), 3))
            painter.drawRect(QRectF(QPointF(), image.deviceIndependentSize()))
        return image

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self._resized.start()


def _with_anchor(heading: re.Match[str]) -> str:
    start, title, end = heading.groups()
    anchor = anchor_of(unescape(_TAG.sub("", title)))
    start = start.replace("margin-top:0px", _HEADING_MARGIN)
    return f'{start}<a name="{anchor}">{title}</a>{end}'
