"""Main window: connection bar, notifications, workspace of the device in use, menus."""

from collections.abc import Callable, Sequence
from pathlib import Path

from PySide6.QtCore import QByteArray, QSettings, Qt, QUrl, Slot
from PySide6.QtGui import QCloseEvent, QDesktopServices
from PySide6.QtWidgets import (
    QApplication,
    QDialog,
    QDialogButtonBox,
    QMainWindow,
    QMenu,
    QMessageBox,
    QStackedWidget,
    QTabWidget,
    QTextBrowser,
    QVBoxLayout,
    QWidget,
)

from trex_gui import __version__
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.devices.device_manager import DeviceManager
from trex_gui.ui.devices.ports import Ports
from trex_gui.ui.frame.actions import build_menus
from trex_gui.ui.frame.connection_bar import ConnectionBar
from trex_gui.ui.frame.stopping import EscapeWatch, UnconfirmedStopWarning
from trex_gui.ui.frame.workspace import Workspace
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.theme.icons import application_icon
from trex_gui.ui.theme.theme import Scheme, theme
from trex_gui.ui.widgets.banner import Banner
from trex_gui.ui.widgets.file_drop import AnyFileDrop
from trex_gui.ui.widgets.inline_prompt import InlinePrompt, PromptAnswer

_SCHEMES: tuple[Scheme, ...] = ("system", "light", "dark")


class MainWindow(QMainWindow):
    """Shows the workspace of the device that is connected, or was last; knows no device itself."""

    def __init__(
        self,
        device_manager: DeviceManager,
        ports: Ports,
        notifier: Notifier,
        parent: QWidget | None = None,
    ) -> None:
        """Make an empty frame; `add_workspaces` fills it."""
        super().__init__(parent)
        self.setObjectName("mainWindow")
        self.setWindowTitle(self.tr("TReX Studio"))
        self.setWindowIcon(application_icon())
        self._manager = device_manager
        self._notifier = notifier
        self._store = QSettings(self)
        frame = QWidget(self)
        self._banner = Banner(frame, notifier)
        self._connection = ConnectionBar(device_manager, ports, frame)
        self.question = InlinePrompt(frame)
        self._stack = QStackedWidget(frame)
        rows = QVBoxLayout(frame)
        for widget in (self._connection, self._banner, self.question):
            rows.addWidget(widget)
        rows.addWidget(self._stack, 1)
        self.setCentralWidget(frame)
        self._workspaces: tuple[Workspace, ...] = ()
        self._help = HelpDialog(self)
        self._warning = UnconfirmedStopWarning(device_manager, self.question, self)
        # After the event: a question about the file must not block the program it comes from.
        drop = AnyFileDrop(self)
        drop.dropped.connect(self._on_dropped, Qt.ConnectionType.QueuedConnection)

    def add_workspaces(self, workspaces: Sequence[Workspace]) -> None:
        """Add a workspace for each kind of device, and fill the menus; once."""
        self._workspaces = tuple(workspaces)
        for workspace in workspaces:
            self._stack.addWidget(workspace)
            for dock in workspace.docks:
                self.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
            workspace.actions_changed.connect(self._on_actions_changed)
        slots = self._slots()
        for workspace in workspaces:
            slots |= workspace.slots()
        self._actions = build_menus(self, slots, [workspace.menus() for workspace in workspaces])

        self._connection.connecting.connect(self._notifier.cleared)
        self._connection.line_settings_requested.connect(self._edit_line_settings)
        self._connection.interruption_wanted.connect(self._on_interruption_wanted)
        self._manager.changed.connect(self._on_actions_changed)
        self._manager.current_changed.connect(self._on_device_changed)
        self._manager.stop_reported.connect(self._notifier.delayed_error)
        theme().changed.connect(self._on_theme_changed)
        app = QApplication.instance()
        if isinstance(app, QApplication):
            self._escape = EscapeWatch(app, self._manager.press_stop, self)
        self._restore()
        self._on_device_changed()
        self._on_theme_changed()

    @property
    def pages(self) -> QTabWidget:
        """The pages of the workspace that is shown, in the order of their tabs."""
        return self._workspace.pages

    @property
    def _workspace(self) -> Workspace:
        key = self._manager.current.plugin.key
        return next(workspace for workspace in self._workspaces if workspace.key == key)

    def _slots(self) -> dict[str, Callable[[], object]]:
        """Return what each action of the frame does."""
        return {
            "quit": self.close,
            "connect": self._connection.connect_shown,
            "disconnect": self._connection.leave,
            "line": self._edit_line_settings,
            "find": self._connection.find_board,
            "stop": self._manager.press_stop,
            **{scheme: self._scheme_chooser(scheme) for scheme in _SCHEMES},
            "guide": self._show_help,
            "about": self._show_about,
        }

    @Slot()
    def _edit_line_settings(self) -> None:
        self._workspace.edit_line_settings()

    # --- Files --------------------------------------------------------------------------

    @Slot(object)
    def _on_dropped(self, paths: tuple[Path, ...]) -> None:
        self.activateWindow()
        if len(paths) == 1:
            self.open_file(paths[0])
        else:
            text = self.tr("{0} files were dropped, and none was opened: drop one at a time.")
            self._notifier.error.emit(text.format(len(paths)))

    def open_file(self, path: Path) -> None:
        """Open a file in the workspace that it belongs to, unless another device is connected."""
        suffix = path.suffix.lower()
        for workspace in self._workspaces:
            for kind in workspace.file_kinds:
                if suffix in kind.suffixes:
                    if self._manager.switch_to(workspace.key):
                        kind.open(path)
                    else:
                        self._notifier.error.emit(self._why_elsewhere(path, kind.name))
                    return
        kinds = [kind for workspace in self._workspaces for kind in workspace.file_kinds]
        names = "; ".join(f"{kind.name} ({', '.join(sorted(kind.suffixes))})" for kind in kinds)
        text = self.tr("{0} was not opened: nothing here opens such files. What can be: {1}.")
        self._notifier.error.emit(text.format(path.name, names))

    def _why_elsewhere(self, path: Path, what: str) -> str:
        return self.tr(
            "{0} is {1}. It was not opened, because this window is connected to {2}: disconnect, "
            "then drop the file again."
        ).format(path.name, what, self._manager.current.plugin.name)

    # --- State --------------------------------------------------------------------------

    @Slot()
    def _on_device_changed(self) -> None:
        """Show the workspace of the device in use, and its menu entries."""
        self._stack.setCurrentWidget(self._workspace)
        self._actions["stop"].setText(self._workspace.stop_text)
        self._actions["guide"].setText(self._workspace.help_title)
        self._help.close()
        for workspace in self._workspaces:
            for key in workspace.slots():
                self._actions[key].setVisible(workspace is self._workspace)
        for menu_action in self.menuBar().actions():
            if isinstance(menu := menu_action.menu(), QMenu):
                offered = (a.isVisible() and not a.isSeparator() for a in menu.actions())
                menu_action.setVisible(any(offered))
        self._notifier.cleared.emit()
        self._on_actions_changed()

    @Slot()
    def _on_actions_changed(self) -> None:
        """Enable the actions that can be done now."""
        device = self._manager.current
        link = device.link
        enabled_actions = {
            "connect": link is ConnectionState.DISCONNECTED,
            "line": link is ConnectionState.DISCONNECTED and device.has_line_settings,
            "disconnect": link not in {ConnectionState.DISCONNECTED, ConnectionState.DISCONNECTING},
            "stop": link
            in {
                ConnectionState.CONNECTING,
                ConnectionState.CONNECTED,
                ConnectionState.NOT_RESPONDING,
            },
            **self._workspace.enabled_actions(),
        }
        for key, is_possible in enabled_actions.items():
            self._actions[key].setEnabled(is_possible)
        self.question.reconsider()

    @Slot(object)
    def _on_interruption_wanted(self, then: Callable[[], object]) -> None:
        """Ask before the writing of settings is interrupted."""
        self.question.ask(
            self.tr(
                "Settings are still being written. Disconnect anyway? Unwritten settings stay "
                "pending."
            ),
            PromptAnswer("disconnectYes", self.tr("Disconnect"), then),
            still=lambda: self._manager.current.is_busy,
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

    def _show_help(self) -> None:
        workspace = self._workspace
        if workspace.help_url:
            QDesktopServices.openUrl(QUrl(workspace.help_url))
        else:
            self._help.show_text(workspace.help_title, workspace.help_text)

    def _show_about(self) -> None:
        QMessageBox.about(
            self,
            self.tr("About TReX Studio"),
            self.tr(
                "TReX Studio {0}\n\nSet up, calibrate, drive and understand a Pololu TReX or "
                "TReX Jr dual motor controller, and drive an Aracna robot.\n\n"
                "Not a product of Pololu."
            ).format(__version__),
        )

    def _restore(self) -> None:
        geometry = self._store.value("window/geometry")
        if not isinstance(geometry, QByteArray) or not self.restoreGeometry(geometry):
            self.resize(1100, 760)
        state = self._store.value("window/state")
        if isinstance(state, QByteArray):
            self.restoreState(state)
        for workspace in self._workspaces:
            workspace.take_actions(self._actions)
        wanted = self._store.value("window/scheme", "system")
        for scheme in _SCHEMES:
            if scheme == wanted and scheme != theme().choice:
                theme().set_scheme(scheme)

    def closeEvent(self, event: QCloseEvent) -> None:
        if not self._warning.given and not all(
            workspace.may_close(self.close) for workspace in self._workspaces
        ):
            event.ignore()
            return
        state = self.saveState()
        self._manager.shut_down()
        if self._warning.is_due:
            event.ignore()
            self._warning.give()
            return
        self._store.setValue("window/state", state)
        for workspace in self._workspaces:
            workspace.prepare_to_close()
        self._connection.close_dialogs()
        self._help.close()
        self._store.setValue("window/geometry", self.saveGeometry())
        for workspace in self._workspaces:
            workspace.finish()
        super().closeEvent(event)


class HelpDialog(QDialog):
    """Help beside the window, so that it can be tried while it is read."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("helpDialog")
        self.resize(560, 620)
        self._shown = ""
        self._text = QTextBrowser(self)
        self._text.setObjectName("helpText")
        self._text.setAccessibleName(self.tr("Help"))
        self._text.setOpenExternalLinks(True)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close, self)
        close = buttons.button(QDialogButtonBox.StandardButton.Close)
        close.setObjectName("helpClose")

        layout = QVBoxLayout(self)
        layout.addWidget(self._text, 1)
        layout.addWidget(buttons)

        buttons.rejected.connect(self.close)

    def show_text(self, title: str, text: str) -> None:
        """Show rich text; `title` as a menu names it."""
        title = title.replace("&", "").removesuffix("…")
        self.setWindowTitle(title)
        if text != self._shown:  # else it keeps its scroll position
            self._text.setHtml(text)
            self._shown = text
        self.show()
        self.activateWindow()
        self._text.setFocus(Qt.FocusReason.PopupFocusReason)
