"""Random requests and faults in any order."""

from collections.abc import Callable

from hypothesis import Phase, given
from hypothesis import strategies as st

from tests.devices.aracna.session.scripted_session import ScriptedSession
from tests.support.matrix import examples
from trex_gui.core.session import Closed, Outcome
from trex_gui.devices.aracna.session.messages import (
    Connected,
    EndPlay,
    Halt,
    Move,
    Moved,
    Moving,
    NotResponding,
    Play,
    PlayEnded,
    Request,
    Restarted,
    SetSpeeds,
    SetTimeScale,
    Step,
    StepStarted,
)

PLACES = st.sampled_from([(400,) * 8, (512,) * 8, (600,) * 8, (5, 6)])
STEPS = st.lists(st.builds(Step, PLACES, st.sampled_from([0.05, 0.4, 1.0])), max_size=3).map(tuple)
REQUESTS: st.SearchStrategy[Callable[[int], Request]] = st.one_of(
    st.builds(lambda goals: lambda number: Move(number, goals), PLACES),
    st.builds(lambda speed: lambda number: SetSpeeds(number, (speed,) * 8), st.integers(50, 1100)),
    st.builds(
        lambda steps, rounds, out: lambda number: Play(number, steps, rounds, (), out),
        STEPS,
        st.integers(0, 3),
        STEPS,
    ),
    st.sampled_from([lambda _n: Halt(), lambda _n: EndPlay(), lambda _n: SetTimeScale(0.5)]),
)
FAULTS = st.sampled_from(
    [
        *("reset", "power cycle", "line mute on", "line mute off", "servo 3 dead", "servo 3 alive"),
        *("servo 5 block", "servo 5 free", "line drop 3", "line drop 3 sent", "line drop 20 sent"),
        *("line garbage 0d0a", "line garbage ff002e680d0a", "servo 2 lose position"),
    ]
)
REPAIRS = ("line mute off", "line drop 0", "line drop 0 sent", "servo 3 alive", "servo 5 free")


@given(
    actions=st.lists(st.tuples(st.floats(0, 1.5), REQUESTS | FAULTS), max_size=25),
    keeps_last=st.booleans(),
)
# Shrinking takes too long for a test.
@examples(40, phases=(Phase.explicit, Phase.generate))
def test_every_request_has_one_outcome_and_robot_recovers(
    actions: list[tuple[float, Callable[[int], Request] | str]], *, keeps_last: bool
) -> None:
    session = ScriptedSession(keeps_last=keeps_last)
    time, numbers = 0.2, set()
    for number, (pause, action) in enumerate(actions):
        time += pause
        if isinstance(action, str):
            session.at(time, action)
        else:
            request = action(number)
            numbers |= {number} if hasattr(request, "id") else set()
            session.at(time, request)
    for line in REPAIRS:
        session.at(time, line)
    session.at(time + 1.0, Halt()).at(time + 20.0, SetSpeeds(98, (500,) * 8))
    session.at(time + 21.0, Move(99, (444,) * 8)).until(time + 24.0).run()
    assert session.reports[-1] == Closed(None)
    assert sorted(outcome.id for outcome in session.of(Outcome)) == [*sorted(numbers), 98, 99]
    assert session.errors[98] is None
    assert session.errors[99] is None
    assert session.of(Moved)[-1].goals == session.stage.goals == (444,) * 8
    assert all(abs(position - 444) <= 2 for position in session.stage.positions)
    _assert_reports_are_consistent(session)


def _assert_reports_are_consistent(session: ScriptedSession) -> None:
    """Check that only an idle, connected robot gets a motion, and that sequences end."""
    is_connected, is_moving = False, False
    started = ended = 0
    for report in session.reports:
        match report:
            case Connected():
                is_connected = True
            case Moving():
                assert is_connected
                assert not is_moving
                is_moving = True
            case Moved():
                is_moving = False
            case StepStarted(part="steps", index=0, round=0):
                started += 1
            case PlayEnded():
                ended += 1
            case Restarted() | NotResponding():
                is_connected, is_moving = False, False
    assert ended >= started
