"""Main window: connection bar, messages, workspaces, menus."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtGui import QAction, QCloseEvent, QGuiApplication, QKeySequence, QShowEvent, QWindow
from PySide6.QtWidgets import QApplication, QMainWindow, QMenu, QStackedWidget, QTabWidget, QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.device_manager import DeviceManager
from trex_gui.ui.devices.ports import Ports
from trex_gui.ui.frame.connection_bar import ConnectionBar
from trex_gui.ui.frame.files import FileOpener
from trex_gui.ui.frame.search_field import SearchField
from trex_gui.ui.frame.stopping import EscapeWatch, UnconfirmedStopWarning, stop_or_close_dialog
from trex_gui.ui.frame.workspace import (
    SEPARATOR,
    Entries,
    Entry,
    Menu,
    Menus,
    Workspace,
    entries_of,
    fill_menu_bar,
    menu_findables,
)
from trex_gui.ui.help.messages import focused_topic
from trex_gui.ui.help.pages import INDEX, help_findables
from trex_gui.ui.help.search import Findable
from trex_gui.ui.last_run import stop_running_boards
from trex_gui.ui.notifier import ConnectWith, Notifier, Remedy
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.theme.icons import application_icon
from trex_gui.ui.theme.theme import restore_choices
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import EnterWatch
from trex_gui.ui.widgets.messages import Banner, InlinePrompt, MessageSpace
from trex_gui.ui.widgets.placement import fit_on_screen, restore_geometry, save_geometry

if TYPE_CHECKING:
    from trex_gui.ui.help.dialog import HelpDialog

HELP_TOPICS = {
    "findDialog": "connecting.md#find",
    "preferencesDialog": "window.md#preferences",
    "reportDialog": "traffic.md#report-for-support",
    "helpDialog": INDEX,
}

_DEVICE = "window/device"


def last_device() -> str:
    """Return the key of the device whose workspace was last visible. Empty at the first start."""
    return Preferences().text(_DEVICE)


class MainWindow(QMainWindow):
    visibility_changed = Signal(bool)  # True if a window of the program is visible

    def __init__(
        self,
        device_manager: DeviceManager,
        ports: Ports,
        notifier: Notifier,
        add_all_workspaces: Callable[[], object],
    ) -> None:
        """`add_all_workspaces`: adds the workspaces of devices that have not been used yet."""
        super().__init__()
        restore_choices()  # before fonts are measured
        self.setObjectName("mainWindow")
        self.setWindowTitle(tr("TReX Studio"))
        self.setWindowIcon(application_icon())
        self._manager = device_manager
        self.ports = ports
        self._notifier = notifier
        self._store = Preferences()
        frame = QWidget(self)
        self.question = InlinePrompt(frame)  # questions of the window and the workspaces
        self.connection = bar = ConnectionBar(
            device_manager, ports, lambda: self._workspace.device_name, self.question
        )
        self._search = SearchField(self.findables, bar)
        tip = tr("Help")
        button = ui.tool_button(bar, "helpButton", icon="help", accessible=tip, tip=tip)
        button.clicked.connect(self._show_help)
        bar.row.addWidget(self._search, 3)
        bar.row.addWidget(button)
        self.stack = QStackedWidget(frame)
        self._banner = banner = Banner(frame, notifier, self._topic_of)
        banner.chosen.connect(self.apply_remedy)
        banner.help_requested.connect(self.show_help)
        messages = MessageSpace(frame, self.question, banner, floats=True)
        self._bars = QStackedWidget(frame)
        parts = self.connection, (self.stack, 1), messages, self._bars
        ui.column(*parts, into=frame, margins=0, spacing=0)
        self.setCentralWidget(frame)
        bar.button.setFocus()
        self._workspaces: tuple[Workspace, ...] = ()
        self._actions: dict[str, QAction] = {}
        self._current_menus: list[QMenu] = []
        self.help_dialog: HelpDialog | None = None
        self._was_connected = False
        self._warning = UnconfirmedStopWarning(device_manager, self.question, self)
        self.files = FileOpener(
            device_manager, notifier, lambda: self._workspaces, add_all_workspaces, self
        )

    def add_workspace(self, workspace: Workspace) -> None:
        is_first = not self._workspaces
        self._workspaces += (workspace,)
        self.stack.addWidget(workspace)
        self._bars.addWidget(workspace.bar)
        for dock in workspace.docks:
            if is_first or not self.restoreDockWidget(dock):
                self.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
        workspace.actions_changed.connect(self._on_actions_changed)
        self._fill_menus()
        if is_first:
            self._connect()
            restore_geometry(self, "window", 1100, 760)
            fit_on_screen(self)
            self.restoreState(self._store.data("window/state"))
        page_key = f"{workspace.key}/page"
        workspace.show_saved(self._store.text(page_key))
        workspace.page_changed.connect(partial(self._store.set, page_key))
        for added in self._workspaces:
            added.set_actions(self._actions)
        self._show_current()

    def _fill_menus(self) -> None:
        for replaced in (*self._actions.values(), *self._current_menus):
            replaced.setObjectName("")
            replaced.deleteLater()
        self.menuBar().clear()
        self._actions = fill_menu_bar(
            self, self._menus([workspace.menus() for workspace in self._workspaces])
        )
        menus = (action.menu() for action in self.menuBar().actions())
        self._current_menus = [menu for menu in menus if isinstance(menu, QMenu)]
        preferences = self._actions["preferences"]
        preferences.setMenuRole(QAction.MenuRole.PreferencesRole)
        self._current_menus[0].insertMenu(preferences, self.files.recent_menu)
        # These actions work in every window of the program.
        for key in ("stop", "help", "search"):
            self._actions[key].setShortcutContext(Qt.ShortcutContext.ApplicationShortcut)
        self._actions["stop"].setAutoRepeat(False)  # Esc may still be held after it closed a menu

    def _connect(self) -> None:
        for signal in (self.connection.connecting, self.connection.choice_changed):
            signal.connect(self._notifier.cleared)
        self.connection.choice_changed.connect(self._on_actions_changed)
        self.connection.line_settings_requested.connect(self._edit_line_settings)
        self.connection.remedy_chosen.connect(self.apply_remedy)
        self._manager.changed.connect(self._on_link_changed)
        self._manager.current_changed.connect(self._on_device_changed)
        self._manager.stop_reported.connect(self._on_stop_reported)
        self._notifier.logged.connect(self._on_logged)
        app = QApplication.instance()
        if isinstance(app, QApplication):
            self._enter = EnterWatch(app, self)
            self._escape = EscapeWatch(app, self._manager, self)

    @property
    def pages(self) -> QTabWidget:
        return self._workspace.pages

    @property
    def _workspace(self) -> Workspace:
        key = self._manager.current.plugin.key
        return next(workspace for workspace in self._workspaces if workspace.key == key)

    def _menus(self, workspaces: Sequence[Menus]) -> Iterator[tuple[str, Entries]]:
        """Yield the title and the entries of each menu.

        The menus of a single workspace precede the Window menu.
        """
        bar, stop = self.connection, partial(stop_or_close_dialog, self._manager)

        def shared(menu: Menu) -> Entries:
            return [entry for menus in workspaces for entry in (SEPARATOR, *menus.get(menu, ()))]

        file = (
            *shared(Menu.FILE),
            SEPARATOR,
            Entry("preferences", tr("&Preferences…"), self._show_preferences, "Ctrl+,", "settings"),
            SEPARATOR,
            Entry("quit", tr("E&xit"), self.close, QKeySequence.StandardKey.Quit),
        )
        device = (
            Entry("connect", tr("&Connect"), bar.connect_shown, "Ctrl+Shift+K", "connect"),
            Entry("disconnect", tr("&Disconnect"), bar.disconnect_device, "Ctrl+D", "disconnect"),
            Entry("line", tr("&Line settings…"), self._edit_line_settings, "", "settings"),
            Entry("find", tr("&Find a board…"), bar.find_board, "Ctrl+Shift+F", "find"),
            SEPARATOR,
            Entry("stop", tr("&Stop motors"), stop, "Esc", "stop"),
            *shared(Menu.DEVICE),
        )
        about = partial(self.show_help, f"{INDEX}#about")
        help_ = (
            Entry("search", tr("Search every&thing"), self._search.start, "Ctrl+K", "find"),
            Entry("help", tr("&Help"), self._show_help, "F1", "help"),
            SEPARATOR,
            *shared(Menu.HELP),
            Entry("report", tr("&Save report for support…"), self._show_report, "", "save"),
            Entry("about", tr("&About"), about, "", "info"),
        )
        yield from ((tr("&File"), file), (tr("&Edit"), shared(Menu.EDIT)), (tr("&Device"), device))
        for menus in workspaces:
            yield from ((title, menus[title]) for title in menus if isinstance(title, str))
        yield from ((tr("&Window"), shared(Menu.WINDOW)), (tr("&Help"), help_))

    @Slot()
    def _edit_line_settings(self) -> None:
        self._workspace.edit_line_settings()

    # --- State --------------------------------------------------------------------------

    @Slot()
    def _on_device_changed(self) -> None:
        self._notifier.cleared.emit()
        self._store.set(_DEVICE, self._manager.current.plugin.key)
        self._show_current()

    def _show_current(self) -> None:
        self.stack.setCurrentWidget(self._workspace)
        self._bars.setCurrentWidget(self._workspace.bar)
        tabs = self.pages
        pages = (tabs.widget(index) for index in range(tabs.count()))
        below = self._banner, self.question, self._workspace.bar
        ui.tab_order(tabs.tabBar(), *(page for page in pages if page), *below)
        self._actions["stop"].setText(self._workspace.stop_text)
        for workspace in self._workspaces:
            for entry in entries_of(workspace.menus()):
                self._actions[entry.key].setVisible(workspace is self._workspace)
        for menu_action in self.menuBar().actions():
            if isinstance(menu := menu_action.menu(), QMenu):
                entries = (a for a in menu.actions() if a.isVisible() and not a.isSeparator())
                menu_action.setVisible(any(entries))
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
            "connect": self.connection.would_connect and link is not ConnectionState.DISCONNECTING,
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
            device = tr("{0} on {1}") if port.url else tr("{0} (demo)")
            title = f"{device.format(name, port.url)}[*] – {tr('TReX Studio')}"
        self.setWindowTitle(title)
        self.setWindowModified(self._workspace.has_edits)

    @Slot(str)
    def _on_stop_reported(self, text: str) -> None:
        self._notifier.delayed_report.emit(text, self._manager.stop_remedies)

    @Slot(str, bool)
    def _on_logged(self, text: str, is_problem: bool) -> None:
        self._workspace.log.add(text, is_problem=is_problem)

    @Slot(object)
    def apply_remedy(self, remedy: Remedy | ConnectWith) -> None:
        match remedy:
            case ConnectWith():
                self.connection.connect_with(remedy)
            case Remedy.FIND:
                self.connection.find_board(at_once=True)
            case Remedy.RECONNECT | Remedy.PLUG_IN:
                self.connection.reconnect()
            case Remedy.CHECK_BOARD:
                self._workspace.trigger("check_board")
            case Remedy.STOP_MOTORS:
                stop_running_boards(self._notifier)
            case Remedy.REPORT:
                self._show_report()
            case Remedy.SET_UP_CRC:
                self._workspace.set_up_crc()

    # --- Dialogs, search, showing and closing -------------------------------------------

    def _show_preferences(self) -> None:
        from trex_gui.ui.frame.preferences_dialog import PreferencesDialog  # noqa: PLC0415

        dialog = self.findChild(PreferencesDialog) or PreferencesDialog(self)
        dialog.open_preferences()

    def _show_help(self) -> None:
        topics = dict(HELP_TOPICS)
        for workspace in self._workspaces:
            topics |= workspace.help_topics
        page = self._workspace.page_at(self._workspace.current)
        self.show_help(focused_topic(topics, page))

    @Slot(str)
    def show_help(self, topic: str) -> None:
        """Show a help page or a section (`page.md#anchor`) beside the window."""
        from trex_gui.ui.help.dialog import HelpDialog  # noqa: PLC0415 - not needed at startup

        if self.help_dialog is None:
            self.help_dialog = HelpDialog()
        self.help_dialog.show_topic(topic)

    def findables(self) -> Iterator[Findable]:
        yield from self._workspace.findables()
        pages = {entry.key for entry in entries_of({"": self._workspace.page_entries()})}
        yield from menu_findables(self, pages, self._workspace.motion_keys)
        yield from help_findables(self._workspace.message_help.headings(), self.show_help)

    def _topic_of(self, message: str) -> str:
        return self._workspace.message_help.topic(message) if self._workspaces else ""

    def _show_report(self) -> None:
        from trex_gui.ui.frame.report_dialog import ReportDialog  # noqa: PLC0415 - rarely needed

        dialog = self.findChild(ReportDialog) or ReportDialog(self._notifier, self)
        dialog.open_report(self._workspace.report_parts())

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.windowHandle().visibilityChanged.connect(
            self._on_visibility_changed, Qt.ConnectionType.UniqueConnection
        )

    @Slot()
    def _on_visibility_changed(self) -> None:
        hidden = {QWindow.Visibility.Hidden, QWindow.Visibility.Minimized}
        windows = QGuiApplication.topLevelWindows()
        self.visibility_changed.emit(any(window.visibility() not in hidden for window in windows))

    def closeEvent(self, event: QCloseEvent) -> None:
        if self._manager.is_armed:  # stop before asking the user anything
            self._manager.stop_because(tr("The window is closing"))
        if not self._warning.is_shown and not all(
            workspace.may_close(self.close) for workspace in self._workspaces
        ):
            event.ignore()
            return
        state = self.saveState()
        self._manager.shut_down()
        if self._warning.is_due:
            event.ignore()
            self._warning.show()
            return
        self._store.set("window/state", state)
        for workspace in self._workspaces:
            workspace.prepare_to_close()
        self.connection.close_dialogs()
        if self.help_dialog is not None:
            self.help_dialog.close()
        save_geometry(self, "window")
        for workspace in self._workspaces:
            workspace.finish()
        super().closeEvent(event)
