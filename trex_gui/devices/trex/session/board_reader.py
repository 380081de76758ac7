"""Reading of a board: first everything, then values in turn, and everything after silence."""

import itertools
import math

from trex_gui.core.errors import BadReply, NoReply
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import DeviceState, agreed, is_several, read_everything
from trex_gui.devices.trex.client.telemetry import Currents, LatchedStatus, ModeSample, poll
from trex_gui.devices.trex.driving.motor_output import OutputEvent
from trex_gui.devices.trex.driving.requests import MotorsStopped
from trex_gui.devices.trex.protocol.commands import GetMode, GetParameter, Signature
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexBadReplyError, TrexError
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.session.messages import Connected, ReadReason
from trex_gui.devices.trex.session.open_line import OpenLine
from trex_gui.devices.trex.session.polling import SAFETY_PARAMETERS, Polling, Topic

_STALE_READS = 3
_STALE_READ_INTERVAL = 2.0  # seconds; telemetry goes on between two of these readings

_SAFETY_READ_INTERVAL = 0.25
"""Seconds between two queries of `SAFETY_PARAMETERS` in turn, so each is read every second. At
1200 baud they take a tenth of the line."""


class BoardReader:
    state: DeviceState  # set once everything was read

    def __init__(self, line: OpenLine) -> None:
        self.signature: Signature | None = None  # of the board that was read last
        self.polling = Polling()
        self.safety_read_at = -math.inf
        self.port_rates: frozenset[int] | None = None  # what the port supports; `None`: unknown
        self._line = line
        # Number and time of further readings, if the board may store other values than `state`:
        self._stale_reads = 0
        self._stale_read_at = -math.inf
        self._safety_keys = itertools.cycle(SAFETY_PARAMETERS)

    def expect_changes(self) -> None:
        """Read everything again a few times: a failed write may be stored all the same."""
        self._stale_reads = _STALE_READS

    def read_everything(self, occasion: ReadReason) -> None:
        """Read everything and report it. Unless merely reloaded, the board is not driven meanwhile.

        The window does not know yet that the board was without power, or that it is another board,
        and goes on sending setpoints. So every motor is stopped and has to be armed again.
        """
        line = self._line
        if occasion.power_cycled:
            line.motors.handle(OutputEvent.STOP, line.now())
        self.state = read_everything(
            line.request, line.report_progress, has_crc=line.client.has_crc
        )
        number = self.state.parameters.get(ParameterKey.DEVICE_NUMBER)
        if occasion is ReadReason.OPENED and number is not None and is_several(line.client, number):
            where = line.client.settings.label, line.client.settings.line.text()
            raise TrexBadReplyError(ErrorCode.SEVERAL_BOARDS, *where)
        self._stale_reads = 0
        self.signature = self.state.signature
        if occasion is not ReadReason.RELOADED:
            if occasion.power_cycled or line.motors.is_armed:
                line.motors.handle(OutputEvent.STOP, line.now())
            line.stop_if_moving()
        self.polling.start(self.state.source, line.now())
        line.liveness.start()
        line.motors.handle(OutputEvent.BOARD_READ, line.now())
        line.transport.wait_for_guardian()
        line.report_guardian()
        if occasion is not ReadReason.SELECTED:  # samples taken meanwhile are of the new board
            line.flush()
        client = line.client
        line.emit(
            Connected(
                self.state,
                client.echo,
                occasion,
                line.settings,
                line.motors.may_move,
                self.port_rates,
                line.queue.selection,
            )
        )

    @property
    def _fed_timeout(self) -> float:
        """Return the serial timeout that polling must not let expire, 0 for none."""
        return self.state.serial_timeout if self._line.motors.is_armed else 0.0

    def seconds_to_next(self, now: float) -> float:
        return self.polling.seconds_to_next(now, self._fed_timeout)

    def next_topic(self, now: float) -> Topic | None:
        line = self._line
        return self.polling.next(
            now,
            line.client.settings.line,
            self._fed_timeout,
            careful=line.driver.avoids_risky_polls(),
        )

    def poll(self, topic: Topic) -> None:
        line = self._line
        try:
            # Stops and setpoints have just been served; only a status may take two transactions.
            request = line.request if topic is LatchedStatus else line.client.request
            sample = poll(request, topic, line.now, line.status)
            line.liveness.record_answer(topic)
            if isinstance(sample, LatchedStatus):
                self.record_status(sample)
            if sample:
                line.batcher.add(sample)
            if isinstance(sample, Currents):
                line.motors.restart.record_currents(sample.counts, sample.time)
            if line.motors.restart.has_restarted:
                confirmed = line.stop_and_confirm()
                line.emit(MotorsStopped(ErrorCode.MAY_HAVE_RESTARTED, confirmed))
                self.read_everything(ReadReason.RETURNED)
            elif isinstance(sample, ModeSample) and sample.mode is not self.state.mode:
                # The power was off and a jumper was moved: everything may have changed.
                line.stop_if_moving()
                self.read_everything(ReadReason.RESTARTED)
            elif self._stale_reads and line.now() >= self._stale_read_at:
                self._stale_reads -= 1
                self._stale_read_at = line.now() + _STALE_READ_INTERVAL
                self.read_everything(ReadReason.RELOADED)
        except (NoReply, BadReply) as error:
            line.record_failure(error, topic)

    def check_safety_parameter(self, now: float) -> None:
        """Read a stored value that decides how the board protects its motors by itself.

        If the value changed unnoticed, the power was off too briefly for a missing reply. Then
        everything is read, and motors have to be armed again.
        """
        line = self._line
        self.safety_read_at = now + _SAFETY_READ_INTERVAL
        key = next(self._safety_keys)
        known = self.state.parameters.get(key)
        if known is None:
            return
        command = GetParameter(self.state.specs[key].number)
        try:
            if line.client.request(command) == known:
                return
            if agreed(line.request, command, has_crc=line.client.has_crc) != known:
                # A failed write may have changed it as well.
                occasion = ReadReason.RELOADED
                if not self._stale_reads:
                    occasion = ReadReason.SETTING_CHANGED
                    line.stop_if_moving()
                self.read_everything(occasion)
        except (NoReply, BadReply) as error:
            line.record_failure(error)

    def record_status(self, latched: LatchedStatus) -> None:
        self._line.motors.record_status(latched, stops_on_error=self.state.stops_on_error)

    # --- A board that does not respond --------------------------------------------------

    def try_to_reconnect(self) -> None:
        """Query the board, or probe the next candidate."""
        line = self._line
        try:
            line.driver.stop_without_reply()
            if not line.liveness.is_scanning(line.client):
                self._request_mode(line.client)
            elif (found := line.liveness.look(line.client)) is not None:
                line.client = line.driver.client = found
                line.status.reset()
            else:
                return
            line.stop_if_moving()
            self.read_everything(ReadReason.RETURNED)
        except (NoReply, BadReply):
            line.liveness.retry_later(line.now())

    def _request_mode(self, client: TrexClient) -> None:
        """Query the board. An echo that has begun or ended makes its replies unreadable."""
        try:
            client.request(GetMode())
        except (NoReply, BadReply) as error:
            if isinstance(error, TrexError) and error.code is ErrorCode.NO_REPLY:
                raise
            client.detect_echo()
            client.request(GetMode())
