"""What happened to the robot, in sentences with times."""

from collections.abc import Sequence

from PySide6.QtCore import QCoreApplication

from trex_gui.devices.aracna.model.robot_state import Missed, RobotState, SpeedRefused
from trex_gui.devices.aracna.session.messages import (
    Ending,
    Moved,
    PlayEnded,
    Restarted,
    SpeedsHeld,
    Stuck,
)
from trex_gui.ui.event_log import EventKind, EventLog


def tr(text: str) -> str:
    """Translate a text of this file."""
    return QCoreApplication.translate("RobotEventLog", text)


def missed_text(missed: Missed) -> str:
    """Say where a motor is that was sent elsewhere."""
    if missed.unreadable:
        return tr("motor {0} did not say where it is (−1)").format(missed.motor)
    text = tr("motor {0} is at {1}, {2} from its goal {3}")
    away = f"{missed.present - missed.goal:+d}".replace("-", "−")
    return text.format(missed.motor, missed.present, away, missed.goal)


def speed_text(refused: SpeedRefused) -> str:
    """Say what a servo made of its speed."""
    if refused.unreadable:
        return tr("motor {0} does not answer (−1): no servo power, or its cable").format(
            refused.motor
        )
    text = tr("motor {0} holds speed {1}, not {2}")
    return text.format(refused.motor, refused.held, refused.wanted)


def missed_texts(known: RobotState) -> list[str]:
    """Say of each motor where it is that was sent elsewhere; once, where none has said it."""
    if known.is_lost:
        return [tr("the answer was lost (or no motor answers): positions are not known")]
    return [missed_text(each) for each in known.missed]


def speed_texts(known: RobotState) -> list[str]:
    """Say what the servos made of their speeds; once, where none answers."""
    if known.no_servo_answers:
        return [tr("no motor answers (−1): is the servo power on?")]
    return [speed_text(each) for each in known.speeds_refused]


def joined(texts: Sequence[str]) -> str:
    """Make one sentence of clauses."""
    text = "; ".join(texts)
    end = "" if text.endswith("?") else "."
    return f"{text[:1].upper()}{text[1:]}{end}"


def stuck_text(motor: int | None) -> str:
    """Say what is waited for, and what to look at."""
    if motor is None:
        return tr("The robot does not answer at all. Look at its power and at the cable.")
    return tr(
        "The robot waits for motor {0}, and listens to nothing until it answers. Look at the servo "
        "power, at the board's, and at the cable of this servo, and whether something blocks it. A "
        "reset of the board ends the wait; it does not stop the servos."
    ).format(motor)


_ENDINGS = {
    Ending.DONE: "Played to the end.",
    Ending.ENDED: "The sequence has ended after its step.",
    Ending.HALTED: "The sequence was stopped.",
    Ending.RESTARTED: "The sequence was broken off: the board has restarted.",
    Ending.STUCK: "The sequence was broken off: the robot waits for a motor.",
    Ending.SPEEDS: "The sequence was broken off: a motor did not take its speed.",
    Ending.MISSED: "The sequence was broken off: a motor was far from its goal.",
    Ending.LOST: "The sequence was broken off: the robot does not answer.",
}


class RobotEventLog:
    """Writes into a list of events what is worth knowing afterwards."""

    def __init__(self, events: EventLog) -> None:
        self._events = events

    def follow(self, report: object, known: RobotState) -> None:
        """Note a report, once it is taken into what is `known`."""
        match report:
            case Restarted():
                self._note(
                    EventKind.FAULT,
                    tr("The board has restarted. Its servos keep their goals and go on."),
                )
            case Moved() if known.missed:
                self._note(EventKind.FAULT, joined(missed_texts(known)))
            case SpeedsHeld() if known.speeds_refused:
                self._note(EventKind.FAULT, joined(speed_texts(known)))
            case Stuck(motor=motor):
                self._note(EventKind.FAULT, stuck_text(motor))
            case PlayEnded(why=why):
                self._note(EventKind.NOTE, tr(_ENDINGS[why]))
            case _:
                pass

    def play_begins(self, steps: int, rounds: int) -> None:
        """Note that something is played."""
        often = tr("for ever") if rounds == 0 else tr("{0} times").format(rounds)
        self._note(EventKind.NOTE, tr("Playing {0} steps, {1}.").format(steps, often))

    def move_begins(self, goals: Sequence[int]) -> None:
        """Note that a person sends every motor to a goal."""
        self._note(EventKind.NOTE, tr("Move to {0}.").format(", ".join(map(str, goals))))

    def halted(self, remaining: float) -> None:
        """Note that a person has stopped what is played."""
        text = tr("Stopped: nothing more is sent.")
        if remaining > 0:
            text += " " + tr("The motion that runs ends by itself in about {0:.1f} s.").format(
                remaining
            )
        self._note(EventKind.STOP, text)

    def _note(self, kind: EventKind, text: str) -> None:
        self._events.add(kind, text)
