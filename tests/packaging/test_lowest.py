"""Versions installed by `test --lowest`."""

from packaging.utils import canonicalize_name
from packaging.version import Version

from tests.packaging.loading import import_script
from tests.support.scripts import PACKAGING

lowest = import_script("lowest")


def test_no_lowest_version_exceeds_the_pinned_version() -> None:
    lines = (PACKAGING / "constraints.txt").read_text("utf-8").splitlines()
    pairs = (line.split("==") for line in lines)
    pinned = {canonicalize_name(name): version for name, version in pairs}
    versions = lowest.lowest_versions((PACKAGING.parent / "pyproject.toml").read_text("utf-8"))
    assert {"click", "pyside6-essentials", "pygame-ce", "mcap"} <= versions.keys()
    assert [name for name in versions if Version(versions[name]) > Version(pinned[name])] == []


def test_lowest_versions_replace_pinned_versions() -> None:
    pinned = "Jinja2==3.1.6\nshiboken6==6.11.3\npytest==9.2.0\n"
    lines = list(lowest.constraints(pinned, {"jinja2": "3.1", "pyside6-essentials": "6.10"}))
    assert lines == ["jinja2==3.1", "pyside6-essentials==6.10", "pytest==9.2.0"]
