"""Workspace of a TReX: pages, dialogs and menus."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property, partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, QUrl, Signal, Slot
from PySide6.QtGui import QAction, QDesktopServices, QKeySequence
from PySide6.QtWidgets import QWidget
from shiboken6 import Shiboken

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.boards import BoardList
from trex_gui.devices.trex.model.controller import TrexController
from trex_gui.devices.trex.model.linter import BoardLinter
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.model.report import settings_parts, status_text
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.views.board.page import BoardPage
from trex_gui.devices.trex.views.boards import BoardPanel
from trex_gui.devices.trex.views.help import GUIDE, TOPICS, message_help
from trex_gui.devices.trex.views.line_settings_dialog import LineSettingsDialog
from trex_gui.devices.trex.views.motor_controls import ControlBar, arm
from trex_gui.devices.trex.views.pages.currents import CurrentsPage
from trex_gui.devices.trex.views.pages.errors import ErrorsPage
from trex_gui.devices.trex.views.pages.parameters.page import ParametersPage
from trex_gui.devices.trex.views.prompts import ClosePrompt, LeasePrompt, RestorePrompt
from trex_gui.devices.trex.views.recordings import Recordings
from trex_gui.devices.trex.views.settings_commands import SettingsCommands
from trex_gui.devices.trex.views.settings_files import SettingsFiles
from trex_gui.devices.trex.views.start_texts import start_texts
from trex_gui.ui.devices.demo_panel import DemoDock
from trex_gui.ui.devices.undo import undo_titles
from trex_gui.ui.diagnostics.place import Diagnostics
from trex_gui.ui.frame.main_window import MainWindow
from trex_gui.ui.frame.start_panel import StartPanel
from trex_gui.ui.frame.workspace import (
    SEPARATOR,
    Entry,
    FileKind,
    Menu,
    Menus,
    PageInfo,
    Workspace,
)
from trex_gui.ui.help.search import Findable
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import ReusedDialog

if TYPE_CHECKING:
    from trex_gui.devices.trex.model.learning.learning import Learning
    from trex_gui.devices.trex.views.pages.currents_panel import PlotWindow
    from trex_gui.devices.trex.views.tools import Tools
    from trex_gui.ui.traffic.page import TrafficPage


class TrexWorkspace(Workspace):
    """Content of the main window for a TReX. It stores no device state."""

    _parameter_shown = Signal(object)  # parameter key

    def __init__(self, controller: TrexController, frame: MainWindow) -> None:
        device = controller.device
        super().__init__(controller.plugin.key, device.notifier, frame.stack)
        self._device = device
        self._controller = controller
        self._frame = frame
        self._linter = BoardLinter(device, self)
        self.help_topics, self.message_help = TOPICS, message_help()
        self.log.follow(device.events)

        self._boards = boards = BoardList(device, self)
        self._panel = panel = BoardPanel(boards, device, controller.group, self)
        tabs = ui.named(self.pages, "tabs", accessible=tr("Pages"))
        ui.tab_order(panel, tabs.tabBar())
        diagnostics = Diagnostics(self, "diagnostics", frame.show_help)
        create_currents = partial(CurrentsPage, device, controller.group)
        self.add_pages(
            (
                PageInfo("board", tr("B&oard"), self._create_board_page, "board"),
                PageInfo("channels", tr("&Channels"), self._create_channels_page, "channels"),
                PageInfo("motors", tr("&Motors"), self._create_motors_page, "motor"),
                PageInfo("currents", tr("C&urrents"), create_currents, "plot"),
                PageInfo("parameters", tr("&Parameters"), self._create_parameters_page, "settings"),
                *diagnostics.pages(partial(ErrorsPage, device), self._create_traffic_page),
            )
        )

        self.recordings = Recordings(device, frame)
        self.bar = bar = ControlBar(device, self.recordings.indicator, self)
        self.page_changed.connect(bar.set_page)
        ui.row(panel, (tabs, 1), into=self, margins=0)
        create_demo, key = self._create_demo_view, "demo_panel/wanted"
        self._demo = DemoDock("demoPanel", key, controller, create_demo, frame)
        self._demo.setWindowTitle(tr("Demo TReX"))
        self.files = files = SettingsFiles(device, frame)
        self.docks = (self._demo,)
        self.motion_keys = {"run"}
        name, suffixes = tr("a settings file of a TReX"), {".txt", ".yaml", ".yml"}
        self.file_kinds = (FileKind(suffixes, name, files.open_file, files.edit_file),)
        self._settings = settings = SettingsCommands(device, self._linter, boards, frame)
        self._close_prompt = ClosePrompt(device, files, settings.review, frame)
        RestorePrompt(device, files, frame.question)
        LeasePrompt(device, frame.question, self)
        self._plot: PlotWindow | None = None

        frame.visibility_changed.connect(device.set_visible)
        self.files.staged.connect(lambda: self.show_page("parameters"))
        self.recordings.accept_drops(frame, self)
        self.openers = {"settings": files.open_file, "recording": self.recordings.open_file}
        files.used.connect(partial(frame.files.recent.add, self.key, "settings"))
        self.recordings.used.connect(partial(frame.files.recent.add, self.key, "recording"))
        settings.parameter_requested.connect(self._show_parameter)
        bar.apply_requested.connect(settings.review)
        controller.demo_board.rejected.connect(self.notifier.error)
        device_changes = device.motors.arming_changed, device.draft.pending_changed, boards.changed
        program_changes = self.recordings.changed, controller.changed, self._demo.wanted_changed
        for changed in (*program_changes, *device_changes):
            changed.connect(self._on_actions_changed)
        self._undo_connection = device.draft.undo.indexChanged.connect(self._on_actions_changed)

    def _create_board_page(self, parent: QWidget) -> QWidget:
        create_start = partial(StartPanel, start_texts(), self._frame, self)
        page = BoardPage(self._device, self._controller.group, create_start, parent)
        page.setup_requested.connect(partial(self._open, "setup"))
        page.page_requested.connect(self.show_page)
        return page

    def _create_channels_page(self, parent: QWidget) -> QWidget:
        from trex_gui.devices.trex.views.pages.channels.page import ChannelsPage  # noqa: PLC0415

        page = ChannelsPage(self._device, self._linter, parent)
        page.power_cycle_requested.connect(self._settings.show_power_cycle)
        page.learn_requested.connect(self._learn)
        page.test_requested.connect(self._test_sticks)
        return page

    def _create_motors_page(self, parent: QWidget) -> QWidget:
        from trex_gui.devices.trex.views.pages.motors.page import MotorsPage  # noqa: PLC0415

        page = MotorsPage(self._device, self._controller.group, parent)
        page.parameter_requested.connect(self._show_parameter)
        page.plot_requested.connect(partial(self.show_page, "currents"))
        return page

    def _create_parameters_page(self, parent: QWidget) -> QWidget:
        page = ParametersPage(self._device, self._linter, parent)
        page.power_cycle_requested.connect(self._settings.show_power_cycle)
        self._parameter_shown.connect(page.table.show_parameter)
        return page

    def _create_demo_view(self, parent: QWidget) -> QWidget:
        from trex_gui.devices.trex.views.demo_panel import DemoBoardView  # noqa: PLC0415

        return DemoBoardView(self._controller, parent)

    @Slot()
    def _show_plot(self) -> None:
        from trex_gui.devices.trex.views.pages.currents_panel import PlotWindow  # noqa: PLC0415

        if self._plot is None or not Shiboken.isValid(self._plot):
            self._plot = PlotWindow(self._device)
        self._plot.show()
        self._plot.activateWindow()

    def _create_traffic_page(self, parent: QWidget) -> "TrafficPage":
        from trex_gui.devices.trex.model.packet_sender import TrexPacketSender  # noqa: PLC0415
        from trex_gui.ui.traffic.page import TrafficPage  # noqa: PLC0415

        traffic = self._device.connection.traffic
        sender = TrexPacketSender(self._device, self)
        return TrafficPage(
            traffic, "transcript", tr("a board"), self.notifier, parent, sender=sender
        )

    @cached_property
    def _learning(self) -> "Learning":
        from trex_gui.devices.trex.model.learning.learning import Learning  # noqa: PLC0415

        learning = Learning(self._device, self)
        # Queued, so that the review receives its result before the stick test starts.
        queued = Qt.ConnectionType.QueuedConnection
        learning.stored.connect(self._settings.close_if_verified, queued)
        learning.started.connect(self._controller.demo_board.center_sticks)
        # Accessing `learn` creates the flow, which also starts the stick test after a set-up.
        learning.started.connect(lambda: self._tools.learn)
        return learning

    @cached_property
    def _tools(self) -> "Tools":
        from trex_gui.devices.trex.views.tools import Tools  # noqa: PLC0415 - rarely needed

        review = self._settings.review
        return Tools(self._device, self._boards, self._learning, review, self._frame)

    def _apply_to_boards(self) -> None:
        self.files.prompt_for_document(self._tools.apply_to_boards.open_file)

    def _open(self, tool: str) -> None:
        """Open a window of `Tools` by its attribute name."""
        getattr(self._tools, tool).show_in_front()

    @Slot(object)
    def _learn(self, channels: Sequence[int] = CHANNELS) -> None:
        self._tools.learn.learn(channels)

    @Slot()
    def _test_sticks(self) -> None:
        self._tools.learn.test()

    @Slot(object)
    def _show_parameter(self, key: object) -> None:
        self.show_page("parameters")
        self._parameter_shown.emit(key)

    def findables(self) -> Iterator[Findable]:
        model = self._device.parameters
        if not model.count:  # before the first connection
            model = ParameterModel()
            model.load(parameters_of("trex", "1.3"), {}, {}, power_cycled=False)
        for row in model.rows:
            for key in row.keys[:1]:
                location = f"{tr('Parameters')} · {model.titles[row.group]}"
                text, show = model.text.description(key), partial(self._show_parameter, key)
                yield Findable("parameter", key, row.name, location, text, show)

    def menus(self) -> Menus:
        device, files, saver = self._device, self.files, self.files.saver
        keys = QKeySequence.StandardKey
        settings = self._settings
        reload, review, activate = settings.reload, settings.review, settings.show_power_cycle
        tool = self._open
        provision, check_board = partial(tool, "provision"), partial(tool, "check_board")
        factory = partial(settings.review_defaults, serial_only=False)
        serial = partial(settings.review_defaults, serial_only=True)
        plot_title = tr("Plot of currents in its o&wn window")

        return {
            Menu.FILE: (
                Entry("new", tr("&New settings file…"), files.prompt_and_create, keys.New, "new"),
                Entry("open", tr("&Open settings file…"), files.prompt_and_open, "Ctrl+O", "open"),
                Entry("save", tr("&Save settings file…"), saver.prompt_and_save, "Ctrl+S", "save"),
                Entry("export", tr("&Export as code…"), saver.prompt_and_export, "", "console"),
                SEPARATOR,
                Entry("history", tr("&History…"), partial(tool, "history"), "Ctrl+H", "history"),
                SEPARATOR,
                *self.recordings.entries(),
            ),
            Menu.EDIT: (
                Entry("undo", tr("&Undo"), device.draft.undo.undo, keys.Undo, "undo"),
                Entry("redo", tr("&Redo"), device.draft.undo.redo, keys.Redo, "redo"),
                SEPARATOR,
                Entry("discard", tr("&Discard all edits"), device.draft.discard_edits, "", "clear"),
            ),
            Menu.DEVICE: (
                Entry("run", tr("A&rm motors"), partial(arm, device, self._frame), "Ctrl+R", "run"),
                SEPARATOR,
                Entry("reload", tr("R&eload settings from device"), reload, "Ctrl+L", "reload"),
                Entry("apply", tr("Review ch&anges…"), review, "Ctrl+Return", "apply"),
                Entry("power", tr("Make stored settings acti&ve…"), activate, "", "power"),
                SEPARATOR,
                Entry("boards", tr("Find &other boards on this line"), self._boards.scan),
                Entry("number", tr("Change device nu&mber…"), self._panel.change_number),
                Entry("to_boards", tr("A&pply a file to several boards…"), self._apply_to_boards),
                Entry("group", tr("Drive together…"), self._panel.join_boards),
                Entry("robots", tr("Robots on the net&work…"), partial(tool, "robots")),
                SEPARATOR,
                Entry("setup", tr("Set &up my robot…"), partial(tool, "setup"), "", "settings"),
                Entry("provision", tr("Set up one board after anot&her…"), provision),
                Entry("learn", tr("Lear&n channels…"), self._learn, "", "calibrate"),
                Entry("test_sticks", tr("&Test the sticks…"), self._test_sticks),
                Entry("bench", tr("&Bench test…"), partial(tool, "bench"), "Ctrl+B", "plot"),
                SEPARATOR,
                Entry("defaults", tr("Restore factor&y defaults…"), factory),
                Entry("serial_defaults", tr("Restore ser&ial defaults…"), serial),
            ),
            Menu.WINDOW: (
                *self.page_entries(),
                SEPARATOR,
                Entry("plot", plot_title, self._show_plot, "Ctrl+Shift+U", "plot"),
                Entry("demo", tr("&Demo TReX panel"), self._demo.toggle, checkable=True),
            ),
            Menu.HELP: (
                Entry("check_board", tr("&Board does not respond…"), check_board, "", "find"),
                Entry("guide", tr("&User's guide of the board (online)…"), _open_guide),
                SEPARATOR,
            ),
        }

    def set_actions(self, actions: Mapping[str, QAction]) -> None:
        super().set_actions(actions)
        self._demo.show_if_wanted()
        self._on_actions_changed()

    def report_parts(self) -> dict[str, Callable[[], str]]:
        device = self._device
        return {
            "status.txt": partial(str, status_text(device)),
            **settings_parts(device),
            **super().report_parts(),
            "traffic.txt": device.connection.traffic.newest_as_text(),
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
        can_use_draft = draft.shown is not None and not device.writer.running
        to_activate = bool(device.parameters.values.waiting_for_power) or draft.reset_pending
        return {
            **dict.fromkeys(
                ("reload", "defaults", "serial_defaults", "learn", "test_sticks"), writable
            ),
            **dict.fromkeys(("save", "export"), can_use_draft),
            "open": not device.writer.running,
            "record": recorder.recording or recorder.can_record,
            "run": device.motors.can_arm,
            "setup": device.is_connected,
            "boards": self._boards.can_scan,
            "number": self._boards.can_change_number,
            "to_boards": writable and self._boards.has_several,
            "group": self._panel.can_join,
            "apply": device.writer.can_apply and draft.pending > 0,
            "power": device.is_connected and to_activate,
            "discard": can_use_draft and draft.pending > 0,
            "undo": can_use_draft and draft.undo.canUndo(),
            "redo": can_use_draft and draft.undo.canRedo(),
            "demo": self._controller.demo_in_use,
        }

    @Slot()
    def _on_actions_changed(self) -> None:
        if self._actions:
            is_recording, undo = self.recordings.recorder.recording, self._device.draft.undo
            record = tr("Stop &recording") if is_recording else tr("&Record…")
            texts = record, *undo_titles(undo.undoText(), undo.redoText())
            for key, text in zip(("record", "undo", "redo"), texts, strict=True):
                self._actions[key].setText(text)
            self.set_page_count("parameters", self._device.draft.pending)
            self._actions["demo"].setChecked(self._demo.wanted)
            self._actions["record_with_run"].setChecked(self.recordings.starts_with_run)
            self._actions["keep_events"].setChecked(self.recordings.events.is_on)
        self.actions_changed.emit()
        self._frame.question.reconsider()

    def may_close(self, leave: Callable[[], object]) -> bool:
        return self._close_prompt.may_close(leave)

    def prepare_to_close(self) -> None:
        # An undo stack also emits signals while it is being destroyed.
        QObject.disconnect(self._undo_connection)
        if not self._close_prompt.keeps_edits:
            self._device.edit_backup.discard()
        children = Qt.FindChildOption.FindDirectChildrenOnly
        for dialog in self._frame.findChildren(ReusedDialog, options=children):
            dialog.close()
        if self._plot is not None and Shiboken.isValid(self._plot):
            self._plot.close()
        self._demo.hide_dock()
        self.files.close_all()

    def finish(self) -> None:
        self.recordings.close_all()
        self._device.edit_backup.files.shut_down()
        self._device.records.files.shut_down()

    def shut_down(self) -> bool:
        device = self._device
        saved = [files.shut_down() for files in (device.edit_backup.files, device.records.files)]
        return self.recordings.shut_down() and all(saved)

    def set_up_crc(self) -> None:
        self._settings.propose_crc()

    def edit_line_settings(self) -> None:
        dialog = self._frame.findChild(LineSettingsDialog)
        if dialog is None:
            dialog = LineSettingsDialog(self._controller.settings, self._frame)
            dialog.chosen.connect(self._controller.set_settings)
            self._controller.settings_changed.connect(dialog.show_settings)
        dialog.show_in_front()


def _open_guide() -> None:
    QDesktopServices.openUrl(QUrl(GUIDE))
