"""Models and controllers of a program, by device."""

from dataclasses import replace
from typing import NamedTuple

from trex_gui.composition import PLUGINS
from trex_gui.core.plugin import DevicePlugin
from trex_gui.core.timing import Timeouts
from trex_gui.devices.aracna.model.controller import AracnaController
from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.plugin import ARACNA
from trex_gui.devices.aracna.views.workspace import AracnaWorkspace
from trex_gui.devices.trex.model.controller import TrexController
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.plugin import TREX
from trex_gui.devices.trex.views.workspace import TrexWorkspace
from trex_gui.ui.devices.ports import Ports
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.program import Program


class TrexParts(NamedTuple):
    controller: TrexController
    device: Device
    workspace: TrexWorkspace


class AracnaParts(NamedTuple):
    controller: AracnaController
    robot: Robot
    library: Library
    workspace: AracnaWorkspace


def trex(program: Program) -> TrexParts:
    """Return the objects of a program for the TReX."""
    controller, workspace = program.device_manager.controller(TREX.key), program.workspace(TREX.key)
    assert isinstance(controller, TrexController)
    assert isinstance(workspace, TrexWorkspace)
    return TrexParts(controller, controller.device, workspace)


def aracna(program: Program) -> AracnaParts:
    """Return the objects of a program for the Aracna."""
    controller, workspace = (
        program.device_manager.controller(ARACNA.key),
        program.workspace(ARACNA.key),
    )
    assert isinstance(controller, AracnaController)
    assert isinstance(workspace, AracnaWorkspace)
    return AracnaParts(controller, controller.robot, workspace.library, workspace)


def new_ports() -> Ports:
    """Return the port list of a program with every device."""
    return Ports(PLUGINS)


def new_controller(ports: Ports | None = None) -> TrexController:
    """Return a TReX controller with its own scanner, without a window."""
    scanner = DeviceScanner([TREX])
    return TrexController(TREX, Notifier(), ports or new_ports(), scanner, Timeouts())


def scanner_of(controller: TrexController) -> DeviceScanner:
    """Return the scanner that a controller shares with other controllers."""
    return controller._scanner


def new_plugin(key: str, name: str) -> DevicePlugin:
    """Return a plugin without commands that is otherwise the TReX plugin."""
    return replace(TREX, key=key, name=name, commands={})
