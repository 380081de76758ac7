"""Why no robot answers on a port: one sentence, and what to look at."""

from trex_gui.core.errors import BadReply, NoReply, StudioError
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.protocol import lines
from trex_gui.devices.aracna.session.client import shown

_NOBODY = "No Aracna answers on "
_STRANGE = "Something answers on "
_MOVING = "It may still be moving and hears nothing meanwhile; wait until it stands."
_CHECK = (
    "Check that the robot's board has power, that the adapter's TX goes to its RX and its RX to "
    "its TX (or that both radios are on the same channel), and that ground is connected."
)


def may_be_elsewhere(text: str) -> bool:
    """Whether a sentence of this module leaves open what is on the port, and at which settings."""
    return text.startswith((_NOBODY, _STRANGE))


def is_echo(received: bytes) -> bool:
    """Whether what came is nothing but the question that was sent."""
    question = lines.QUERY.strip()
    return question in received and not received.replace(question, b"").strip(b"\r\n\x00\xff")


def is_start(received: bytes) -> bool:
    """Whether a board has said that it starts, and nothing else."""
    heard = received.strip(b"\r\n")
    return bool(heard) and not heard.replace(b".h", b"").strip(b"\r\nh")


def diagnose(settings: PortSettings, received: bytes) -> StudioError:
    """Return an error that tells a person why no Aracna was found, from the first bytes heard."""
    where = settings.text()
    heard = received.strip(b"\r\n")
    if not heard:
        return NoReply(f"{_NOBODY}{where}. {_MOVING} {_CHECK}")
    if is_echo(received):
        return NoReply(
            f"Everything sent on {where} comes back, and nothing else: the adapter's TX and RX "
            "are joined."
        )
    if is_start(received):
        return NoReply(
            f"An Aracna on {where} has said that it starts, but does not answer then. Perhaps it "
            "starts again and again: look at its power supply."
        )
    return BadReply(
        f"{_STRANGE}{where}, but not as an Aracna does: {shown(heard)}. Another "
        "device, perhaps a TReX at another baud rate, or a line that is disturbed."
    )


def why_stuck(motor: int | None) -> StudioError:
    """Return an error for an answer to a `.c` that is late: which motor is waited for."""
    if motor is None:
        return NoReply("The robot has not answered in time.")
    return NoReply(f"The robot waits for motor {motor}, which does not arrive.")
