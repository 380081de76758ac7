"""The frame around the pages: connection above, stop and apply below, menus."""

from collections.abc import Callable

from PySide6.QtCore import QByteArray, QObject, QSettings, Qt, QUrl, Slot
from PySide6.QtGui import QCloseEvent, QDesktopServices
from PySide6.QtWidgets import (
    QApplication,
    QMainWindow,
    QMessageBox,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from trex_gui import __version__
from trex_gui.link.doctor import may_be_set_otherwise
from trex_gui.link.writing import Written
from trex_gui.model.connector import Connector
from trex_gui.model.device import Device, Link
from trex_gui.model.learning import Learning
from trex_gui.model.ports import Ports
from trex_gui.model.power_cycle import PowerCycle
from trex_gui.protocol.errors import sentence
from trex_gui.views.action_bar import ActionBar
from trex_gui.views.actions import build_menus
from trex_gui.views.bench.opener import BenchOpener
from trex_gui.views.connection_bar import ConnectionBar
from trex_gui.views.demo.panel import DemoPanel
from trex_gui.views.escape import EscapeWatch
from trex_gui.views.history.dialog import HistoryDialog
from trex_gui.views.icons import application_icon
from trex_gui.views.learning.dialog import LearnDialog
from trex_gui.views.pages.calibration.page import CalibrationPage
from trex_gui.views.pages.channels_page import ChannelsPage
from trex_gui.views.pages.currents import CurrentsPage
from trex_gui.views.pages.motors.page import MotorsPage
from trex_gui.views.pages.parameters_page import ParametersPage
from trex_gui.views.pages.status_page import StatusPage
from trex_gui.views.recording.recordings import SUFFIXES, Recordings
from trex_gui.views.review.defaults_dialog import DefaultsDialog
from trex_gui.views.review.power_cycle_dialog import PowerCycleDialog
from trex_gui.views.review.review_dialog import ReviewDialog
from trex_gui.views.settings_editor.file_drop import FileDrop
from trex_gui.views.settings_files import SettingsFiles
from trex_gui.views.theme import Scheme, theme
from trex_gui.views.widgets.banner import Banner
from trex_gui.views.widgets.question import Answer, Question
from trex_gui.views.widgets.scroll_box import ScrollBox

GUIDE_URL = "https://www.pololu.com/docs/0J1"

_SCHEMES: tuple[Scheme, ...] = ("system", "light", "dark")


class MainWindow(QMainWindow):
    """Everything a person sees; it holds no state of the device."""

    def __init__(
        self,
        device: Device,
        ports: Ports,
        connector: Connector,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setObjectName("mainWindow")
        self.setWindowTitle(self.tr("TReX Studio"))
        self.setWindowIcon(application_icon())
        self._device = device
        self._connector = connector
        self._store = QSettings(self)
        self._was_up = False

        self._connection = ConnectionBar(device, ports, connector, self)
        self._banner = Banner(self)
        self._question = Question(self)
        self._may_leave = False
        self._tabs = QTabWidget(self)
        self._tabs.setObjectName("tabs")
        self._tabs.setAccessibleName(self.tr("Pages"))
        self._tabs.setDocumentMode(True)
        parameters_page = ParametersPage(device, self)
        calibration_page = CalibrationPage(device, self)
        motors_page = MotorsPage(device, self)
        pages = {
            self.tr("Status"): StatusPage(device, self),
            self.tr("Channels"): ChannelsPage(device, self),
            self.tr("Calibration"): calibration_page,
            self.tr("Motors"): motors_page,
            self.tr("Currents"): CurrentsPage(device, self),
            self.tr("Parameters"): parameters_page,
        }
        for title, page in pages.items():
            self._tabs.addTab(ScrollBox(page, self), title)
        parameters_index = list(pages.values()).index(parameters_page)

        frame = QWidget(self)
        layout = QVBoxLayout(frame)
        layout.addWidget(self._connection)
        layout.addWidget(self._banner)
        layout.addWidget(self._question)
        layout.addWidget(self._tabs, 1)
        self._recordings = Recordings(device, self)
        layout.addWidget(self._recordings.indicator)
        self._bar = ActionBar(device, self)
        layout.addWidget(self._bar)
        self.setCentralWidget(frame)
        self._demo = DemoPanel(connector, self)
        self.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, self._demo)
        self._files = SettingsFiles(device, self)
        self._drop = FileDrop(self)
        self._guided = PowerCycle(device, self)
        self._review = ReviewDialog(device, PowerCycle(device, self), self)
        self._defaults = DefaultsDialog(device, self)
        self._power = PowerCycleDialog(self._guided, self)
        self._history = HistoryDialog(device, self)
        learning = Learning(device, self)
        self._learn = LearnDialog(learning, self)
        self._bench = BenchOpener(device, self)
        self._actions = build_menus(self, self._slots())

        self._files.told.connect(self._banner.show_news)
        self._files.refused.connect(self._banner.show_problem)
        self._files.staged.connect(lambda: self._tabs.setCurrentIndex(parameters_index))
        self._drop.dropped.connect(self._files.open_file)
        FileDrop(self, SUFFIXES).dropped.connect(self._recordings.open_file)
        self._recordings.told.connect(self._banner.show_news)
        self._recordings.refused.connect(self._banner.show_problem)
        self._recordings.settings_wanted.connect(self._files.open_editor)
        self._recordings.changed.connect(self._on_recording_changed)
        self._connection.connecting.connect(self._banner.clear)
        self._connection.interruption_wanted.connect(self._on_interruption_wanted)
        self._bar.apply_requested.connect(self._review.review)
        self._bench.apply_requested.connect(self._review.review)
        self._defaults.staged.connect(self._review.review)
        self._history.restore_requested.connect(self._review.review)
        self._defaults.reset_requested.connect(device.reset_to_factory)
        parameters_page.reload_requested.connect(self._on_reload_requested)
        parameters_page.power_cycle_requested.connect(self._on_power_cycle_wanted)
        calibration_page.power_cycle_requested.connect(self._on_power_cycle_wanted)
        calibration_page.learn_requested.connect(self._learn.learn)
        learning.taken.connect(self._review.review)
        motors_page.parameter_wanted.connect(parameters_page.show_parameter)
        motors_page.parameter_wanted.connect(lambda: self._tabs.setCurrentIndex(parameters_index))
        calibration_page.told.connect(self._banner.show_news)
        calibration_page.refused.connect(self._banner.show_problem)
        connector.failed.connect(self._banner.show_problem)
        connector.demo_changed.connect(self._on_demo_changed)
        connector.demo_board.refused.connect(self._banner.show_problem)
        self._demo.wanted_changed.connect(self._on_demo_changed)
        device.failed.connect(self._on_device_failed)
        # Behind what the same report changes: a link that is up again clears the banner.
        device.told.connect(self._banner.show_news, Qt.ConnectionType.QueuedConnection)
        device.applied.connect(self._on_applied)
        device.applied.connect(self._question.reconsider)
        device.link_changed.connect(self._on_link_changed)
        device.motors.changed.connect(self._on_motors_changed)
        device.pending_changed.connect(self._on_possibilities_changed)
        self._undo_watch = device.undo.indexChanged.connect(self._on_undo_changed)
        theme().changed.connect(self._on_theme_changed)
        app = QApplication.instance()
        if isinstance(app, QApplication):
            self._escape = EscapeWatch(app, device.motors.press_stop, self)
        self._on_link_changed()
        self._restore()
        self._on_theme_changed()

    @property
    def files(self) -> SettingsFiles:
        """Opening and saving of settings files."""
        return self._files

    @property
    def recordings(self) -> Recordings:
        """What is recorded, and the recordings that are open."""
        return self._recordings

    @property
    def pages(self) -> QTabWidget:
        """The pages, in the order of their tabs."""
        return self._tabs

    def _slots(self) -> dict[str, Callable[[], object]]:
        """What each action of the menus does."""

        def page(index: int) -> Callable[[], object]:
            return lambda: self._tabs.setCurrentIndex(index)

        return {
            "new": self._files.ask_and_begin,
            "open": self._files.ask_and_open,
            "history": self._history.open_history,
            "record": self._recordings.toggle,
            "open_recording": self._recordings.ask_and_open,
            "save": self._files.ask_and_save,
            "print": self._files.preview,
            "export": self._files.ask_and_export,
            "quit": self.close,
            "undo": self._device.undo.undo,
            "redo": self._device.undo.redo,
            "discard": self._device.discard_edits,
            "connect": self._connection.connect_preferred,
            "disconnect": self._connection.leave,
            "line": self._connection.edit_line,
            "find": self._connection.find_board,
            "stop": self._device.motors.press_stop,
            "run": self._device.motors.arm,
            "reload": self._on_reload_requested,
            "apply": self._review.review,
            "power": self._on_power_cycle_wanted,
            "learn": self._learn.learn,
            "test_sticks": self._learn.test,
            "bench": self._bench.open,
            "defaults": lambda: self._defaults.preview(serial_only=False),
            "serial_defaults": lambda: self._defaults.preview(serial_only=True),
            **{f"page{index}": page(index) for index in range(self._tabs.count())},
            "demo": self._demo.toggle,
            **{scheme: self._scheme_chooser(scheme) for scheme in _SCHEMES},
            "guide": lambda: QDesktopServices.openUrl(QUrl(GUIDE_URL)),
            "about": self._show_about,
        }

    # --- What has changed ---------------------------------------------------------------

    @Slot()
    def _on_link_changed(self) -> None:
        up = self._device.link is Link.UP
        if up and not self._was_up:
            self._banner.clear()
        self._was_up = up
        self._on_possibilities_changed()

    @Slot()
    def _on_motors_changed(self) -> None:
        """A drag tells of wishes many hundred times a second; no action depends on them."""
        motors = self._device.motors
        run = motors.can_arm and not motors.armed and not motors.locked_for
        if run != self._actions["run"].isEnabled():
            self._on_possibilities_changed()

    @Slot()
    def _on_possibilities_changed(self) -> None:
        """Let every action say whether it can be done now."""
        link, motors = self._device.link, self._device.motors
        idle, up = link is Link.NONE, link is Link.UP
        shown = self._device.draft.shown is not None and not self._device.applying
        waiting = bool(self._device.parameters.waiting_for_power)
        edited = shown and self._device.pending > 0
        for key, possible in {
            "connect": idle,
            "line": idle,
            "disconnect": link not in {Link.NONE, Link.CLOSING},
            "reload": up and not self._device.applying,
            "open": not self._device.applying,
            "save": shown,
            "print": shown,
            "export": shown,
            "stop": link in {Link.OPENING, Link.UP, Link.SILENT},
            "run": motors.can_arm and not motors.armed and not motors.locked_for,
            "apply": up and self._device.pending > 0 and not self._device.applying,
            "power": up and (waiting or self._device.reset_ordered),
            "defaults": up and not self._device.applying,
            "serial_defaults": up and not self._device.applying,
            "learn": up and not self._device.applying,
            "test_sticks": up and not self._device.applying,
            "discard": edited,
            "undo": shown and self._device.undo.canUndo(),
            "redo": shown and self._device.undo.canRedo(),
        }.items():
            self._actions[key].setEnabled(possible)
        self._on_recording_changed()
        self._question.reconsider()

    @Slot()
    def _on_recording_changed(self) -> None:
        recorder = self._recordings.recorder
        text = self.tr("Stop &recording") if recorder.recording else self.tr("&Record…")
        self._actions["record"].setText(text)
        self._actions["record"].setEnabled(recorder.recording or recorder.can_record)

    @Slot()
    def _on_undo_changed(self) -> None:
        """Say in the menu what would be undone."""
        undo = self._device.undo
        self._actions["undo"].setText(self.tr("&Undo {0}").format(undo.undoText()).strip())
        self._actions["redo"].setText(self.tr("&Redo {0}").format(undo.redoText()).strip())
        self._on_possibilities_changed()

    @Slot()
    def _on_demo_changed(self) -> None:
        self._actions["demo"].setEnabled(self._connector.demo_in_use)
        self._actions["demo"].setChecked(self._demo.wanted)

    @Slot(str)
    def _on_device_failed(self, text: str) -> None:
        if may_be_set_otherwise(text):
            text = self.tr("{0} Find a board (Ctrl+Shift+F) tries every setting.").format(text)
        self._banner.show_problem(text)

    @Slot(object)
    def _on_applied(self, results: tuple[Written, ...]) -> None:
        failed = [result for result in results if result.error is not None]
        if not failed:
            self._banner.clear()
            if any(result.what == "factory_reset" for result in results):
                self._on_power_cycle_wanted()
            elif not self._review.isVisible():
                text = self.tr("{0} settings are stored and read back equal.")
                self._banner.show_news(text.format(len(results)))
            return
        names = ", ".join(self._device.name_of(result.what) for result in failed)
        reasons = " ".join(dict.fromkeys(sentence(result.error) for result in failed))
        self._banner.show_problem(self.tr("Not stored: {0}. {1}").format(names, reasons))

    @Slot()
    def _on_power_cycle_wanted(self) -> None:
        if self._device.link is Link.UP:  # a window that closes has nothing to lead through
            self._guided.begin()
            self._power.guide()

    @Slot()
    def _on_reload_requested(self) -> None:
        if not self._device.pending:
            self._device.reload()
            return
        self._question.ask(
            self.tr("Read the settings from the board and forget the edits made here?"),
            Answer("reloadYes", self.tr("Forget them and reload"), self._forget_and_reload),
            still=lambda: (
                self._device.pending > 0
                and self._device.link is Link.UP
                and not self._device.applying
            ),
        )

    def _forget_and_reload(self) -> None:
        self._device.discard_edits()
        self._device.reload()

    @Slot(object)
    def _on_interruption_wanted(self, then: Callable[[], object]) -> None:
        """Ask before writing is cut off."""
        self._question.ask(
            self.tr(
                "Settings are being written. Disconnect all the same? What was not written yet "
                "stays an edit."
            ),
            Answer("disconnectYes", self.tr("Disconnect"), then),
            still=lambda: self._device.applying,
        )

    # --- Appearance, beginning and end --------------------------------------------------

    def _scheme_chooser(self, scheme: Scheme) -> Callable[[], object]:
        def choose() -> None:
            theme().set_scheme(scheme)
            self._store.setValue("window/scheme", scheme)

        return choose

    @Slot()
    def _on_theme_changed(self) -> None:
        self._actions[theme().choice].setChecked(True)

    def _show_about(self) -> None:
        QMessageBox.about(
            self,
            self.tr("About TReX Studio"),
            self.tr(
                "TReX Studio {0}\n\nSet up, calibrate, drive and understand a Pololu TReX or "
                "TReX Jr dual motor controller.\n\nNot a product of Pololu."
            ).format(__version__),
        )

    def _restore(self) -> None:
        geometry = self._store.value("window/geometry")
        if not isinstance(geometry, QByteArray) or not self.restoreGeometry(geometry):
            self.resize(1100, 760)
        state = self._store.value("window/state")
        if isinstance(state, QByteArray):
            self.restoreState(state)
        self._demo.show_if_wanted()
        self._on_demo_changed()
        page = str(self._store.value("window/page", 0))
        self._tabs.setCurrentIndex(int(page) if page.isdigit() else 0)
        wanted = self._store.value("window/scheme", "system")
        for scheme in _SCHEMES:
            if scheme == wanted and scheme != theme().choice:
                theme().set_scheme(scheme)

    def closeEvent(self, event: QCloseEvent) -> None:
        if not self._may_close():
            event.ignore()
            return
        QObject.disconnect(self._undo_watch)  # the stack tells of its own end, too
        self._store.setValue("window/state", self.saveState())
        self._history.close()
        self._learn.close()
        self._bench.close()
        self._demo.leave()
        self._files.close_all()
        self._connection.close_dialogs()
        self._store.setValue("window/geometry", self.saveGeometry())
        self._store.setValue("window/page", self._tabs.currentIndex())
        self._connector.shut_down()
        self._recordings.close_all()  # behind the stop of the motors: a disk may take its time
        super().closeEvent(event)

    def _may_close(self) -> bool:
        """Ask before something is lost; an answer that lets the window go closes it again."""
        if self._may_leave or not (self._device.applying or self._device.pending):
            self._may_leave = False
            return self._files.may_close()
        self.activateWindow()
        if self._device.applying:
            self._question.ask(
                self.tr(
                    "Settings are being written. Close all the same? What was not written yet is "
                    "lost."
                ),
                Answer("closeYes", self.tr("Close all the same"), self._leave),
                still=lambda: self._device.applying,
            )
        else:
            self._question.ask(
                self.tr("There are changes that were not applied to the board."),
                Answer("saveAndClose", self.tr("Save as a settings file…"), self._save_and_leave),
                Answer("closeYes", self.tr("Close and lose them"), self._leave),
                still=lambda: self._device.pending > 0 and not self._device.applying,
            )
        return False

    def _save_and_leave(self) -> None:
        if self._files.ask_and_save():
            self._leave()

    def _leave(self) -> None:
        self._may_leave = True
        self.close()
