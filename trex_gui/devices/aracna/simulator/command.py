"""Options of `trex-sim` for the Aracna."""

from functools import partial

import click

from trex_gui.core.simulator.plugin import Simulation, SimulatorPlugin
from trex_gui.devices.aracna.protocol.units import MOTORS
from trex_gui.devices.aracna.simulator.control import control
from trex_gui.devices.aracna.simulator.line import AracnaLine


def simulate(*, motors: int | None = None, paced: bool = True, seed: int = 0) -> Simulation:
    """Create a robot; by default it has as many motors as it can."""
    line = AracnaLine(motors or MOTORS, paced=paced, seed=seed)
    return Simulation(line, partial(control, line))


SIMULATOR = SimulatorPlugin(
    help="Simulate an Aracna instead, at 38400 8N1. "
    "Its control lines: reset, power, servo, line, show, quit.",
    options=(
        click.Option(
            ["--motors"],
            type=click.IntRange(1, MOTORS),
            help="Number of motors; 2 make a robot of version 0.  [default: 8]",
        ),
    ),
    build=simulate,
)
