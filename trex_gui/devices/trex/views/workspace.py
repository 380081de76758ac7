"""The workspace of a TReX: pages, dialogs and menus."""

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cached_property, partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, QUrl, Signal, Slot
from PySide6.QtGui import QAction, QDesktopServices, QKeySequence
from PySide6.QtWidgets import QWidget
from shiboken6 import Shiboken

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.boards import BoardList
from trex_gui.devices.trex.model.controller import TrexController
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.model.linter import BoardLinter
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.board_records import utc_now
from trex_gui.devices.trex.settings.comparison import ComparisonRow
from trex_gui.devices.trex.views.action_bar import ActionBar
from trex_gui.devices.trex.views.arm_dialog import arm
from trex_gui.devices.trex.views.boards import BoardPanel
from trex_gui.devices.trex.views.close_prompt import ClosePrompt
from trex_gui.devices.trex.views.demo_panel import DemoPanel
from trex_gui.devices.trex.views.help import GUIDE, TOPICS, message_help
from trex_gui.devices.trex.views.learning.dialog import LearnDialog
from trex_gui.devices.trex.views.line_settings_dialog import LineSettingsDialog
from trex_gui.devices.trex.views.pages.channels import ChannelsPage
from trex_gui.devices.trex.views.pages.currents import CurrentsPage
from trex_gui.devices.trex.views.pages.status import StatusPage
from trex_gui.devices.trex.views.recordings import Recordings
from trex_gui.devices.trex.views.review.defaults_dialog import DefaultsDialog
from trex_gui.devices.trex.views.review.power_cycle import PowerCycleDialog
from trex_gui.devices.trex.views.review.review_dialog import ReviewDialog
from trex_gui.devices.trex.views.settings_files import SettingsFiles
from trex_gui.devices.trex.views.start_ways import start_ways
from trex_gui.ui.devices.undo import undo_titles
from trex_gui.ui.frame.main_window import MainWindow
from trex_gui.ui.frame.start_panel import StartPanel, StartTexts
from trex_gui.ui.frame.wiring_sketch import Wires
from trex_gui.ui.frame.workspace import (
    SEPARATOR,
    Entry,
    FileKind,
    LineChoice,
    Menu,
    Menus,
    PageInfo,
    Workspace,
)
from trex_gui.ui.log import LogPage
from trex_gui.ui.notifier import Answer, Remedy
from trex_gui.ui.translations import error_sentence, local_time
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import ReusedDialog

if TYPE_CHECKING:
    from trex_gui.devices.trex.views.apply_to_boards_dialog import ApplyToBoardsDialog
    from trex_gui.devices.trex.views.bench.dialog import BenchDialog
    from trex_gui.devices.trex.views.check_board import CheckBoardDialog
    from trex_gui.devices.trex.views.history_dialog import HistoryDialog
    from trex_gui.devices.trex.views.pages.currents_panel import PlotWindow
    from trex_gui.devices.trex.views.setup.dialog import SetupDialog


class TrexWorkspace(Workspace):
    """Everything of the window that is about a TReX; it holds no state of the device."""

    _parameter_shown = Signal(object)  # its key, on the parameters page

    def __init__(self, controller: TrexController, frame: MainWindow) -> None:
        device = controller.device
        super().__init__(controller.plugin.key, device.notifier, frame)
        self._device = device
        self._controller = controller
        self._question = frame.question
        self._frame = frame
        self._linter = BoardLinter(device, self)
        self._wiring = Wires(
            tr("TReX"),
            (("TX", "SI"), ("RX", "SO"), ("GND", "GND")),
            tr("Wiring: TX of the adapter to SI, RX to SO, GND to GND of the board"),
        )
        self._offered_losses: set[ComparisonRow] = set()  # lost settings
        self.help_topics, self.message_help = TOPICS, message_help()
        self.log.follow(device.events)

        self._boards = boards = BoardList(device, self)
        self._panel = panel = BoardPanel(boards, device, self)
        panel.file_requested.connect(self._apply_to_boards)
        tabs = self.pages
        ui.tab_order(panel, tabs.tabBar())
        tabs.setObjectName("tabs")
        tabs.setAccessibleName(tr("Pages"))
        self.add_pages(
            (
                PageInfo("status", tr("S&tatus"), self._make_status_page),
                PageInfo("channels", tr("&Channels"), partial(ChannelsPage, device, self)),
                PageInfo("calibration", tr("Cali&bration"), self._make_calibration_page),
                PageInfo("motors", tr("&Motors"), self._make_motors_page),
                PageInfo("currents", tr("C&urrents"), self._make_currents_page),
                PageInfo("parameters", tr("&Parameters"), self._make_parameters_page),
                PageInfo("errors", tr("&Errors"), self._make_errors_page),
                PageInfo("log", tr("Lo&g"), self._make_log_page),
                PageInfo("transcript", tr("T&raffic"), self._make_traffic_page),
            )
        )

        self.recordings = Recordings(device, frame)
        bar = ActionBar(device, self.recordings.indicator, self)
        beside = ui.row(panel, (tabs, 1), margins=0)
        ui.column((beside, 1), bar, into=self, margins=0)
        self._demo = DemoPanel(controller, frame)
        self.files = files = SettingsFiles(device, frame)
        self.docks = (self._demo,)
        name, suffixes = tr("a settings file of a TReX"), {".txt", ".yaml", ".yml"}
        self.file_kinds = (FileKind(suffixes, name, files.open_file, files.edit_file),)
        self._review = ReviewDialog(device, self._linter, frame)
        self._close_prompt = ClosePrompt(device, files, self._review, frame)
        self._defaults = DefaultsDialog(device, boards, frame)
        self._power = PowerCycleDialog(device, frame)
        learning = Learning(device, self)
        self._learning = learning
        self._learn = LearnDialog(learning, frame)
        self._plot: PlotWindow | None = None
        learning.begun.connect(controller.demo_board.centre_sticks)

        frame.seen_changed.connect(device.set_seen)
        self.files.staged.connect(lambda: self.show_page("parameters"))
        self.recordings.accept_drops(frame, self)
        self.openers = {"settings": files.open_file, "recording": self.recordings.open_file}
        files.used.connect(partial(frame.files.recent.note, self.key, "settings"))
        self.recordings.used.connect(partial(frame.files.recent.note, self.key, "recording"))
        self.recordings.settings_wanted.connect(self.files.open_editor)
        self._defaults.staged.connect(self._review.review_staged)
        for reviewed in (bar.apply_requested, learning.edited):
            reviewed.connect(self._review.review)
        learning.stored.connect(self._review.close_if_verified)  # the test of the sticks follows
        self._defaults.reset_requested.connect(device.writer.reset_to_factory)
        controller.demo_board.rejected.connect(self.notifier.error)
        device.applied.connect(self._on_applied)
        device.applied.connect(self._question.reconsider)
        device.edit_backup.offered.connect(self._on_edits_offered)
        device.kept.changed.connect(self._on_memory_changed)
        for changed in (
            self.recordings.changed,
            controller.changed,
            self._demo.wanted_changed,
            device.motors.arming_changed,
            device.motors.availability_changed,
            device.motors.lockout_changed,
            device.draft.pending_changed,
            boards.changed,
        ):
            changed.connect(self._on_actions_changed)
        device.errors_changed.connect(self._on_errors_changed)
        self._undo_watch = device.draft.undo.indexChanged.connect(self._on_actions_changed)

    # --- Pages --------------------------------------------------------------------------

    def _make_status_page(self) -> QWidget:
        texts = StartTexts(
            title=tr("Connect my TReX"),
            ways=start_ways(self._wiring, self),
            none=tr("No board at hand?"),
            demo=tr("&Try the demo"),
            files=(
                ("open", tr("Open &settings file…"), "open"),
                ("open_recording", tr("&Open recording…"), "plot"),
            ),
            welcome=tr(
                "Set up, calibrate, drive and understand a Pololu TReX or TReX Jr. You need the "
                "board with its supply, and a serial adapter with three wires. No motor moves "
                "before you click Run motor, and Esc stops the motors in every window."
            ),
        )
        start = StartPanel(texts, self._frame, self)
        page = StatusPage(self._device, start, self)
        page.setup_requested.connect(self._set_up)
        return page

    # The first window is shown without these pages, and without what they import.

    def _make_calibration_page(self) -> QWidget:
        from trex_gui.devices.trex.views.pages.calibration.page import (  # noqa: PLC0415
            CalibrationPage,
        )

        page = CalibrationPage(self._device, self._linter, self)
        page.power_cycle_requested.connect(self._power.guide)
        page.learn_requested.connect(self._learn.learn)
        return page

    def _make_motors_page(self) -> QWidget:
        from trex_gui.devices.trex.views.pages.motors.page import MotorsPage  # noqa: PLC0415

        page = MotorsPage(self._device, self)
        page.parameter_wanted.connect(self._show_parameter)
        return page

    def _make_parameters_page(self) -> QWidget:
        from trex_gui.devices.trex.views.pages.parameters.page import (  # noqa: PLC0415
            ParametersPage,
        )

        page = ParametersPage(self._device, self._linter, self)
        page.reload_requested.connect(self._on_reload_requested)
        page.power_cycle_requested.connect(self._power.guide)
        self._parameter_shown.connect(page.table.show_parameter)
        return page

    def _make_currents_page(self) -> QWidget:
        page = CurrentsPage(self._device, self)
        page.window_wanted.connect(self._show_plot)
        return page

    @Slot()
    def _show_plot(self) -> None:
        """Show the plot of the currents in a window of its own, beside any page."""
        from trex_gui.devices.trex.views.pages.currents_panel import PlotWindow  # noqa: PLC0415

        if self._plot is None or not Shiboken.isValid(self._plot):
            self._plot = PlotWindow(self._device)
        self._plot.show()
        self._plot.activateWindow()

    def _make_errors_page(self) -> QWidget:
        from trex_gui.devices.trex.views.pages.errors import ErrorsPage  # noqa: PLC0415

        return ErrorsPage(self._device, self)

    def _make_log_page(self) -> QWidget:
        page = LogPage(self.log, self.key, self.notifier, self.message_help, self)
        page.help_wanted.connect(self._frame.show_help)
        return page

    def _make_traffic_page(self) -> QWidget:
        from trex_gui.devices.trex.model.packet_sender import TrexPacketSender  # noqa: PLC0415
        from trex_gui.ui.traffic.page import TrafficPage  # noqa: PLC0415

        traffic = self._device.connection.traffic
        sender = TrexPacketSender(self._device, self)
        page = TrafficPage(traffic, "transcript", tr("a board"), self.notifier, self, sender=sender)
        self._frame.seen_changed.connect(page.set_window_seen)
        return page

    def _compare_traffic(self) -> None:
        from trex_gui.devices.trex.views.traffic_comparison import (  # noqa: PLC0415 - rarely
            compare_traffic,
        )

        compare_traffic(self.notifier, self)

    # --- Dialogs that are made, and imported, when they are first opened -------------------

    @cached_property
    def _bench(self) -> "BenchDialog":
        from trex_gui.devices.trex.model.bench import Bench  # noqa: PLC0415
        from trex_gui.devices.trex.views.bench.dialog import BenchDialog  # noqa: PLC0415

        dialog = BenchDialog(self._device, Bench(self._device, self), self._frame)
        dialog.apply_requested.connect(self._review.review)
        return dialog

    def _open_bench(self) -> None:
        self._bench.show_in_front()

    @cached_property
    def _history(self) -> "HistoryDialog":
        from trex_gui.devices.trex.views.history_dialog import HistoryDialog  # noqa: PLC0415

        dialog = HistoryDialog(self._device, self._frame)
        dialog.restore_requested.connect(self._review.review)
        return dialog

    def _open_history(self) -> None:
        self._history.open_history()

    @cached_property
    def _setup(self) -> "SetupDialog":
        from trex_gui.devices.trex.views.setup.dialog import SetupDialog  # noqa: PLC0415

        dialog = SetupDialog(self._device, self._learning, self._frame)
        dialog.learn_requested.connect(self._learn.learn)
        dialog.apply_requested.connect(self._review.review)
        return dialog

    def _set_up(self) -> None:
        self._setup.open_setup()

    @cached_property
    def _to_boards(self) -> "ApplyToBoardsDialog":
        from trex_gui.devices.trex.views.apply_to_boards_dialog import (  # noqa: PLC0415
            ApplyToBoardsDialog,
        )

        return ApplyToBoardsDialog(self._boards, self._device, self._frame)

    @Slot()
    def _apply_to_boards(self) -> None:
        self.files.ask_for_document(self._to_boards.open_file)

    @cached_property
    def _check(self) -> "CheckBoardDialog":
        from trex_gui.devices.trex.views.check_board import CheckBoardDialog  # noqa: PLC0415

        dialog = CheckBoardDialog(self._device, self._wiring, self._frame)
        dialog.find_requested.connect(lambda: self._frame.apply_remedy(Remedy.FIND))
        dialog.connect_requested.connect(self._frame.apply_remedy)
        return dialog

    def _check_board(self) -> None:
        self._check.open_dialog()

    @Slot(object)
    def _show_parameter(self, key: object) -> None:
        self.show_page("parameters")
        self._parameter_shown.emit(key)

    # --- What its menus do --------------------------------------------------------------

    def menus(self) -> Menus:
        device, files, keys = self._device, self.files, QKeySequence.StandardKey
        factory = partial(self._defaults.preview, serial_only=False)
        serial = partial(self._defaults.preview, serial_only=True)
        return {
            Menu.FILE: (
                Entry("new", tr("&New settings file…"), files.ask_and_begin, keys.New, "new"),
                Entry("open", tr("&Open settings file…"), files.ask_and_open, "Ctrl+O", "open"),
                Entry("save", tr("&Save settings file…"), files.ask_and_save, "Ctrl+S", "save"),
                Entry("print", tr("Prin&t settings…"), files.preview, keys.Print, "print"),
                Entry("export", tr("&Export as code…"), files.ask_and_export, "", "console"),
                SEPARATOR,
                Entry("history", tr("&History…"), self._open_history, "Ctrl+H", "history"),
                SEPARATOR,
                Entry("record", tr("&Record…"), self.recordings.toggle, "Ctrl+Shift+R", "record"),
                Entry(
                    "open_recording",
                    tr("Open recor&ding…"),
                    self.recordings.choose_and_open,
                    "Ctrl+Shift+O",
                    "plot",
                ),
                Entry(
                    "open_kept",
                    tr("Open fa&ult or stop…"),
                    self.recordings.choose_and_open_kept,
                ),
                Entry(
                    "record_with_run",
                    tr("Start recording &with Run motor"),
                    self.recordings.toggle_starts_with_run,
                    checkable=True,
                ),
                Entry(
                    "keep_events",
                    tr("&Keep 30 s around each fault and stop"),
                    self.recordings.toggle_keeps_events,
                    checkable=True,
                ),
                SEPARATOR,
                Entry("replay", tr("Compare traffic &log with simulator…"), self._compare_traffic),
            ),
            Menu.EDIT: (
                Entry("undo", tr("&Undo"), device.draft.undo.undo, keys.Undo, "undo"),
                Entry("redo", tr("&Redo"), device.draft.undo.redo, keys.Redo, "redo"),
                SEPARATOR,
                Entry("discard", tr("&Discard all edits"), device.draft.discard_edits, "", "clear"),
            ),
            Menu.DEVICE: (
                Entry("run", tr("&Run motor"), partial(arm, device, self._frame), "Ctrl+R", "run"),
                SEPARATOR,
                Entry(
                    "reload",
                    tr("R&eload settings from device"),
                    self._on_reload_requested,
                    "Ctrl+L",
                    "reload",
                ),
                Entry("apply", tr("&Apply settings…"), self._review.review, "Ctrl+Return", "apply"),
                Entry("power", tr("Make stored settings acti&ve…"), self._power.guide, "", "power"),
                SEPARATOR,
                Entry("boards", tr("Find &other boards on this line"), self._boards.scan),
                Entry("number", tr("Change device nu&mber…"), self._panel.change_number),
                Entry("to_boards", tr("A&pply a file to several boards…"), self._apply_to_boards),
                SEPARATOR,
                Entry("setup", tr("Set &up my robot…"), self._set_up, "", "settings"),
                Entry("learn", tr("Lear&n channels…"), self._learn.learn, "", "calibrate"),
                Entry("test_sticks", tr("&Test the sticks…"), self._learn.test),
                Entry("bench", tr("&Bench test…"), self._open_bench, "Ctrl+B", "plot"),
                SEPARATOR,
                Entry("defaults", tr("Restore factor&y defaults…"), factory),
                Entry("serial_defaults", tr("Restore ser&ial defaults…"), serial),
            ),
            Menu.WINDOW: (
                *self.page_entries(),
                SEPARATOR,
                Entry(
                    "plot",
                    tr("Plot of currents in its o&wn window"),
                    self._show_plot,
                    "Ctrl+Shift+U",
                    "plot",
                ),
                Entry("demo", tr("&Demo TReX panel"), self._demo.toggle, checkable=True),
            ),
            Menu.HELP: (
                Entry("check_board", tr("&Board does not respond…"), self._check_board, "", "find"),
                Entry(
                    "guide",
                    tr("&User's guide of the board (online)…"),
                    lambda: QDesktopServices.openUrl(QUrl(GUIDE)),
                ),
                SEPARATOR,
            ),
        }

    def take_actions(self, actions: Mapping[str, QAction]) -> None:
        super().take_actions(actions)
        self._demo.show_if_wanted()
        self._on_actions_changed()

    def report_parts(self) -> dict[str, Callable[[], str]]:
        from trex_gui.devices.trex.model.report import (  # noqa: PLC0415 - rarely needed
            settings_parts,
            status_text,
        )

        device = self._device
        status = status_text(device)
        return {
            "status.txt": lambda: status,
            **settings_parts(device),
            **super().report_parts(),
            "traffic.txt": device.connection.traffic.newest(),
        }

    @property
    def device_name(self) -> str:
        return self._device.board_name

    @property
    def has_edits(self) -> bool:
        return self._device.draft.pending > 0

    def enabled_actions(self) -> Mapping[str, bool]:
        device, draft = self._device, self._device.draft
        recorder, writable = self.recordings.recorder, device.is_writable
        shown = draft.shown is not None and not device.writer.running
        to_activate = bool(device.parameters.waiting_for_power) or device.draft.reset_pending
        return {
            **dict.fromkeys(
                ("reload", "defaults", "serial_defaults", "learn", "test_sticks"),
                device.is_writable,
            ),
            **dict.fromkeys(("save", "print", "export"), shown),
            "open": not device.writer.running,
            "record": recorder.recording or recorder.can_record,
            "run": device.motors.can_arm,
            "setup": device.is_connected,
            "boards": self._boards.can_scan,
            "number": self._boards.can_change_number,
            "to_boards": writable and self._boards.has_several,
            "apply": device.writer.can_apply and draft.pending > 0,
            "power": device.is_connected and to_activate,
            "discard": shown and draft.pending > 0,
            "undo": shown and draft.undo.canUndo(),
            "redo": shown and draft.undo.canRedo(),
            "demo": self._controller.demo_in_use,
        }

    # --- What has changed ---------------------------------------------------------------

    @Slot()
    def _on_actions_changed(self) -> None:
        if self._actions:
            record, undo = tr("&Record…"), self._device.draft.undo
            undo_title, redo_title = undo_titles(undo.undoText(), undo.redoText())
            if self.recordings.recorder.recording:
                record = tr("Stop &recording")
            for key, text in (
                ("record", record),
                ("undo", undo_title),
                ("redo", redo_title),
            ):
                self._actions[key].setText(text)
            for key, checked in (
                ("demo", self._demo.wanted),
                ("record_with_run", self.recordings.starts_with_run),
                ("keep_events", self.recordings.events.is_on),
            ):
                self._actions[key].setChecked(checked)
        self.actions_changed.emit()
        self._question.reconsider()

    @Slot()
    def _on_errors_changed(self) -> None:
        count = self._device.board.errors.uncleared
        title = tr("Errors ({0})").format(count) if count else tr("Errors")
        self.set_page_title("errors", title)

    @Slot(object)
    def _on_applied(self, results: tuple[WriteResult, ...]) -> None:
        failed = [result for result in results if result.error is not None]
        if not failed:
            self.notifier.cleared.emit()
            if any(result.key == ParameterKey.FACTORY_RESET for result in results):
                self._power.guide()
            elif not self._review.isVisible():
                self.notifier.info.emit(tr("%n setting(s) written and verified.", "", len(results)))
            return
        names = ", ".join(self._device.draft.name_of(result.key) for result in failed)
        reasons = " ".join(dict.fromkeys(error_sentence(result.error) for result in failed))
        self.notifier.error.emit(tr("Not verified: {0}. {1}").format(names, reasons))

    @Slot()
    def _on_reload_requested(self) -> None:
        if not self._device.draft.pending:
            self._device.reload()
            return
        self._question.ask(
            tr("Read the settings from the board and discard the edits made here?"),
            Answer("reloadYes", tr("Discard and reload"), self._forget_and_reload),
            still=lambda: self._device.draft.pending > 0 and self._device.is_writable,
        )

    def _forget_and_reload(self) -> None:
        self._device.draft.discard_edits()
        self._device.reload()

    @Slot()
    def _on_edits_offered(self) -> None:
        backup = self._device.edit_backup
        offer = backup.offer
        self._question.reconsider()
        if offer is None:
            self._on_memory_changed()
            return
        if self._question.text:
            return  # what another question keeps from being asked is offered at the next connection
        text = tr(
            "Edited earlier but not applied: %n setting(s) of this {0} ({1}). Restore as pending "
            "edits?",
            "",
            len(offer.rows),
        )
        saved = local_time(offer.saved.saved)
        self._question.ask(
            text.format(offer.saved.settings.product.name, saved),
            Answer("restoreEdits", tr("Restore edits"), backup.restore),
            Answer("discardEdits", tr("Discard edits"), backup.discard_offer),
            still=lambda: backup.offer is offer,
        )

    @Slot()
    def _on_memory_changed(self) -> None:
        """Ask about each difference from what was applied last, once for each connection."""
        memory = self._device.board.memory
        differing, record = memory.differing, memory.expected
        self._question.reconsider()
        news = set(differing.rows) - self._offered_losses
        if not differing.rows or record is None or record.applied is None:
            self._offered_losses = set()
        elif news and not self._question.text:
            self._offered_losses = set(differing.rows)
            text = tr(
                "%n setting(s) of this {0} differ from what was applied last ({1}): lost, changed "
                "by something else, or this is another board.",
                "",
                len(differing.rows),
            )
            keep = tr("Keep the values of the board")
            self._question.ask(
                text.format(record.settings.product.name, local_time(record.applied)),
                Answer("showDiffering", tr("Show…"), self._show_differing),
                Answer("keepDiffering", keep, lambda: memory.accept(utc_now())),
                still=lambda: memory.differing == differing,
            )

    def _show_differing(self) -> None:
        applied, record = self._device.board.memory.applied, self._device.board.memory.expected
        if applied is not None and record is not None and record.applied is not None:
            self.files.offer_settings(applied, local_time(record.applied))

    # --- The end ------------------------------------------------------------------------

    def may_close(self, leave: Callable[[], object]) -> bool:
        return self._close_prompt.may_close(leave)

    def prepare_to_close(self) -> None:
        QObject.disconnect(self._undo_watch)  # the stack emits at its own end, too
        if not self._close_prompt.keeps_edits:
            self._device.edit_backup.discard()
        children = Qt.FindChildOption.FindDirectChildrenOnly
        for dialog in self._frame.findChildren(ReusedDialog, options=children):
            dialog.close()
        if self._plot is not None and Shiboken.isValid(self._plot):
            self._plot.close()
        self._demo.leave()
        self.files.close_all()

    def finish(self) -> None:
        self.recordings.close_all()
        self._device.edit_backup.files.shut_down()
        self._device.kept.files.shut_down()

    def shut_down(self) -> bool:
        device = self._device
        kept = [files.shut_down() for files in (device.edit_backup.files, device.kept.files)]
        return self.recordings.shut_down() and all(kept)

    def line_choices(self, line: object) -> Sequence[LineChoice]:
        texts = {
            LineSettings(): tr("Factor&y line settings: {0}…"),
            LineSettings(115200): tr("Fas&t: {0}…"),
        }
        return [
            LineChoice(text.format(other.text()), partial(self._review_line, other))
            for other, text in texts.items()
            if other != line
        ]

    def _review_line(self, line: LineSettings) -> None:
        text = tr(
            "{0} is now one of the pending changes. It takes effect after the board is switched "
            "off and on; this window then follows. Other programs on this line have to use it, too."
        )
        self._propose_line(lambda _: line, text.format(line.text()))

    def set_up_crc(self) -> None:
        self._propose_line(
            lambda wire: replace(LineSettings.from_wire(wire), detection=Detection.CRC7),
            tr(
                "CRC-7 is now one of the pending changes. It takes effect after the board is "
                "switched off and on; this window then follows. Other programs on this line "
                "have to use CRC-7, too."
            ),
        )

    def _propose_line(self, change: Callable[[int], LineSettings], text: str) -> None:
        """Edit the line settings that the board stores, and let the user review that."""
        key, parameters = ParameterKey.UART_SETTINGS, self._device.parameters
        if parameters.stored_of(key) != parameters.active_of(key):
            self._power.guide()
            return
        self._show_parameter(key)
        wire = parameters.value_of(key)
        if wire is None:
            return
        with suppress(BadRequest):  # a value that names no baud rate has to be edited first
            parameters.edit(key, change(wire).to_wire())
            self.notifier.info.emit(text)
            self._review.review()

    def edit_line_settings(self) -> None:
        dialog = self._frame.findChild(LineSettingsDialog)
        if dialog is None:
            dialog = LineSettingsDialog(self._controller.settings, self._frame)
            dialog.chosen.connect(self._controller.set_settings)
            self._controller.settings_changed.connect(dialog.show_settings)
        dialog.show_in_front()
