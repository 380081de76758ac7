"""Installer for Windows, with placeholders for the programs."""

import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.packaging.loading import import_script
from trex_gui.version import __version__

package = import_script("windows.package")

pytestmark = [
    pytest.mark.realtime,
    pytest.mark.skipif(shutil.which("makensis") is None, reason="needs NSIS"),
]


def wine_test(function: Callable[..., None]) -> Callable[..., None]:
    """Mark a test that installs the program in Wine."""
    for mark in (
        pytest.mark.slow,
        pytest.mark.timeout(300),
        pytest.mark.skipif(shutil.which("wine") is None, reason="needs Wine"),
    ):
        function = mark(function)
    return function


@pytest.fixture(scope="module")
def installer(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("installer")
    frozen = folder / "frozen"
    for name in (*package.PROGRAMS, "_internal/deep/library.dll", "licences/Python.txt"):
        path = frozen / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(b"placeholder")
    file = folder / "installer.exe"
    package.build_installer(frozen, __version__, file)
    return file


def test_installer_is_a_windows_program(installer: Path) -> None:
    assert installer.read_bytes().startswith(b"MZ")
    assert sorted(path.name for path in installer.parent.iterdir()) == ["frozen", "installer.exe"]


@pytest.fixture
def installation(tmp_path: Path) -> Iterator[Any]:
    wine = package.Wine(tmp_path / "prefix")
    wine.drive.mkdir(parents=True)
    try:
        wine.run(["wineboot", "--init"])
        yield package.Installation(wine)
    finally:
        wine.stop()


@wine_test
def test_uninstaller_removes_only_installed_files(installer: Path, installation: Any) -> None:
    installation.install(installer)
    installation.require_installed(__version__)
    assert (installation.folder / "_internal" / "deep" / "library.dll").exists()
    old = installation.folder / "_internal" / "of an earlier version.dll"
    old.touch()
    installation.install(installer)
    assert not old.exists()
    notes = installation.folder / "notes of the user.txt"
    notes.touch()
    installation.uninstall()
    assert [path.name for path in installation.folder.iterdir()] == [notes.name]
    installation.install(installer)
    notes.unlink()
    installation.uninstall()
    installation.require_removed()


@wine_test
def test_running_program_is_not_replaced_or_removed(installer: Path, installation: Any) -> None:
    installation.folder = installation.windows.drive / "robots"
    installation.windows.run([installer, "/S", r"/D=C:\robots"])
    program = installation.folder / "trexcmd.exe"
    shutil.copy(installation.windows.drive / "windows" / "system32" / "cmd.exe", program)
    with installation.windows.start([program]) as running:
        assert running.stdout.read(1)  # the program has started
        for command in (
            [installer, "/S"],
            [installation.folder / "uninstall.exe", "/S", r"_?=C:\robots"],  # without a copy
        ):
            with installation.windows.start(command) as process:
                assert process.wait(60) == 2  # Wine's desktop does not close the pipes
        installation.require_installed(__version__)
        assert (installation.folder / "_internal" / "deep" / "library.dll").exists()
        running.communicate(b"exit\r\n")
    installation.uninstall()
    installation.require_removed()


@wine_test
def test_newer_version_is_installed_in_the_folder_of_the_older(
    installer: Path, installation: Any
) -> None:
    installation.folder = installation.windows.drive / "robots"
    installation.windows.run([installer, "/S", r"/D=C:\robots"])
    installation.require_installed(__version__)
    (installation.folder / package.PROGRAMS[0]).unlink()
    installation.install(installer)
    installation.require_installed(__version__)
    assert not (installation.windows.drive / "Program Files" / package.NAME).exists()
    values = installation.windows.run(["reg", "query", installation.key, "/reg:64"])
    assert "Publisher" in values
    assert "EstimatedSize" in values
