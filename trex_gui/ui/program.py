"""Main window and its models, built from device plugins."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QEvent

from trex_gui.core.plugin import DevicePlugin
from trex_gui.core.timing import Timeouts
from trex_gui.ui.devices.auto_connect import AutoConnect
from trex_gui.ui.devices.device_manager import Controller, DeviceManager
from trex_gui.ui.devices.ports import Ports
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.files import end_background
from trex_gui.ui.frame.main_window import MainWindow, last_device
from trex_gui.ui.frame.workspace import FileKind, Workspace
from trex_gui.ui.last_run import report_last_run
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.plotting.page import PlotPage
from trex_gui.ui.workers.threads import have_orphans_ended

_FILES_TIMEOUT_MS = 5000  # time to finish saving on a slow disk


class Program:
    def __init__(self, plugins: Sequence[DevicePlugin], timeouts: Timeouts | None = None) -> None:
        self.plugins = tuple(plugins)
        self.timeouts = timeouts or Timeouts()
        self._notifier = notifier = Notifier()
        self.ports = Ports(plugins)
        self._scanner = scanner = DeviceScanner(plugins, timeouts=self.timeouts)
        last = last_device()
        factories = {
            plugin.key: partial(self._create_controller, plugin)
            for plugin in sorted(plugins, key=lambda plugin: plugin.key != last)
        }
        self.device_manager = manager = DeviceManager(factories, scanner)
        # Connect these slots before the window's slots, which need the workspace.
        manager.changed.connect(self._add_current_workspace)
        manager.current_changed.connect(self._add_current_workspace)
        self._workspaces: dict[str, Workspace] = {}
        self._is_complete = False
        self.window = MainWindow(manager, self.ports, notifier, lambda: self.workspaces)
        self._add_workspace(manager.current)

        self.auto_connect = AutoConnect(self.ports, manager, notifier, manager)

    def _create_controller(self, plugin: DevicePlugin) -> Controller:
        create: Callable[..., Controller] = plugin.controller.load()
        return create(plugin, self._notifier, self.ports, self._scanner, self.timeouts)

    def _add_workspace(self, controller: Controller) -> Workspace:
        plugin = controller.plugin
        workspace: Workspace = plugin.workspace.load()(controller, self.window)
        self._workspaces[plugin.key] = workspace
        self.window.add_workspace(workspace)
        return workspace

    def complete(self) -> None:
        """Create the missing pages. Call this after the window has been painted."""
        self._is_complete = True
        self._add_current_workspace()

    def _add_current_workspace(self) -> None:
        if not self._workspaces:  # the window is still being created
            return
        workspace = self.workspace(self.device_manager.current.plugin.key)
        if self._is_complete:
            workspace.create_pages()

    def create_plots(self) -> None:
        for workspace in self._workspaces.values():
            for page in workspace.findChildren(PlotPage):
                page.ensure_plot()

    def workspace(self, device: str) -> Workspace:
        existing = self._workspaces.get(device)
        return existing or self._add_workspace(self.device_manager.controller(device))

    @property
    def workspaces(self) -> Mapping[str, Workspace]:
        """Workspaces by plugin key. Creates missing workspaces."""
        return {plugin.key: self.workspace(plugin.key) for plugin in self.plugins}

    def connect_to_demo(self, device: str) -> None:
        self.device_manager.connect_to(self.ports.demo_of(device))

    def connect_to_port(self, url: str, device: str | None = None) -> None:
        """Connect to a port. If `device` is given, assign the port to this plugin first."""
        port = self.ports.add_typed(url)
        if device is not None:
            port = self.ports.assign(port, device)
        self.device_manager.connect_to(port)

    def open_file(self, path: Path, *, connecting: bool) -> None:
        """Open a file from the command line in the workspace for its type.

        `connecting`: a connection has been started. A kind with `open_offline` then waits for its
        device. So does the error for a file of another device, because a connection clears errors.
        """
        key, kind = self._file_kind(path)
        is_current = key == self.device_manager.current.plugin.key
        if kind.open_offline is not None:
            if connecting and is_current:
                self.device_manager.when_connected(lambda: kind.open(path))
            else:
                kind.open_offline(path)
        elif connecting and not is_current:
            self.device_manager.when_connected(lambda: self.window.files.open_file(path))
        else:
            self.window.files.open_file(path)

    def _file_kind(self, path: Path) -> tuple[str, FileKind]:
        workspaces = self.workspaces.items()
        kinds = [(key, kind) for key, workspace in workspaces for kind in workspace.file_kinds]
        suffix = path.suffix.lower()
        return next((item for item in kinds if suffix in item[1].suffixes), kinds[0])

    def report_last_run(self, *, has_crashed: bool = False) -> None:
        """Report running boards, stops by the guardian, or a crash.

        Boards and stops are reported again whenever a connection clears the messages.
        """
        report_last_run(self._notifier, has_crashed=has_crashed)
        self._notifier.cleared.connect(partial(report_last_run, self._notifier))

    def shut_down(self) -> bool:
        """Stop the motors, close the line, and end recordings.

        Return whether all threads have ended. Qt aborts if a running thread is destroyed.
        """
        results = [self.device_manager.shut_down()]
        results += [workspace.shut_down() for workspace in self._workspaces.values()]
        results.append(end_background(_FILES_TIMEOUT_MS))
        return all(results) and have_orphans_ended()

    def close(self) -> bool:
        """Shut down and destroy everything. Requires a running event loop.

        Return whether all threads have ended. Otherwise nothing is destroyed, and the process
        must exit with `os._exit`.
        """
        if not self.shut_down():
            return False
        self.destroy()
        return True

    def destroy(self) -> None:
        """Destroy the window and its models. Call `shut_down` first.

        Without this call, Qt crashes at exit, because the interpreter destroys the objects in
        arbitrary order and after disabling their event handlers.
        """
        for workspace in self._workspaces.values():
            workspace.prepare_to_close()
            workspace.finish()
        manager = self.device_manager
        models = (manager, *manager.controllers, manager.scanner, self.ports, self._notifier)
        for item in (self.window.help_dialog, self.window, *models):
            if item is not None:
                item.deleteLater()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)

    def end(self) -> None:
        self.device_manager.shut_down()
        QCoreApplication.exit(0)
