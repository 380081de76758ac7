"""Every registered device is complete."""

import click
import pytest

from trex_gui.composition import PLUGINS
from trex_gui.core.discovery.prober import ProberInfo
from trex_gui.core.plugin import DevicePlugin, PortReports
from trex_gui.core.simulator.plugin import SimulatorPlugin


@pytest.mark.parametrize("plugin", PLUGINS, ids=lambda plugin: plugin.key)
def test_plugin_names_objects_that_exist(plugin: DevicePlugin) -> None:
    assert isinstance(plugin.prober.load(), ProberInfo)
    assert isinstance(plugin.port_reports.load(), PortReports)
    assert isinstance(plugin.simulator.load(), SimulatorPlugin)
    assert all(callable(part.load()) for part in (plugin.controller, plugin.workspace, plugin.tour))
    for name, info in plugin.commands.items():
        command = info.command.load()
        assert isinstance(command, click.Command)
        assert command.name == name


def test_plugins_and_commands_have_different_names() -> None:
    keys = [plugin.key for plugin in PLUGINS]
    commands = [name for plugin in PLUGINS for name in plugin.commands]
    assert len(set(keys)) == len(keys)
    assert len(set(commands)) == len(commands)
