"""Preferences dialog. All changes except the language take effect at once."""

from collections.abc import Sequence

from PySide6.QtCore import QSignalBlocker, Slot
from PySide6.QtWidgets import QFormLayout, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.ui.devices.auto_connect import connects_automatically, set_connects_automatically
from trex_gui.ui.theme.theme import (
    FONT_SIZES,
    SCHEMES,
    Scheme,
    select_font_size,
    select_scheme,
    theme,
)
from trex_gui.ui.translations import LANGUAGES, SYSTEM_LANGUAGE, select_language, selected_language
from trex_gui.ui.units import units
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.labels import Muted
from trex_gui.ui.widgets.placement import fitted

_WIDTH = 440  # pixels at a font size of 100 %


class PreferencesDialog(ReusedDialog):
    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("preferencesDialog")
        self.setWindowTitle(title_of(tr("&Preferences…")))
        names: dict[Scheme, str] = {
            "system": tr("As the system"),
            "light": tr("Light"),
            "dark": tr("Dark"),
            "high_contrast": tr("High contrast"),
        }
        schemes = [(names[scheme], scheme) for scheme in SCHEMES]
        sizes = [(tr("{0} %").format(percent), percent) for percent in FONT_SIZES]
        languages = [(name, code) for code, name in LANGUAGES.items()]
        unit_names = (
            tr("Physical units (µs, V, %, s)"),
            tr("Values of the board (counts, 0 to 127)"),
        )
        form = QFormLayout()

        def add_box(
            name: str,
            title: str,
            items: Sequence[tuple[str, object]],
            on_activate: ui.Handler,
            tip: str = "",
        ) -> ui.ComboBox:
            box = ui.combo_box(self, name, "", items=items, tip=tip, on_activate=on_activate)
            form.addRow(title, box)
            return box

        self._scheme = add_box(
            "schemeBox", tr("&Theme:"), schemes, lambda index: select_scheme(SCHEMES[index])
        )
        self._font_size = add_box(
            "fontSizeBox",
            tr("&Font size:"),
            sizes,
            lambda index: select_font_size(FONT_SIZES[index]),
        )
        self._language = add_box(
            "languageBox",
            tr("&Language:"),
            [(tr("As the system"), SYSTEM_LANGUAGE), *languages],
            lambda _: select_language(self._language.currentData()),
            tr("Takes effect the next time the program starts"),
        )
        self._units = add_box(
            "unitsBox",
            tr("&Units:"),
            list(zip(unit_names, (False, True), strict=True)),
            lambda index: units().set_order(own_first=bool(index)),
            tr(
                "Determines which unit is shown first, and which unit applies to a number "
                "typed without one"
            ),
        )
        self._automatic = ui.check_box(
            self,
            "automaticBox",
            tr("Connect to known boards automat&ically"),
            on_click=set_connects_automatically,
        )
        explanation = Muted(
            tr(
                "The program connects when it starts or when a known adapter is plugged in, "
                "if exactly one board responds. It does not connect after Disconnect or "
                "while another program uses the port. No motor moves."
            ),
            self,
        )
        close = ui.button(self, "preferencesClose", tr("&Close"), on_click=self.close)
        close.setDefault(True)
        self._rows = ui.column(
            ui.label(self, text=self.windowTitle(), size="title"),
            form,
            self._automatic,
            ui.row((explanation, 1), margins=(22, 0, 0, 0)),
            1,
            ui.row(1, close),
            into=self,
        )
        theme().changed.connect(self._show_choices)
        theme().changed.connect(self._fit)
        self._fit()

    def open_preferences(self) -> None:
        self._show_choices()
        self.show_in_front()

    @Slot()
    def _show_choices(self) -> None:
        with QSignalBlocker(self._scheme), QSignalBlocker(self._font_size):
            self._scheme.setCurrentIndex(self._scheme.findData(theme().choice))
            self._font_size.setCurrentIndex(self._font_size.findData(theme().font_size))
        self._language.setCurrentIndex(self._language.findData(selected_language()))
        self._units.setCurrentIndex(self._units.findData(units().own_first))
        self._automatic.setChecked(connects_automatically())

    @Slot()
    def _fit(self) -> None:
        self._rows.activate()  # updates the heights of the inner rows
        width = max(_WIDTH * theme().font_size // 100, self.minimumSizeHint().width())
        self.resize(width, self.heightForWidth(width))
        if self.isVisible():
            self.setGeometry(fitted(self.geometry(), self.screen().availableGeometry()))
