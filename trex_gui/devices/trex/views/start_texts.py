"""Texts and wiring of the start page."""

from trex_gui.core.translation import tr
from trex_gui.ui.frame.start_panel import StartTexts, StartWay
from trex_gui.ui.frame.wiring_sketch import Wires
from trex_gui.ui.widgets.circuit import Jumper


def ttl_wiring() -> Wires:
    pairs = ("TX", "SI"), ("RX", "SO"), ("GND", "GND")
    return Wires(tr("TReX"), tr("Adapter"), pairs, _to_remove())


def start_texts() -> StartTexts:
    """Return the texts and the wiring of the start page.

    Ref: Pololu TReX manual page 7 (RS-232 levels, BEC jumper); forum thread 1769 (3.3 V levels,
    mode jumper).
    """
    rs_232 = Wires(
        tr("TReX"),
        tr("RS-232 port"),
        (("TX, pin 3", "RX"), ("RX, pin 2", "TX"), ("GND, pin 5", "GND")),
        _to_remove(),
    )
    receiver = Wires(
        tr("TReX"),
        tr("Receiver"),
        (("CH 1", "CH1"), ("CH 2", "CH2"), ("5 V, GND", "5 V, GND")),
        ((tr("Mode: set it to RC"), True), (tr("BEC: feeds the receiver"), True)),
    )
    danger = tr("Never connect RS-232 levels (±12 V) to SI and SO: they can destroy the board.")
    scale = tr("Schematic drawing: see the user's guide for the positions on your board.")
    set_up_first = tr(
        "Set the board up through an adapter first: with the mode jumper on, it accepts no "
        "settings. BEC supplies at most 100 mA."
    )
    return StartTexts(
        title=tr("Connect my {0}").format(tr("TReX")),
        hint=tr(
            "Switch off the motor supply, or put the robot on blocks. Connecting and "
            "searching do not move a motor."
        ),
        ways=(
            StartWay(ttl_wiring(), scale, tr("USB adapter, 3.3 or 5 V"), danger),
            StartWay(rs_232, scale, tr("RS-&232 adapter"), danger),
            StartWay(receiver, f"{set_up_first} {scale}", tr("RC recei&ver")),
        ),
        demo_heading=tr("No board at hand?"),
        demo=tr("&Try the demo"),
        files=(("open", tr("Open &settings file…")), ("open_recording", tr("&Open recording…"))),
    )


def _to_remove() -> tuple[Jumper, ...]:
    return (tr("Mode: remove it"), False), (tr("SO–G: remove it"), False)
