"""Screenshot tour of an Aracna: at rest, moving, and waiting for a servo that has died."""

from collections.abc import Iterator
from functools import partial

from trex_gui.devices.aracna.model.controller import AracnaController
from trex_gui.devices.aracna.session.messages import Play, Step
from trex_gui.ui.tour import Do, Tour

_STEP_S = 2.5  # so long that every picture shows a motion
_DEAD_SERVO = 3


def tour_steps(tour: Tour, controller: AracnaController) -> Iterator[Do]:
    """Visit the pages. The simulator panel shows states that the robot does not report."""
    robot, demo = controller.robot, controller.demo_robot
    pairs = robot.state.motors // 2
    steps = tuple(
        Step(goals * pairs, _STEP_S, name)
        for name, goals in (("down", (300, 400)), ("up", (550, 150)))
    )
    play = partial(robot.play, Play(0, steps, rounds=0))

    def is_stuck() -> bool:
        """Let a servo die while it moves. Return whether the robot waits for it.

        On a busy computer the robot may miss a byte, which aborts the sequence. Then play it again.
        """
        if robot.state.stuck is None and robot.state.play is None:
            demo.set_dead(_DEAD_SERVO, False)
            play()
        elif robot.state.moving is not None:
            demo.set_dead(_DEAD_SERVO, True)
        return robot.state.stuck is not None

    yield partial(robot.move, steps[0].goals)
    yield lambda: robot.state.moved is not None
    yield from tour.look_at_pages()
    yield play
    yield lambda: robot.state.moving is not None
    yield from tour.look_at_pages("-moving")
    yield is_stuck
    yield from tour.look_at_pages("-stuck", first_only=True)
