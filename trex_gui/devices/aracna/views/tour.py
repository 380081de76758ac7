"""Screenshot tour of an Aracna."""

from collections.abc import Iterator
from functools import partial

from trex_gui.devices.aracna.model.controller import AracnaController
from trex_gui.devices.aracna.session.messages import Play, Step
from trex_gui.ui.tour import Tour, TourStep

_STEP_S = 2.5  # long enough that every picture shows a motion


def tour_steps(tour: Tour, controller: AracnaController) -> Iterator[TourStep]:
    robot = controller.robot
    pairs = robot.state.motors // 2
    steps = tuple(
        Step(goals * pairs, _STEP_S, name)
        for name, goals in (("down", (300, 400)), ("up", (550, 150)))
    )

    yield partial(robot.move, steps[0].goals)
    yield lambda: robot.state.moved is not None
    yield from tour.capture_pages()
    yield partial(robot.play, Play(0, steps, rounds=0))
    yield lambda: robot.state.moving is not None
    yield from tour.capture_pages("-moving")
