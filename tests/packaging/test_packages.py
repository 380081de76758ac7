"""Packages for users: one version, complete metadata, licences."""

import ast
import configparser
import json
import os
import re
import runpy
import subprocess
import sys
from io import BytesIO
from pathlib import Path, PurePath
from typing import Any
from xml.etree import ElementTree

import pytest

from tests.packaging.loading import import_script
from tests.support.scripts import PACKAGING
from trex_gui.version import __version__

ROOT = PACKAGING.parent
LINUX = PACKAGING / "linux"

packages = import_script("packages")


# --- The version


def test_version_is_written_in_one_place() -> None:
    assert packages.version() == __version__
    files = [ROOT / "pyproject.toml", *PACKAGING.rglob("*.*")]
    copies = [
        path.name
        for path in files
        if path.name != "constraints.txt"
        and path.suffix in {".toml", ".py", ".spec", ".xml", ".desktop"}
        and f'"{__version__}"' in path.read_text(encoding="utf-8")
    ]
    assert copies == []


# --- The frozen folder


@pytest.fixture(scope="module")
def spec() -> ast.Module:
    return ast.parse((PACKAGING / "frozen" / "trex-studio.spec").read_text(encoding="utf-8"))


def spec_value(spec: ast.Module, name: str, **known: Any) -> Any:
    """Return the value that the spec assigns to a name."""
    for statement in spec.body:
        if isinstance(statement, ast.Assign) and ast.unparse(statement.targets[0]) == name:
            return eval(ast.unparse(statement.value), {"re": re, **known})  # part of this project
    raise KeyError(name)


def test_modules_imported_by_name_are_frozen(spec: ast.Module) -> None:
    hidden = spec_value(spec, "HIDDEN", collect_submodules=lambda package: [package])
    assert {"trex_gui", "serial.urlhandler", "mcap", "pygame.joystick"} <= set(hidden)


def test_program_runs_without_the_excluded_modules(spec: ast.Module) -> None:
    script = Path(__file__).with_name("import_without.py")
    command = [sys.executable, "-W", "error", str(script), *spec_value(spec, "EXCLUDED")]
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "QT_QPA_PLATFORM": "offscreen"}
    process = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert (process.returncode, process.stderr) == (0, "")


@pytest.mark.parametrize(
    ("plugin", "is_frozen"),
    [
        ("platforms/libqxcb.so", True),
        ("platforms/libqoffscreen.so", True),
        ("platforms/qwindows.dll", True),
        ("platforms/libqcocoa.dylib", True),
        ("wayland-shell-integration/libxdg-shell.so", True),
        ("imageformats/libqsvg.so", True),
        ("platformthemes/libqgtk3.so", False),
        ("platforms/libqeglfs.so", False),
        ("egldeviceintegrations/libqeglfs-x11-integration.so", False),
        ("tls/libqopensslbackend.so", False),
        ("imageformats/libqtiff.so", False),
    ],
)
def test_only_plugins_that_a_desktop_needs_are_frozen(
    spec: ast.Module, plugin: str, is_frozen: bool
) -> None:
    assert (spec_value(spec, "PLUGINS").match(plugin) is not None) is is_frozen


def spec_function(spec: ast.Module, name: str, **known: Any) -> Any:
    """Return a function of the spec, with the functions that it calls."""
    functions = [part for part in spec.body if isinstance(part, ast.FunctionDef)]
    names = {"re": re, "PurePath": PurePath, "PYZ": object, **known}
    exec(compile(ast.Module([*functions], []), "spec", "exec"), names)  # part of this project
    return names[name]


def test_libraries_that_nothing_imports_are_excluded(spec: ast.Module) -> None:
    imports = {
        "python": ["VCRUNTIME140.dll"],
        "joystick": ["sdl2.DLL", "KERNEL32.dll"],
        "qwindows": ["Qt6Gui.dll"],
    }
    unneeded = spec_function(
        spec,
        "unneeded_libraries",
        get_imports=lambda source: [(name, None) for name in imports.get(source, [])],
    )
    binaries = [
        ("python311.dll", "python", "BINARY"),
        ("VCRUNTIME140.dll", "runtime", "BINARY"),
        (r"pygame\joystick.pyd", "joystick", "EXTENSION"),
        (r"pygame\SDL2.dll", "sdl", "BINARY"),
        (r"pygame\SDL2_mixer.dll", "mixer", "BINARY"),
        ("SDL2.dll", r"pygame\SDL2.dll", "SYMLINK"),
        (r"PySide6\plugins\platforms\qwindows.dll", "qwindows", "BINARY"),
        (r"PySide6\Qt6Gui.dll", "gui", "BINARY"),
        (r"PySide6\opengl32sw.dll", "mesa", "BINARY"),
    ]
    assert unneeded(binaries) == {"sdl2_mixer.dll", "opengl32sw.dll"}


@pytest.mark.parametrize(
    ("name", "is_frozen"),
    [
        ("pygame/freesansbold.ttf", False),
        ("numpy/_core/tests/data.csv", False),
        ("resources/tests/sample.txt", True),
        ("pygame/joystick.so", True),
    ],
)
def test_files_that_nothing_opens_are_excluded(
    spec: ast.Module, name: str, is_frozen: bool
) -> None:
    assert spec_function(spec, "is_used")(name) is is_frozen


def test_child_processes_get_the_libraries_of_the_user(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    hook = str(PACKAGING / "frozen" / "clean_environment.py")
    monkeypatch.setenv("LD_LIBRARY_PATH", "/bundle")
    monkeypatch.setenv("LD_LIBRARY_PATH_ORIG", "/user")
    environment = runpy.run_path(hook)["os"].environ
    assert environment["LD_LIBRARY_PATH"] == "/user"
    assert "LD_LIBRARY_PATH_ORIG" not in environment
    runpy.run_path(hook)
    assert "LD_LIBRARY_PATH" not in environment


# --- Licences


def test_every_bundled_package_has_a_licence() -> None:
    bundled = packages.bundled_distributions()
    names = {package.metadata["Name"] for package in bundled}
    assert {"PySide6_Essentials", "pygame-ce", "zstandard", "click"} <= names
    assert not names & {"pytest", "ruff", "pyinstaller"}
    without = {
        package.metadata["Name"] for package in bundled if not packages.licence_texts(package)
    }
    assert without == packages.WITHOUT_LICENCE.keys()
    for file in packages.WITHOUT_LICENCE.values():
        assert (PACKAGING / "licences" / file).stat().st_size > 500
    debian = (LINUX / "copyright").read_text(encoding="utf-8").lower()
    assert [name for name in names if name.lower().replace("-", "_") not in debian] == []


def test_licence_files_named_in_documents_exist() -> None:
    folder = PACKAGING / "licences"
    named = set(re.findall(r"`([\w.-]+\.txt)`", (folder / "README.md").read_text()))
    debian = re.findall(r"licences/([\w.-]+\.txt)", (LINUX / "copyright").read_text())
    packaged = {f"{package.metadata['Name']}.txt" for package in packages.bundled_distributions()}
    copied = {"NAME.txt", "Debian-NAME.txt", "Python.txt", "PyInstaller.txt", "TReX-Studio.txt"}
    existing = {path.name for path in folder.iterdir()}
    assert {*named, *debian} <= existing | packaged | copied | {"versions.txt"}


# --- The files of a Linux desktop


def test_desktop_file_starts_the_window_and_has_an_icon() -> None:
    desktop = configparser.ConfigParser(interpolation=None)
    desktop.read(LINUX / "trex-studio.desktop", encoding="utf-8")
    entry = desktop["Desktop Entry"]
    assert (entry["Type"], entry["Exec"], entry["Icon"]) == (
        "Application",
        "trex-gui",
        "trex-studio",
    )
    assert (ROOT / "resources" / "icons" / f"{entry['Icon']}.svg").exists()
    app = (ROOT / "trex_gui" / "app.py").read_text(encoding="utf-8")
    assert 'setDesktopFileName("trex-studio")' in app  # name of the desktop file


def test_metadata_contain_the_programs_and_the_version() -> None:
    text = packages.linux_file(packages.METADATA)
    component = ElementTree.fromstring(text)
    assert f"{component.findtext('id')}.metainfo.xml" == packages.METADATA
    assert [entry.text for entry in component.iterfind("provides/binary")] == [*packages.PROGRAMS]
    release = component.find("releases/release")
    assert release is not None
    assert release.get("version") == __version__
    assert re.fullmatch(r"\d{4}-\d\d-\d\d", release.get("date", ""))


def test_udev_rules_are_well_formed() -> None:
    text = (LINUX / "60-trex-studio.rules").read_text(encoding="utf-8")
    term = r'[A-Z]+(\{\w+\})?(==|!=|=|\+=)"[^"]*"'
    rules = [line for line in text.splitlines() if line and not line.startswith("#")]
    for rule in rules:
        assert re.fullmatch(rf"{term}(, {term})*", rule), rule
    labels = set(re.findall(r'LABEL="(\w+)"', text))
    assert labels == set(re.findall(r'GOTO="(\w+)"', text))
    assert any('TAG+="uaccess"' in rule and 'SUBSYSTEM=="tty"' in rule for rule in rules)


# --- Manual pages and names


def test_manual_page_contains_the_help_of_every_command(monkeypatch: pytest.MonkeyPatch) -> None:
    def help_text(*words: str) -> str:
        return (
            "Usage: trexcmd\n\nCommands:\n  status  Show it.\n  find    Find it.\n"
            if len(words) == 1
            else f"Usage of {words[1]}\n"
        )

    monkeypatch.setattr(packages, "command_help", help_text)
    page = packages.manual_page("trexcmd")
    assert page.startswith(".TH TREXCMD 1")
    assert '.SH "TREXCMD STATUS"\n.nf\nUsage of status\n' in page
    assert '.SH "TREXCMD FIND"' in page
    assert ".BR trex\\-gui (1)" in page


def test_special_characters_are_escaped_for_roff() -> None:
    assert packages.roff(".start\n'a-b\\n") == "\\&.start\n\\&'a\\-b\\en"


def test_archives_of_equal_content_are_identical(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
    folder = tmp_path / "program"
    folder.mkdir()
    archives = []
    for name in ("first", "second"):
        (folder / "file").write_text("content")
        packages.pack(folder, tmp_path / name)
        archives.append((tmp_path / name).read_bytes())
        (folder / "file").unlink()
    assert archives[0] == archives[1]


def test_checksums_list_files_of_this_version(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(packages, "DIST", tmp_path)
    (tmp_path / f"trex_gui-{__version__}.tar.gz").write_bytes(b"abc")
    (tmp_path / "trex_gui-0.0.1.tar.gz").write_bytes(b"old")
    packages.write_checksums()
    lines = (tmp_path / "SHA256SUMS").read_text().splitlines()
    assert [line.split() for line in lines] == [
        [
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad",
            f"trex_gui-{__version__}.tar.gz",
        ]
    ]


# --- Checks of packages


def test_failed_step_is_reported_and_the_next_step_runs(capsys: pytest.CaptureFixture[str]) -> None:
    steps, is_skipped = packages.Steps(), True
    with steps.group("here"):
        with steps.step("read"):
            packages.require(False, "no reply")
        with steps.step("write"):
            pass
        with steps.required("install"):
            packages.require(False, "no space")
        is_skipped = False
    assert is_skipped
    assert steps.failed == ["here: read", "here: install"]
    output = capsys.readouterr().out
    assert "FAILED  read\nno reply" in output
    assert "ok      write" in output


def set_targets(monkeypatch: pytest.MonkeyPatch, folder: Path, **targets: Any) -> None:
    monkeypatch.setattr(packages, "DIST", folder)
    monkeypatch.setattr(packages, "ROOT", folder)
    monkeypatch.setattr(packages, "version", lambda: __version__)
    monkeypatch.setattr(packages, "TARGETS", targets)


def test_failed_package_does_not_prevent_other_checksums(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    package = tmp_path / f"program-{__version__}"

    def build() -> list[Path]:
        package.write_text("program")
        return [package]

    def fail(*_: object) -> Any:
        raise packages.BootstrapError("no space")

    set_targets(
        monkeypatch,
        tmp_path,
        first=packages.Target(fail, fail),
        second=packages.Target(build, fail, checked_on=""),
        third=packages.Target(build, fail, checked_on="mars"),
    )
    assert packages.main(["--check"]) == 1
    assert package.name in (tmp_path / "SHA256SUMS").read_text()
    output = capsys.readouterr().out
    assert "third cannot be checked on this system." in output
    assert output.endswith("Failed:\n  build first\n  check second\n")


def test_unknown_package_or_system_is_a_usage_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    target = packages.Target(list, print, system="mars")
    set_targets(monkeypatch, tmp_path, rover=target)
    assert packages.main([]) == 0
    for name, text in (
        ("rover", "cannot be built on this system: rover"),
        ("tent", "no such package: tent"),
    ):
        with pytest.raises(SystemExit) as exit_info:
            packages.main([name])
        assert exit_info.value.code == 2
        assert text in capsys.readouterr().err


@pytest.mark.skipif(sys.platform == "win32", reason="needs programs of Linux")
@pytest.mark.parametrize("names", [(), ("dpkg-query", "apt-get")])
def test_debian_package_is_created_only_if_dpkg_exists(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, names: tuple[str, ...]
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    for name in names:
        (tmp_path / name).touch(0o755)
    assert bool(packages.TARGETS["deb"].is_default()) is bool(names)


def test_wheel_is_checked_at_least_with_the_current_python(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setenv("PYENV_ROOT", str(tmp_path))
    number = f"3.{sys.version_info.minor}"
    assert packages.find_pythons() == {number: Path(sys.executable)}


@pytest.mark.parametrize(
    ("direction", "speed", "is_at_rest"),
    [("forward", 40, False), ("forward", 0, True), ("brake", 127, True)],
)
def test_board_is_at_rest_while_no_motor_is_driven(
    direction: str, speed: int, is_at_rest: bool
) -> None:
    motors = [{"direction": "forward", "speed": 0}, {"direction": direction, "speed": speed}]
    reply = f"event\nok {json.dumps({'motors': motors})}\n"
    board = packages.SimulatedBoard(requests := BytesIO(), BytesIO(reply.encode()))
    assert board.is_at_rest is is_at_rest
    assert requests.getvalue() == b"show\n"
    with pytest.raises(packages.BootstrapError, match="has ended"):
        assert board.is_at_rest
