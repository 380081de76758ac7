"""Versions installed by `test --lowest`."""

from types import ModuleType

import pytest
from packaging.utils import canonicalize_name
from packaging.version import Version

from tests.support.scripts import PACKAGING, load_script

ROOT = PACKAGING.parent


@pytest.fixture
def lowest(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(PACKAGING)
    return load_script("lowest")


def test_every_dependency_has_a_lowest_version_below_the_pinned_one(
    lowest: ModuleType,
) -> None:
    pinned = dict(
        line.split("==")
        for line in (ROOT / "packaging" / "constraints.txt").read_text("utf-8").splitlines()
    )
    pinned = {canonicalize_name(name): version for name, version in pinned.items()}
    found = lowest.lowest_versions((ROOT / "pyproject.toml").read_text("utf-8"))
    assert {"click", "pyside6-essentials", "pygame-ce", "mcap"} <= found.keys()
    assert [name for name in found if Version(found[name]) > Version(pinned[name])] == []


def test_lowest_versions_take_the_place_of_pinned_ones(lowest: ModuleType) -> None:
    pinned = "Jinja2==3.1.6\nshiboken6==6.11.3\npytest==9.2.0\n"
    lines = list(lowest.constraints(pinned, {"jinja2": "3.1", "pyside6-essentials": "6.10"}))
    assert lines == ["jinja2==3.1", "pyside6-essentials==6.10", "pytest==9.2.0"]
