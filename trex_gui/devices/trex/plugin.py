"""Device plugin for the Pololu TReX and TReX Jr."""

from trex_gui.core.plugin import CommandInfo, DevicePlugin, Lazy

_PACKAGE = "trex_gui.devices.trex"


def _command(target: str, text: str) -> CommandInfo:
    return CommandInfo(Lazy(f"{_PACKAGE}.cli.{target}"), text)


TREX = DevicePlugin(
    key="trex",
    name="TReX",
    prober=Lazy(f"{_PACKAGE}.discovery:TREX_PROBER"),
    port_reports=Lazy(f"{_PACKAGE}.cli.common:PORT_REPORTS"),
    simulator_arguments=("--demo",),
    controller=Lazy(f"{_PACKAGE}.model.controller:TrexController"),
    workspace=Lazy(f"{_PACKAGE}.views.workspace:TrexWorkspace"),
    tour=Lazy(f"{_PACKAGE}.views.tour:tour_steps"),
    commands={
        "boards": _command("status:boards", "List the boards that share a line, by device number."),
        "status": _command(
            "status:status", "Show the state of the board, its measurements and parameters."
        ),
        "stream": _command("stream:stream", "Write measurements as CSV until Ctrl-C."),
        "get": _command("status:get_command", "Show one parameter."),
        "set": _command("parameters:set_command", "Store one parameter and read it back."),
        "get-settings": _command("files:get_settings", "Save the board's settings to a file."),
        "set-settings": _command(
            "set_settings:set_settings", "Write a settings file to the board."
        ),
        "check-settings": _command(
            "check:check_settings", "Check a settings file without a board."
        ),
        "diff": _command("files:diff", "Compare settings files, or a file with the board."),
        "audit": _command("files:audit", "Check the board against a settings file."),
        "provision": _command(
            "provision:provision", "Set up several boards, one after another, on the same cable."
        ),
        "history": _command(
            "history:history", "List the snapshots of settings saved before each change."
        ),
        "calibration": _command("calibration:calibration", "Show or store channel calibrations."),
        "export": _command("files:export", "Write the settings as Python or an Arduino sketch."),
        "restore-defaults": _command(
            "parameters:restore_defaults", "Reset all parameters to factory defaults."
        ),
        "motor": _command(
            "motor:motor", "Run a motor for a set time or until Ctrl-C, then stop it."
        ),
        "stop": _command("motor:stop", "Stop all motors and wait for confirmation."),
        "serve": _command("serve:serve", "Serve the board to other computers over the network."),
        "robots": _command("serve:robots", "List the boards that are served on the network."),
        "raw": _command("packets:raw", "Send bytes and show the reply."),
        "decode": _command("packets:decode", "Decode packets without a board."),
        "report": _command("report:report", "Save a ZIP file for support, without personal data."),
        "survey": _command("survey:survey", "Write facts about a board's firmware to a file."),
        "replay": _command(
            "replay:replay", "Compare a traffic log with the replies of a simulated board."
        ),
    },
    simulator=Lazy(f"{_PACKAGE}.simulator.command:SIMULATOR"),
)
