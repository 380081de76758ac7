"""Workflows, recipes and release notes."""

import plistlib
import re
import shlex
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtWidgets import QApplication
from ruamel.yaml import YAML

from tests.packaging.loading import import_script
from tests.support.scripts import PACKAGING

ROOT = PACKAGING.parent
WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))


def read(path: Path) -> Any:
    return YAML(typ="safe", pure=True).load(path)


def steps(workflow: Path) -> list[dict[str, Any]]:
    return [step for job in read(workflow)["jobs"].values() for step in job.get("steps", [])]


# --- Workflows


def named_files(command: str) -> set[str]:
    """Return the project files named in a command."""
    words = shlex.split(command, comments=True)
    return {word for word in words if re.match(r"(packaging|tests|\.ci|trex_gui)/", word)}


@pytest.mark.parametrize("workflow", WORKFLOWS, ids=lambda path: path.stem)
def test_files_workflows_and_packages_in_a_workflow_exist(workflow: Path) -> None:
    workflows = {job["uses"] for job in read(workflow)["jobs"].values() if "uses" in job}
    commands = [step.get("run", "") for step in steps(workflow)]
    names = workflows.union(*map(named_files, commands))
    assert names
    assert [name for name in sorted(names) if not (ROOT / name).exists()] == []
    known = {*import_script("packages").TARGETS, "package", "--check"}
    for command in commands:
        words = shlex.split(command, comments=True)
        if "package" in words:
            assert set(words[words.index("package") :]) <= known


def test_every_action_has_a_version() -> None:
    assert {path.stem for path in WORKFLOWS} == {"ci", "packages", "release"}
    used = [step["uses"] for path in WORKFLOWS for step in steps(path) if "uses" in step]
    assert [name for name in used if not re.search(r"@v\d+$", name)] == []


# --- Release notes

CHANGELOG = """# Changelog

## [Unreleased]

## [0.2.0] - 2026-12-01

### Added

- a feature

## [0.1.0]

The first.
"""


def test_section_of_a_version_is_found() -> None:
    notes = import_script("release_notes")
    assert notes.release_notes("v0.2.0", "0.2.0", CHANGELOG) == "### Added\n\n- a feature"
    assert notes.section(CHANGELOG, "0.1.0") == "The first."
    assert notes.section(CHANGELOG.replace("0.2.0", "0x2.0"), "0.2.0") is None


@pytest.mark.parametrize(
    ("tag", "version", "text"),
    [
        ("v0.3.0", "0.2.0", "The tag is v0.3.0"),
        ("0.2.0", "0.2.0", "The tag is 0.2.0"),
        ("v0.3.0", "0.3.0", "no section"),
        ("v0.2", "0.2", "no section"),
    ],
)
def test_release_requires_its_version_and_section(tag: str, version: str, text: str) -> None:
    with pytest.raises(ValueError, match=text):
        import_script("release_notes").release_notes(tag, version, CHANGELOG)


def test_release_is_refused_with_unreleased_entries() -> None:
    changelog = CHANGELOG.replace("[Unreleased]\n", "[Unreleased]\n\n### Added\n\n- later\n")
    with pytest.raises(ValueError, match=r"entries in \[Unreleased\]"):
        import_script("release_notes").release_notes("v0.2.0", "0.2.0", changelog)


def test_current_version_has_a_section() -> None:
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    assert import_script("release_notes").section(changelog, import_script("packages").version())


# --- Recipes


def test_macos_bundle_is_a_program_with_a_window() -> None:
    with (PACKAGING / "macos" / "Info.plist").open("rb") as file:
        information = plistlib.load(file)
    assert information["LSBackgroundOnly"] is False
    assert information["NSHighResolutionCapable"] is True


@pytest.mark.parametrize(("suffix", "start"), [(".ico", b"\0\0\1\0"), (".icns", b"icns")])
def test_icon_file_contains_a_picture_of_every_size(
    qapp: QApplication, tmp_path: Path, suffix: str, start: bytes
) -> None:
    icons = import_script("icons")
    icons.write_icon(tmp_path / f"icon{suffix}")
    content = (tmp_path / f"icon{suffix}").read_bytes()
    assert content.startswith(start)
    sizes = icons.ICO_SIZES if suffix == ".ico" else icons.ICNS_TYPES.values()
    widths = [int.from_bytes(picture[12:16], "big") for picture in content.split(b"\x89PNG")[1:]]
    assert widths == list(sizes)
    if suffix == ".icns":
        assert int.from_bytes(content[4:8], "big") == len(content)
