"""Installer for Windows, with stand-ins for the programs."""

import shutil
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from trex_gui.version import __version__

PACKAGING = Path(__file__).resolve().parents[2] / "packaging"

pytestmark = [
    pytest.mark.realtime,
    pytest.mark.skipif(shutil.which("makensis") is None, reason="needs NSIS"),
]


def wine_test(function: Callable[..., None]) -> Callable[..., None]:
    """Mark a test that installs into a separate Windows."""
    for mark in (
        pytest.mark.slow,
        pytest.mark.timeout(300),
        pytest.mark.skipif(shutil.which("wine") is None, reason="needs Wine"),
    ):
        function = mark(function)
    return function


@pytest.fixture(scope="module")
def package() -> ModuleType:
    sys.path.insert(0, str(PACKAGING))
    try:
        from windows import package
    finally:
        sys.path.remove(str(PACKAGING))
    return package


@pytest.fixture(scope="module")
def installer(package: ModuleType, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("installer")
    frozen = folder / "frozen"
    for name in (*package.PROGRAMS, "_internal/deep/library.dll", "licences/Python.txt"):
        path = frozen / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(b"stand-in")
    file = folder / "installer.exe"
    package.make_installer(frozen, __version__, file)
    return file


def test_installer_is_a_windows_program(installer: Path) -> None:
    assert installer.read_bytes().startswith(b"MZ")
    assert sorted(path.name for path in installer.parent.iterdir()) == ["frozen", "installer.exe"]


@pytest.fixture
def installed(package: ModuleType, tmp_path: Path) -> Iterator[Any]:
    wine = package.Wine(tmp_path / "prefix")
    wine.drive.mkdir(parents=True)
    try:
        wine.run(["wineboot", "--init"])
        yield package.Installation(wine)
    finally:
        wine.stop()


@wine_test
def test_uninstaller_removes_what_was_installed_only(
    package: ModuleType, installer: Path, installed: Any
) -> None:
    installed.install(installer)
    installed.require_installed(__version__)
    assert (installed.folder / "_internal" / "deep" / "library.dll").exists()
    old = installed.folder / "_internal" / "of an earlier version.dll"
    old.touch()
    installed.install(installer)
    assert not old.exists()
    users = installed.folder / "notes of the user.txt"
    users.touch()
    installed.uninstall()
    assert [path.name for path in installed.folder.iterdir()] == [users.name]
    installed.install(installer)
    users.unlink()
    installed.uninstall()
    installed.require_removed()


@wine_test
def test_running_program_is_not_replaced_or_removed(
    package: ModuleType, installer: Path, installed: Any
) -> None:
    installed.folder = installed.windows.drive / "robots"
    installed.windows.run([installer, "/S", r"/D=C:\robots"])
    program = installed.folder / "trexcmd.exe"
    shutil.copy(installed.windows.drive / "windows" / "system32" / "cmd.exe", program)
    with installed.windows.start([program]) as running:
        assert running.stdout.read(1)  # the program has started
        for command in (
            [installer, "/S"],
            [installed.folder / "uninstall.exe", "/S", r"_?=C:\robots"],  # itself, not a copy
        ):
            with installed.windows.start(command) as process:
                assert process.wait(60) == 2  # Wine's desktop keeps its pipes open
        installed.require_installed(__version__)
        assert (installed.folder / "_internal" / "deep" / "library.dll").exists()
        running.communicate(b"exit\r\n")
    installed.uninstall()
    installed.require_removed()


@wine_test
def test_newer_version_goes_where_the_older_one_is(
    package: ModuleType, installer: Path, installed: Any
) -> None:
    installed.folder = installed.windows.drive / "robots"
    installed.windows.run([installer, "/S", r"/D=C:\robots"])
    installed.require_installed(__version__)
    (installed.folder / package.PROGRAMS[0]).unlink()
    installed.install(installer)
    installed.require_installed(__version__)
    assert not (installed.windows.drive / "Program Files" / package.NAME).exists()
    listing = installed.windows.run(["reg", "query", installed.key, "/reg:64"])
    assert "Publisher" in listing
    assert "EstimatedSize" in listing
