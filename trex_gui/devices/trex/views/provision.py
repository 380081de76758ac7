"""Dialog that sets up boards one after another on one cable."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import Slot
from PySide6.QtWidgets import (
    QFileDialog,
    QGridLayout,
    QHeaderView,
    QLineEdit,
    QTableWidget,
    QTableWidgetItem,
)

from trex_gui.core.errors import StudioError
from trex_gui.core.files import load
from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.discovery import NUMBERS
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.provision import Provision, ProvisionStep
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.provision_record import KNOWN, NEW, NUMBER_ONLY, ProvisionRecord
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.views.comparison_view import ComparisonView
from trex_gui.devices.trex.views.pulse_controls import PulseControls
from trex_gui.devices.trex.views.start_texts import ttl_wiring
from trex_gui.devices.trex.views.steps import Flow, FlowState, Page
from trex_gui.ui.files import in_background
from trex_gui.ui.frame.wiring_sketch import WiringSketch
from trex_gui.ui.translations import error_sentence
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.labels import Muted, Note

_MAX_WIDTH = 480  # maximum width of the motor buttons, in pixels

_CERTAINTY_TEXTS = {
    NEW: tr_noop("A new board: its device number is not in the record."),
    KNOWN: tr_noop("Known: its device number and its calibrations are in the record."),
    NUMBER_ONLY: tr_noop(
        "Probably known: its device number is in the record, but with other calibrations."
    ),
}
_RESULTS = {"ok": tr_noop("written and verified"), "skipped": tr_noop("skipped")}


class ProfilePage(Page):
    def __init__(self, start: Callable[[], object]) -> None:
        super().__init__("provisionProfilePage", tr("What every board gets"))
        grid = ui.grid(self, margins=0, spacing=(8, 12), stretch=[(1, 1)])
        add = partial(self._add_path, grid)
        self.profile = add("provisionProfile", tr("&Profile:"), self._select_profile)
        self.record = add("provisionRecord", tr("&Record:"), self._select_record)
        self.names = ui.named(QLineEdit("robot {number}", self), "provisionNames")
        title = tr("First device number")
        self.first = ui.spin_box(self, "provisionFirst", title, 0, NUMBERS - 1, value=1)
        for text, field in ((tr("&Names:"), self.names), (tr("&First number:"), self.first)):
            row = grid.rowCount()
            grid.addWidget(ui.label(self, text=text, buddy=field), row, 0)
            grid.addWidget(field, row, 1)
        self.motors = ui.check_box(
            self, "provisionMotors", tr("Then turn each &motor while a button is held")
        )
        grid.addWidget(self.motors, grid.rowCount(), 1)
        grid.setRowStretch(grid.rowCount(), 1)
        self.setFocusProxy(self.profile)
        self.problem = ui.named(Note(0, self.side), "provisionTrouble")
        for path in (self.profile, self.record):
            path.returnPressed.connect(start)
            path.textChanged.connect(lambda: self.problem.show_note(""))
        about = tr(
            "The profile is a settings file. Each board gets the settings of the profile, a "
            "device number that no other board has, and a line in the record. The record is "
            "a CSV file. An existing file is extended."
        )
        serial = tr(
            "Boards have no serial number. A board whose device number is in the record "
            "keeps this number."
        )
        texts = Muted(about, self.side), Muted(serial, self.side)
        ui.column(*texts, self.problem, 1, into=self.side, margins=0)

    def _add_path(
        self, grid: QGridLayout, name: str, title: str, on_click: Callable[[], object]
    ) -> QLineEdit:
        field, row = ui.named(QLineEdit(self), name), grid.rowCount()
        text = tr("Select…")
        button = ui.button(
            self,
            f"{name}Select",
            text,
            icon="folder",
            accessible=f"{text} {title.replace('&', '')}",
            default=False,
            on_click=on_click,
        )
        for column, widget in enumerate((ui.label(self, text=title, buddy=field), field, button)):
            grid.addWidget(widget, row, column)
        return field

    @Slot()
    def _select_profile(self) -> None:
        if path := file_questions.prompt_to_open(self.window(), tr("Profile for every board")):
            self.profile.setText(str(path))
            if not self.record.text():
                self.record.setText(str(path.with_name("provisioned.csv")))

    @Slot()
    def _select_record(self) -> None:
        proposal = Path(self.record.text() or file_questions.last_folder() / "provisioned.csv")
        kinds = tr("CSV files (*.csv);;All files (*)")
        option = QFileDialog.Option.DontConfirmOverwrite
        title = tr("Record of the boards")
        path, _ = QFileDialog.getSaveFileName(self, title, str(proposal), kinds, options=option)
        if path:
            self.record.setText(path)


class ProvisionBoardPage(Page):
    def __init__(self, work: Provision, device: Device) -> None:
        super().__init__("provisionBoardPage")
        self._work, self._device = work, device
        self._title = ui.label(self, "provisionBoard", bold=True, size="heading", wrap=True)
        self._about = ui.named(Note(1, self), "provisionAbout")
        self._changes = ComparisonView(self)
        self._wiring = WiringSketch(ttl_wiring(), "provisionWiring", self)
        items = self._title, self._about, (self._changes, 1), (self._wiring, 1)
        ui.column(*items, into=self, margins=0)
        title = tr("Finished boards")
        self._done = ui.flat_table(QTableWidget(0, 2, self.side), "provisionDone", title)
        self._done.setHorizontalHeaderLabels([tr("Board"), tr("Result")])
        self._done.setWordWrap(True)
        header = self._done.horizontalHeader()
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        header.setStretchLastSection(True)
        ui.column((self._done, 1), into=self.side, margins=0)

    def refresh(self) -> None:
        work, board = self._work, self._work.board
        self._title.setText(self._title_text())
        about = "" if board is None else tr(_CERTAINTY_TEXTS[board.certainty])
        self._about.show_note("" if work.step is ProvisionStep.UNPLUG else about)
        has_changes = work.step in {ProvisionStep.REVIEW, ProvisionStep.WRITE}
        if has_changes:
            sides = tr("Board"), tr("Profile")
            self._changes.show_comparison(work.comparison, *sides, with_ticks=False)
        self._changes.setVisible(has_changes)
        self._wiring.setVisible(not has_changes)
        self._done.setRowCount(len(work.done))
        for row, entry in enumerate(reversed(work.done)):
            result = tr(_RESULTS.get(entry.result, "")) or entry.result
            for column, text in enumerate((entry.name, result)):
                self._done.setItem(row, column, QTableWidgetItem(text))
        self._done.resizeRowsToContents()

    def _title_text(self) -> str:
        work, board = self._work, self._work.board
        if work.step is ProvisionStep.WAIT or board is None:
            if work.step is ProvisionStep.UNPLUG:
                return tr("This board cannot be set up. Unplug it.")
            if self._device.settings is None:
                return tr("Connect to a board: use Connect or Find in the main window.")
            return tr("Plug in a board, and switch it on.")
        if work.step is ProvisionStep.UNPLUG:
            result = tr(_RESULTS.get(board.result, "")) or board.result
            text = tr("{0}: {1}. Unplug this board, and plug in the next board.")
            return text.format(board.name, result.rstrip("."))
        text = tr("{0}, device number {1}: {2}")
        return text.format(board.name, board.number, board.board)


class ProvisionMotorsPage(Page):
    def __init__(self, work: Provision, device: Device) -> None:
        super().__init__("provisionMotorsPage", tr("Hold each button: does its motor turn?"))
        self._controls = PulseControls("provision", device, work.pulses, self)
        self._controls.hold_started.connect(work.pulses.start)
        self._controls.setMaximumWidth(_MAX_WIDTH)
        ui.column(self._controls, 1, into=self, margins=0)

    def refresh(self) -> None:
        self._controls.refresh()


class ProvisionFlow(Flow):
    name = "provision"
    size = 1040, 600

    def __init__(self, device: Device) -> None:
        super().__init__()
        self._device = device
        self.work = work = Provision(device, self)
        self._profile_page = ProfilePage(self._start)
        self._board: ProvisionBoardPage | None = None
        self._motors: ProvisionMotorsPage | None = None
        self._is_loading = False
        for changed in (work.changed, device.writer.changed):
            changed.connect(self.changed)
        for field in (self._profile_page.profile, self._profile_page.record):
            field.textChanged.connect(self.changed)

    def on_hidden(self, *, closed: bool) -> None:
        if closed:
            self.work.stop()
        elif self.work.step is ProvisionStep.MOTORS:
            self.work.pulses.stop(tr("The assistant was closed."))

    def skip(self) -> None:
        if self.work.step is ProvisionStep.MOTORS:
            self.work.finish_motors(turned=False)
        else:
            self.work.skip()

    def next(self) -> None:
        work = self.work
        if work.step is ProvisionStep.PROFILE:
            self._start()
        elif work.problem:
            work.retry()
        elif work.step is ProvisionStep.MOTORS:
            work.finish_motors(turned=True)
        else:
            work.write()

    @Slot()
    def _start(self) -> None:
        page = self._profile_page
        profile, record = Path(page.profile.text()), Path(page.record.text())
        names, first = page.names.text(), page.first.value()
        if self._is_loading or not page.profile.text() or not page.record.text():
            return
        self._is_loading = True

        def read() -> tuple[Settings, ProvisionRecord]:
            settings, _ = read_settings(load(profile), profile.name)
            return settings, ProvisionRecord(record, name=names, first=first)

        in_background(self, read, self._on_read, self._on_read_failed)

    def _on_read(self, profile_and_record: tuple[Settings, ProvisionRecord]) -> None:
        self._is_loading = False
        self.work.start(*profile_and_record, turns_motors=self._profile_page.motors.isChecked())

    def _on_read_failed(self, error: StudioError) -> None:
        self._is_loading = False
        self._profile_page.problem.show_note(error_sentence(error), alarming=True)
        self.changed.emit()

    def state(self) -> FlowState:
        work, step = self.work, self.work.step
        titles = {
            ProvisionStep.PROFILE: tr("Profile"),
            ProvisionStep.WAIT: tr("Plug in"),
            ProvisionStep.REVIEW: tr("Review"),
            ProvisionStep.WRITE: tr("Write"),
            ProvisionStep.MOTORS: tr("M&otors").replace("&", ""),
            ProvisionStep.UNPLUG: tr("Unplug"),
        }
        if not (work.turns_motors or self._profile_page.motors.isChecked()):
            del titles[ProvisionStep.MOTORS]
        names, index = list(titles.values()), list(titles).index(step)
        show = partial(FlowState, tr("Set up boards in turn"), names, index, self._page())
        if step is ProvisionStep.PROFILE:
            is_complete = bool(
                self._profile_page.profile.text() and self._profile_page.record.text()
            )
            return show(next=tr("&Start"), may_go_on=is_complete)
        if work.problem:
            is_unsaved = work.board is not None
            return show(
                note=work.problem, is_alarming=True, next=tr("&Try again") if is_unsaved else ""
            )
        if step is ProvisionStep.MOTORS:
            return show(next=tr("Both &turned"), may_skip=True)
        writer = self._device.writer
        if step is ProvisionStep.REVIEW:
            return show(
                note=writer.blocker,
                is_alarming=bool(writer.blocker),
                next=tr("&Write and check"),
                may_go_on=writer.can_apply,
                may_skip=True,
            )
        return show(next=tr("&Write and check"), may_go_on=False)

    def _page(self) -> Page:
        if self.work.step is ProvisionStep.PROFILE:
            return self._profile_page
        if self.work.step is ProvisionStep.MOTORS:
            self._motors = self._motors or ProvisionMotorsPage(self.work, self._device)
            return self._motors
        self._board = self._board or ProvisionBoardPage(self.work, self._device)
        return self._board
