"""Main window: connection bar, notifications, workspace of the device in use, menus."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, Qt, QTimer, QUrl, Signal, Slot
from PySide6.QtGui import (
    QAction,
    QCloseEvent,
    QDesktopServices,
    QGuiApplication,
    QKeyEvent,
    QKeySequence,
    QShowEvent,
    QWindow,
)
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QDialog,
    QMainWindow,
    QMenu,
    QMessageBox,
    QStackedWidget,
    QTabWidget,
    QWidget,
)

from trex_gui import __version__
from trex_gui.core.files import log_folder
from trex_gui.core.translation import tr
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.device_manager import DeviceManager
from trex_gui.ui.devices.ports import Port, Ports
from trex_gui.ui.files import in_background
from trex_gui.ui.frame.connection_bar import ConnectionBar
from trex_gui.ui.frame.workspace import (
    SEPARATOR,
    Entries,
    Entry,
    FileKind,
    LineChoice,
    Menu,
    Menus,
    Workspace,
    entries_of,
    fill_menu_bar,
)
from trex_gui.ui.help.pages import INDEX
from trex_gui.ui.last_run import stop_left_running
from trex_gui.ui.notifier import Answer, ConnectWith, Notifier, Remedy
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.recent_files import RecentFile, RecentFiles
from trex_gui.ui.runtime import now
from trex_gui.ui.theme.icons import DialogIcons, application_icon
from trex_gui.ui.theme.theme import restore_choices
from trex_gui.ui.units import restore_units
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import EnterWatch, ReusedDialog
from trex_gui.ui.widgets.file_drop import FileDrop
from trex_gui.ui.widgets.messages import Banner, InlinePrompt, MessageRoom
from trex_gui.ui.widgets.placement import keep_on_screen, restore_geometry, save_geometry

if TYPE_CHECKING:
    from trex_gui.ui.help.dialog import HelpDialog

_LOG_OUT_S = 60.0
"""Seconds after the start of a log-out within which closing the window is part of it."""

_HELP_TOPICS = {
    "findDialog": "connecting.md#find",
    "preferencesDialog": "window.md#preferences",
    "reportDialog": "traffic.md#report-for-support",
    "helpDialog": INDEX,
}


_DEVICE = "window/device"


def last_device() -> str:
    """Return the key of the kind of device whose workspace was shown last; empty at first."""
    return Preferences().text(_DEVICE)


class MainWindow(QMainWindow):
    """Shows the workspace of the device that is connected, or was last."""

    # Whether any window of the program is seen: neither hidden nor minimised.
    seen_changed = Signal(bool)

    def __init__(
        self,
        device_manager: DeviceManager,
        ports: Ports,
        notifier: Notifier,
        add_all_workspaces: Callable[[], object],
    ) -> None:
        """`add_all_workspaces` adds those of the kinds of devices that were not used yet."""
        super().__init__()
        restore_choices()  # before fonts are measured
        restore_units()
        self.setObjectName("mainWindow")
        self.setWindowTitle(tr("TReX Studio"))
        self.setWindowIcon(application_icon())
        self._manager = device_manager
        self.ports = ports
        self._notifier = notifier
        self._add_all_workspaces = add_all_workspaces
        self._store = Preferences()
        frame = QWidget(self)
        self._connection = ConnectionBar(device_manager, ports, self._line_choices, frame)
        self.question = InlinePrompt(frame)  # for questions of the window and of the workspaces
        self._stack = QStackedWidget(frame)
        banner = Banner(frame, notifier, self._topic_of)
        banner.chosen.connect(self.apply_remedy)
        banner.help_wanted.connect(self.show_help)
        messages = MessageRoom(frame, self.question, banner, lines=1)
        below = ui.column(messages, (self._stack, 1), spacing=0)
        ui.column(self._connection, (below, 1), into=frame, spacing=0)
        self.setCentralWidget(frame)
        self._workspaces: tuple[Workspace, ...] = ()
        self._actions: dict[str, QAction] = {}
        self._menus_shown: list[QMenu] = []
        self.recent = RecentFiles(self)
        self.recent.changed.connect(self._fill_recent)
        self._recent_menu = QMenu(tr("Recent &files"), self)
        self._recent_menu.setToolTipsVisible(True)
        self.help_dialog: HelpDialog | None = None
        self._was_connected = False
        self._is_reopening = False
        self.reopens = False  # once it is closed: it was closed to be opened again,
        self.port_to_reopen: Port | None = None  # and connected to this port
        self._warning = UnconfirmedStopWarning(device_manager, self.question, self)
        # After the event: a question about the file must not block the program it comes from.
        drop = FileDrop(self)
        drop.dropped.connect(self._on_dropped, Qt.ConnectionType.QueuedConnection)

    def add_workspace(self, workspace: Workspace) -> None:
        """Add the workspace of a kind of device, and fill the menus with those of all.

        The first is that of the window as it is first shown.
        """
        is_first = not self._workspaces
        self._workspaces += (workspace,)
        self._stack.addWidget(workspace)
        for dock in workspace.docks:
            if is_first or not self.restoreDockWidget(dock):
                self.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
        workspace.actions_changed.connect(self._on_actions_changed)
        self._fill_menus()
        if is_first:
            self._connect()
            restore_geometry(self, "window", 1100, 760)
            keep_on_screen(self)
            self.restoreState(self._store.data("window/state"))
        self._restore(workspace)
        self._show_current()

    def _fill_menus(self) -> None:
        for old in (*self._actions.values(), *self._menus_shown):
            old.setObjectName("")
            old.deleteLater()
        self.menuBar().clear()
        self._actions = fill_menu_bar(self, self._menus([one.menus() for one in self._workspaces]))
        menus = (action.menu() for action in self.menuBar().actions())
        self._menus_shown = [menu for menu in menus if isinstance(menu, QMenu)]
        preferences = self._actions["preferences"]
        preferences.setMenuRole(QAction.MenuRole.PreferencesRole)
        self._menus_shown[0].insertMenu(preferences, self._recent_menu)
        self._fill_recent()
        # Whatever window is in front; the others have their own keys.
        self._actions["stop"].setShortcutContext(Qt.ShortcutContext.ApplicationShortcut)
        self._actions["help"].setShortcutContext(Qt.ShortcutContext.ApplicationShortcut)
        self._actions["stop"].setAutoRepeat(False)  # Esc that closed a menu may still be held

    def _connect(self) -> None:
        self._connection.connecting.connect(self._notifier.cleared)
        self._connection.choice_changed.connect(self._on_actions_changed)
        self._connection.line_settings_requested.connect(self._edit_line_settings)
        self._connection.remedy_chosen.connect(self.apply_remedy)
        self._connection.interruption_wanted.connect(self._on_interruption_wanted)
        self._manager.changed.connect(self._on_link_changed)
        self._manager.current_changed.connect(self._on_device_changed)
        self._manager.stop_reported.connect(self._on_stop_reported)
        self._notifier.logged.connect(self._log)
        app = QApplication.instance()
        if isinstance(app, QApplication):
            self._enter = EnterWatch(app, self)
            self._escape = EscapeWatch(app, self._manager, self)
            self._dialog_icons = DialogIcons(app, self)

    def _line_choices(self, device: str, line: object) -> Sequence[LineChoice]:
        made = [workspace for workspace in self._workspaces if workspace.key == device]
        return made[0].line_choices(line) if made else ()

    def connect_to(self, port: Port) -> None:
        self._connection.connect_to(port)

    @property
    def pages(self) -> QTabWidget:
        return self._workspace.pages

    @property
    def _workspace(self) -> Workspace:
        key = self._manager.current.plugin.key
        return next(workspace for workspace in self._workspaces if workspace.key == key)

    def _menus(self, workspaces: Sequence[Menus]) -> Iterator[tuple[str, Entries]]:
        """Yield titles and entries; menus that only one workspace has come before Window."""
        connection = self._connection

        def shared(menu: Menu) -> Entries:
            return [entry for menus in workspaces for entry in (SEPARATOR, *menus.get(menu, ()))]

        yield (
            tr("&File"),
            (
                *shared(Menu.FILE),
                SEPARATOR,
                Entry(
                    "preferences", tr("&Preferences…"), self._show_preferences, "Ctrl+,", "settings"
                ),
                SEPARATOR,
                Entry("quit", tr("E&xit"), self.close, QKeySequence.StandardKey.Quit),
            ),
        )
        yield tr("&Edit"), shared(Menu.EDIT)
        yield (
            tr("&Device"),
            (
                Entry("connect", tr("&Connect"), connection.connect_shown, "Ctrl+K", "connect"),
                Entry("disconnect", tr("&Disconnect"), connection.leave, "Ctrl+D", "disconnect"),
                Entry("line", tr("&Line settings…"), self._edit_line_settings, "", "settings"),
                Entry("find", tr("&Find a board…"), connection.find_board, "Ctrl+Shift+F", "find"),
                SEPARATOR,
                Entry("stop", tr("&Stop motors"), self._stop_or_close, "Esc", "stop"),
                *shared(Menu.DEVICE),
            ),
        )
        for menus in workspaces:
            yield from ((own, menus[own]) for own in menus if isinstance(own, str))
        yield tr("&Window"), shared(Menu.WINDOW)
        yield (
            tr("&Help"),
            (
                Entry("help", tr("&Help"), self._show_help, "F1", "help"),
                SEPARATOR,
                *shared(Menu.HELP),
                Entry("report", tr("&Save report for support…"), self._show_report, "", "save"),
                Entry("log_folder", tr("Open &log folder"), self._open_log_folder, "", "open"),
                Entry("about", tr("&About…"), self._show_about, "", "info"),
            ),
        )

    @Slot()
    def _edit_line_settings(self) -> None:
        self._workspace.edit_line_settings()

    # --- Files --------------------------------------------------------------------------

    @Slot(object)
    def _on_dropped(self, paths: Sequence[Path]) -> None:
        self.activateWindow()
        if len(paths) == 1:
            self.open_file(paths[0])
        else:
            text = tr("{0} files were dropped, and none was opened: drop one at a time.")
            self._notifier.error.emit(text.format(len(paths)))

    def open_file(self, path: Path) -> None:
        """Open a file in the workspace that it belongs to, unless another device is connected."""
        if not any(path.suffix.lower() in kind.suffixes for _, kind in self._file_kinds()):
            self._add_all_workspaces()
        kinds = self._file_kinds()
        for key, kind in kinds:
            if path.suffix.lower() in kind.suffixes:
                self._open_in(key, partial(kind.open, path), path.name, kind.name)
                return
        names = "; ".join(f"{kind.name} ({', '.join(sorted(kind.suffixes))})" for _, kind in kinds)
        text = tr("{0} was not opened: its type is not supported. Supported: {1}.")
        self._notifier.error.emit(text.format(path.name, names))

    def _open_in(self, key: str, then: Callable[[], object], name: str, kind: str) -> None:
        if not self._manager.switch_to(key, then):
            text = tr(
                "{0} is {1}. It was not opened, because this window is connected to {2}: "
                "disconnect, then open it again."
            )
            device = self._manager.current.plugin.name
            self._notifier.error.emit(text.format(name, kind, device))

    def open_recent(self, file: RecentFile) -> None:
        """Open a file again where it was opened; one that is gone is taken off the list."""

        def then(is_there: bool) -> None:
            if is_there:
                self._open_again(file)
                return
            self.recent.remove(file)
            text = tr("{0} is no longer there; it was removed from the recent files.")
            self._notifier.error.emit(text.format(file.path))

        in_background(self, file.path.is_file, then, lambda _: None)

    def _open_again(self, file: RecentFile) -> None:
        if all(file.device != workspace.key for workspace in self._workspaces):
            self._add_all_workspaces()
        for workspace in self._workspaces:
            if workspace.key == file.device and file.kind in workspace.openers:
                device = self._manager.controller(workspace.key).plugin.name
                self._open_in(
                    workspace.key,
                    partial(workspace.openers[file.kind], file.path),
                    file.path.name,
                    tr("a file of the {0}").format(device),
                )

    @Slot()
    def _fill_recent(self) -> None:
        menu, files = self._recent_menu, self.recent.entries
        menu.clear()
        for number, file in enumerate(files, start=1):
            text, then = f"&{number} {ui.no_mnemonic(file.title)}", partial(self.open_recent, file)
            action = ui.action(menu, "", text, on_trigger=then)
            action.setToolTip(ui.plain(str(file.path)))
            menu.addAction(action)
        menu.addSeparator()
        clear = menu.addAction(tr("&Clear list"))
        clear.triggered.connect(self.recent.clear, Qt.ConnectionType.QueuedConnection)
        menu.setEnabled(bool(files))

    def _file_kinds(self) -> list[tuple[str, FileKind]]:
        return [(space.key, kind) for space in self._workspaces for kind in space.file_kinds]

    # --- State --------------------------------------------------------------------------

    @Slot()
    def _on_device_changed(self) -> None:
        self._notifier.cleared.emit()
        self._store.set(_DEVICE, self._manager.current.plugin.key)
        self._show_current()

    def _show_current(self) -> None:
        self._stack.setCurrentWidget(self._workspace)
        self._actions["stop"].setText(self._workspace.stop_text)
        for workspace in self._workspaces:
            for entry in entries_of(workspace.menus()):
                self._actions[entry.key].setVisible(workspace is self._workspace)
        for menu_action in self.menuBar().actions():
            if isinstance(menu := menu_action.menu(), QMenu):
                offered = (a.isVisible() and not a.isSeparator() for a in menu.actions())
                menu_action.setVisible(any(offered))
        self._on_actions_changed()

    @Slot()
    def _on_link_changed(self) -> None:
        is_connected = self._manager.current.link is ConnectionState.CONNECTED
        if is_connected and not self._was_connected:
            self._notifier.cleared.emit()
        self._was_connected = is_connected
        self._on_actions_changed()

    @Slot()
    def _on_actions_changed(self) -> None:
        device = self._manager.current
        link = device.link
        is_open = link not in {ConnectionState.DISCONNECTED, ConnectionState.DISCONNECTING}
        enabled_actions = {
            "connect": self._connection.would_connect and link is not ConnectionState.DISCONNECTING,
            "line": link is ConnectionState.DISCONNECTED and device.has_line_settings,
            "disconnect": is_open,
            "stop": is_open or bool(device.unconfirmed_stop),
            **self._workspace.enabled_actions(),
        }
        for key, is_possible in enabled_actions.items():
            self._actions[key].setEnabled(is_possible)
        self.question.reconsider()
        self._show_title()

    def _show_title(self) -> None:
        name, port = self._workspace.device_name, self._manager.current.port
        title = f"{tr('TReX Studio')}[*]"
        if name and port is not None:
            where = tr("{0} on {1}") if port.url else tr("{0} (demo)")
            title = f"{where.format(name, port.url)}[*] – {tr('TReX Studio')}"
        self.setWindowTitle(title)
        self.setWindowModified(self._workspace.has_edits)

    @Slot(object)
    def _on_interruption_wanted(self, then: Callable[[], object]) -> None:
        self.question.ask(
            tr(
                "Settings are still being written. Disconnect anyway? Unwritten settings stay "
                "pending."
            ),
            Answer("disconnectYes", tr("Disconnect"), then),
            still=lambda: self._manager.current.is_busy,
        )

    @Slot(str)
    def _on_stop_reported(self, text: str) -> None:
        self._notifier.delayed_report.emit(text, self._manager.stop_remedies)

    @Slot(str, bool)
    def _log(self, text: str, is_problem: bool) -> None:
        self._workspace.log.add(text, is_problem=is_problem)

    @Slot(object)
    def apply_remedy(self, remedy: Remedy | ConnectWith) -> None:
        """Do what a button in a message offers."""
        match remedy:
            case ConnectWith():
                self._connection.connect_with(remedy)
            case Remedy.FIND:
                self._connection.find_board(at_once=True)
            case Remedy.RECONNECT | Remedy.PLUG_IN:
                self._connection.reconnect()
            case Remedy.CHECK_BOARD:
                self._workspace.trigger("check_board")
            case Remedy.STOP_THEM:
                stop_left_running(self._notifier)
            case Remedy.REPORT:
                self._show_report()
            case Remedy.SET_UP_CRC:
                self._workspace.set_up_crc()

    def _stop_or_close(self) -> None:
        """Stop, or close the dialog in front, which stops only what may be moving."""
        dialog, needs_stop = QApplication.activeWindow(), self._manager.needs_stop
        if needs_stop or not isinstance(dialog, QDialog):
            self._manager.press_stop()
        stays = isinstance(dialog, ReusedDialog) and dialog.stays_on_stop
        if isinstance(dialog, QDialog) and not (needs_stop and stays):
            dialog.reject()

    # --- Appearance, beginning and end --------------------------------------------------

    def _show_preferences(self) -> None:
        from trex_gui.ui.frame.preferences_dialog import PreferencesDialog  # noqa: PLC0415

        dialog = self.findChild(PreferencesDialog)
        if dialog is None:
            dialog = PreferencesDialog(self)
            dialog.language_chosen.connect(self.reopen, Qt.ConnectionType.QueuedConnection)
        dialog.open_preferences()

    @Slot()
    def reopen(self) -> None:
        """Close the window to be opened again, connected as it is; asks what closing asks."""
        is_connected = self._manager.current.link is ConnectionState.CONNECTED
        port = self._manager.current.port if is_connected else None
        self._is_reopening = True
        if self.close():
            self.reopens, self.port_to_reopen = True, port
        self._is_reopening = False

    def _show_help(self) -> None:
        self.show_help(self._topic_in_front())

    @Slot(str)
    def show_help(self, topic: str) -> None:
        """Show a page of the help beside the window, or a section: `page.md#anchor`."""
        from trex_gui.ui.help.dialog import HelpDialog  # noqa: PLC0415 - not at the start

        if self.help_dialog is None:
            self.help_dialog = HelpDialog(self._topic_of)
        self.help_dialog.show_topic(topic)

    def _topic_of(self, message: str) -> str:
        return self._workspace.message_help.topic(message) if self._workspaces else ""

    def _topic_in_front(self) -> str:
        """Return the help on what has the focus, or on the page that is shown."""
        topics = dict(_HELP_TOPICS)
        for workspace in self._workspaces:
            topics |= workspace.help_topics
        widget = QApplication.focusWidget() or QApplication.activeWindow()
        while widget is not None:
            if widget.objectName() in topics:
                return topics[widget.objectName()]
            widget = None if widget.isWindow() else widget.parentWidget()
        page = self.pages.currentWidget()
        name = page.objectName().removesuffix("Area") if page is not None else ""
        return topics.get(name, INDEX)

    def _show_report(self) -> None:
        from trex_gui.ui.frame.report_dialog import ReportDialog  # noqa: PLC0415 - rarely needed

        dialog = self.findChild(ReportDialog) or ReportDialog(self._notifier, self)
        dialog.open_report(self._workspace.report_parts())

    def _open_log_folder(self) -> None:
        folder = log_folder()

        def then(is_there: bool) -> None:
            if not is_there:
                text = tr("There is no log: {0} could not be written.")
            elif not QDesktopServices.openUrl(QUrl.fromLocalFile(str(folder))):
                text = tr("No program of this computer shows folders. The log is in {0}.")
            else:
                return
            self._notifier.error.emit(text.format(folder))

        in_background(self, folder.is_dir, then, lambda _: None)

    def _show_about(self) -> None:
        QMessageBox.about(
            self,
            tr("About TReX Studio"),
            tr(
                "TReX Studio {0}\n\nSet up, calibrate, drive and understand a Pololu TReX or "
                "TReX Jr dual motor controller, and drive an Aracna robot.\n\n"
                "Not a product of Pololu."
            ).format(__version__),
        )

    def _restore(self, added: Workspace) -> None:
        page = self._store.integer(f"{added.key}/page", 0, 0, added.pages.count() - 1)
        added.pages.setCurrentIndex(page)
        added.pages.currentChanged.connect(partial(self._store.set, f"{added.key}/page"))
        for workspace in self._workspaces:
            workspace.take_actions(self._actions)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.windowHandle().visibilityChanged.connect(
            self._on_visibility_changed, Qt.ConnectionType.UniqueConnection
        )

    @Slot()
    def _on_visibility_changed(self) -> None:
        unseen = {QWindow.Visibility.Hidden, QWindow.Visibility.Minimized}
        windows = QGuiApplication.topLevelWindows()
        self.seen_changed.emit(any(window.visibility() not in unseen for window in windows))

    def closeEvent(self, event: QCloseEvent) -> None:
        if self._manager.is_armed:  # whatever is asked first, and however long the answer takes
            self._manager.stop_because(tr("The window was to be closed"))
        if not self._warning.given and not all(
            workspace.may_close(self.reopen if self._is_reopening else self.close)
            for workspace in self._workspaces
        ):
            event.ignore()
            return
        state = self.saveState()
        self._manager.shut_down()
        if self._warning.is_due:
            event.ignore()
            self._warning.give()
            return
        self._store.set("window/state", state)
        for workspace in self._workspaces:
            workspace.prepare_to_close()
        self._connection.close_dialogs()
        if self.help_dialog is not None:
            self.help_dialog.close()
        save_geometry(self, "window")
        for workspace in self._workspaces:
            workspace.finish()
        super().closeEvent(event)


class EscapeWatch(QObject):
    """Event filter that stops on Esc before any widget gets the key.

    Modal dialogs block a shortcut, and editors in a table consume the key. The filter is on the
    native windows, so only their events pass through Python.

    Esc that closes a dialog, a question, a menu, a list or an editor in a table is no stop while
    nothing can be moving; otherwise it does both.
    """

    def __init__(
        self, app: QGuiApplication, device_manager: DeviceManager, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._manager = device_manager
        app.focusWindowChanged.connect(self._on_focus_window_changed)
        self._on_focus_window_changed(app.focusWindow())

    @Slot(QWindow)
    def _on_focus_window_changed(self, window: QWindow | None) -> None:
        if window is not None:
            window.removeEventFilter(self)
            window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        del watched
        if not isinstance(event, QKeyEvent) or event.key() != Qt.Key.Key_Escape:
            return False
        if event.type() == QEvent.Type.ShortcutOverride and _is_closed_by_escape():
            event.accept()  # it comes as a key press, not as the shortcut of the menu
            return True
        is_pressed = event.type() == QEvent.Type.KeyPress and not event.isAutoRepeat()
        closes = _is_closed_by_escape() or isinstance(QApplication.activeWindow(), QDialog)
        if is_pressed and (not closes or self._manager.needs_stop):
            self._manager.press_stop()
        return False


def _is_closed_by_escape() -> bool:
    """Whether a menu, a list, a question or an editor in a table is open, which Esc closes."""
    if QApplication.activePopupWidget() is not None:
        return True
    focus = QApplication.focusWidget()
    parent = None if focus is None or focus.isWindow() else focus.parentWidget()
    while parent is not None and not isinstance(parent, QAbstractItemView | InlinePrompt):
        parent = None if parent.isWindow() else parent.parentWidget()
    return parent is not None


class UnconfirmedStopWarning(QObject):
    """Warns in the window about an unconfirmed stop when the window is closed.

    It does not block, so that anything else can still end the program. A stop that is confirmed
    after all closes the window, and so does closing it again. There is no warning on log-out.
    """

    def __init__(
        self, device_manager: DeviceManager, question: InlinePrompt, window: QWidget
    ) -> None:
        super().__init__(window)
        self._manager = device_manager
        self._question = question
        self._window = window
        self.given = False  # whether it is shown; closing the window then needs no other question
        self._log_out_at: float | None = None
        app = QApplication.instance()
        if isinstance(app, QApplication):
            app.commitDataRequest.connect(self.note_log_out)

    @property
    def is_due(self) -> bool:
        """Whether the window, with every line closed, must not close without it."""
        is_log_out = self._log_out_at is not None and now() - self._log_out_at < _LOG_OUT_S
        return bool(self._manager.unconfirmed_stop) and not self.given and not is_log_out

    @Slot()
    def note_log_out(self) -> None:
        self._log_out_at = now()

    def give(self) -> None:
        text = self._manager.unconfirmed_stop
        self.given = True
        self._window.setWindowState(self._window.windowState() & ~Qt.WindowState.WindowMinimized)
        self._window.activateWindow()
        self._question.ask(
            text,
            Answer("closeUnstopped", tr("Close the window"), self._window.close),
            still=lambda: self._manager.unconfirmed_stop == text,
            otherwise=self._on_over,
        )

    def _on_over(self) -> None:
        if self._manager.is_idle and not self._manager.unconfirmed_stop:
            QTimer.singleShot(0, self._window.close)
        else:
            self.given = False
