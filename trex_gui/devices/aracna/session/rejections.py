"""Why a motion is not sent, in a sentence for people."""

from collections.abc import Mapping, Sequence

from trex_gui.core.errors import NoReply, StudioError

STUCK = "The robot is stuck: nothing was sent."


def why_not_taken(wanted: Sequence[int], held: Sequence[int]) -> StudioError | None:
    """Return an error that names the motors that hold another speed; `None`: there is none."""
    wrong = [
        (motor, speed, holds)
        for motor, (speed, holds) in enumerate(zip(wanted, held, strict=True))
        if speed != holds
    ]
    if not wrong:
        return None
    if all(holds < 0 for holds in held):
        return NoReply("No motor took its speed: do the servos have power?")
    parts = [
        f"motor {motor} did not take its speed of {speed}"
        + (", it does not answer" if holds < 0 else f", it holds {holds}")
        for motor, speed, holds in wrong
    ]
    text = "; ".join(parts)
    return NoReply(f"{text[0].upper()}{text[1:]}.")


def why_missed(off: Mapping[int, int]) -> StudioError:
    """Return an error for a sequence whose step ended with motors far from their goals."""
    parts = [f"motor {motor} is {abs(units)} units off its goal" for motor, units in off.items()]
    text = "; ".join(parts)
    return NoReply(
        f"{text[0].upper()}{text[1:]}: something holds it, or the servo power was off. The "
        "sequence does not go on by itself."
    )


def why_not_confirmed(error: StudioError) -> StudioError:
    """Return an error for speeds whose answer was lost: nobody knows what the servos hold."""
    return NoReply(f"The robot did not confirm its speeds, so no motor was moved. {error}")
