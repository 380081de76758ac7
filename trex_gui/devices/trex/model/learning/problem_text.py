"""Sentences for problems of a channel that is being learned."""

from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.calibration.problems import CalibrationProblem, ProblemKind


def problem_text(problem: CalibrationProblem) -> str:
    return " ".join(_sentences()[problem.kind, problem.variant]).format(
        *(Number(value) if isinstance(value, float) else value for value in problem.values)
    )


def problems_text(problems: tuple[CalibrationProblem, ...]) -> str:
    return " ".join(map(problem_text, problems))


def _sentences() -> dict[tuple[ProblemKind, str], list[str]]:
    kind = ProblemKind
    moved = tr(
        "The signal moved during sampling, between {0} and {1}. Release the stick and sample again."
    )
    worn = tr(
        "Release the stick and sample again. If the drift continues, the stick or the "
        "transmitter is warming up or worn."
    )
    weak = tr("Move the transmitter closer, or check the antenna and the cable.")
    noisy = tr(
        "At rest the noise is {0}: a deadband wide enough to hide this noise would take a "
        "quarter of the travel. Repair the cable, the supply or the stick first."
    )
    open_input = tr("An unconnected input behaves in the same way.")
    unmoved = tr(
        "Either nothing is connected to this input (its voltage is then meaningless), or its "
        "stick was not moved."
    )
    needed = tr("At least {1} is needed: the deadband plus one count for each of the {2} speeds.")
    other_way = tr(
        "Push the stick in the other direction, too. If this is not possible, the stick was "
        "at an end during sampling."
    )
    one_way = tr("The stick moved in one direction only.")
    hold = tr("Go back, push the stick all the way and hold this position for {0:.1f} s.")
    uneven = tr("The stick moved {0} to one side, but only {1} to the other side.")
    all_the_way = tr("Was the stick pushed all the way?")
    refused = tr("The board would reject this: {0}.")
    reverse = tr("Should the channel be reversed?")
    return {
        (kind.NO_SIGNAL, "RC"): [
            tr("No signal: no valid pulse arrives."),
            tr("Is the transmitter on, and is the receiver connected to this channel?"),
        ],
        (kind.NO_SIGNAL, "ANALOG"): [tr("No signal.")],
        (kind.MOVED, "RC"): [moved],
        (kind.MOVED, "ANALOG"): [moved, open_input],
        (kind.MOVED, "UP"): [tr("The signal drifted up by {0} during sampling."), worn],
        (kind.MOVED, "DOWN"): [tr("The signal drifted down by {0} during sampling."), worn],
        (kind.JITTER, "LOST"): [
            tr("The signal comes and goes: {0:.0%} of the samples had no valid pulse."),
            weak,
        ],
        (kind.JITTER, "SPIKES"): [
            tr("Outlying pulses: {0} of {1}."),
            tr("The radio link is poor, or the cable picks up noise."),
        ],
        (kind.JITTER, "STUCK"): [
            tr(
                "About {0:.0%} of the pulses are lost (estimated: the value often repeats where "
                "it otherwise varies)."
            ),
            weak,
            tr(
                "The board repeats the last value, so losses below a third, or losses in a "
                "steadier signal, cannot be detected."
            ),
        ],
        (kind.NOISE, "RC"): [noisy],
        (kind.NOISE, "ANALOG"): [noisy, open_input],
        (kind.NOISE, "CREEP"): [
            tr("At rest the noise is {0}, more than the deadband ({1}): the motor would creep.")
        ],
        (kind.NEVER_MOVED, "RC"): [
            tr("A steady signal arrives, but it never moved."),
            tr("Either another stick controls this channel, or the stick was not moved."),
        ],
        (kind.NEVER_MOVED, "ANALOG"): [
            tr("This input does not change: it stays at {0}."),
            unmoved,
        ],
        (kind.NEVER_MOVED, "RAIL"): [
            tr("This input does not change: it stays at {0}, an end of the measuring range."),
            unmoved,
        ],
        (kind.TOO_LITTLE, ""): [tr("The stick moved only {0} from its rest position."), needed],
        (kind.ONE_DIRECTION, "DOWN"): [one_way, other_way],
        (kind.ONE_DIRECTION, "UP"): [one_way, other_way],
        (kind.END_TOO_NEAR, "DOWN"): [
            tr("The low end is only {0} from the rest position."),
            needed,
        ],
        (kind.END_TOO_NEAR, "UP"): [tr("The high end is only {0} from the rest position."), needed],
        (kind.NOT_HELD, "DOWN"): [tr("The low end was only passed, not held."), hold],
        (kind.NOT_HELD, "UP"): [tr("The high end was only passed, not held."), hold],
        (kind.NOT_HELD, "BOTH"): [tr("Both ends were only passed, not held."), hold],
        (kind.NEUTRAL_OUTSIDE, ""): [
            tr("The rest position ({0}) is not between the ends ({1} and {2})."),
            tr("Was a trim moved? Begin again with the sticks at rest."),
        ],
        (kind.UNEVEN, "DOWN"): [uneven, all_the_way],
        (kind.UNEVEN, "UP"): [uneven, all_the_way],
        (kind.REFUSED, "MEASURED"): [refused],
        (kind.REFUSED, "CHOSEN"): [refused],
        (kind.NEUTRAL_MOVED, "CHOSEN"): [
            tr("The stick rests at {0}: with this neutral, the output there would be {1}.")
        ],
        (kind.NEUTRAL_MOVED, "MEASURED"): [
            tr(
                "After release the stick rests at {0}, not at {1}, and the output there would "
                "be {2}."
            ),
            tr("Was a hand on the stick during sampling, or was a trim moved?"),
            tr("Go back and sample the channel again, or use the new rest position."),
        ],
        (kind.USELESS, ""): ["{0}"],
        (kind.NEVER_FULL, ""): [
            tr(
                "{0} is beyond {1}, the farthest value reached: the output cannot reach its "
                "full value."
            )
        ],
        (kind.SPEEDS_UP, ""): [
            tr(
                "Beyond the rest position the motor speeds up again: at {0}, to {1} of {2} "
                "in either direction."
            ),
            tr("Check that no trim and no broken wire can move the signal there."),
        ],
        (kind.SWITCHES_AT_REST, ""): [
            tr("The rest position ({0}) is too close to the switching point ({1})."),
            tr("The channel may switch by itself."),
        ],
        (kind.NEVER_SWITCHES, "ACTIVE"): [
            tr(
                "The switch is active in all its positions: none is beyond the switching "
                "point, {0}."
            ),
            reverse,
        ],
        (kind.NEVER_SWITCHES, "INACTIVE"): [
            tr(
                "The switch is inactive in all its positions: none is beyond the switching "
                "point, {0}."
            ),
            reverse,
        ],
    }
