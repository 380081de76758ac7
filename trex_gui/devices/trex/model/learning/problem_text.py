"""Sentences for the problems of a channel that is learned."""

from PySide6.QtCore import QCoreApplication

from trex_gui.devices.trex.calibration.problems import Problem, ProblemKind


def problem_text(problem: Problem) -> str:
    """Return what is wrong and what to do about it."""
    return _texts()[problem.kind, problem.variant].format(*problem.values)


def problems_text(problems: tuple[Problem, ...]) -> str:
    return " ".join(map(problem_text, problems))


def _texts() -> dict[tuple[ProblemKind, str], str]:
    """Return the sentences by kind and variant; translated anew, since the language can change."""
    kind = ProblemKind
    open_input = _tr("An input to which nothing is connected does that, too.")
    moved = _tr("It moved during sampling, between {0} and {1}. Let go of it and sample again.")
    noisy = _tr(
        "At rest its noise is {0}: a deadband that holds it still would take a quarter of the "
        "travel. Repair the cable, the supply or the stick first."
    )
    return {
        (kind.NO_SIGNAL, "RC"): _tr(
            "No signal: no valid pulse arrives. Is the transmitter on, and is the receiver "
            "connected to this channel?"
        ),
        (kind.NO_SIGNAL, "ANALOG"): _tr("No signal."),
        (kind.MOVED, "RC"): moved,
        (kind.MOVED, "ANALOG"): f"{moved} {open_input}",
        (kind.MOVED, "UP"): _tr(
            "It drifted up by {0} during sampling. Let go of it and sample again; if it "
            "continues, the stick or the transmitter warms up or is worn."
        ),
        (kind.MOVED, "DOWN"): _tr(
            "It drifted down by {0} during sampling. Let go of it and sample again; if it "
            "continues, the stick or the transmitter warms up or is worn."
        ),
        (kind.JITTER, "LOST"): _tr(
            "The signal comes and goes: {0:.0%} of the samples had no valid pulse. Bring the "
            "transmitter nearer, or check antenna and cable."
        ),
        (kind.JITTER, "SPIKES"): _tr(
            "{0} of {1} pulses were far from all others: the radio link is poor, or the cable "
            "picks up noise."
        ),
        (kind.JITTER, "STUCK"): _tr(
            "About {0:.0%} of the pulses are lost (estimated: the value often repeats where it "
            "otherwise varies). Bring the transmitter nearer, or check antenna and cable. The "
            "board repeats the last value, so that losses below a third, or of a steadier "
            "signal, go unnoticed."
        ),
        (kind.NOISE, "RC"): noisy,
        (kind.NOISE, "ANALOG"): f"{noisy} {open_input}",
        (kind.NOISE, "CREEP"): _tr(
            "At rest the noise is {0}, more than the deadband ({1}): the motor would creep."
        ),
        (kind.NEVER_MOVED, "RC"): _tr(
            "It never moved, although a steady signal arrives. Either another stick controls this "
            "channel, or it was not moved."
        ),
        (kind.NEVER_MOVED, "ANALOG"): _tr(
            "Nothing moves on this input: it stays at {0}. Either nothing is connected to it (its "
            "voltage then means nothing), or what is connected was not moved."
        ),
        (kind.NEVER_MOVED, "RAIL"): _tr(
            "Nothing moves on this input: it stays at {0}, an end of what can be measured. Either "
            "nothing is connected to it (its voltage then means nothing), or what is connected "
            "was not moved."
        ),
        (kind.TOO_LITTLE, ""): _tr(
            "It went only {0} from its rest; {1} are needed: the deadband, and a count for each "
            "of the {2} speeds."
        ),
        (kind.ONE_DIRECTION, "BELOW"): _tr(
            "It went one way only, never below its rest. Push it the other way too; if it cannot "
            "go there, it rested at an end during sampling."
        ),
        (kind.ONE_DIRECTION, "ABOVE"): _tr(
            "It went one way only, never above its rest. Push it the other way too; if it cannot "
            "go there, it rested at an end during sampling."
        ),
        (kind.END_TOO_NEAR, "BELOW"): _tr(
            "The end below is only {0} from its rest; {1} are needed: the deadband, and a count "
            "for each of the {2} speeds."
        ),
        (kind.END_TOO_NEAR, "ABOVE"): _tr(
            "The end above is only {0} from its rest; {1} are needed: the deadband, and a count "
            "for each of the {2} speeds."
        ),
        (kind.NOT_HELD, "BELOW"): _tr(
            "The end below was only passed, so it may lie further out than what was seen. Go back, "
            "push it there and hold it for {0:.1f} s."
        ),
        (kind.NOT_HELD, "ABOVE"): _tr(
            "The end above was only passed, so it may lie further out than what was seen. Go back, "
            "push it there and hold it for {0:.1f} s."
        ),
        (kind.NOT_HELD, "BOTH"): _tr(
            "Both ends were only passed, so they may lie further out than what was seen. Go back, "
            "push it to each and hold it for {0:.1f} s."
        ),
        (kind.NEUTRAL_OUTSIDE, ""): _tr(
            "Its rest position ({0}) is not between its ends ({1} and {2}). Was a trim moved? "
            "Begin again with the sticks at rest."
        ),
        (kind.UNEVEN, "BELOW"): _tr(
            "It went {0} to one side, {1} below. Was it pushed all the way?"
        ),
        (kind.UNEVEN, "ABOVE"): _tr(
            "It went {0} to one side, {1} above. Was it pushed all the way?"
        ),
        (kind.REFUSED, "MEASURED"): _tr("The board would not accept what was measured: {0}."),
        (kind.REFUSED, "CHOSEN"): _tr("The board would not accept these values: {0}."),
        (kind.NEUTRAL_MOVED, "CHOSEN"): _tr(
            "It rests at {0}: with this neutral it would give {1} there."
        ),
        (kind.NEUTRAL_MOVED, "MEASURED"): _tr(
            "After letting go it rests at {0}, not at {1}, and would give {2} there. Was a hand on "
            "it during sampling, or was a trim moved? Go back and sample it again, or use the new "
            "rest position."
        ),
        (kind.USELESS, ""): "{0}",
        (kind.USELESS, "UP"): _tr(
            "The deadband ({0} to each side of neutral) reaches minimum: there is nothing between "
            "0 and full output."
        ),
        (kind.USELESS, "DOWN"): _tr(
            "The deadband ({0} to each side of neutral) reaches maximum: there is nothing between "
            "0 and full output."
        ),
        (kind.NEVER_FULL, "MAXIMUM"): _tr(
            "Maximum is beyond the {0} that was reached: there is no full output."
        ),
        (kind.NEVER_FULL, "MINIMUM"): _tr(
            "Minimum is beyond the {0} that was reached: there is no full output."
        ),
        (kind.NEVER_FULL, "BOTH"): _tr(
            "Maximum is beyond the {0} that was reached; Minimum is beyond the {1} that was "
            "reached: there is no full output."
        ),
        (kind.SPEEDS_UP, "UP"): _tr(
            "Above its rest the motor speeds up again, whatever the sign: at {0} to {1} of {2}. "
            "Check that no trim and no broken wire brings it there."
        ),
        (kind.SPEEDS_UP, "DOWN"): _tr(
            "Below its rest the motor speeds up again, whatever the sign: at {0} to {1} of {2}. "
            "Check that no trim and no broken wire brings it there."
        ),
        (kind.SWITCHES_AT_REST, ""): _tr(
            "Its rest position ({0}) is too close to its switching point ({1}): it may switch by "
            "itself."
        ),
        (kind.NEVER_SWITCHES, "ACTIVE"): _tr(
            "It is active in all its positions: none lies beyond {0}, where it switches. Should it "
            "be reversed, or not?"
        ),
        (kind.NEVER_SWITCHES, "INACTIVE"): _tr(
            "It is inactive in all its positions: none lies beyond {0}, where it switches. Should "
            "it be reversed, or not?"
        ),
    }


def _tr(text: str) -> str:
    return QCoreApplication.translate("learning_problems", text)
