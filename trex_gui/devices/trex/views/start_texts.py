"""Texts and pictures of the panel that is shown while nothing is connected."""

from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.views.jumper_sketch import JumperPlaces, JumperSketch
from trex_gui.ui.frame.start_panel import StartTexts, StartWay
from trex_gui.ui.frame.wiring_sketch import Wires


def ttl_wiring() -> Wires:
    return Wires(
        tr("TReX"),
        (("TX", "SI"), ("RX", "SO"), ("GND", "GND")),
        tr("Wiring: TX of the adapter to SI, RX to SO, GND to GND of the board"),
    )


def start_texts(parent: QWidget) -> StartTexts:
    return StartTexts(
        title=tr("Connect my TReX"),
        ways=_start_ways(parent),
        none=tr("No board at hand?"),
        demo=tr("&Try the demo"),
        files=(
            ("open", tr("Open &settings file…"), "open"),
            ("open_recording", tr("&Open recording…"), "plot"),
        ),
        welcome=tr(
            "Set up, calibrate, drive and understand a Pololu TReX or TReX Jr. You need the "
            "board with its supply, and a serial adapter with three wires. No motor moves "
            "before you arm the motors, and Esc stops the motors in every window."
        ),
    )


def _start_ways(parent: QWidget) -> tuple[StartWay, ...]:
    """Return the wiring of a TTL adapter, an RS-232 adapter and a receiver.

    Ref: the reference, 4 (levels) and 7 (BEC and mode jumpers).
    """
    to_connect = JumperPlaces(tr("Jumpers to connect"), "", None)
    to_drive = JumperPlaces(tr("Jumpers to drive"), "RC", None)
    ttl_steps = tr(
        "You need a USB-serial adapter with TTL levels (5 V or 3.3 V) and three wires."
        "<ol style='margin-left: -10px'>"
        "<li>Switch the board off. Remove the mode jumper: then it starts in serial mode, "
        "which is needed to drive it and to change settings from here. Remove the SO–G "
        "jumper, too.</li>"
        "<li>Wire the adapter as shown.</li>"
        "<li>Lift the wheels off the ground, switch the board on, and connect:</li>"
        "</ol>"
    )
    rs_232_steps = tr(
        "You need an RS-232 port of the computer or an RS-232 adapter, and three wires."
        "<ol style='margin-left: -10px'>"
        "<li>Switch the board off. Remove the mode and SO–G jumpers, as for a TTL "
        "adapter.</li>"
        "<li>Wire the port to the RS-232 pins as shown, and leave SI and SO free: the "
        "voltages of RS-232 can damage them.</li>"
        "<li>Lift the wheels off the ground, switch the board on, and connect:</li>"
        "</ol>"
    )
    receiver_steps = tr(
        "You need an RC receiver with a servo cable for each channel, and an adapter to "
        "connect the board to this computer."
        "<ol style='margin-left: -10px'>"
        "<li>Set the board up through the adapter first: with the mode jumper on, it "
        "accepts no settings.</li>"
        "<li>Switch the board off. Connect the receiver as shown: a servo cable has "
        "signal, 5 V and GND. The BEC jumper lets the board feed the receiver, with 100 "
        "mA at most.</li>"
        "<li>Put the mode jumper on RC. Lift the wheels off the ground and switch on: the "
        "transmitter drives, and this program shows what it does.</li>"
        "</ol>"
    )
    rs_232 = Wires(
        tr("TReX"),
        (("TX, pin 3", "RX"), ("RX, pin 2", "TX"), ("GND, pin 5", "GND")),
        tr(
            "Wiring: TX of the RS-232 port (pin 3 of nine) to RX, RX (pin 2) to TX, GND "
            "(pin 5) to GND of the board"
        ),
        tr("RS-232 port"),
    )
    receiver = Wires(
        tr("TReX"),
        (("CH 1", "Channel 1"), ("CH 2", "Channel 2"), ("5 V, GND", "5 V, GND")),
        tr(
            "Wiring: channels 1 and 2 of the receiver to channels 1 and 2 of the board, "
            "5 V to 5 V, GND to GND"
        ),
        tr("Receiver"),
    )
    return (
        StartWay(ttl_steps, ttl_wiring(), tr("TT&L adapter"), _jumpers(to_connect, parent)),
        StartWay(rs_232_steps, rs_232, tr("RS-&232 adapter"), _jumpers(to_connect, parent)),
        StartWay(receiver_steps, receiver, tr("RC recei&ver"), _jumpers(to_drive, parent)),
    )


def _jumpers(places: JumperPlaces, parent: QWidget) -> JumperSketch:
    jumpers = JumperSketch(parent)
    jumpers.show_boards(places)
    return jumpers
