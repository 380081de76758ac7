"""Reader of a board's settings and polled values."""

import itertools
import math

from trex_gui.core.errors import BadReply, NoReply
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import (
    DeviceState,
    read_everything,
    read_reliably,
    several_reply,
)
from trex_gui.devices.trex.client.telemetry import Currents, LatchedStatus, ModeSample, poll
from trex_gui.devices.trex.driving.motor_output import OutputEvent
from trex_gui.devices.trex.driving.requests import MotorsStopped
from trex_gui.devices.trex.protocol.commands import GetMode, GetParameter, Signature
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexBadReplyError, TrexError
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.session.messages import Connected, ReadReason
from trex_gui.devices.trex.session.open_line import OpenLine
from trex_gui.devices.trex.session.polling import SAFETY_PARAMETERS, Polling, Topic

_STALE_READS = 3  # readings after a failed write
_STALE_READ_INTERVAL = 2.0  # seconds

# Each of the four safety parameters is read once a second. At 1200 baud, this takes a tenth of the
# line's capacity.
_SAFETY_READ_INTERVAL = 0.25  # seconds


class BoardReader:
    """Reads and reports the settings and polled values of one board."""

    state: DeviceState  # set by the first reading

    def __init__(self, line: OpenLine) -> None:
        self.signature: Signature | None = None  # signature of the last board read
        self.polling = Polling()
        self.safety_read_at = -math.inf
        self.port_rates: frozenset[int] | None = None  # baud rates of the port; `None` if unknown
        self._line = line
        self._stale_reads = 0  # remaining readings after a failed write
        self._stale_read_at = -math.inf  # earliest time of the next reading
        self._safety_keys = itertools.cycle(SAFETY_PARAMETERS)

    def expect_changes(self) -> None:
        """Schedule further readings, since the value of a failed write may have been stored."""
        self._stale_reads = _STALE_READS

    def read_everything(self, occasion: ReadReason) -> None:
        """Read and report all settings.

        Stop the motors, except after a reload. After the stop, the motors must be armed again,
        because the window may still send setpoints for the previous state or board.
        """
        line, client = self._line, self._line.client
        if occasion.power_cycled:
            line.motors.handle(OutputEvent.STOP, line.now())
        self.state = read_everything(line.request, line.report_progress, has_crc=client.has_crc)
        number = self.state.parameters.get(ParameterKey.DEVICE_NUMBER)
        if occasion is ReadReason.OPENED and number is not None and several_reply(client, number):
            settings = client.settings
            raise TrexBadReplyError(ErrorCode.SEVERAL_BOARDS, settings.label, settings.line.text())
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
        # After a selection, the pending samples are from the new board.
        if occasion is not ReadReason.SELECTED:
            line.flush()
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
    def _timeout_to_prevent(self) -> float:
        """Serial timeout that polling must prevent, in seconds. 0 means none."""
        return self.state.serial_timeout if self._line.motors.is_armed else 0.0

    def seconds_to_next(self, now: float) -> float:
        return self.polling.seconds_to_next(now, self._timeout_to_prevent)

    def next_topic(self, now: float) -> Topic | None:
        line = self._line
        return self.polling.next(
            now,
            line.client.settings.line,
            self._timeout_to_prevent,
            careful=line.driver.avoids_risky_polls(),
        )

    def poll(self, topic: Topic) -> None:
        line = self._line
        try:
            # Stops and setpoints were just served. Only a status read may take two transactions.
            request = line.request if topic is LatchedStatus else line.client.request
            sample = poll(request, topic, line.now, line.status)
            line.liveness.record_reply(topic)
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
        """Read the next safety parameter.

        An unexpected value indicates a power cycle during which no reply was lost. In this case,
        everything is read, and the motors must be armed again.
        """
        line = self._line
        self.safety_read_at = now + _SAFETY_READ_INTERVAL
        key = next(self._safety_keys)
        expected = self.state.parameters.get(key)
        if expected is None:
            return
        command = GetParameter(self.state.specs[key].number)
        try:
            if line.client.request(command) == expected:
                return
            if read_reliably(line.request, command, has_crc=line.client.has_crc) != expected:
                # A failed write may also have changed the value.
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
        line = self._line
        try:
            line.driver.stop_without_reply()
            if not line.liveness.is_scanning(line.client):
                self._request_mode(line.client)
            elif (new_client := line.liveness.probe_next(line.client)) is not None:
                line.client = line.driver.client = new_client
                line.status.reset()
            else:
                return
            line.stop_if_moving()
            self.read_everything(ReadReason.RETURNED)
        except (NoReply, BadReply):
            line.liveness.retry_later(line.now())

    def _request_mode(self, client: TrexClient) -> None:
        try:
            client.request(GetMode())
        except (NoReply, BadReply) as error:
            if isinstance(error, TrexError) and error.code is ErrorCode.NO_REPLY:
                raise
            client.detect_echo()
            client.request(GetMode())
