"""Decisions of the set-up script. Fakes replace the commands that it runs."""

import ast
import re
import sys
from collections.abc import Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from tests.support.scripts import PACKAGING, load_script

bootstrap = load_script("bootstrap")


class FakeMachine:
    """Replaces the computer. Records commands and returns an outcome for the words in them."""

    def __init__(self, **outcomes: Any) -> None:
        self.outcomes = outcomes
        self.commands: list[list[str]] = []

    def __call__(self, command: Sequence[str], extra_env: Mapping[str, str]) -> Any:
        self.commands.append(list(command))
        for word, outcome in self.outcomes.items():
            if word.replace("_", "-") in command:
                return outcome
        return bootstrap.Outcome(0)

    @property
    def apt_commands(self) -> list[list[str]]:
        return [command for command in self.commands if "apt-get" in command]


def package_list(*lines: tuple[str, str, str]) -> Any:
    return bootstrap.Outcome(0, "".join("\t".join(line) + "\n" for line in lines))


SUDO_DENIED = bootstrap.Outcome(1, errors="sudo: a password is required")
LIBEGL_ONLY = package_list(("installed", "libegl1", ""))


# --- Debian packages


def test_installed_packages_are_listed_under_each_name() -> None:
    lines = "config-files\tlibegl1\t\n"
    lines += "installed\tlibglib2.0-0t64\tlibglib2.0-0 (= 2.84.4-3), libglib2.0-x\n"
    assert bootstrap.packages_in(lines) == {"libglib2.0-0t64", "libglib2.0-0", "libglib2.0-x"}


def test_package_is_missing_if_dpkg_fails() -> None:
    debian = bootstrap.Debian(FakeMachine(dpkg_query=bootstrap.Outcome(127)), is_root=True)
    assert debian.missing(["libegl1"]) == ["libegl1"]


def test_installed_package_is_not_installed_again() -> None:
    machine = FakeMachine(dpkg_query=LIBEGL_ONLY)
    bootstrap.Debian(machine, is_root=True).install_missing(["libegl1"])
    assert machine.apt_commands == []


def test_root_updates_apt_once_and_installs_missing_packages() -> None:
    machine = FakeMachine(dpkg_query=LIBEGL_ONLY)
    bootstrap.Debian(machine, is_root=True).install_missing(["libegl1", "libgl1", "libdbus-1-3"])
    apt = ["env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "--quiet"]
    assert machine.apt_commands == [
        [*apt, "update"],
        [*apt, "install", "--yes", "--no-install-recommends", "libgl1", "libdbus-1-3"],
    ]


def test_passwordless_sudo_is_used_without_root() -> None:
    machine = FakeMachine(dpkg_query=LIBEGL_ONLY)
    bootstrap.Debian(machine, is_root=False).install_missing(["libgl1"])
    assert [command[:3] for command in machine.apt_commands] == [["sudo", "-n", "env"]] * 2


def test_install_command_is_printed_if_sudo_is_denied(capsys: pytest.CaptureFixture[str]) -> None:
    machine = FakeMachine(dpkg_query=LIBEGL_ONLY, sudo=SUDO_DENIED)
    bootstrap.Debian(machine, is_root=False).install_missing(["libgl1", "libegl1", "libdbus-1-3"])
    output = capsys.readouterr().out
    assert output.count("\n") == 1
    assert "sudo apt-get install libgl1 libdbus-1-3\n" in output
    assert machine.apt_commands == []


def test_failed_installation_reports_cause_and_command(capsys: pytest.CaptureFixture[str]) -> None:
    failed = bootstrap.Outcome(100, errors="E: Unable to locate package libgl1")
    machine = FakeMachine(dpkg_query=LIBEGL_ONLY, install=failed)
    bootstrap.Debian(machine, is_root=True).install_missing(["libgl1"])
    output = capsys.readouterr().out
    assert "Unable to locate package libgl1" in output
    assert "sudo apt-get install libgl1" in output


# --- Start of Qt


def test_qt_start_reports_platform_and_fonts() -> None:
    start = bootstrap.read_qt_start(bootstrap.Outcome(0, "started offscreen 6\n"))
    assert (start.platform, start.fonts, start.has_window) == ("offscreen", 6, False)
    assert bootstrap.read_qt_start(bootstrap.Outcome(0, "started xcb 6\n")).has_window


@pytest.mark.parametrize(
    ("status", "errors", "reason"),
    [
        (
            1,
            "Traceback:\nImportError: libEGL.so.1: cannot open shared object file: No such file\n",
            "the system has no libEGL.so.1",
        ),
        (
            -6,
            "qt.qpa.xcb: could not connect to display :77\n" + "qt.qpa.plugin: ...\n" * 9,
            "the display does not respond",
        ),
        (-11, "", "status -11"),
    ],
)
def test_failed_start_of_qt_has_a_reason(status: int, errors: str, reason: str) -> None:
    start = bootstrap.read_qt_start(bootstrap.Outcome(status, errors=errors))
    assert (start.platform, start.has_window) == (None, False)
    assert start.reason == reason


def test_setup_requires_qt_and_reports_missing_fonts(capsys: pytest.CaptureFixture[str]) -> None:
    errors = "ImportError: libGL.so.1: cannot open shared object file: No such file"
    with pytest.raises(bootstrap.BootstrapError, match=r"libGL\.so\.1"):
        bootstrap.require_qt(FakeMachine(**{"-c": bootstrap.Outcome(1, errors=errors)}))
    bootstrap.require_qt(FakeMachine(**{"-c": bootstrap.Outcome(0, "started offscreen 0\n")}))
    assert "font" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("environment", "system", "expected"),
    [
        ({}, "linux", False),
        ({"DISPLAY": ""}, "linux", False),
        ({"DISPLAY": ":0"}, "linux", True),
        ({"WAYLAND_DISPLAY": "wayland-0"}, "linux", True),
        ({"DISPLAY": ":0", "QT_QPA_PLATFORM": "offscreen"}, "linux", False),
        ({}, "darwin", True),
        ({}, "win32", True),
    ],
)
def test_display_is_expected_as_environment_and_system_say(
    environment: dict[str, str], system: str, expected: bool
) -> None:
    assert bootstrap.may_have_display(environment, system) is expected


def test_display_that_cannot_be_opened_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DISPLAY", ":77")
    monkeypatch.delenv("QT_QPA_PLATFORM", raising=False)
    monkeypatch.setattr(bootstrap, "find_debian", lambda: None)
    machine = FakeMachine(
        **{"-c": bootstrap.Outcome(-6, errors="could not connect to display :77")}
    )
    assert "cannot be opened" in bootstrap.reason_without_window(machine)


# --- Stamp of the environment

STAMP = bootstrap.Stamp("3.11 /usr", "/home/ada/trex", "f00d")


@pytest.mark.parametrize("text", ["", "{", "[]", "{}", '{"interpreter": "3.11"}', '{"x": 1}'])
def test_damaged_stamp_is_ignored(tmp_path: Path, text: str) -> None:
    (tmp_path / "stamp.json").write_text(text, encoding="utf-8")
    assert bootstrap.read_stamp(tmp_path / "stamp.json") is None


@pytest.mark.parametrize(
    "earlier",
    [
        None,
        bootstrap.Stamp("3.12 /usr", "/home/ada/trex", "f00d"),
        bootstrap.Stamp("3.11 /usr", "/home/ada/moved", "f00d"),
    ],
)
def test_changed_python_or_folder_requires_a_new_environment(earlier: Any) -> None:
    assert not STAMP.can_keep_venv(earlier)


class Project:
    """Project in a temporary folder. Its set-up only counts the installations."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.machine = FakeMachine()
        self.installations = 0
        self.venv = folder / ".venv"
        self.stamp_file = self.venv / "bootstrap.json"
        monkeypatch.setattr(bootstrap, "VENV", self.venv)
        monkeypatch.setattr(bootstrap, "STAMP_FILE", self.stamp_file)
        monkeypatch.setattr(bootstrap, "find_debian", lambda: None)
        monkeypatch.setattr(bootstrap, "require_qt", lambda run: None)
        monkeypatch.setattr(bootstrap, "install_packages", self._install)

    def set_up(self) -> bool:
        result: bool = bootstrap.set_up(self._run)
        return result

    @property
    def created_venvs(self) -> int:
        return sum("--clear" in command for command in self.machine.commands)

    def _run(self, command: Sequence[str], extra_env: Mapping[str, str]) -> Any:
        if "--clear" in command:
            python = bootstrap.venv_python()
            python.parent.mkdir(parents=True, exist_ok=True)
            python.touch()
        return self.machine(command, extra_env)

    def _install(self) -> None:
        self.installations += 1


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Project:
    return Project(tmp_path, monkeypatch)


def test_second_setup_does_nothing(project: Project) -> None:
    assert project.set_up()
    commands = len(project.machine.commands)
    assert not project.set_up()
    assert (project.installations, len(project.machine.commands)) == (1, commands)


def test_changed_requirements_are_installed_in_same_environment(
    project: Project, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    project.set_up()
    (tmp_path / "other.txt").touch()
    monkeypatch.setattr(bootstrap, "CONSTRAINTS", tmp_path / "other.txt")
    assert project.set_up()
    assert (project.created_venvs, project.installations) == (1, 2)


def test_environment_without_python_is_recreated(project: Project) -> None:
    project.set_up()
    bootstrap.venv_python().unlink()
    assert project.set_up()
    assert project.created_venvs == 2


def interrupt() -> None:
    raise KeyboardInterrupt


def test_interrupted_setup_resumes_in_same_environment(
    project: Project, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as patch:
        patch.setattr(bootstrap, "install_packages", interrupt)
        with pytest.raises(KeyboardInterrupt):
            project.set_up()
    assert project.set_up()
    assert (project.created_venvs, project.installations) == (1, 1)


@pytest.mark.skipif(sys.platform == "win32", reason="links need a permission on Windows")
def test_environment_behind_a_link_is_not_deleted(project: Project, tmp_path: Path) -> None:
    other = tmp_path / "other"
    other.mkdir()
    project.venv.symlink_to(other, target_is_directory=True)
    with pytest.raises(bootstrap.BootstrapError, match=f"would empty its target, {other}"):
        project.set_up()
    assert not project.machine.commands
    assert not list(other.iterdir())


def test_missing_venv_package_is_named(project: Project) -> None:
    project.machine.outcomes["-c"] = bootstrap.Outcome(1, errors="No module named 'ensurepip'")
    version = f"python{sys.version_info[0]}.{sys.version_info[1]}-venv"
    with pytest.raises(bootstrap.BootstrapError, match=version):
        project.set_up()


# --- Commands


def test_pip_installs_build_backend_first_and_pins_versions() -> None:
    backend, package = bootstrap.pip_commands(["pip"])
    assert backend[-2:] == ["hatchling", "editables"]
    assert "--no-build-isolation" in package
    for command in (backend, package):
        assert command[command.index("--constraint") + 1] == str(bootstrap.CONSTRAINTS)


def test_pytest_checks_run_last_and_receive_arguments() -> None:
    checks = bootstrap.checks(["-k", "crc"])
    assert [check.is_tests for check in checks] == [False] * 5 + [True] * 2
    virtual, real = (check.command for check in checks[5:])
    assert virtual[-2:] == real[-2:] == ("-k", "crc")
    assert "not realtime" in virtual
    assert "realtime" in real


def test_option_all_runs_slow_tests_with_random_seeds() -> None:
    for every in (False, True):
        for check in bootstrap.checks([], every=every):
            if check.is_tests:
                assert ("--all" in check.command) is every
                assert check.environment == {"HYPOTHESIS_PROFILE": "all" if every else "gate"}


@dataclass
class Programs:
    """Replaces commands whose output is visible. `statuses`: exit codes by command, else 0."""

    statuses: dict[str, int] = field(default_factory=dict)
    tests: int = 12
    commands: list[Sequence[str]] = field(default_factory=list)
    environment: Mapping[str, str] = field(default_factory=dict)

    def run(self, command: Sequence[str], extra_env: Mapping[str, str]) -> int:
        self.commands.append(command)
        self.environment = extra_env
        for word in command:
            if word.startswith("--junitxml="):
                report = f'<testsuites><testsuite tests="{self.tests}"/></testsuites>'
                Path(word.removeprefix("--junitxml=")).write_text(report, encoding="utf-8")
        return self.statuses.get(Path(command[0]).stem, 0)


@pytest.fixture
def programs(monkeypatch: pytest.MonkeyPatch) -> Programs:
    programs = Programs()
    monkeypatch.setattr(bootstrap, "set_up", lambda: False)
    monkeypatch.setattr(bootstrap, "run_visibly", programs.run)
    monkeypatch.setattr(bootstrap, "compile_tests", nullcontext)
    return programs


def last_lines(capsys: pytest.CaptureFixture[str]) -> list[list[str]]:
    return [line.split() for line in capsys.readouterr().out.splitlines()[-6:]]


def test_passing_checks_exit_0(programs: Programs, capsys: pytest.CaptureFixture[str]) -> None:
    assert bootstrap.main(["test"]) == 0
    assert [line[3] for line in last_lines(capsys)[-2:]] == ["12", "12"]
    assert programs.environment["QT_QPA_PLATFORM"] == "offscreen"
    assert programs.environment["HYPOTHESIS_PROFILE"] == "gate"


def test_checks_continue_after_failure(
    programs: Programs, capsys: pytest.CaptureFixture[str]
) -> None:
    programs.statuses["mypy"] = 1
    assert bootstrap.main(["test"]) == 1
    results = [line[0] for line in last_lines(capsys)]
    assert results == ["ok", "ok", "FAILED", "ok", "ok", "ok"]


@pytest.mark.parametrize(("tests", "status"), [(12, 0), (0, 1)])
def test_checks_fail_if_no_test_is_selected(programs: Programs, tests: int, status: int) -> None:
    programs.statuses["pytest"], programs.tests = 5, tests
    assert bootstrap.main(["test"]) == status


def test_soak_gets_minutes_and_seed_and_returns_its_status(programs: Programs) -> None:
    programs.statuses["python"] = 1
    assert bootstrap.main(["soak"]) == 1
    assert bootstrap.main(["soak", "--minutes", "0.5", "--seed", "7"]) == 1
    assert [list(command[1:]) for command in programs.commands] == [
        ["-m", "tests.soak", "--minutes=10"],
        ["-m", "tests.soak", "--minutes=0.5", "--seed=7"],
    ]
    assert programs.environment == {"QT_QPA_PLATFORM": "offscreen"}


def test_ctrl_c_ends_without_output(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(bootstrap, "set_up", interrupt)
    assert bootstrap.main(["setup"]) == 130
    assert capsys.readouterr() == ("", "")


@pytest.mark.parametrize(
    "arguments", [[], ["launch"], ["setup", "--", "-k"], ["test", "-k"], ["soak", "--minutes", "0"]]
)
def test_invalid_arguments_exit_with_status_2(
    arguments: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as exit_info:
        bootstrap.main(arguments)
    assert exit_info.value.code == 2


def test_benchmarks_are_compared_to_file_in_current_folder(
    programs: Programs, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert bootstrap.main(["bench", "--compare", "run.txt", "--", "-k", "start"]) == 0
    assert bootstrap.main(["bench"]) == 0
    compiled, compared, _, plain = programs.commands
    assert "compileall" in compiled
    assert compared[-3:] == [f"--compare={tmp_path / 'run.txt'}", "-k", "start"]
    assert not any(word.startswith("--compare") for word in plain)


def test_named_packages_are_created_and_checked(programs: Programs) -> None:
    assert bootstrap.main(["package", "deb", "--check"]) == 0
    assert bootstrap.main(["package"]) == 0
    named, default = programs.commands
    assert list(named[-3:]) == [str(bootstrap.PACKAGES), "--check", "deb"]
    assert default[-1] == str(bootstrap.PACKAGES)


def test_demo_without_display_requires_and_lists_its_screenshots(
    programs: Programs,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    folder = tmp_path / "demo-screenshots"
    folder.mkdir()
    (folder / "of-an-earlier-run.png").touch()

    def save_picture(command: Sequence[str], extra_env: Mapping[str, str]) -> int:
        (folder / "boardPage.png").touch()
        return programs.run(command, extra_env)

    monkeypatch.setattr(bootstrap, "ROOT", tmp_path)
    monkeypatch.setattr(bootstrap, "SCREENSHOTS", folder)
    monkeypatch.setattr(bootstrap, "reason_without_window", lambda run: "There is no display")
    monkeypatch.setattr(bootstrap, "run_visibly", save_picture)
    assert bootstrap.main(["demo"]) == 0
    assert list(programs.commands[0][-2:]) == ["--tour", "demo-screenshots"]
    assert programs.environment == {"QT_QPA_PLATFORM": "offscreen"}
    output = capsys.readouterr().out
    assert "There is no display" in output
    assert "demo-screenshots/boardPage.png" in output.replace("\\", "/")
    assert "of-an-earlier-run" not in output
    programs.statuses["python"] = 3
    assert bootstrap.main(["demo"]) == 1, "the program failed"
    programs.statuses.clear()
    monkeypatch.setattr(bootstrap, "run_visibly", programs.run)
    assert bootstrap.main(["demo"]) == 1, "no screenshot was written"


def test_pictures_are_created_offscreen_without_user_settings(
    monkeypatch: pytest.MonkeyPatch, programs: Programs
) -> None:
    def run(command: Sequence[str], extra_env: Mapping[str, str]) -> int:
        assert command[-1] == str(bootstrap.PICTURES)
        assert extra_env["QT_QPA_PLATFORM"] == "offscreen"
        home = Path(extra_env["XDG_CONFIG_HOME"])
        assert home.is_dir()
        assert not list(home.iterdir())
        return 3

    monkeypatch.setattr(bootstrap, "run_visibly", run)
    assert bootstrap.PICTURES.is_file()
    assert bootstrap.main(["pictures"]) == 3


# --- Files


def test_script_parses_in_python_3_7() -> None:
    ast.parse((PACKAGING / "bootstrap.py").read_text(encoding="utf-8"), feature_version=(3, 7))


def test_constraints_are_sorted_exact_versions() -> None:
    lines = bootstrap.CONSTRAINTS.read_text(encoding="utf-8").splitlines()
    names = [line.split("==")[0].lower() for line in lines]
    version = re.compile(r"[\w.-]+==\d+(\.\d+)*(\.post\d+|b\d+)?")
    assert [line for line in lines if not version.fullmatch(line)] == []
    assert names == sorted(set(names))
