"""The wheel contains the program and its data, and no development files."""

import re
import subprocess
import sys
import tomllib
from pathlib import Path
from zipfile import ZipFile

import pytest

from trex_gui.version import __version__

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    build = [sys.executable, "-m", "hatchling", "build", "--target", "wheel"]
    process = subprocess.run(
        [*build, "--directory", str(folder)], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert process.returncode == 0, process.stderr
    (file,) = folder.glob("*.whl")
    return file


@pytest.fixture(scope="module")
def wheel_names(wheel: Path) -> set[str]:
    with ZipFile(wheel) as archive:
        return set(archive.namelist())


def test_wheel_contains_every_resource(wheel_names: set[str]) -> None:
    resources = ROOT / "resources"
    expected = {
        f"trex_gui/_resources/{path.relative_to(resources).as_posix()}"
        for path in resources.rglob("*")
        if path.is_file()
    }
    assert "trex_gui/_resources/trex_parameters.toml" in expected
    assert expected - wheel_names == set()


def test_wheel_contains_every_module_and_no_other_folder(wheel_names: set[str]) -> None:
    modules = {path.relative_to(ROOT).as_posix() for path in (ROOT / "trex_gui").rglob("*.py")}
    assert "trex_gui/__init__.py" in modules
    assert modules - wheel_names == set()
    folders = {name.split("/")[0] for name in wheel_names}
    assert {folder for folder in folders if not folder.endswith(".dist-info")} == {"trex_gui"}


def test_wheel_has_version_licence_and_programs(wheel: Path) -> None:
    dist_info = f"trex_gui-{__version__}.dist-info"
    with ZipFile(wheel) as archive:
        metadata = archive.read(f"{dist_info}/METADATA").decode().splitlines()
        entry_points = archive.read(f"{dist_info}/entry_points.txt").decode()
        licence = archive.read(f"{dist_info}/licenses/LICENSE").decode()
    assert wheel.name == f"trex_gui-{__version__}-py3-none-any.whl"
    assert {f"Version: {__version__}", "Provides-Extra: gamepad", "Provides-Extra: mcap"} <= {
        *metadata
    }
    assert re.findall(r"^([\w-]+) = ", entry_points, re.MULTILINE) == [
        "trex-sim",
        "trexcmd",
        "trex-gui",
    ]
    assert licence.startswith("MIT License")


def test_sdist_includes_the_folders_linked_in_the_readme() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    included = project["tool"]["hatch"]["build"]["targets"]["sdist"]["include"]
    links = re.findall(
        r"\]\(([\w./-]+)(?:#[\w-]+)?\)", (ROOT / "README.md").read_text(encoding="utf-8")
    )
    assert "CONTRIBUTING.md" in links
    files = [link for link in links if not link.startswith("../")]  # the other links lead to GitHub
    assert {link.split("/")[0] for link in files} <= {*included}
    assert {".ci", ".github"} <= {*included}  # tests read these folders
