"""Cases and messages of the soak."""

from itertools import islice
from pathlib import Path

import pytest

from tests.fault_matrix.cases import CASES
from tests.soak import __main__ as soak
from tests.soak import faults


def test_status_is_1_if_any_part_fell_short(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    seen: list[int] = []

    def find_nothing(_seconds: float, seed: int) -> list[str]:
        seen.append(seed)
        return []

    parts: dict[str, soak.Part] = {
        "good": find_nothing,
        "bad": lambda _seconds, seed: [f"case {seed}"],
    }
    monkeypatch.setattr(soak, "PARTS", parts)
    assert soak.main(["--minutes", "0.01", "--seed", "7", "--part", "good"]) == 0
    assert soak.main(["--minutes", "0.01", "--seed", "7"]) == 1
    assert capsys.readouterr().out.endswith("1 fell short, seed 7\n  bad: case 7\n")
    assert seen == [7, 7]


def test_seed_repeats_the_order_of_all_cases() -> None:
    rounds = -(-len(CASES) // faults.ROUND)
    first, again, other = (list(islice(faults._rounds(seed), rounds)) for seed in (1, 1, 2))
    assert first == again != other
    names = [name for batch in first for name in batch]
    assert len(set(names)) == len(names) == len(CASES)


def test_report_names_cases_that_fell_short(tmp_path: Path) -> None:
    report = tmp_path / "report.xml"
    report.write_text(
        '<testsuites><testsuite><testcase name="test_real_fault[mute-find]" time="2.5"/>'
        '<testcase name="test_real_fault[mute-connect]" time="4"><failure message="so it is"/>'
        "</testcase></testsuite></testsuites>"
    )
    assert faults._read(report) == {"mute-find": (2.5, ""), "mute-connect": (4.0, "so it is")}
    assert faults._read(tmp_path / "none.xml") == {}
