"""Plugin for the Aracna robot."""

from trex_gui.core.plugin import CommandInfo, DevicePlugin, Lazy

_HERE = "trex_gui.devices.aracna"

ARACNA = DevicePlugin(
    key="aracna",
    name="Aracna",
    prober=Lazy(f"{_HERE}.discovery:ARACNA_PROBER"),
    port_reports=Lazy(f"{_HERE}.cli.session:PORT_REPORTS"),
    simulator_arguments=("--aracna",),
    controller=Lazy(f"{_HERE}.model.controller:AracnaController"),
    workspace=Lazy(f"{_HERE}.views.workspace:AracnaWorkspace"),
    tour=Lazy(f"{_HERE}.views.tour:tour_steps"),
    commands={
        "aracna": CommandInfo(
            Lazy(f"{_HERE}.cli.commands:aracna"), "Query an Aracna, move it, play its poses."
        )
    },
    simulator=Lazy(f"{_HERE}.simulator.control:SIMULATOR"),
)
