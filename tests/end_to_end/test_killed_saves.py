"""A program that is killed while it saves leaves each file old or new, never half."""

import random
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.kill_saves import KINDS, Saver, attack

pytestmark = [
    pytest.mark.realtime,
    pytest.mark.skipif(sys.platform == "win32", reason="the program that saves forks"),
]

KILLS = 8


@pytest.fixture(scope="module")
def saver() -> Iterator[Saver]:
    with Saver() as saver:
        yield saver


@pytest.mark.parametrize("kind", KINDS)
def test_killed_save_leaves_the_old_file_or_the_new_one(
    saver: Saver, kind: str, tmp_path: Path
) -> None:
    assert attack(saver, kind, tmp_path, KILLS, random.Random(kind)) == []
