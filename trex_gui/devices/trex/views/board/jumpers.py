"""Picture of a board whose jumpers and LEDs are as a task needs them."""

from collections.abc import Collection, Mapping

from PySide6.QtCore import QRectF, Qt, Slot
from PySide6.QtGui import QAccessible, QHideEvent, QPaintEvent, QPen, QShowEvent
from PySide6.QtWidgets import QApplication, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.views.board.parts import BoardPart, JumperPart, LedPart
from trex_gui.ui.runtime import new_timer, now
from trex_gui.ui.theme.theme import follow_theme, scaled_font, theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.painted import Painted, Painter, wants_motion

_FRAME_MS = 40
_PULSE_S = 1.2  # from one pulse of a jumper to move to the next


class JumperPicture(Painted):
    """Names the position of each jumper; a frame pulses round those to be moved."""

    def __init__(self, parent: QWidget | None = None, *, scale: float = 1.0) -> None:
        """`scale`: size of the font, relative to that of the application."""
        super().__init__(parent)
        self.setObjectName("jumperPicture")
        self.setAccessibleName(tr("Jumpers"))
        self._scale = scale
        self._moved: Collection[str] = ()
        self._timer = new_timer(self, _FRAME_MS, self._on_frame)
        names = {"mode": tr("Mode jumper"), "mix": tr("Mix jumper"), "so_ground": tr("SO–G jumper")}
        self._jumpers = {
            key: JumperPart(key, name, self.update, self) for key, name in names.items()
        }
        self._leds = (
            LedPart("Red", tr("Red LED"), self.update, self, "led_red"),
            LedPart("Green", tr("Green LED"), self.update, self, "led_green"),
        )
        for part in self.findChildren(BoardPart):  # here it leads nowhere
            part.spoken_role = QAccessible.Role.Graphic
            part.setFocusPolicy(Qt.FocusPolicy.NoFocus)
            part.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        jumpers = ui.column(*self._jumpers.values(), spacing=4)
        leds = ui.row(*self._leds)
        ui.column(leds, (jumpers, 1), into=self, margins=(24, 20, 12, 20), spacing=4)
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
        for led, name, pattern in zip(
            self._leds, (tr("Red"), tr("Green")), leds or ("", ""), strict=True
        ):
            led.pattern = pattern
            led.show_lines(name)
            led.setVisible(leds is not None)
        self._take_room()
        self._run()

    def _take_room(self) -> None:
        self.setFont(scaled_font(QApplication.font(), self._scale))
        advance, line = self.fontMetrics().horizontalAdvance, self.fontMetrics().height()
        for part in self.findChildren(BoardPart):
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
            painter.setBrush(color("base"))
            holes = body.adjusted(10, 10, -10, -10)
            for x in (holes.left(), holes.right()):
                for y in (holes.top(), holes.bottom()):
                    painter.drawEllipse(QRectF(x - 4, y - 4, 8, 8))
            is_bright = not wants_motion(self) or now() % _PULSE_S < _PULSE_S / 2
            painter.setPen(QPen(color("accent"), 2 if is_bright else 1))
            painter.setBrush(color("selected" if is_bright else "board"))
            for key in self._moved:
                place = QRectF(self._jumpers[key].geometry()).adjusted(-6, 0, 6, 0)
                painter.drawRoundedRect(place, 8, 8)

    @Slot()
    def _on_frame(self) -> None:
        for number, led in enumerate(self._leds):
            led.show_moment(now(), second=number == 1)
        if self._moved:
            self.update()

    def _run(self) -> None:
        self._on_frame()
        if self.isVisible() and (self._moved or any(led.moves for led in self._leds)):
            self._timer.start()
        else:
            self._timer.stop()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._run()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._run()
