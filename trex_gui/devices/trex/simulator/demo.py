"""Something to look at: sticks that move slowly by themselves, motors with a light load."""

import math

from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.signals import Signal, SignalKind

_PERIOD = 0.02
"""Seconds between two pulses of a standard receiver."""

# Channel: seconds for a full swing and its size as a share of the stick's way. The periods
# share no small multiple, so the picture does not repeat. Channel 5 stays where it does not
# call for serial override.
_SWINGS = {1: (7.0, 0.8), 2: (11.0, 0.7), 3: (17.0, 0.6), 4: (23.0, 0.3), 5: (29.0, 0.2)}


class Demo:
    """Moves the sticks of one board; a channel that somebody sets is left alone from then on."""

    def __init__(self, board: Board) -> None:
        self._board = board
        self._ours = {channel: board.channels.signal(channel) for channel in _SWINGS}
        self._next = 0.0
        for physics in board.physics:
            physics.load = physics.load_at_first = physics.constants.light_load

    def update(self) -> None:
        """Move the sticks to where they are by now, 50 times a second."""
        now = self._board.now
        if now < self._next:
            return
        self._next = now + _PERIOD
        for channel, (seconds, size) in _SWINGS.items():
            present = self._board.channels.signal(channel)
            if present == self._ours[channel] or present.kind is SignalKind.REST:
                way = size * math.sin(2 * math.pi * now / seconds)
                signal = self._stick(way)
                self._ours[channel] = signal
                self._board.connect(channel, signal)

    def _stick(self, way: float) -> Signal:
        """Return what a stick gives at -1 to 1 of its way."""
        if self._board.channels.source is InputSource.RC:
            return Signal.pulses(1500 + 500 * way)
        return Signal.voltage(2.5 + 2.5 * way)
