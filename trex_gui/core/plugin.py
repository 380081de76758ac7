"""Plugin interface for a kind of device."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING, Any, Generic, TypeVar, cast

if TYPE_CHECKING:  # not imported at run time, so that `trexcmd --help` starts fast
    import click

    from trex_gui.core.discovery.prober import ProberInfo
    from trex_gui.core.simulator.plugin import SimulatorPlugin

T_co = TypeVar("T_co", covariant=True)


@dataclass(frozen=True, slots=True)
class Lazy(Generic[T_co]):
    """Object imported on first use. `target`: `package.module:name`."""

    target: str

    def load(self) -> T_co:
        module, _, name = self.target.partition(":")
        return cast("T_co", getattr(import_module(module), name))


@dataclass(frozen=True, slots=True)
class CommandInfo:
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
    """Functions of a device for `trexcmd list` and `trexcmd find`.

    Attributes:
        identify: probes a port, called as (URL, options of the command). It never moves anything.
            The text of the answer is empty if no device replied. Raises PortUnavailable.
        describe: returns sentences about a found device.
        row: returns the fields that `find --json` adds to the connection settings of a found
            device.
    """

    identify: Callable[[str, Mapping[str, Any]], PortAnswer]
    describe: Callable[[Any], str]
    row: Callable[[Any], dict[str, Any]]


@dataclass(frozen=True, slots=True, kw_only=True)
class DevicePlugin:
    """Kind of device. `key` identifies it in settings and commands.

    Attributes:
        prober: searches a port for a device. Its probes never move a device of any kind.
        commands: name → command of trexcmd.
        simulator_arguments: arguments of trex-sim that simulate a device for the port list.
        controller: creates a `DeviceController`, called as
            (plugin, notifier, ports, scanner, timeouts).
        workspace: creates a `Workspace`, called as (controller, window).
        tour: yields steps of the screenshot tour, called as (tour, controller).
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
