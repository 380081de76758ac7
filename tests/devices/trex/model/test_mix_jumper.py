"""Whether the mix jumper is on, as the board's answers show it."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trex_gui.devices.trex.model.channel_curve import MixWatch, is_mixed
from trex_gui.devices.trex.simulator.channel_control import motor_values

outputs = st.integers(-127, 127)


@given(turn=outputs, forward=outputs, mix=st.booleans(), skew=st.integers(-10, 10))
def test_detected_mix_jumper_is_never_wrong(turn: int, forward: int, mix: bool, skew: int) -> None:
    first, second = motor_values([turn, forward], mix=mix, flip=False, joint=False)
    assert is_mixed((turn, forward), (first + skew, second)) in {mix, None}


@pytest.mark.parametrize("pushed", [(80, 0), (-80, 0), (0, 80), (60, 60), (127, 127)])
@pytest.mark.parametrize("mix", [True, False])
def test_pushed_stick_reveals_the_mix_jumper(pushed: tuple[int, int], mix: bool) -> None:
    answered = motor_values(pushed, mix=mix, flip=False, joint=False)
    assert is_mixed(pushed, answered) is mix


def test_neutral_or_inconsistent_values_give_no_result() -> None:
    assert is_mixed((0, 0), (0, 0)) is None
    assert is_mixed((80, 0), (-40, 90)) is None


def test_mix_result_needs_several_values_and_survives_neutral() -> None:
    watch, seen = MixWatch(), []
    for times, outputs, answered in (
        (1, (80, 0), (80, -80)),
        (5, (80, 0), (80, -80)),
        (1, (80, 0), (80, 0)),
        (9, (0, 0), (0, 0)),
        (5, (80, 0), (80, 0)),
    ):
        for _ in range(times):
            watch.feed(outputs, answered)
        seen.append(watch.mixed)
    watch.forget()
    assert [*seen, watch.mixed] == [None, True, True, True, False, None]
