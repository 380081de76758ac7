"""Picture of the required jumper positions and LED patterns."""

from collections.abc import Collection

from PySide6.QtCore import QPointF, QRectF, QSize
from PySide6.QtGui import QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.theme.theme import scaled_font, theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.circuit import Jumper, jumpers_size, paint_body, paint_jumpers
from trex_gui.ui.widgets.leds import Leds
from trex_gui.ui.widgets.painted import Painted, Painter

_SCALE = 1.4  # text size relative to the font of the widget
_LEFT, _ABOVE, _LEDS = 1.8, 1.3, 1.9  # lines of text: left margin, top margin, height of the LEDs


class JumperPicture(Painted):
    """Picture of the jumpers. Each jumper that the user must move has a frame."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("jumperPicture")
        self._jumpers: dict[str, Jumper] = {}
        self._to_move: Collection[str] = ()
        self._leds = Leds(self)
        ui.column(self._leds, 1, into=self, margins=(32, 20, 24, 20))

    def show_jumpers(
        self,
        mix: bool | None,
        *,
        mode: str = "",
        so_ground: bool = False,
        to_move: Collection[str] = (),
        leds: tuple[str, str] | None = None,
    ) -> None:
        """Show the required jumper positions and the resulting LED patterns.

        If `mode` is empty, the mode jumper is off. If `mix` is `None`, the mix jumper is not
        drawn. `to_move` contains the keys of the jumpers to move: `mode`, `mix` or `so_ground`.
        """
        names = {
            "mode": (tr("Mode: {0}").format(mode) if mode else tr("Mode: off"), bool(mode)),
            "mix": (tr("Mix: on") if mix else tr("Mix: off"), bool(mix)),
            "so_ground": (tr("SO–G: on") if so_ground else tr("SO–G: off"), so_ground),
        }
        if mix is None:
            del names["mix"]
        self._to_move, self._jumpers = to_move, {}
        for key, (name, is_on) in names.items():
            action = tr("put it on") if is_on else tr("remove it")
            self._jumpers[key] = (f"{name}  {action}" if key in to_move else name), is_on
        self.setAccessibleName(", ".join(text for text, _ in self._jumpers.values()))
        self._leds.setVisible(leds is not None)
        if leds is not None:
            self._leds.show_patterns(leds)
        self.updateGeometry()
        self.update()

    def minimumSizeHint(self) -> QSize:
        line = _SCALE * self.fontMetrics().height()
        size = jumpers_size(scaled_font(self.font(), _SCALE), [*self._jumpers.values()])
        return QSize(
            round(size.width() + 2 * _LEFT * line),
            round(size.height() + (self._above + 0.9) * line),
        )

    def sizeHint(self) -> QSize:
        return self.minimumSizeHint()

    @property
    def _above(self) -> float:
        return _ABOVE if self._leds.isHidden() else _ABOVE + _LEDS

    def paintEvent(self, _event: QPaintEvent) -> None:
        line, color = _SCALE * self.fontMetrics().height(), theme().color
        origin = QPointF(_LEFT * line, self._above * line)
        step = jumpers_size(self.font(), [("", True)]).height() * _SCALE
        with Painter(self) as painter:
            paint_body(painter, QRectF(self.rect()).adjusted(1, 1, -1, -1), "")
            painter.setPen(QPen(color("accent"), 2))
            painter.setBrush(color("selected"))
            for number, key in enumerate(self._jumpers):
                if key in self._to_move:
                    top = origin.y() + number * step - 0.2 * line
                    box = QRectF(origin.x() - 8, top, self.width() - origin.x() - line, 2.2 * line)
                    painter.drawRoundedRect(box, 8, 8)
            painter.setFont(scaled_font(self.font(), _SCALE))
            paint_jumpers(painter, origin, [*self._jumpers.values()], line)
