"""Page shown while nothing is connected, with wiring, ports, search, demo and files."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from itertools import zip_longest

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QLabel, QPushButton, QStackedWidget, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.ui.devices.ports import Port, PortKind
from trex_gui.ui.frame.main_window import MainWindow
from trex_gui.ui.frame.wiring_sketch import Wires, WiringSketch
from trex_gui.ui.frame.workspace import Workspace
from trex_gui.ui.theme.theme import set_look, set_text_color
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import ElidedLabel, Muted, PageHead

_MAX_PORTS = 4


@dataclass(frozen=True, slots=True)
class StartWay:
    """One way to connect a board."""

    wiring: Wires
    note: str
    name: str = ""  # button text with a free mnemonic; required with more than one way
    danger: str = ""


@dataclass(frozen=True, slots=True)
class StartTexts:
    title: str
    hint: str  # first step for the user, in one line
    ways: Sequence[StartWay]
    demo_heading: str  # heading of the card about the demo
    demo: str  # button text with a free mnemonic
    files: Sequence[tuple[str, str]]  # key of an action that opens a file, text of the button
    prefix: str = ""  # prefix of object names


class PortRow(QWidget):
    def __init__(self, name: str, parent: QWidget) -> None:
        super().__init__(parent)
        self._name, self._about = ElidedLabel("", self), ElidedLabel("", self)
        ui.set_bold(self._name)
        set_text_color(self._about, "muted")
        self.button = ui.button(self, name, title_of(tr("&Connect")))
        texts = ui.column(self._name, self._about, margins=0, spacing=0)
        ui.row((texts, 1), self.button, into=self, margins=0)

    def show_port(self, port: Port, *, is_preferred: bool) -> None:
        name, _, about = port.label.partition("  (")
        self._name.show_text(name)
        self._about.show_text(about.removesuffix(")"))
        self._about.setVisible(bool(about))
        set_look(self.button, "primary" if is_preferred else "")
        self.button.setAccessibleName(tr("Connect to {0}").format(port.label))
        self.button.setToolTip(ui.plain(port.label))


class StartPanel(QWidget):
    def __init__(
        self, texts: StartTexts, frame: MainWindow, workspace: Workspace, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self._prefix = prefix = texts.prefix
        self.setObjectName(f"{prefix}startPanel")
        self._device = workspace.key
        self._frame = frame
        head = PageHead(texts.title, self)
        head.show_state(texts.hint)
        wirings = self._wirings(texts.ways)

        plugged = ui.Card(tr("What is plugged in"), self)
        self._rows = [PortRow(f"{prefix}startPort", plugged) for _ in range(_MAX_PORTS)]
        for index, row in enumerate(self._rows):
            row.button.clicked.connect(partial(self._on_port_clicked, index))
        self._none = ui.label(
            plugged,
            f"{prefix}startNoPort",
            tr(
                "No serial port was found. Plug in the adapter, and it will be listed here at once."
            ),
            wrap=True,
        )
        ui.column(*self._rows, self._none, 1, into=plugged, spacing=12)
        silent = ui.Card(tr("No response?"), self)
        tip = tr("Search every port and baud rate; no motor moves")
        find = ui.button(silent, f"{prefix}startFind", tr("Find &my board…"))
        find.clicked.connect(partial(workspace.trigger, "find"))
        other = ui.Card(texts.demo_heading, self)
        demo = ui.button(other, f"{prefix}startDemo", texts.demo)
        demo.clicked.connect(lambda: frame.connection.connect_to(frame.ports.demo_of(self._device)))
        about = tr("A simulated board: nothing can be damaged")
        for card, text, button in ((silent, tip, find), (other, about, demo)):
            button.setToolTip(ui.plain(text))
            ui.column(Muted(text, card), (button, 0, Qt.AlignmentFlag.AlignLeft), into=card)

        files = ui.named(ui.Card(title_of(tr("&Files:")), self), f"{prefix}startFiles")
        file_buttons = [
            ui.button(files, f"{prefix}start_{key}", text, on_click=partial(workspace.trigger, key))
            for key, text in texts.files
        ]
        for button in file_buttons:
            set_look(button, "link")
        ui.row(*file_buttons, 1, into=files)
        right = ui.column((plugged, 1), silent, other, margins=0, spacing=12)
        top = ui.row((wirings, 2), (right, 1), margins=0, spacing=16)
        ui.column(head, (top, 1), files, into=self, margins=0, spacing=12)
        frame.connection.connecting.connect(self._on_connecting)
        frame.ports.changed.connect(self._on_ports_changed)
        self._on_ports_changed()

    def _wirings(self, ways: Sequence[StartWay]) -> QWidget:
        card = ui.Card("", self)
        pages, choices = QStackedWidget(card), list[QPushButton]()
        for number, way in enumerate(ways, start=1):
            page = QWidget(pages)
            sketch = WiringSketch(way.wiring, f"{self._prefix}wiringSketch{number}", page)
            danger = ui.label(page, "", way.danger, wrap=True, bold=True)
            set_text_color(danger, "danger")
            note = ui.named(Muted(way.note, page), f"{self._prefix}startNote{number}")
            parts: list[QLabel] = [danger, note] if way.danger else [note]
            ui.column((sketch, 1), *parts, into=page, margins=0)
            pages.addWidget(page)
            if way.name:
                name = f"{self._prefix}startWay{number}"
                choice = ui.button(card, name, way.name, checkable=True)
                choice.setAutoExclusive(True)
                choice.setChecked(number == 1)
                choice.clicked.connect(partial(pages.setCurrentWidget, page))
                choices.append(choice)
        chosen = [ui.row(*choices, 1, margins=0)] if choices else []
        ui.column(*chosen, (pages, 1), into=card)
        return card

    @property
    def _real_ports(self) -> list[Port]:
        """Serial ports, and typed addresses at which a device was found."""
        return [
            port
            for port in self._frame.ports.entries
            if port.kind is PortKind.SERIAL or (port.kind is PortKind.TYPED and port.settings)
        ]

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._on_ports_changed()  # a device may have been found at a typed address

    @Slot()
    def _on_ports_changed(self) -> None:
        preferred, self._ports = self._frame.ports.preferred, self._real_ports[:_MAX_PORTS]
        self._none.setVisible(not any(port.kind is PortKind.SERIAL for port in self._ports))
        for row, port in zip_longest(self._rows, self._ports):
            row.setVisible(port is not None)
            if port is not None:
                row.show_port(port, is_preferred=port == preferred)

    @Slot()
    def _on_connecting(self) -> None:
        """Focus the bar of places. Otherwise Qt would move the focus to an arbitrary widget."""
        focused = self._frame.focusWidget()
        if focused is not None and self.isAncestorOf(focused):
            self._frame.pages.tabBar().setFocus()

    def _on_port_clicked(self, index: int) -> None:
        """Connect to a port as this device, unless the port is assigned to a non-default kind."""
        port, ports = self._ports[index], self._frame.ports
        is_assigned = port.device != ports.plugins[0].key
        self._frame.connection.connect_to(port if is_assigned else ports.assign(port, self._device))
