"""Programs in the guide for engineers."""

import re

import pytest

from tests.support.library_program import Program
from tests.support.scripts import PACKAGING
from tests.support.simulator import SimulatedDevice
from tests.support.virtual_time import VirtualRuntime

GUIDE = (PACKAGING / "docs" / "guide.md").read_text("utf-8")
PROGRAMS = re.findall(r"^```python\n(.*?)^```", GUIDE, re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("number", range(len(PROGRAMS)))
def test_program_of_the_guide_runs(
    virtual_time: VirtualRuntime,
    quick_simulator: SimulatedDevice,
    capsys: pytest.CaptureFixture[str],
    number: int,
) -> None:
    program = PROGRAMS[number].replace("/dev/ttyUSB0", quick_simulator.url)
    assert program != PROGRAMS[number]
    Program(virtual_time, lambda: exec(program, {})).end()
    printed = capsys.readouterr().out
    assert printed or ".stop()" in program
    assert quick_simulator.show()["motors"][0]["speed"] in {0, 127}, (
        "the program has stopped the motor or never driven it"
    )


def test_guide_has_programs() -> None:
    assert len(PROGRAMS) >= 4
