"""Picture of a board whose jumpers and LEDs are as a task needs them."""

from collections.abc import Collection, Mapping

from PySide6.QtCore import QRectF, Slot
from PySide6.QtGui import QAccessible, QHideEvent, QPaintEvent, QPen, QShowEvent
from PySide6.QtWidgets import QApplication, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.views.board.parts import JumperPart
from trex_gui.ui.runtime import new_timer
from trex_gui.ui.theme.theme import follow_theme, scaled_font, theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.leds import Leds
from trex_gui.ui.widgets.painted import Painted, Painter, wants_motion

_PULSE_MS = 600


class JumperPicture(Painted):
    """Names the position of each jumper; a frame pulses round those to be moved."""

    def __init__(self, parent: QWidget | None = None, *, scale: float = 1.0) -> None:
        """`scale`: size of the font, relative to that of the application."""
        super().__init__(parent)
        self.setObjectName("jumperPicture")
        self.setAccessibleName(tr("Jumpers"))
        self._scale = scale
        self._moved: Collection[str] = ()
        self._is_bright = True
        self._timer = new_timer(self, _PULSE_MS, self._on_pulse)
        names = {"mode": tr("Mode jumper"), "mix": tr("Mix jumper"), "so_ground": tr("SO–G jumper")}
        self._jumpers = {
            key: JumperPart(key, name, self.update, self) for key, name in names.items()
        }
        for part in self._jumpers.values():  # here it leads nowhere
            part.spoken_role = QAccessible.Role.Graphic
            part.setEnabled(False)
        self._leds = Leds(self)
        jumpers = self._jumpers.values()
        ui.column(self._leds, *jumpers, into=self, margins=(24, 20, 12, 20), spacing=4)
        follow_theme(self, "room", self._take_room)

    def show_jumpers(
        self,
        mode: str = "",
        mix: bool | None = None,
        *,
        so_ground: bool = False,
        moved: Collection[str] = (),
        leds: tuple[str, str] | None = None,
        remarks: Mapping[str, str] | None = None,
    ) -> None:
        """Show where the jumpers shall be, and the patterns of the LEDs then.

        `mode` is RC, Analog or empty; `mix` is `None` if it does not matter. `moved` and `remarks`
        (what is known of a jumper) have the keys `mode`, `mix` and `so_ground`.
        """
        mix_name = tr("Mix: on") if mix else tr("Mix: either") if mix is None else tr("Mix: off")
        names = {
            "mode": (bool(mode), tr("Mode: {0}").format(mode) if mode else tr("Mode: off")),
            "mix": (mix, mix_name),
            "so_ground": (so_ground, tr("SO–G: on") if so_ground else tr("SO–G: off")),
        }
        self._moved = moved
        for key, (is_on, name) in names.items():
            to_do = (tr("put it on") if is_on else tr("remove it")) if key in moved else ""
            lines = filter(None, (name, (remarks or {}).get(key, to_do)))
            self._jumpers[key].show_jumper(is_on, *lines)
        self._leds.setVisible(leds is not None)
        if leds is not None:
            self._leds.show_patterns(leds, ("", ""), ("", ""))
        self._take_room()

    def _take_room(self) -> None:
        self.setFont(scaled_font(QApplication.font(), self._scale))
        advance, line = self.fontMetrics().horizontalAdvance, self.fontMetrics().height()
        for part in self._jumpers.values():
            widest = max(map(advance, part.lines), default=0)
            part.setMinimumSize(round(1.1 * widest) + 5 * line, round((2 + self._scale / 2) * line))
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        color, body = theme().color, QRectF(self.rect()).adjusted(1, 1, -1, -1)
        with Painter(self) as painter:
            painter.setPen(QPen(color("board_edge"), 2))
            painter.setBrush(color("board"))
            painter.drawRoundedRect(body, 10, 10)
            painter.setPen(QPen(color("accent"), 2))
            painter.setBrush(color("selected" if self._is_bright else "board"))
            for key in self._moved:
                place = QRectF(self._jumpers[key].geometry()).adjusted(-6, 0, 6, 0)
                painter.drawRoundedRect(place, 8, 8)

    @Slot()
    def _on_pulse(self) -> None:
        self._is_bright = not self._is_bright or not wants_motion(self)
        self.update()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._take_room()  # the style sheet forgets the font of a widget that gets another parent
        self._timer.start()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._timer.stop()
