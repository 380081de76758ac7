"""One command in flight on a line to the robot.

The answer to a `.c` comes as the motors arrive, so nothing here waits for an answer: whoever
owns the line begins a command and listens in small slices, and is told what has come of it.

The one thing that may be sent behind a command that is not answered is a single `.q`: three
bytes, which the chip keeps while the firmware is busy. Its answer shows that the firmware is
free again; a late answer to the command itself comes before it.
"""

from collections.abc import Sequence
from dataclasses import replace

from trex_gui.core.errors import BadReply, BadRequest, NoReply, StudioError
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.devices.aracna.protocol import lines
from trex_gui.devices.aracna.protocol.replies import (
    Hello,
    Led,
    Positions,
    Reader,
    Reply,
    Speeds,
    Strange,
    Version,
)
from trex_gui.devices.aracna.session.command_events import (
    Answered,
    LateReply,
    Lost,
    News,
    Passing,
    Sent,
    Voided,
)
from trex_gui.devices.aracna.session.messages import LineStats

LINE = SerialFormat(lines.BAUD)

ANSWER = 1.0
"""Seconds within which `.q`, `.l` and `.v` are answered; the slowest takes 0.06 s on a wire."""

ASK_AGAIN = 5.0
"""Seconds after which a robot that has broken off in mid-answer is asked once more whether it is
free. Its chip keeps one `.q`, however often that was sent, and answers once."""

_KEPT = 48
"""Bytes that are kept of what nobody understands, to show them."""


class AracnaClient:
    """Talks over an open line, which it tells the robot's settings.

    Attributes:
        motors: how many values a command has; from the answer to `.q`.
        asked: what is on its way.
        received: the first bytes that came, to show where none of them is a reply.
    """

    def __init__(self, transport: Transport, settings: PortSettings) -> None:
        self.transport = transport
        self.settings = settings.at(LINE)
        self.motors = 0
        self.asked: Sent | None = None
        self.received = b""
        self.counters = LineStats()
        self._strange = b""
        self._reader = Reader()
        self._passed: tuple[int, ...] | None = None
        self._is_late = False
        self._free_by: float | None = None  # when an answer to the `.q` behind it is late

    @property
    def slack(self) -> float:
        """Seconds that an answer may be late for reasons that are not the robot's."""
        return self.transport.latency + self.settings.timeouts.extra

    @property
    def waits_for(self) -> int | None:
        """The motor that a streamed answer waits for; `None` while none comes."""
        passed = self._reader.passed
        return None if passed is None else len(passed)

    # --- Commands -----------------------------------------------------------------------

    def query(self, seconds: float = ANSWER) -> None:
        """Ask for version and number of motors.

        Raises:
            PortUnavailable: the line is gone.
        """
        self._send("q", (), lines.QUERY, seconds)

    def set_led(self, *, on: bool) -> None:
        """Switch the debug LED.

        Raises:
            PortUnavailable: the line is gone.
        """
        self._send("l", (), lines.LED[on], ANSWER)

    def set_speeds(self, values: Sequence[int]) -> None:
        """Give every servo a speed.

        Raises:
            BadRequest: not one value of 0-1023 for each motor.
            PortUnavailable: the line is gone.
        """
        self._send("v", tuple(values), lines.speeds(values, self._known_motors()), ANSWER)

    def move(self, goals: Sequence[int], seconds: float) -> None:
        """Send every motor to a goal; the answer is late after so many seconds.

        Raises:
            BadRequest: not one value of 0-1023 for each motor.
            PortUnavailable: the line is gone.
        """
        self._send("c", tuple(goals), lines.positions(goals, self._known_motors()), seconds)

    def _known_motors(self) -> int:
        if not self.motors:
            raise NoReply("The robot has not said yet how many motors it has.")
        return self.motors

    def _send(self, letter: str, values: tuple[int, ...], line: bytes, seconds: float) -> None:
        if self.asked is not None:
            raise BadRequest("One command at a time: the last one is not answered yet.")
        self.transport.write(line)
        self.asked = Sent(letter, values, self.transport.clock(), seconds + self.slack)
        self._passed = None
        self._strange = b""
        self._is_late = False
        self._free_by = None
        self.counters = replace(self.counters, requests=self.counters.requests + 1)

    # --- Answers ------------------------------------------------------------------------

    def listen(self, seconds: float = 0.0) -> list[News]:
        """Return what has come of it, waiting up to `seconds` for the first byte.

        Raises:
            PortUnavailable: the line is gone.
        """
        data = self.transport.read(1, seconds) if seconds > 0 else b""
        looked = self.transport.clock()  # what had not come by then was late, whenever this is read
        try:
            data += self.transport.discard()
        except BadReply:  # bytes without end are no answer; some of them show what it is
            data += self.transport.read(_KEPT, 0.0)
        now = self.transport.clock()
        self.received = (self.received + data)[:_KEPT]
        news: list[News] = []
        for reply in self._reader.feed(data):
            news += self._take(reply, now)
        news += self._look_at_the_rest(now)
        news += self._look_at_the_clock(looked)
        return news

    def _take(self, reply: Reply, now: float) -> list[News]:
        if isinstance(reply, Hello):
            self.counters = replace(self.counters, restarts=self.counters.restarts + 1)
            voided, self.asked = self.asked, None
            return [Voided(voided, now)]
        asked = self.asked
        if not isinstance(reply, Strange) and asked is not None:
            if self._answers(asked, reply):
                self._count_answer(asked, now)
                self.asked = self._behind(now)
                return [Answered(asked, reply, now)]
            if isinstance(reply, Version) and self._free_by is not None:
                return [self._lose(self._why_lost(), now, free=True)]
        if isinstance(reply, Strange) or not isinstance(reply, Version):
            self._note_strange(reply)
            if asked is not None and asked.letter == "c":
                self._ask_whether_free(max(asked.sent + asked.seconds, now) + ANSWER + self.slack)
        return []

    def _answers(self, asked: Sent, reply: Reply) -> bool:
        match reply:
            case Version():
                return asked.letter == "q"
            case Led():
                return asked.letter == "l"
            case Speeds(values):
                return asked.letter == "v" and len(values) == self.motors
            case Positions(values):
                return asked.letter == "c" and len(values) == self.motors
            case _:
                return False

    def _behind(self, now: float) -> Sent | None:
        """Return what is answered next: the `.q` that went out behind a late command, if one did.

        The robot speaks then and does not listen.
        """
        if self._free_by is None:
            return None
        self._free_by = None
        return Sent("q", (), now, ANSWER + self.slack)

    def _count_answer(self, asked: Sent, now: float) -> None:
        counters = self.counters
        if not counters.answers:  # until now nobody knew whether it listens
            self.counters = LineStats(requests=1, answers=1)
            return
        took = 0.0 if asked.letter == "c" else now - asked.sent
        self.counters = replace(
            counters, answers=counters.answers + 1, slowest=max(counters.slowest, took)
        )

    def _note_strange(self, reply: Reply) -> None:
        self.counters = replace(self.counters, strange=self.counters.strange + 1)
        if isinstance(reply, Strange):
            self._strange = reply.line

    def _look_at_the_rest(self, now: float) -> list[News]:
        passed = self._reader.passed
        if self.asked is None or self.asked.letter != "c" or passed in {None, self._passed}:
            return []
        self._passed = passed
        if self._is_late:  # the next motor may be waited for in vain, too
            self._is_late = False
            seconds = max(self.asked.seconds, now - self.asked.sent + ANSWER + self.slack)
            self.asked = replace(self.asked, seconds=seconds)
        return [Passing(self.asked, passed or (), now)]

    def _look_at_the_clock(self, now: float) -> list[News]:
        asked = self.asked
        if asked is None:
            return []
        if self._free_by is not None and now >= self._free_by:
            if self.waits_for is None:
                return [self._lose(self._why_lost(), now, free=False)]
            # The end of the line may be lost, and with it the answer to what was asked then.
            self._free_by = None
            self._ask_whether_free(now + ASK_AGAIN)
        if self._is_late or now < asked.sent + asked.seconds:
            return []
        if asked.letter != "c":
            return [self._lose(self._why_lost(), now, free=False)]
        self._is_late = True
        self._ask_whether_free(now + ANSWER + self.slack)
        return [LateReply(asked, self.waits_for, now)]

    def _ask_whether_free(self, by: float) -> None:
        if self._free_by is None:
            self._free_by = by
            self.transport.write(lines.QUERY)
            self.counters = replace(self.counters, requests=self.counters.requests + 1)

    def _why_lost(self) -> StudioError:
        if self._strange:
            return BadReply(f"What came back is no answer to this: {shown(self._strange)}.")
        return NoReply("The robot has not answered in time.")

    def _lose(self, error: StudioError, now: float, *, free: bool) -> Lost:
        assert self.asked is not None  # noqa: S101 - for the type checker
        lost, self.asked = self.asked, None
        if free or self._strange:  # the robot is there, or something came
            self.counters = replace(self.counters, damaged=self.counters.damaged + 1)
        else:
            self.counters = replace(self.counters, silences=self.counters.silences + 1)
        return Lost(lost, error, free, now)

    def close(self) -> None:
        """Give the port back; never raises."""
        self.transport.close()


def shown(data: bytes) -> str:
    """Return bytes as a person can read them: text where it is, else hexadecimal."""
    data = data.strip(b"\r\n")
    if data and all(0x20 <= byte < 0x7F for byte in data):
        return data.decode("ascii")
    return data[:12].hex(" ").upper() + (" …" if len(data) > 12 else "")
