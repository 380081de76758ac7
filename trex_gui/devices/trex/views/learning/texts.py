"""Texts of the wizard that learns channels."""

from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.model.learning.learning import Learning, LearningStep


def again_texts(step: LearningStep) -> tuple[str, str]:
    """Return the text and the tip of the button that repeats a step."""
    match step:
        case LearningStep.NEUTRAL:
            return (
                tr("Sample &again"),
                tr("Measure the rest positions of all channels once more."),
            )
        case LearningStep.TRAVEL:
            return (
                tr("&Forget these ends"),
                tr("Forget the ends reached so far. The rest positions are kept."),
            )
        case LearningStep.REVIEW:
            return (
                tr("&Start over"),
                tr("Forget everything measured and go back to the rest positions."),
            )
        case LearningStep.TEST:
            return (
                tr("Test &again"),
                tr("Forget what was tested so far and begin the test again."),
            )
    return tr("Try &again"), tr("Stop the motors again and begin again.")


def is_alarming(learning: Learning) -> bool:
    if learning.inputs.stalled:
        return True
    match learning.step:
        case LearningStep.NEUTRAL if learning.has_sampled:
            return not all(channel.is_at_rest for channel in learning.channels)
        case LearningStep.TEST if learning.tests is not None:
            return learning.tests.channels_passed and not learning.tests.passed
    return learning.step in {LearningStep.FAILED, LearningStep.DOUBT}


def head_text(learning: Learning, *, offers_test: bool) -> str:
    if offers_test:
        return tr(
            "The new values are in the board. The test does not start by itself, because the "
            "motors may be running: it has to stop them first."
        )
    if learning.inputs.stalled:
        return tr("The board sends no measurements: the line is busy or disturbed. Waiting …")
    match learning.step:
        case LearningStep.STOPPING:
            return tr(
                "Stopping the motors. The next step comes when the board has confirmed the "
                "stop and no current flows."
            )
        case LearningStep.NEUTRAL:
            return _rest_text(learning)
        case LearningStep.TRAVEL:
            return _travel_text(learning)
        case LearningStep.REVIEW:
            return review_texts(learning)[0]
        case LearningStep.TEST:
            return f"{learning.news} {_test_text(learning)}".strip()
    return learning.trouble


def _rest_text(learning: Learning) -> str:
    if learning.sampling:
        return tr("Hands off. Sampling … {0:.1f} s").format(Number(learning.seconds_left))
    if not learning.has_sampled:
        return tr(
            "The motors are stopped. Release every stick and set every switch to off. Then "
            "click Next to measure the rest positions."
        )
    bad = [str(channel.number) for channel in learning.channels if not channel.is_at_rest]
    if len(bad) == len(learning.channels):
        return tr("No channel is at rest. Correct the problems below, then click “Sample again”.")
    return tr(
        "Not every channel is at rest. Correct the problems below and click “Sample again”, or "
        "click Next to continue without channel {0}."
    ).format(", ".join(bad))


def _travel_text(learning: Learning) -> str:
    text = tr(
        "Push every stick forward or right first, all the way; then the other way. "
        "Move switches to all positions."
    )
    slow = [c.travel for c in learning.channels if c.travel and c.travel.is_slow]
    if not slow:
        return f"{text} " + tr("Hold each end for a moment, then click Next.")
    reason = tr(
        "Hold each end until its check mark appears, for at least {0:.1f} s: this line "
        "({1} baud) carries only {2:.1f} measurements per second. Then click Next."
    )
    hold = max(travel.hold_seconds for travel in slow)
    rate = 1 / max(travel.interval for travel in slow)
    return f"{text} {reason.format(Number(hold), learning.baud, Number(rate))}"


def review_texts(learning: Learning) -> tuple[str, str]:
    """Return the text of the head and the tip of the button that uses the values."""
    rejected = ", ".join(str(c.number) for c in learning.included if not c.can_be_used)
    if not any(channel.choice is not None for channel in learning.channels):
        return (
            tr("Nothing was learned. The reason is below. Go back, or start over."),
            tr("Nothing was learned, so there are no values to use."),
        )
    if not learning.included:
        return (
            tr("No channel is selected. Select each channel whose new values to use."),
            tr("No channel is selected."),
        )
    if rejected:
        return (
            tr(
                "The board would reject the values of channel {0}: change them, or clear its "
                "check box."
            ).format(rejected),
            tr("The board would reject the values of channel {0}.").format(rejected),
        )
    return (
        tr(
            "Check the new values. You can change them; clear the check box of a channel to "
            "keep its old values. "
            "Nothing is written yet: you confirm all changes in the next window."
        ),
        learning.preconditions.blocker
        or tr("Use the values of all selected channels. Nothing is written yet."),
    )


def _test_text(learning: Learning) -> str:
    tests = learning.tests
    if tests is not None and tests.heard:
        if tests.passed:
            return tr("Everything is as it should be.")
        if tests.all_ignored:
            return tr(
                "There is nothing to test: the board ignores this input, so it holds it at "
                "neutral. See the setting Ignored Channels."
            )
        if tests.channels_passed:
            text = tr(
                "The tested channels are good. But in {0} mode the motors would not start. {1}"
            )
            return text.format(tests.mode, tests.safe_start_reasons)
    return tr(
        "Push every stick to all its ends, then release it. Move every switch to all its "
        "positions. The motors stay off: in serial mode the sticks do not drive them."
    )
