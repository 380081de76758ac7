"""Board page: state of the motors, drawing, open set-up steps and problems."""

from collections.abc import Callable

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.board.drive_status import DriveInputs, DriveStatus, drive_statuses
from trex_gui.devices.trex.board.mirror import SetUp
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.driving.blockers import DriveBlocker, Effect
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import drive_inputs
from trex_gui.devices.trex.model.group import BoardGroup
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.views.board.view import BoardView
from trex_gui.devices.trex.views.group import SideBySide
from trex_gui.devices.trex.views.motor_controls import LostPanel, TimeoutNotice
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.labels import PAGE_MARGINS, Muted, Note, PageHead

_SIGNS = {
    Effect.STOPS: ("warning", "warning"),
    Effect.BLOCKS: ("info", "info"),
    Effect.LIMITS: ("warning", "warning"),
    Effect.NOTE: ("ok", "good"),
}


class BoardPage(QWidget):
    setup_requested = Signal()
    page_requested = Signal(str)  # page key

    def __init__(
        self,
        device: Device,
        group: BoardGroup,
        create_start_panel: Callable[[QWidget], QWidget],
        parent: QWidget,
    ) -> None:
        """Create the page. `create_start_panel` creates the panel for the disconnected state."""
        super().__init__(parent)
        self.setObjectName("boardPage")
        self._device = device
        self._report = QWidget(self)
        self._lost = LostPanel(device, "boardLost", self)
        self._head = PageHead("", self._report)  # reasons for the state of the motors
        ui.named(self._head.title, "motorsReason1")
        ui.named(self._head.sign, "motorsSign")
        self._statuses: tuple[DriveStatus, ...] = ()
        self._facts = ui.named(Muted("", self._report), "boardFacts")
        drawing = ui.named(ui.Card("", self._report), "boardDrawing", accessible=tr("The board"))
        self._views = SideBySide(drawing)
        self._view = BoardView(device, self._views)
        self._view.page_requested.connect(self.page_requested)
        self._views.add(self._view)
        self._group, self._others = group, dict[BoardView, Device]()
        ui.column((self._views, 1), self._facts, into=drawing)
        group.changed.connect(self._on_group_changed)
        self._on_group_changed()

        set_up = ui.Card(tr("Set up my robot"), self._report)
        self._open_steps = ui.named(Note(1, set_up), "setUpOpen")
        self._set_up = ui.button(
            set_up, "setUpButton", tr("Set &up my robot…"), on_click=self.setup_requested
        )
        ui.column((self._open_steps, 1), (self._set_up, 0, Qt.AlignmentFlag.AlignLeft), into=set_up)
        cable = ui.Card(tr("If the cable fails"), self._report)
        ui.column(TimeoutNotice(device, cable), into=cable)
        problems = ui.Card(title_of(tr("Prob&lems")), self._report)
        self._problems = ui.named(Note(1, problems), "boardProblems")
        show = ui.button(problems, "showProblems", tr("Sh&ow them"))
        show.clicked.connect(lambda: self.page_requested.emit("errors"))
        ui.column((self._problems, 1), (show, 0, Qt.AlignmentFlag.AlignLeft), into=problems)
        cards = ui.row((set_up, 1), (cable, 1), (problems, 1), spacing=16)
        ui.column(self._head, (drawing, 1), cards, into=self._report, margins=0, spacing=8)
        self._start = create_start_panel(self)
        parts = self._lost, self._start, (self._report, 1)
        ui.column(*parts, into=self, margins=PAGE_MARGINS, spacing=12)

        for changed in (device.link_changed, device.state_changed):
            changed.connect(self._on_device_changed)
        device.telemetry.text_due.connect(self._on_text_due)
        device.motors.arming_changed.connect(self._show_motors)
        device.errors_changed.connect(self._show_problems)
        self._on_device_changed()

    @Slot()
    def _on_group_changed(self) -> None:
        for view in self._others:
            self._views.remove(view)
        others = [device for device in self._group.devices.values() if device is not self._device]
        self._others = {BoardView(device, self._views): device for device in others}
        for view, device in self._others.items():
            view.page_requested.connect(self.page_requested)
            self._views.add(view)
            for due in (device.telemetry.text_due, device.link_changed):
                due.connect(self._on_text_due, Qt.ConnectionType.UniqueConnection)

    @Slot()
    def _on_device_changed(self) -> None:
        state, settings = self._device.state, self._device.settings
        is_idle = self._device.link is ConnectionState.DISCONNECTED
        _, status = self._show_motors()
        is_lost = self._lost.show_loss(f"{status.text} {status.remedy}".strip())
        self._start.setVisible(is_idle and not is_lost)
        self._report.setVisible(not is_idle or is_lost)
        self._head.setVisible(not is_lost)
        self._set_up.setEnabled(self._device.is_connected)
        facts, set_up = "", self._device.board.set_up if self._device.is_connected else None
        if state is not None and settings is not None and self._device.is_connected:
            facts = " · ".join(self._facts_of(state, settings))
        self._facts.setText(facts)
        self._open_steps.setText("" if set_up is None else _open_steps_text(set_up))
        self._show_problems()
        self._on_text_due()

    def _facts_of(self, state: DeviceState, settings: ConnectionSettings) -> list[str]:
        model, number = state.signature.model, settings.device_number
        facts = [
            f"{model.name} ({model.part})",
            tr("firmware {0}").format(state.signature.firmware),
            settings.label,
            settings.line.text(),
        ]
        if number is not None:
            facts.append(tr("device number {0}").format(number))
        if (delay := self._device.board.network_delay) is not None:
            facts.append(tr("network {0:.0f} ms").format(Number(1000 * delay)))
        if self._device.board.is_joint:
            facts.append(tr("joint: one motor"))
        if self._device.board.echo:
            facts.append(tr("RS-232 (everything sent comes back)"))
        wire = state.parameters.get(ParameterKey.UART_SETTINGS)
        is_valid = wire is not None and wire in state.specs[ParameterKey.UART_SETTINGS].valid
        real = settings.line.real_baud(state.signature.firmware)
        if is_valid and real != settings.line.baud:
            facts.insert(4, tr("this firmware runs at half this baud rate"))  # after the baud rate
        return facts

    @Slot()
    def _show_motors(self) -> tuple[DriveInputs, DriveStatus]:
        """Show the state of the motors. Return the inputs and the first status."""
        inputs = drive_inputs(self._device)
        statuses = drive_statuses(inputs)
        if statuses != self._statuses:
            self._statuses = statuses
            self._show_statuses(statuses)
        return inputs, statuses[0]

    def _show_statuses(self, statuses: tuple[DriveStatus, ...]) -> None:
        """Show the most important status as the title and the others below."""
        head, (first, *others) = self._head, statuses
        is_armed = first.blocker is DriveBlocker.RUNNING
        sign = ("run", "warning") if is_armed else _SIGNS[first.blocker.effect]
        head.sign.show_sign(*sign)
        head.show_title(first.text)
        more = (first.remedy, *(f"{status.text} {status.remedy}" for status in others))
        state = " ".join(filter(None, map(str.strip, more)))
        head.show_state(state)
        head.title.setAccessibleName(f"{first.text} {state}".rstrip())

    @Slot()
    def _show_problems(self) -> None:
        board = self._device.board
        names = [tr(entry.name) for entry in board.errors.entries if entry.is_uncleared]
        text = ", ".join(names)
        if not names and board.connected_utc is not None:
            text = tr("None since {0}.").format(f"{board.connected_utc.astimezone():%H:%M}")
        self._problems.setText(text if self._device.is_connected else "")

    @Slot()
    @only_when_visible
    def _on_text_due(self) -> None:
        inputs, _ = self._show_motors()
        if self._report.isVisible():
            self._view.show_board(inputs)
            for view, device in self._others.items():
                view.show_board(drive_inputs(device))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._on_text_due()


def _open_steps_text(set_up: SetUp) -> str:
    steps = {
        tr("sticks learned"): set_up.sticks,
        tr("current limits"): set_up.limits,
        tr("serial timeout"): set_up.timeout,
    }
    words = (f"{'✓' if is_done else '○'} {text}" for text, is_done in steps.items())
    return "   ".join(word.replace(" ", "\N{NO-BREAK SPACE}") for word in words)
