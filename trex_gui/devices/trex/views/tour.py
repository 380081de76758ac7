"""Screenshot tour of a TReX."""

from collections.abc import Iterator
from functools import partial

from trex_gui.devices.trex.model.controller import TrexController
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.tour import Tour, TourStep

# Steps of the set-up for a robot that is driven with one stick.
SETUP_STEPS = ("driver", "jumpers", "sticks", "motors", "limits", "review")
_HOLD_S = 1.2  # a stick must be held for one second at each end of its travel


def tour_steps(tour: Tour, controller: TrexController) -> Iterator[TourStep]:
    motors, sticks = controller.device.motors, controller.demo_board

    def drive() -> bool:
        motors.arm()  # fails until the lockout of the first stop is over
        if not motors.armed:
            return False
        motors.set_speed(1, 30)
        motors.set_speed(2, -20)
        motors.set_auxiliary(15)
        return True

    def hold(microseconds: float) -> Iterator[TourStep]:
        def push() -> None:
            for channel in CHANNELS:
                sticks.hold_stick(channel, microseconds)

        yield push
        yield from tour.wait(_HOLD_S)

    def reach_page(page: str) -> bool:
        """Return true if a page is visible. Otherwise try again, because stopping takes time."""
        if not tour.is_visible(page):
            tour.press("learnAgainButton")
            return False
        return True

    yield drive
    yield from tour.wait()
    yield from tour.capture_pages()
    yield partial(sticks.set_automatic, False)
    yield sticks.center_sticks
    yield partial(tour.trigger_action, "learnAction")
    yield partial(reach_page, "learnRestPage")
    yield from tour.capture_dialog("learnDialog", "learn-rest")
    yield partial(tour.press, "learnNextButton")
    yield partial(tour.is_visible, "learnTravelPage")
    for microseconds in (1850, 1150):
        yield from hold(microseconds)
    yield sticks.center_sticks
    yield from tour.capture_dialog("learnDialog", "learn-travel")
    yield partial(tour.press, "learnNextButton")
    yield partial(tour.is_visible, "learnReviewPage")
    yield from tour.capture_dialog("learnDialog", "learn-review")
    yield partial(tour.press, "learnCloseButton")
    yield partial(tour.trigger_action, "test_sticksAction")
    yield partial(reach_page, "learnTestPage")
    yield from hold(1850)
    yield from tour.capture_dialog("learnDialog", "learn-test")
    yield partial(tour.press, "learnCloseButton")
    yield partial(tour.trigger_action, "setupAction")
    for step in SETUP_STEPS:
        yield from tour.capture_dialog("setupDialog", f"setup-{step}")
        if step != SETUP_STEPS[-1]:
            yield partial(tour.press, "setupNextButton")
    yield partial(tour.press, "setupCloseButton")
    yield controller.disconnect_device
    yield lambda: controller.link is ConnectionState.DISCONNECTED
    yield partial(tour.trigger_action, "check_boardAction")
    yield from tour.capture_dialog("checkDialog", "check-leds")
    for _ in range(2):
        yield partial(tour.press, "checkNextButton")
    yield from tour.capture_dialog("checkDialog", "check-jumpers")
    yield partial(tour.press, "checkCloseButton")
