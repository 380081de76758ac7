"""Status, cases and report of the soak test."""

from itertools import islice
from pathlib import Path

import pytest

from tests.fault_matrix.cases import CASES
from tests.soak import __main__ as soak
from tests.soak import faults


def test_status_is_1_if_any_part_has_failures(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    seeds: list[int] = []

    def succeed(_seconds: float, seed: int) -> list[str]:
        seeds.append(seed)
        return []

    parts: dict[str, soak.Part] = {
        "good": succeed,
        "bad": lambda _seconds, seed: [f"case {seed}"],
    }
    monkeypatch.setattr(soak, "PARTS", parts)
    assert soak.main(["--minutes", "0.01", "--seed", "7", "--part", "good"]) == 0
    assert soak.main(["--minutes", "0.01", "--seed", "7"]) == 1
    assert capsys.readouterr().out.endswith("1 failed, seed 7\n  bad: case 7\n")
    assert seeds == [7, 7]


def test_seed_repeats_the_order_of_all_cases() -> None:
    rounds = -(-len(CASES) // faults.ROUND)
    first, same, other = (list(islice(faults._rounds(seed), rounds)) for seed in (1, 1, 2))
    assert first == same != other
    names = [name for batch in first for name in batch]
    assert len(set(names)) == len(names) == len(CASES)


def test_report_contains_the_failure_of_each_case(tmp_path: Path) -> None:
    report = tmp_path / "report.xml"
    report.write_text(
        '<testsuites><testsuite><testcase name="test_fault[mute-find]" time="2.5"/>'
        '<testcase name="test_fault[mute-connect]" time="4"><failure message="it failed"/>'
        "</testcase></testsuite></testsuites>"
    )
    assert faults._read(report) == {"mute-find": (2.5, ""), "mute-connect": (4.0, "it failed")}
    assert faults._read(tmp_path / "none.xml") == {}
