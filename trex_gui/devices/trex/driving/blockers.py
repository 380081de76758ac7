"""Reasons why motors do not run, with texts for the user."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import Enum, IntEnum, unique

from trex_gui.core.translation import tr, tr_noop


class Effect(IntEnum):
    """Effect of a reason on the motors, worst first. JSON uses the names in lower case."""

    STOPS = 0  # the motors are off or may be off, in every mode
    BLOCKS = 1  # serial commands do not reach the motors
    LIMITS = 2  # the motors run more slowly than commanded
    NOTE = 3


@unique
class DriveBlocker(Enum):
    """Reason why the motors do not follow the setpoints, or a note about them.

    Reasons with equal effect are shown in this order. `Reason.fields` fills the placeholders.
    """

    LOST = (
        Effect.STOPS,
        tr_noop("The connection was lost: motors may still be turning."),
        tr_noop("Cut the power."),
    )
    SILENT = (
        Effect.STOPS,
        tr_noop("The board does not respond."),
        tr_noop("Check its power and the cable."),
    )
    NETWORK_SILENT = (
        Effect.BLOCKS,
        tr_noop("The server of the robot does not respond."),
        tr_noop("The server stops the motors half a second after the last heartbeat."),
    )
    CHANNEL_SILENT = (
        Effect.STOPS,
        tr_noop("Channel {0} is required but has no signal."),
        tr_noop(
            "Safe-start keeps the motors off: switch the transmitter on and release its sticks."
        ),
    )
    CHANNEL_ABOVE = (
        Effect.STOPS,
        tr_noop("Channel {0} is {1} above neutral."),
        tr_noop(
            "Safe-start holds the motors until the channel is within about {2} of neutral "
            "(inferred): release the stick, or calibrate the channel (in serial mode)."
        ),
    )
    CHANNEL_BELOW = (Effect.STOPS, tr_noop("Channel {0} is {1} below neutral."), CHANNEL_ABOVE[2])
    OVERRIDE_AT_START = (
        Effect.STOPS,
        tr_noop("Channel 5 requests serial override."),
        tr_noop("Safe-start holds the motors until you turn the switch of channel 5 off."),
    )
    SAFE_START = (
        Effect.STOPS,
        tr_noop("Safe-start may be holding the motors (inferred)."),
        tr_noop("Release all sticks."),
    )
    FAULT = (
        Effect.STOPS,
        tr_noop(
            "Motor {0} is off: its driver shut down because of overheating, a short circuit "
            "or low voltage."
        ),
        tr_noop("Reduce the load, check the wires and the battery, and let the driver cool."),
    )
    TIMEOUT = (
        Effect.STOPS,
        tr_noop("Serial timeout: the board received nothing for {0}."),
        tr_noop("Check the cable, or set a longer Serial Timeout in Parameters."),
    )
    LINE_ERROR = (
        Effect.STOPS,
        tr_noop("Serial errors ({0}): the board stops the motors when bytes arrive corrupted."),
        tr_noop(
            "Check the cable and the ground connection. Without UART-Error Shutdown, the "
            "Serial Timeout may not stop the motors either (twin)."
        ),
    )
    STOPPING = (
        Effect.STOPS,
        tr_noop("Stopping: the board has not confirmed the stop yet."),
        tr_noop("The stop is being repeated. Motors may still be turning."),
    )
    LOCKED = (
        Effect.STOPS,
        tr_noop("Stopped. The motors are locked for {0} s."),
        tr_noop("Then arm them again."),
    )
    OTHER_DRIVES = (
        Effect.BLOCKS,
        tr_noop("{0} drives this robot. You can watch and stop it."),
        tr_noop("“Arm motors” asks {0} to hand over control."),
    )
    NO_BOARD = (
        Effect.BLOCKS,
        tr_noop("No board is connected."),
        tr_noop("Select a port above and press Connect."),
    )
    OPENING = (Effect.BLOCKS, tr_noop("The program is connecting to the board."))
    CLOSING = (Effect.BLOCKS, tr_noop("The connection is being closed."))
    UNKNOWN = (Effect.BLOCKS, tr_noop("The board has not yet reported what controls the motors."))
    NOT_SERIAL = (
        Effect.BLOCKS,
        tr_noop("The board reports that serial commands do not control the motors."),
        tr_noop("Switch the board off and on."),
    )
    RC_CHANNELS = (
        Effect.BLOCKS,
        tr_noop("The RC channels control the motors, not serial commands."),
        tr_noop(
            "To drive by serial commands, turn on the override switch (channel 5), or switch "
            "the board off, remove the mode jumper and switch the board on again."
        ),
    )
    ANALOG_CHANNELS = (
        Effect.BLOCKS,
        tr_noop("The analog channels control the motors, not serial commands."),
        RC_CHANNELS[2],
    )
    SEVERAL_BOARDS = (
        Effect.BLOCKS,
        tr_noop("Commands without a device number would reach several boards."),
        tr_noop("Select one of the boards on this line."),
    )
    GROUP = (
        Effect.BLOCKS,
        tr_noop("Board {0}, which is driven together with this board, does not follow commands."),
        tr_noop("Its diagram shows why. “Drive alone” drives the other board without it."),
    )
    NOT_ALLOWED = (Effect.BLOCKS, tr_noop("The motors cannot be armed at this moment."))
    STOPPED = (Effect.BLOCKS, tr_noop("Stopped. {0}"), tr_noop("Arm the motors again to continue."))
    NOT_ARMED = (
        Effect.BLOCKS,
        tr_noop("Not armed: no motor is driven."),
        tr_noop("Put the robot on blocks, then arm the motors."),
    )
    OVER_LIMIT = (
        Effect.LIMITS,
        tr_noop("Motor {0} is slowed down: its current exceeds the limit."),
        tr_noop("Reduce the load, or raise the current limit in Parameters."),
    )
    RUNNING = (
        Effect.NOTE,
        tr_noop("The motors are armed: the controls on the Motors page move them."),
        tr_noop("Esc stops everything."),
    )
    OVERRIDE = (
        Effect.NOTE,
        tr_noop("Channel 5 overrides the sticks for as long as its switch is on."),
    )
    JOINT = (Effect.NOTE, tr_noop("Joint mode: both drivers work as one motor."))

    def __init__(self, effect: Effect, text: str, remedy: str = "") -> None:
        self.effect = effect
        self.text = text
        self.remedy = remedy


@dataclass(frozen=True, slots=True)
class Reason:
    """Blocker with the values for its placeholders. A tuple value holds names to translate."""

    blocker: DriveBlocker
    fields: tuple[object, ...] = ()

    def text(self) -> str:
        return tr(self.blocker.text).format(*self._values())

    def remedy(self) -> str:
        """Return the remedy as a sentence, or an empty string."""
        return tr(self.blocker.remedy).format(*self._values()) if self.blocker.remedy else ""

    def _values(self) -> Iterator[object]:
        for field in self.fields:
            if isinstance(field, tuple):
                yield ", ".join(tr(str(name)) for name in field)
            else:
                yield field


def worst_first(reasons: Iterable[Reason]) -> tuple[Reason, ...]:
    order = list(DriveBlocker)
    return tuple(
        sorted(reasons, key=lambda reason: (reason.blocker.effect, order.index(reason.blocker)))
    )
