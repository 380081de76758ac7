"""How long a line without CRC that corrupts one byte in a hundred turns a motor another way."""

import pytest

from tests.soak.drives import LONGEST_TURN, drive
from tests.support.matrix import sampled


@pytest.mark.parametrize(
    ("seed", "shutdown"), sampled([(seed, bool(seed % 2)) for seed in range(30)], every=15)
)
def test_wrong_turn_is_short_and_no_restart(seed: int, shutdown: bool) -> None:
    result = drive(seed, 5.0, shutdown=shutdown)
    assert max(result.turned, default=0.0) <= LONGEST_TURN
    assert result.stopped == []
