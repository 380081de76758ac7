"""What a session asks by itself: what is due, and while motors are armed only what is in time."""

from collections.abc import Collection

from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.schedule import Schedule, Topic, rates
from trex_gui.devices.trex.driving.keepalive import CHEAPEST, longest_pause, too_slow
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey


class Polling:
    """The schedule of one board, and its serial timeout; knows no clock but the times it is given.

    Attributes:
        timeout: seconds of silence after which the board stops its motors; 0 for never.
    """

    def __init__(self) -> None:
        self.timeout = 0.0
        self._schedule = Schedule()
        self._asked_at = 0.0

    def start(self, state: DeviceState, now: float) -> None:
        """Ask what a board with such inputs renews."""
        self._schedule.start(rates(state.source), now)
        self._asked_at = now
        self.take(state.parameters.get(ParameterKey.SERIAL_TIMEOUT, 0), state)

    def take(self, wire: int, state: DeviceState) -> None:
        """Follow the serial timeout that the board stores: it is in force at once."""
        self.timeout = wire * state.specs[ParameterKey.SERIAL_TIMEOUT].scale

    def next(
        self, now: float, line: LineSettings, *, armed: bool, careful: bool = False
    ) -> Topic | None:
        """Return what to ask now, and count it as asked; `None` while nothing is due.

        Who is `careful` asks nothing that one damaged bit makes a command which starts a motor.
        """
        left_out: Collection[Topic] = too_slow(line, self.timeout) if armed else ()
        if careful:
            left_out = {*left_out, Topic.RAW}  # 86 1F is one bit away from C6 1F, 87 1F brakes
        while topic := self._schedule.next(now):
            self._schedule.asked(topic, now)
            if topic not in left_out:
                break
        if topic is None and armed and self._pause_left(now) == 0:
            topic = CHEAPEST
        if topic is not None:
            self._asked_at = now
        return topic

    def seconds_to_next(self, now: float, *, armed: bool) -> float | None:
        """Return how long nothing has to be asked; `None` when nothing ever has."""
        seconds = self._schedule.seconds_to_next(now)
        pause = self._pause_left(now) if armed else None
        if seconds is None or pause is None:
            return pause if seconds is None else seconds
        return min(seconds, pause)

    def _pause_left(self, now: float) -> float | None:
        pause = longest_pause(self.timeout)
        return None if pause is None else max(0.0, self._asked_at + pause - now)
