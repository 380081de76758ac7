"""Search for a silent board, perhaps at other line settings."""

import logging
from collections import Counter, deque
from collections.abc import Iterable, Mapping
from dataclasses import replace

from trex_gui.core.discovery.prober import flush
from trex_gui.core.errors import BadReply, BadRequest, NoReply
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.serial_port import Transport
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import query
from trex_gui.devices.trex.client.telemetry import Control, ModeSample
from trex_gui.devices.trex.probe import Attempt, ReplyKind, send_probe
from trex_gui.devices.trex.protocol.commands import GetSignature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.framing import check_polynomial
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey, parameters_of
from trex_gui.devices.trex.session.polling import Topic

log = logging.getLogger(__name__)

_FAILURES = 3  # after this number of failures in a row, the board counts as silent

# The failures of each of these topics are also counted separately, because only a few byte values
# are valid replies. If TX and RX touch, requests come back and look like valid replies to the other
# topics.
_STRICT = frozenset({Control, ModeSample})


class LivenessMonitor:
    """Detects a silent board and probes for it."""

    def __init__(self, timeouts: Timeouts) -> None:
        self.retry_at = 0.0  # time of the next probe, on the line's clock
        self.candidates: tuple[ConnectionSettings, ...] = ()  # further settings to probe
        self._retry = timeouts.retry
        self._failures_of = Counter[Topic]()
        self._untried = deque[ConnectionSettings]()
        self.start()

    def set_candidates(self, candidates: tuple[ConnectionSettings, ...]) -> None:
        if candidates != self.candidates:
            self.candidates = candidates
            self._untried.clear()

    def start(self) -> None:
        self.is_silent = False  # True if the board has stopped responding
        self._failures = 0
        self._failures_of.clear()
        self._has_probed = False

    @property
    def is_failing(self) -> bool:
        return self._failures > 0 and not self.is_silent

    def record_reply(self, topic: Topic) -> None:
        self._failures = self._failures_of[topic] = 0

    def record_failure(self, now: float, topic: Topic | None = None) -> bool:
        """Count a failed transaction. Return True if the board becomes silent."""
        self._failures += 1
        if topic in _STRICT:
            self._failures_of[topic] += 1
        failures = max((self._failures, *self._failures_of.values()))
        if failures < _FAILURES or self.is_silent:
            return False
        self.is_silent = True
        self._untried.clear()
        self.retry_later(now)
        return True

    def retry_later(self, now: float) -> None:
        self.retry_at = now + self._retry

    def is_scanning(self, client: TrexClient) -> bool:
        """True if a silent board may be at other settings.

        In this state, only stops and probes may be sent. After the first probe, the state lasts
        until the board responds, because a board at another baud rate may have misread the probe.
        """
        can_probe = client.transport.is_configurable
        return self.is_silent and can_probe and (self._has_probed or bool(self.candidates))

    def probe_next(self, client: TrexClient) -> TrexClient | None:
        """Send one probe. Return a client if the board replied."""
        self._has_probed = True
        if not self._untried:
            self._untried.extend(settings_to_probe(client.settings, self.candidates))
        new_client = _probe(client, self._untried.popleft())
        if new_client is None:
            self.retry_at = client.transport.clock() + (0.0 if self._untried else self._retry)
        elif new_client is not client:
            self.set_candidates(())
        return new_client


def _probe(client: TrexClient, settings: ConnectionSettings) -> TrexClient | None:
    transport = client.transport
    try:
        new_client = client_at(transport, settings)
    except BadRequest as error:
        log.debug("%s: %s", settings.text(), error)
        new_client = None
    if new_client is None:
        # A stop must use the settings at which the board last replied.
        transport.reconfigure(client.settings.line)
        return None
    if settings == client.settings:
        client.echo = new_client.echo
        return client
    log.info("the board responds at %s", settings.text())
    new_client.counters = client.counters
    return new_client


# --- Settings to probe ------------------------------------------------------------------

LINK_KEYS = (ParameterKey.DEVICE_NUMBER, ParameterKey.CRC7_POLYNOMIAL, ParameterKey.UART_SETTINGS)
"""Keys of the parameters that change the connection settings of a board."""


def reconnect_candidates(
    link: ConnectionSettings, before: Mapping[str, int], after: Mapping[str, int], firmware: str
) -> tuple[ConnectionSettings, ...]:
    """Return the possible settings of a board that loses power during a write.

    Inferred: a value that was being stored becomes the factory default. `link`, the current
    settings, is omitted, because it is always probed. `before` and `after` map keys to stored wire
    values.
    """
    specs = {spec.key: spec for spec in parameters_of("trex", firmware).readable}
    keys = (key for key in LINK_KEYS if key in before)
    changed = [key for key in keys if after.get(key) not in {None, before[key]}]
    complete = [before, {**before, **after}]
    interrupted = [{**stored, key: specs[key].default} for stored in complete for key in changed]
    candidates = dict.fromkeys(
        candidate
        for stored in [*reversed(complete), *interrupted]
        if (candidate := after_power_cycle(link, stored, firmware)) is not None
    )
    candidates.pop(link, None)
    return tuple(candidates)


def after_power_cycle(
    link: ConnectionSettings, stored: Mapping[str, int], firmware: str
) -> ConnectionSettings | None:
    """Return the connection settings after the next start. `None` for invalid values.

    `stored` maps keys to wire values. Missing values are taken from `link`. Firmware before 1.2
    halves two baud rates. In this case, the result has the actual rate.
    """
    line, polynomial = link.line, link.polynomial
    try:
        if ParameterKey.UART_SETTINGS in stored:
            line = LineSettings.from_wire(stored[ParameterKey.UART_SETTINGS])
            line = replace(line, baud=line.real_baud(firmware))
        if ParameterKey.CRC7_POLYNOMIAL in stored:
            # The highest bit is always set. Inferred: the board does not store it.
            polynomial = check_polynomial(stored[ParameterKey.CRC7_POLYNOMIAL] | 0x80)
    except BadRequest:
        return None
    number = link.device_number
    if number is not None:
        number = stored.get(ParameterKey.DEVICE_NUMBER, number)
    return replace(link, line=line, polynomial=polynomial, device_number=number)


def settings_to_probe(
    used: ConnectionSettings, expected: Iterable[ConnectionSettings]
) -> tuple[ConnectionSettings, ...]:
    """Return the settings to probe for a silent board, current settings first.

    The factory default is last. A board returns to this default if power fails while the UART
    settings are being stored (inferred). A board replies at any number of stop bits, so a candidate
    that differs only in stop bits replaces the current settings. Settings are omitted if a board at
    other settings could read their probe as a motor command. On a line with other devices, only the
    current settings are probed.
    """
    if used.reserved:
        return (used,)
    candidates = [
        replace(settings, url=used.url, name=used.name, timeouts=used.timeouts)
        for settings in expected
    ]
    first = next(
        (candidate for candidate in candidates if _differ_only_in_stop_bits(candidate, used)), used
    )
    unique: dict[object, ConnectionSettings] = {}
    for settings in (first, *candidates, replace(first, line=LineSettings())):
        unique.setdefault((settings.line, settings.framing), settings)
    return tuple(
        settings
        for settings in unique.values()
        if not (Attempt.at(settings).is_unsafe and _may_misread(settings.line, unique.values()))
    )


def _differ_only_in_stop_bits(first: ConnectionSettings, second: ConnectionSettings) -> bool:
    stop_bits = second.line.stop_bits
    is_equal = replace(first, line=replace(first.line, stop_bits=stop_bits)) == second
    return is_equal and first.line.stop_bits != stop_bits


def _may_misread(line: LineSettings, candidates: Iterable[ConnectionSettings]) -> bool:
    """Return True if a board at a candidate's settings may misread a probe on this line."""
    return any(
        candidate.line.detection is Detection.ODD and candidate.line.baud * 3 == line.baud * 8
        for candidate in candidates
    )


def client_at(transport: Transport, settings: ConnectionSettings) -> TrexClient | None:
    """Apply the settings to the line. Return a client if the board responds.

    Without a reply, this takes about 0.3 s on a local port. A second query checks the address.

    Raises:
        BadRequest: the port does not support the settings.
        PortUnavailable: the line was lost.
    """
    if not settings.reserved:
        flush(transport, settings.timeouts.extra)
    transport.reconfigure(settings.line)
    reply = send_probe(transport, Attempt.at(settings), settings.timeouts.extra)
    if reply.kind not in {ReplyKind.BOARD, ReplyKind.SEVERAL}:
        return None
    client = TrexClient(transport, settings, echo=reply.echo)
    try:
        query(client.request, GetSignature())
    except (NoReply, BadReply):
        return None
    return client
