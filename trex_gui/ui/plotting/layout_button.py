"""Menu to select the colours of a plot, and to open and save its layout."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QPoint, QSize, Qt, Slot
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QMenu, QToolButton, QWidget

from trex_gui.core.files import load, save
from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.ui.files import in_background, save_in_background
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.plotting.figures import swatch
from trex_gui.ui.plotting.layout_file import (
    COLORS,
    LARGEST_FILE,
    PlotLayout,
    read_layout,
    write_layout,
)
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.plotting.traces import TraceInfo
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.builders import action

_SUFFIX = ".toml"


class LayoutButton(QToolButton):
    """Opens a menu of colours and of layout files."""

    def __init__(
        self,
        plot: TracePlot,
        notifier: Notifier,
        parent: QWidget,
        *,
        layout: Callable[[], PlotLayout],
        use: Callable[[PlotLayout | None], object],
    ) -> None:
        """`layout` returns the current layout. `use` shows a layout, or the default (`None`)."""
        super().__init__(parent)
        self._plot = plot
        self._notifier = notifier
        self._layout = layout
        self._use = use
        self.setObjectName("layoutButton")
        self.setText(tr("La&yout"))
        self.setAccessibleName(title_of(tr("La&yout")))
        self.setToolTip(tr("Colours of the curves; save and open how the plot is shown"))
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        set_icon(self, "settings")
        menu = QMenu(parent)
        self.setMenu(menu)
        self._colors = QMenu(tr("&Colours"), menu)
        self._colors.aboutToShow.connect(self._fill_colors)
        menu.addMenu(self._colors)
        menu.addSeparator()
        for name, text, slot in (
            ("layoutOpenAction", tr("&Open layout…"), self._prompt_and_open),
            ("layoutSaveAction", tr("&Save layout…"), self._prompt_and_save),
            ("layoutResetAction", tr("&Reset layout"), partial(use, None)),
        ):
            menu.addAction(action(self, name, text, on_trigger=slot))

    @Slot()
    def _fill_colors(self) -> None:
        for old in self._colors.findChildren(QMenu):
            old.deleteLater()
        self._colors.clear()
        if self._plot.source is not None:
            for trace in self._plot.source.traces:
                self._colors.addMenu(self.colors_of(trace, self._colors))

    def colors_of(self, trace: TraceInfo, parent: QWidget) -> QMenu:
        menu = QMenu(trace.label, parent)
        for name, (color, text) in COLORS.items():
            choose = partial(self._plot.set_color, trace.name, color)
            key = f"color_{trace.name}_{name}"
            entry = action(menu, key, tr(text), checkable=True, on_trigger=choose)
            entry.setIcon(QIcon(swatch(theme().color(color), QSize(14, 14))))
            entry.setChecked(trace.color == color)
            menu.addAction(entry)
        return menu

    def show_colors_of(self, trace: TraceInfo, place: QPoint) -> None:
        menu = self.colors_of(trace, self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.popup(place)

    def _prompt_and_open(self) -> None:
        path = file_questions.prompt_to_open(
            self.window(), title_of(tr("&Open layout…")), self._filter()
        )
        if path is not None:
            self.open(path)

    def open(self, path: Path) -> None:
        """Show the layout of a file, which is read in the background."""
        source = self._plot.source
        known = [] if source is None else [trace.name for trace in source.traces]

        def work() -> PlotLayout:
            return read_layout(load(path, tr("plot layouts"), LARGEST_FILE), str(path), known)

        def use(layout: PlotLayout) -> None:
            file_questions.remember_folder(path)
            self._use(layout)
            self._notifier.info.emit(tr("The layout of {0} is shown.").format(path.name))

        in_background(self, work, use, self._notifier.report_error)

    def _prompt_and_save(self) -> None:
        proposal = file_questions.last_folder() / f"plot_layout{_SUFFIX}"
        path = file_questions.prompt_to_save(
            self.window(), title_of(tr("&Save layout…")), proposal, self._filter(), _SUFFIX
        )
        if path is not None:
            self.save(path)

    def save(self, path: Path) -> None:
        """Save the layout of the plot to a file, in the background."""
        file_questions.remember_folder(path)
        saved = tr("The layout was saved in {0}.").format(path)
        work = partial(save, path, write_layout(self._layout()))
        save_in_background(self, work, self._notifier, saved)

    def _filter(self) -> str:
        return tr("Plot layouts (*{0})").format(_SUFFIX)
