"""Interface between `trex-sim` and a simulated device."""

from collections.abc import Callable
from dataclasses import dataclass

import click

from trex_gui.core.simulator.line import SimulatedLine


@dataclass(frozen=True, slots=True)
class Simulation:
    """Simulated line in virtual time, and a function that replies to control lines."""

    line: SimulatedLine
    control: Callable[[str], str]


@dataclass(frozen=True, slots=True)
class SimulatorPlugin:
    """Simulated device on the command line.

    Attributes:
        help: help text of the option that selects the device. For the default device, help text of
            the command.
        options: options of this device only.
        build: creates the simulation from the values of `options`, `paced` and `seed`. Raises
            StudioError if a file cannot be read.
    """

    help: str
    options: tuple[click.Option, ...]
    build: Callable[..., Simulation]
