"""The installer for Windows, with stand-ins for the programs."""

import shutil
import sys
from pathlib import Path
from types import ModuleType

import pytest

from trex_gui import __version__

PACKAGING = Path(__file__).resolve().parents[2] / "packaging"

pytestmark = [
    pytest.mark.realtime,
    pytest.mark.skipif(shutil.which("makensis") is None, reason="needs NSIS"),
]


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


@pytest.mark.slow
@pytest.mark.timeout(300)
@pytest.mark.skipif(shutil.which("wine") is None, reason="needs Wine")
def test_uninstaller_removes_what_was_installed_only(
    package: ModuleType, installer: Path, tmp_path: Path
) -> None:
    wine = package.Wine(tmp_path / "prefix")
    wine.drive.mkdir(parents=True)
    installed = package.Installation(wine)
    try:
        wine.run(["wineboot", "--init"])
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
    finally:
        wine.stop()
