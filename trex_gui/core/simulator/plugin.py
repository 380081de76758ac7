"""Contribution of a device to `trex-sim`."""

from collections.abc import Callable
from dataclasses import dataclass

import click

from trex_gui.core.simulator.line import SimulatedLine


@dataclass(frozen=True, slots=True)
class Simulation:
    """A line in virtual time, and the function that executes a control line and replies."""

    line: SimulatedLine
    control: Callable[[str], str]


@dataclass(frozen=True, slots=True)
class SimulatorPlugin:
    """A simulated device on the command line.

    Attributes:
        help: of the option that selects the device; of the command for the default device.
        options: options that apply to this device only.
        build: creates the simulation from the values of `options`, `paced` and `seed`; raises a
            `StudioError` if a file cannot be read.
    """

    help: str
    options: tuple[click.Option, ...]
    build: Callable[..., Simulation]
