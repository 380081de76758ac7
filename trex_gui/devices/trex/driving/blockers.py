"""Reasons why motors do not run, with their sentences.

The command line shows the sentences as they are, the window translates them.
"""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from enum import Enum, IntEnum, unique

from trex_gui.core.errors import QT_TRANSLATE_NOOP

TEXT_CONTEXT = "DriveBlocker"
"""Of everything here that is translated."""


class Effect(IntEnum):
    """What a reason does to the motors, the worst first; JSON has the names in lower case."""

    STOPS = 0  # the motors are off, or may be, whatever drives them
    BLOCKS = 1  # serial commands do not reach them
    LIMITS = 2  # they run more slowly than they should
    NOTE = 3


@unique
class DriveBlocker(Enum):
    """A reason why the motors do not follow the setpoints; the last ones say that they do.

    Reasons with the same effect are shown in this order. Fields of the sentences are in braces.
    """

    LOST = (
        Effect.STOPS,
        QT_TRANSLATE_NOOP("DriveBlocker", "The connection was lost: motors may still turn."),
        QT_TRANSLATE_NOOP("DriveBlocker", "Cut their power."),
    )
    SILENT = (
        Effect.STOPS,
        QT_TRANSLATE_NOOP("DriveBlocker", "The board does not respond."),
        QT_TRANSLATE_NOOP("DriveBlocker", "Check its power and the cable."),
    )
    CHANNEL_SILENT = (
        Effect.STOPS,
        QT_TRANSLATE_NOOP("DriveBlocker", "Channel {0} is required but has no signal."),
        QT_TRANSLATE_NOOP(
            "DriveBlocker",
            "Safe-start keeps the motors off: switch the transmitter on and release its sticks.",
        ),
    )
    CHANNEL_ABOVE = (
        Effect.STOPS,
        QT_TRANSLATE_NOOP("DriveBlocker", "Channel {0} is {1} above neutral."),
        QT_TRANSLATE_NOOP(
            "DriveBlocker",
            "Safe-start holds the motors until it is within about {2}: release the stick, or "
            "calibrate the channel (in serial mode).",
        ),
    )
    CHANNEL_BELOW = (
        Effect.STOPS,
        QT_TRANSLATE_NOOP("DriveBlocker", "Channel {0} is {1} below neutral."),
        CHANNEL_ABOVE[2],
    )
    OVERRIDE_AT_START = (
        Effect.STOPS,
        QT_TRANSLATE_NOOP("DriveBlocker", "Channel 5 requests serial override."),
        QT_TRANSLATE_NOOP(
            "DriveBlocker", "Safe-start holds the motors until this switch is off once."
        ),
    )
    SAFE_START = (
        Effect.STOPS,
        QT_TRANSLATE_NOOP("DriveBlocker", "Safe-start may be holding the motors."),
        QT_TRANSLATE_NOOP("DriveBlocker", "Release all sticks."),
    )
    FAULT = (
        Effect.STOPS,
        QT_TRANSLATE_NOOP(
            "DriveBlocker",
            "Motor {0} has no drive: its driver shut down (too hot, a short circuit, or low "
            "voltage).",
        ),
        QT_TRANSLATE_NOOP("DriveBlocker", "Reduce the load, check wires and battery, let it cool."),
    )
    TIMEOUT = (
        Effect.STOPS,
        QT_TRANSLATE_NOOP(
            "DriveBlocker",
            "Serial timeout ({0}): the board received nothing and stopped the motors.",
        ),
        QT_TRANSLATE_NOOP(
            "DriveBlocker", "Check the cable, or set a longer Serial Timeout in Parameters."
        ),
    )
    LINE_ERROR = (
        Effect.STOPS,
        QT_TRANSLATE_NOOP(
            "DriveBlocker",
            "Serial errors ({0}): the board stops the motors when bytes arrive corrupted.",
        ),
        QT_TRANSLATE_NOOP(
            "DriveBlocker",
            "Check cable and ground; UART-Error Shutdown can be turned off in Parameters.",
        ),
    )
    STOPPING = (
        Effect.STOPS,
        QT_TRANSLATE_NOOP("DriveBlocker", "Stopping: the board has not confirmed it yet."),
        QT_TRANSLATE_NOOP("DriveBlocker", "The stop is being repeated; motors may still turn."),
    )
    LOCKED = (
        Effect.STOPS,
        QT_TRANSLATE_NOOP("DriveBlocker", "Stopped. The motors are locked for {0} s."),
        QT_TRANSLATE_NOOP("DriveBlocker", "Then Run motor arms them again."),
    )
    NO_BOARD = (
        Effect.BLOCKS,
        QT_TRANSLATE_NOOP("DriveBlocker", "No board is connected."),
        QT_TRANSLATE_NOOP("DriveBlocker", "Choose a port above and press Connect."),
    )
    OPENING = (
        Effect.BLOCKS,
        QT_TRANSLATE_NOOP("DriveBlocker", "The program is connecting to the board."),
    )
    CLOSING = (Effect.BLOCKS, QT_TRANSLATE_NOOP("DriveBlocker", "The connection is being closed."))
    UNKNOWN = (
        Effect.BLOCKS,
        QT_TRANSLATE_NOOP(
            "DriveBlocker", "The board has not reported yet what controls the motors."
        ),
    )
    NOT_SERIAL = (
        Effect.BLOCKS,
        QT_TRANSLATE_NOOP(
            "DriveBlocker", "The board reports that serial commands do not control the motors."
        ),
        QT_TRANSLATE_NOOP("DriveBlocker", "Switch it off and on."),
    )
    RC_CHANNELS = (
        Effect.BLOCKS,
        QT_TRANSLATE_NOOP(
            "DriveBlocker", "The RC channels control the motors, not serial commands."
        ),
        QT_TRANSLATE_NOOP(
            "DriveBlocker",
            "To drive by serial commands, turn on the override switch (channel 5), or switch the "
            "board off, remove the mode jumper and switch it on.",
        ),
    )
    ANALOG_CHANNELS = (
        Effect.BLOCKS,
        QT_TRANSLATE_NOOP(
            "DriveBlocker", "The analog channels control the motors, not serial commands."
        ),
        RC_CHANNELS[2],
    )
    SEVERAL_BOARDS = (
        Effect.BLOCKS,
        QT_TRANSLATE_NOOP(
            "DriveBlocker", "Commands without a device number would reach several boards."
        ),
        QT_TRANSLATE_NOOP("DriveBlocker", "Select one of the boards on this line."),
    )
    NOT_ALLOWED = (
        Effect.BLOCKS,
        QT_TRANSLATE_NOOP("DriveBlocker", "The motors cannot be armed at this moment."),
    )
    STOPPED = (
        Effect.BLOCKS,
        QT_TRANSLATE_NOOP("DriveBlocker", "Stopped. {0}"),
        QT_TRANSLATE_NOOP("DriveBlocker", "Run motor arms the motors again."),
    )
    NOT_ARMED = (
        Effect.BLOCKS,
        QT_TRANSLATE_NOOP("DriveBlocker", "Not armed: nothing is sent yet."),
        QT_TRANSLATE_NOOP("DriveBlocker", "Put the robot on blocks, then press Run motor."),
    )
    OVER_LIMIT = (
        Effect.LIMITS,
        QT_TRANSLATE_NOOP("DriveBlocker", "Motor {0} is slowed down: current over the limit."),
        QT_TRANSLATE_NOOP(
            "DriveBlocker", "Reduce the load, or raise the current limit in Parameters."
        ),
    )
    RUNNING = (
        Effect.NOTE,
        QT_TRANSLATE_NOOP(
            "DriveBlocker", "The motors are armed: the controls on the Motors page move them."
        ),
        QT_TRANSLATE_NOOP("DriveBlocker", "Esc stops everything."),
    )
    OVERRIDE = (
        Effect.NOTE,
        QT_TRANSLATE_NOOP(
            "DriveBlocker", "Channel 5 overrides the sticks for as long as its switch is on."
        ),
    )
    JOINT = (
        Effect.NOTE,
        QT_TRANSLATE_NOOP("DriveBlocker", "Joint mode: both drivers work as one motor."),
    )

    def __init__(self, effect: Effect, text: str, remedy: str = "") -> None:
        self.effect = effect
        self.text = text
        self.remedy = remedy

    @property
    def is_obeyed(self) -> bool:
        """Whether the motors follow the setpoints, if more slowly."""
        return self.effect in {Effect.LIMITS, Effect.NOTE}

    @property
    def is_alarming(self) -> bool:
        """Whether something is wrong, rather than not started."""
        return self.effect in {Effect.STOPS, Effect.LIMITS}


@dataclass(frozen=True, slots=True)
class Reason:
    """A blocker with the fields of its sentences; a tuple is a list of names, translated too."""

    blocker: DriveBlocker
    fields: tuple[object, ...] = ()

    def text(self, translate: Callable[[str], str] = str) -> str:
        """Return what keeps the motors from running, as a sentence."""
        return translate(self.blocker.text).format(*self._words(translate))

    def remedy(self, translate: Callable[[str], str] = str) -> str:
        """Return what the user can do about it, as a sentence; empty if nothing."""
        remedy = self.blocker.remedy
        return translate(remedy).format(*self._words(translate)) if remedy else ""

    def _words(self, translate: Callable[[str], str]) -> Iterator[object]:
        for field in self.fields:
            if isinstance(field, tuple):
                yield ", ".join(translate(str(name)) for name in field).lower()
            else:
                yield field


def worst_first(reasons: Iterable[Reason]) -> tuple[Reason, ...]:
    order = list(DriveBlocker)
    return tuple(sorted(reasons, key=lambda one: (one.blocker.effect, order.index(one.blocker))))
