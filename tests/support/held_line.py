"""Something that happens to a line right before a setting is sent, however fast the line is."""

from collections.abc import Callable

from tests.support.virtual_devices import VirtualSimulator
from trex_gui.devices.trex.protocol.commands import SetParameter

_STORE = SetParameter(0, 0).opcode


def before_storing(simulator: VirtualSimulator, number: int, act: Callable[[], object]) -> None:
    """Do something in the line's own thread before the `number`th parameter is sent, once.

    One that is sent again, since its answer was late, counts once. For boards that are addressed
    by no number.
    """
    seen: set[bytes] = set()

    def act_once(data: bytes) -> None:
        if data[0] == _STORE and data not in seen:
            seen.add(data)
            if len(seen) == number:
                act()

    simulator.on_write = act_once
