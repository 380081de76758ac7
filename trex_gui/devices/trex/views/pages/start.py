"""What the Status page shows while nothing is connected: how to begin."""

from collections.abc import Callable
from functools import partial
from itertools import zip_longest

from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt, Slot
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QGroupBox, QPushButton, QWidget

from trex_gui.ui.devices.ports import Port, PortKind, Ports
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders as ui

_WIDEST_LINES = 100  # characters: longer lines are hard to read
_WIDEST_PORT = 38
_MOST_PORTS = 4


class StartPanel(QWidget):
    """Leads to a first connection; `choose` presses an action of the menus by its key."""

    def __init__(
        self,
        ports: Ports,
        device: str,
        connect_to: Callable[[Port], object],
        choose: Callable[[str], object],
        parent: QWidget | None = None,
    ) -> None:
        """`device` is the key of the kind of device that the demo simulates."""
        super().__init__(parent)
        self.setObjectName("startPanel")
        self._ports = ports
        self._connect_to = connect_to

        hardware = QGroupBox(self.tr("Connect my TReX"), self)
        steps = ui.label(
            hardware,
            "startSteps",
            self.tr(
                "<ol style='margin-left: -20px'>"
                "<li>Switch the board off. Remove the mode jumper: then it starts in serial mode, "
                "which is needed to drive it and to change settings from here. Remove the SO–G "
                "jumper, too.</li>"
                "<li>Wire a USB-serial adapter with TTL levels as shown. A real RS-232 port goes "
                "to the board's RS-232 pins: its voltages can damage SI and SO.</li>"
                "<li>Lift the wheels off the ground, switch the board on, and connect:</li>"
                "</ol>"
            ),
            wrap=True,
        )
        self._shown: list[Port] = []  # those of the buttons
        self._buttons = [
            ui.button(
                hardware, "startPort", icon="connect", on_click=partial(self._on_clicked, number)
            )
            for number in range(_MOST_PORTS)
        ]
        self._none = ui.label(
            hardware,
            "startNoPort",
            self.tr("No serial port was found. Plug the adapter in: it is listed here at once."),
            wrap=True,
        )
        find = ui.button(
            hardware,
            "startFind",
            self.tr("Find &my board…"),
            icon="find",
            tip=self.tr("Search every port and baud rate; no motor moves"),
            on_click=lambda: choose("find"),
        )
        begin = ui.column(
            steps,
            self._none,
            *((button, 0, Qt.AlignmentFlag.AlignLeft) for button in self._buttons),
            ui.row(find, 1),
            1,
        )
        ui.row((WiringSketch(hardware), 0, Qt.AlignmentFlag.AlignTop), (begin, 1), into=hardware)

        other = QGroupBox(self.tr("No board at hand?"), self)
        ui.row(
            ui.button(
                other,
                "startDemo",
                self.tr("&Try the demo"),
                icon="run",
                tip=self.tr("A simulated board: nothing can be damaged"),
                on_click=lambda: connect_to(ports.demo_of(device)),
            ),
            ui.button(
                other,
                "startSettings",
                self.tr("Open &settings file…"),
                icon="open",
                on_click=lambda: choose("open"),
            ),
            ui.button(
                other,
                "startRecording",
                self.tr("&Open recording…"),
                icon="plot",
                on_click=lambda: choose("open_recording"),
            ),
            1,
            into=other,
        )
        frame = QWidget(self)
        frame.setMaximumWidth(self.fontMetrics().averageCharWidth() * _WIDEST_LINES)
        ui.column(hardware, other, into=frame, margins=0)
        ui.column((ui.row((frame, 1)), 0), 1, into=self, margins=0)

        ports.changed.connect(self._on_ports_changed)
        self._on_ports_changed()

    @Slot()
    def _on_ports_changed(self) -> None:
        real = [port for port in self._ports.entries if port.kind is not PortKind.DEMO]
        self._shown = real[:_MOST_PORTS]
        for button, port in zip_longest(self._buttons, self._shown):
            button.setVisible(port is not None)
            if port is not None:
                self._show_port(button, port)
        self._none.setVisible(not any(port.kind is PortKind.SERIAL for port in real))

    def _on_clicked(self, number: int) -> None:
        self._connect_to(self._shown[number])

    def _show_port(self, button: QPushButton, port: Port) -> None:
        metrics = self.fontMetrics()
        room = metrics.averageCharWidth() * _WIDEST_PORT
        name = metrics.elidedText(port.label, Qt.TextElideMode.ElideRight, room)
        button.setText(self.tr("Connect to {0}").format(name.replace("&", "&&")))
        button.setToolTip(port.label)


class WiringSketch(QWidget):
    """The three wires between an adapter and the board."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("wiringSketch")
        self.setAccessibleName(
            self.tr("Wiring: TX of the adapter to SI, RX to SO, GND to GND of the board")
        )
        self.setFixedSize(self.sizeHint())
        theme().changed.connect(self.update)

    def sizeHint(self) -> QSize:
        line = self.fontMetrics().height()
        return QSize(self.fontMetrics().averageCharWidth() * 34, line * 9)

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        line = self.fontMetrics().height()
        box = QRectF(0.5, 1.5 * line, self.width() * 0.32, 6 * line)
        board = box.translated(self.width() - box.width() - 1, 0)
        text = theme().color("window_text")
        painter.setPen(QPen(text, 1))
        for place, title in ((box, self.tr("Adapter")), (board, self.tr("TReX"))):
            painter.drawRoundedRect(place, 6, 6)
            above = QRectF(place.left(), 0, place.width(), 1.4 * line)
            painter.drawText(above, Qt.AlignmentFlag.AlignCenter, title)
        wires = (("TX", "SI", "motor1"), ("RX", "SO", "motor2"), ("GND", "GND", "muted"))
        for number, (left, right, color) in enumerate(wires):
            y = box.top() + (2 * number + 1) * line
            begin, end = QPointF(box.right(), y), QPointF(board.left(), y)
            painter.setPen(QPen(theme().color(color), 2))
            painter.drawLine(QLineF(begin, end))
            painter.setBrush(theme().color(color))
            for pin in (begin, end):
                painter.drawEllipse(pin, 3, 3)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(text)
            room = QRectF(0, y - line / 2, box.width() - 8, line)
            middle = Qt.AlignmentFlag.AlignVCenter
            painter.drawText(room, middle | Qt.AlignmentFlag.AlignRight, left)
            room.moveLeft(board.left() + 8)
            painter.drawText(room, middle | Qt.AlignmentFlag.AlignLeft, right)
