"""Plugin for the Aracna robot."""

from trex_gui.core.plugin import CommandInfo, DevicePlugin, Lazy

_PACKAGE = "trex_gui.devices.aracna"

ARACNA = DevicePlugin(
    key="aracna",
    name="Aracna",
    prober=Lazy(f"{_PACKAGE}.discovery:ARACNA_PROBER"),
    port_reports=Lazy(f"{_PACKAGE}.cli.session:PORT_REPORTS"),
    simulator_arguments=("--aracna",),
    controller=Lazy(f"{_PACKAGE}.model.controller:AracnaController"),
    workspace=Lazy(f"{_PACKAGE}.views.workspace:AracnaWorkspace"),
    tour=Lazy(f"{_PACKAGE}.views.tour:tour_steps"),
    commands={
        "aracna": CommandInfo(
            Lazy(f"{_PACKAGE}.cli.commands:aracna"),
            "Query and move an Aracna, and play sequences.",
        )
    },
    simulator=Lazy(f"{_PACKAGE}.simulator.control:SIMULATOR"),
)
