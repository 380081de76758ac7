"""Texts for joints, quantities and states of the robot."""

from collections.abc import Sequence

from trex_gui.core.events import EventKind
from trex_gui.core.texts import signed_text
from trex_gui.core.translation import Number, tr
from trex_gui.devices.aracna.model.robot_state import RobotState
from trex_gui.devices.aracna.protocol.joints import LEGS, MOTORS, degrees, degrees_per_second
from trex_gui.devices.aracna.session.errors import ErrorCode
from trex_gui.devices.aracna.session.messages import Moved, PlayEnded, Restarted, SpeedsHeld, Stuck
from trex_gui.ui.translations import error_text


def joint_text(motor: int) -> str:
    """Return a motor and its joint, such as `0 inner`. The joint is unknown from motor 8 on."""
    if motor >= MOTORS:
        return str(motor)
    return f"{motor} {tr('outer') if motor % 2 else tr('inner')}"


def spoken_joint(motor: int) -> str:
    if motor >= MOTORS:
        return tr("Motor {0}").format(motor)
    leg = tr(LEGS[motor // 2]).lower()
    return tr("Motor {0}, {1} leg").format(joint_text(motor), leg)


def position_text(position: int | None) -> str:
    """Return units and degrees, such as `512 = 150.1°`."""
    return "–" if position is None else f"{position} = {Number(degrees(position)):.1f}°"


def speed_text(speed: int) -> str:
    per_second = degrees_per_second(speed)
    return tr("unlimited") if per_second is None else f"{per_second:.0f} °/s"


def drawing_text() -> str:
    return tr(
        "Solid lines: last reported positions. Dashed lines: goals. In this sketch, "
        "all angles are drawn flat."
    )


def assumed_text() -> str:
    return tr(
        "The order of the legs is assumed. Even motors are inner joints, odd motors "
        "are outer joints."
    )


def missed_goals_text(state: RobotState) -> str:
    if state.reply_lost:
        return tr("The reply was lost, or no motor responds. The positions are unknown.")
    return " ".join(map(error_text, state.missed_goals.values()))


def difference_text(state: RobotState, motor: int, *, is_observed: bool = True) -> tuple[str, bool]:
    """Return a motor's problem, `moving …` or its difference from the goal.

    Also return True for a problem. `is_observed`: True if the robot responds.
    """
    present = state.present[motor]
    difference = ""
    if present is not None and state.goals is not None:
        difference = signed_text(present - state.goals[motor])
    if state.stuck is not None and state.stuck.motor == motor:
        return tr("stuck here"), True
    if state.moving is not None:
        is_awaited = is_observed and state.awaited_motor <= motor
        return tr("moving …") if is_awaited else difference, False
    missed = state.missed_goals.get(motor)
    if missed is not None and missed.code is ErrorCode.GOAL_MISSED:
        return tr("missed by {0}").format(difference), True
    if missed is not None or (state.held_speed(motor) or 0) < 0:
        return tr("no reply (−1)"), True
    return difference, False


def activity_text(state: RobotState, remaining: float) -> tuple[str, bool]:
    """Return the activity of a robot. Also return True if it calls for caution.

    `remaining`: seconds until a motion should end.
    """
    if state.stuck is not None:
        return waiting_text(state.stuck.motor), True
    texts = [_playing_text(state)]
    if state.moving is not None and remaining > 0:
        texts.append(ending_text(remaining))
    elif state.moving is not None:
        texts.append(tr("Waiting for motor {0} to arrive …").format(state.awaited_motor))
    if any(texts):
        return " ".join(filter(None, texts)), True
    if not state.may_be_moving:
        return tr("At rest: nothing is sent."), False
    if remaining > 0:
        text = tr("Unknown: a motion may continue for about {0:.0f} s.")
        return text.format(max(remaining, 1)), True
    if state.uncertain:
        return tr("Unknown: the last motion may still be running."), True
    return tr(
        "Nothing is sent. The robot may be moving: its state is unknown until its first move."
    ), False


def ending_text(remaining: float) -> str:
    """Return the remaining time of a motion, or an empty text for 0."""
    text = tr("The motion ends by itself in about {0:.1f} s.")
    return text.format(Number(remaining)) if remaining > 0 else ""


def _playing_text(state: RobotState) -> str:
    play, step = state.play, state.step
    if step is None:
        return "" if play is None else tr("The sequence starts.")
    if step.part != "steps":
        return tr("Playing blend-in.") if step.part == "in" else tr("Playing blend-out.")
    number, round_ = step.index + 1, step.round + 1
    if play is None:  # a recording does not contain the `Play`
        return tr("Playing step {0}, round {1}.").format(number, round_)
    text = tr("Playing step {0} of {1} “{2}”, round {3} of {4}.")
    name = play.steps[step.index].name
    return text.format(number, len(play.steps), name, round_, play.rounds or "∞")


def waiting_text(motor: int | None) -> str:
    if motor is None:
        return tr("The robot does not respond.")
    return tr(ErrorCode.MOTOR_STUCK.value).format(motor)


def stuck_text(motor: int | None) -> str:
    hint = tr("Check its power and the cable.")
    if motor is not None:
        hint = tr(
            "Check the servo power, the cable, and whether the servo is blocked. Resetting "
            "the board ends the wait, but does not stop the servos."
        )
    return f"{waiting_text(motor)} {hint}"


def clamped_goals_text(goals: Sequence[int], clamped: Sequence[int]) -> str:
    changes = [
        tr("motor {0} to {1} instead of {2}").format(motor, sent, goal)
        for motor, (goal, sent) in enumerate(zip(goals, clamped, strict=True))
        if goal != sent
    ]
    return tr("Clamped to the limits of the joints: {0}.").format(", ".join(changes))


def event_of(report: object, state: RobotState) -> tuple[EventKind, str] | None:
    match report:
        case Restarted():
            text = tr("The board has restarted. Its servos continue to their goals.")
            return EventKind.FAULT, text
        case Moved() if state.missed_goals:
            return EventKind.FAULT, missed_goals_text(state)
        case SpeedsHeld() if state.speed_error is not None:
            return EventKind.FAULT, error_text(state.speed_error)
        case Stuck(motor=motor):
            return EventKind.FAULT, stuck_text(motor)
        case PlayEnded(ending=ending):
            return EventKind.NOTE, tr(ending.value)
    return None
