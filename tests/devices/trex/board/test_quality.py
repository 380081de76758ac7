"""Quality of a line: good or noisy."""

from dataclasses import replace

import pytest

from trex_gui.devices.trex.board.quality import ConnectionQuality, quality_text
from trex_gui.devices.trex.client.client import Counters


class MeasuredLine:
    """A line whose quality is updated in each frame."""

    def __init__(self, rate: float = 190.0) -> None:
        self.quality = ConnectionQuality()
        self.counters = Counters()
        self.time = 1000.0
        self._rate = rate
        self._totals = dict.fromkeys(("requests", "missing", "corrupted", "unsolicited"), 0.0)

    def run(
        self, seconds: float, *, missing: float = 0.0, corrupted: float = 0.0, stray: float = 0.0
    ) -> list[bool | None]:
        """Advance the time with these shares of failures. Return each new value of `is_noisy`."""
        results: list[bool | None] = []
        shares = {"requests": 1.0, "missing": missing, "corrupted": corrupted, "unsolicited": stray}
        for _ in range(round(seconds * 30)):
            self.time += 1 / 30
            for name, share in shares.items():
                self._totals[name] += share * self._rate / 30
                setattr(self.counters, name, int(self._totals[name]))
            if self.quality.update(self.time, replace(self.counters)):
                results.append(self.quality.is_noisy)
        return results


def test_quality_is_unknown_until_enough_is_measured() -> None:
    line = MeasuredLine()
    assert line.run(2.5) == []
    assert line.quality.is_noisy is None
    assert quality_text(line.quality) == "being measured …"
    assert line.run(4) == [False]
    assert (
        quality_text(line.quality) == "good: 100.0 % of the requests in the last 6 s were answered"
    )


@pytest.mark.parametrize(
    "failures", [{"missing": 0.026}, {"corrupted": 0.026}, {"missing": 0.016, "corrupted": 0.01}]
)
def test_share_of_lost_transactions_is_measured(failures: dict[str, float]) -> None:
    line = MeasuredLine()
    assert True in line.run(20, **failures)
    assert line.quality.lost == pytest.approx(0.026, abs=0.001)
    assert line.quality.rate == pytest.approx(190, abs=1)
    assert 10 <= line.quality.seconds < 13
    text = quality_text(line.quality)
    assert text.startswith("noisy: 97.4 % of the requests in the last 1")


def test_stray_bytes_make_a_line_noisy_without_lost_replies() -> None:
    line = MeasuredLine()
    assert True in line.run(20, stray=0.2)
    assert line.quality.lost == 0
    assert line.run(20)[-1] is False, "earlier stray bytes do not count"


def test_noise_result_does_not_flicker_between_the_thresholds() -> None:
    line = MeasuredLine()
    line.run(20, missing=0.02)
    results = line.run(60, missing=0.008)
    assert set(results) <= {True}
    assert len(results) < 10, "the share over ten seconds falls and then stays constant"
    assert line.run(30, missing=0.001)[-1] is False
    assert True not in line.run(60, missing=0.008)


def test_noise_result_changes_at_most_every_two_seconds() -> None:
    line = MeasuredLine()
    changes = [line.run(2, missing=share) for share in (0.05, 0.0) * 20]
    assert all(len(results) <= 1 for results in changes)


def test_three_failures_before_a_silence_are_not_noise() -> None:
    line = MeasuredLine()
    line.run(3)
    line.counters.missing += 3
    assert line.quality.update(line.time + 2, line.counters)
    assert line.quality.is_noisy is False


def test_slow_line_is_measured_for_a_longer_time() -> None:
    line = MeasuredLine(rate=12)
    assert line.run(40, missing=0.03) == []
    assert line.run(10, missing=0.03)[0] is True


def test_reset_starts_the_measurement_again() -> None:
    line = MeasuredLine()
    line.run(20, missing=0.05)
    assert line.quality.reset()
    assert line.quality.is_noisy is None
    assert not line.quality.reset()
    for seconds in (0, 1 / 30):
        line.run(seconds)
        assert line.quality.rate == 0, "the rate is unknown until some time has passed"
    line.run(6)
    assert line.quality.is_noisy is False


@pytest.mark.parametrize("failure", ["missing", "corrupted"])
def test_replies_may_be_corrupted_for_five_seconds_after_a_failure(failure: str) -> None:
    quality, counters = ConnectionQuality(), Counters(**{failure: 1})
    assert not quality.has_failed_lately(9.0, Counters())
    failed = [quality.has_failed_lately(10.0 + age, counters) for age in (0.0, 4.9, 5.0)]
    assert failed == [True, True, False]
