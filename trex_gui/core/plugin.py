"""Everything that the program needs to support a kind of device."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING, Any, Generic, TypeVar, cast

if TYPE_CHECKING:  # trexcmd --help needs none of this
    import click

    from trex_gui.core.discovery.prober import ProberInfo
    from trex_gui.core.simulator.plugin import SimulatorPlugin

T_co = TypeVar("T_co", covariant=True)


@dataclass(frozen=True, slots=True)
class Lazy(Generic[T_co]):
    """An object that is imported when it is first needed. `target` is `package.module:name`."""

    target: str

    def load(self) -> T_co:
        module, _, name = self.target.partition(":")
        return cast("T_co", getattr(import_module(module), name))


@dataclass(frozen=True, slots=True)
class CommandInfo:
    """A command of trexcmd and its line in the list of commands."""

    command: "Lazy[click.Command]"
    help: str


@dataclass(frozen=True, slots=True)
class PortAnswer:
    """Row of `trexcmd list`. `product` is `None` if no device replied."""

    text: str
    product: str | None = None
    firmware: str | None = None


@dataclass(frozen=True, slots=True)
class PortReports:
    """Functions by which `trexcmd list` and `trexcmd find` identify and report a device.

    Attributes:
        identify: probes a port (URL, options of the command) without moving anything. The text of
            its answer is empty if there is nothing to report. Raises PortUnavailable.
        describe: returns the sentences that report a found device to the user.
        row: returns the fields of a found device that `find --json` adds to its connection.
    """

    identify: Callable[[str, Mapping[str, Any]], PortAnswer]
    describe: Callable[[Any], str]
    row: Callable[[Any], dict[str, Any]]


@dataclass(frozen=True, slots=True, kw_only=True)
class DevicePlugin:
    """One kind of device. `key` identifies it in settings and on the command line.

    Attributes:
        prober: searches a port for a device; its probes move no device of any kind.
        commands: its commands of trexcmd by name.
        simulator_arguments: arguments of trex-sim that simulate a device for the port list.
        controller: creates its controller and model: `DeviceController`, called as
            (plugin, notifier, ports, scanner, timeouts).
        workspace: creates its workspace: `Workspace`, called as (controller, window).
        tour: yields its steps of the screenshot tour, called as (tour, controller).
    """

    key: str
    name: str
    prober: "Lazy[ProberInfo]"
    port_reports: Lazy[PortReports]
    commands: Mapping[str, CommandInfo]
    simulator: "Lazy[SimulatorPlugin]"
    simulator_arguments: tuple[str, ...]
    controller: Lazy[Callable[..., Any]]
    workspace: Lazy[Callable[..., Any]]
    tour: Lazy[Callable[..., Any]]
