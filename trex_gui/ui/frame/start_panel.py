"""What a page shows while nothing is connected: how to begin."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import zip_longest

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QHideEvent
from PySide6.QtWidgets import QAbstractButton, QPushButton, QStackedWidget, QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.devices.ports import Port, PortKind
from trex_gui.ui.frame.main_window import MainWindow
from trex_gui.ui.frame.welcome import Welcome, is_first_start
from trex_gui.ui.frame.wiring_sketch import Wires, WiringSketch
from trex_gui.ui.frame.workspace import Workspace
from trex_gui.ui.theme.theme import follow_theme
from trex_gui.ui.widgets import builders as ui

_WIDEST_LINES = 100  # characters: longer lines are hard to read
_WIDEST_BUTTON = 38
_MOST_PORTS = 4
_MOST_FILES = 3


@dataclass(frozen=True, slots=True)
class StartWay:
    steps: str  # rich text
    wiring: Wires
    name: str = ""  # to choose it by, with a free letter, if there are several
    jumpers: QWidget | None = None  # a picture, for below that of the wires


@dataclass(frozen=True, slots=True)
class StartTexts:
    title: str
    ways: Sequence[StartWay]
    none: str  # heading of what needs no hardware
    demo: str  # on the button, as the texts of files with a free letter
    files: Sequence[tuple[str, str, str]]  # action that opens a file, text, icon
    prefix: str = ""  # starts object names
    welcome: str = ""  # what the very first start says of the program; empty: nothing


class StartPanel(QWidget):
    """Leads to a first connection with the kind of device that a workspace is for."""

    def __init__(self, texts: StartTexts, frame: MainWindow, workspace: Workspace) -> None:
        super().__init__(workspace)
        self.setObjectName(f"{texts.prefix}startPanel")
        self._device = workspace.key
        self._prefix = texts.prefix
        self._frame = frame

        hardware = ui.Card(texts.title, self)
        pictures, steps = QStackedWidget(hardware), QStackedWidget(hardware)
        choices: list[QAbstractButton] = []
        for number, way in enumerate(texts.ways, start=1):
            pictures.addWidget(self._picture(way, number, hardware))
            name = f"{texts.prefix}startSteps{number}"
            text = ui.label(steps, name, way.steps, wrap=True, rich=True)
            text.setAlignment(Qt.AlignmentFlag.AlignTop)
            steps.addWidget(text)
            if way.name:
                choice = ui.radio_button(hardware, f"{texts.prefix}startWay{number}", way.name)
                choice.setChecked(number == 1)
                choice.clicked.connect(partial(pictures.setCurrentIndex, number - 1))
                choice.clicked.connect(partial(steps.setCurrentIndex, number - 1))
                choices.append(choice)
        self._ports = [
            self._button(hardware, "startPort", "", "connect", partial(self._on_port_clicked, at))
            for at in range(_MOST_PORTS)
        ]
        self._none = ui.label(
            hardware,
            f"{texts.prefix}startNoPort",
            tr("No serial port was found. Plug the adapter in: it is listed here at once."),
            wrap=True,
        )
        find = self._button(
            hardware,
            "startFind",
            tr("Find &my board…"),
            "find",
            partial(workspace.trigger, "find"),
        )
        find.setToolTip(tr("Search every port and baud rate; no motor moves"))
        begin = ui.column(steps, self._none, *_left(*self._ports, find), 1)
        top = (pictures, 0, Qt.AlignmentFlag.AlignTop)
        both = ui.row(top, (begin, 1), margins=0)
        ui.column(*([ui.row(*choices, 1, margins=0)] if choices else []), both, into=hardware)

        other = ui.Card(texts.none, self)
        demo = self._button(other, "startDemo", texts.demo, "run", self._connect_to_demo)
        demo.setToolTip(tr("A simulated board: nothing can be damaged"))
        opening = [
            self._button(other, f"start_{key}", text, icon, partial(workspace.trigger, key))
            for key, text, icon in texts.files
        ]
        ui.row(demo, *opening, 1, into=other)

        self._recent = ui.named(ui.Card(tr("Recent files"), self), f"{texts.prefix}startFiles")
        self._files = [
            self._button(
                self._recent, "startRecent", "", "open", partial(self._on_file_clicked, at)
            )
            for at in range(_MOST_FILES)
        ]
        ui.column(*_left(*self._files), into=self._recent)
        content = QWidget(self)
        ui.column(hardware, other, self._recent, into=content, margins=0)
        shown = [content]
        self._content, self._first = content, choices[0] if choices else find
        self._welcome: Welcome | None = None
        if texts.welcome and is_first_start():
            find_board = partial(workspace.trigger, "find")
            self._welcome = Welcome(texts.welcome, find_board, self._connect_to_demo, self)
            self._welcome.connect_chosen.connect(self._end_welcome)
            content.hide()
            shown.append(self._welcome)
        for each in shown:
            follow_theme(each, "widest", partial(self._limit_width, each))
        ui.column(*(ui.row((each, 1)) for each in shown), 1, into=self, margins=0)
        frame.ports.changed.connect(self._on_ports_changed)
        frame.files.recent.changed.connect(self._on_recent_changed)
        self._on_ports_changed()
        self._on_recent_changed()

    def _picture(self, way: StartWay, number: int, parent: QWidget) -> QWidget:
        picture = QWidget(parent)
        sketch = WiringSketch(way.wiring, f"{self._prefix}wiringSketch{number}", picture)
        ui.column(sketch, *([way.jumpers] if way.jumpers else []), 1, into=picture, margins=0)
        return picture

    def _limit_width(self, part: QWidget) -> None:
        widest = self.fontMetrics().averageCharWidth() * _WIDEST_LINES
        part.setMaximumWidth(max(widest, part.minimumSizeHint().width()))

    @Slot()
    def _end_welcome(self) -> None:
        if self._welcome is not None:
            self._welcome.hide()
            self._content.show()
            self._first.setFocus()
            self._welcome.deleteLater()
            self._welcome = None

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        if self.isHidden():  # a device is being connected, rather than another page shown
            self._end_welcome()

    def _button(
        self, parent: QWidget, name: str, text: str, icon: str, act: Callable[[], object]
    ) -> QPushButton:
        return ui.button(parent, f"{self._prefix}{name}", text, icon=icon, on_click=act)

    @property
    def _real_ports(self) -> list[Port]:
        return [port for port in self._frame.ports.entries if port.kind is not PortKind.DEMO]

    @Slot()
    def _on_ports_changed(self) -> None:
        self._none.setVisible(not any(port.kind is PortKind.SERIAL for port in self._real_ports))
        for button, port in zip_longest(self._ports, self._real_ports[:_MOST_PORTS]):
            button.setVisible(port is not None)
            if port is not None:
                button.setText(tr("Connect to {0}").format(self._elided(port.label)))
                button.setToolTip(ui.plain(port.label))

    @Slot()
    def _on_recent_changed(self) -> None:
        files = self._frame.files.recent.entries[:_MOST_FILES]
        self._recent.setVisible(bool(files))
        for button, file in zip_longest(self._files, files):
            button.setVisible(file is not None)
            if file is not None:
                button.setText(self._elided(file.title))
                button.setToolTip(ui.plain(str(file.path)))

    def _elided(self, text: str) -> str:
        """Return a text for a button, with an end that it has room for."""
        metrics = self.fontMetrics()
        room = metrics.averageCharWidth() * _WIDEST_BUTTON
        return ui.no_mnemonic(metrics.elidedText(text, Qt.TextElideMode.ElideRight, room))

    def _on_port_clicked(self, at: int) -> None:
        """Connect to this kind of device, unless another one was found on the port."""
        port, ports = self._real_ports[at], self._frame.ports
        is_known = port.device != ports.plugins[0].key
        self._frame.connect_to(port if is_known else ports.lead_to(port, self._device))

    def _connect_to_demo(self) -> None:
        self._frame.connect_to(self._frame.ports.demo_of(self._device))

    def _on_file_clicked(self, at: int) -> None:
        self._frame.files.open_recent(self._frame.files.recent.entries[at])


def _left(*buttons: QPushButton) -> list[ui.Item]:
    return [(button, 0, Qt.AlignmentFlag.AlignLeft) for button in buttons]
