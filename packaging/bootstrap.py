#!/usr/bin/env python3
"""Set up the project in `.venv/`, then show, check or measure it.

    python3 packaging/bootstrap.py setup | demo | test [--all | --lowest] | bench | soak | mutate |
                                    translations | pictures | docs | package [--check] [KIND ...]

Requires only Python's standard library. The syntax stays valid for older versions of Python, so
that they can print the message about their version.
"""

import argparse
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import partial
from pathlib import Path
from xml.etree import ElementTree

OLDEST_PYTHON = (3, 11)

if sys.version_info < OLDEST_PYTHON:
    sys.exit(
        "TReX Studio needs Python {}.{} or newer, and this is Python {}.{} ({}). "
        "Please run this file with a newer one.".format(
            *OLDEST_PYTHON, *sys.version_info[:2], sys.executable
        )
    )

ROOT = Path(__file__).resolve().parent.parent
VENV = ROOT / ".venv"
STAMP_FILE = VENV / "bootstrap.json"
PROJECT_FILE = ROOT / "pyproject.toml"
PACKAGING = ROOT / "packaging"
CONSTRAINTS = PACKAGING / "constraints.txt"
BENCHMARKS = ROOT / "tests" / "benchmarks"
DOCS = PACKAGING / "docs.py"
BUILD_DOCS = ROOT / "build" / "docs"
LOWEST = PACKAGING / "lowest.py"
MUTATE = PACKAGING / "mutate.py"
PICTURES = PACKAGING / "pictures.py"
ANIMATION = PACKAGING / "animation.py"
PACKAGES = PACKAGING / "packages.py"

CORES = max(2, min(4, os.cpu_count() or 1))
VIRTUAL = ("-m", "not realtime", "-n", str(CORES), "--dist", "worksteal")
REALTIME = ("-m", "realtime", "-n", str(CORES + 3), "--dist", "worksteal")
"""Distribution of the tests: virtual-time tests compute, real-time tests also wait."""

NO_TESTS = 5  # exit code of pytest if no test was selected
SCREENSHOTS = ROOT / "demo-screenshots"

# Libraries that Qt loads from the system, by their names in Debian 12. Later releases still provide
# these names. The offscreen platform needs only the first group. A window needs both.
OFFSCREEN_PACKAGES = (
    "libegl1",
    "libgl1",
    "libxkbcommon0",
    "libdbus-1-3",
    "libfontconfig1",
    "libglib2.0-0",
    "fonts-dejavu-core",  # without a font, Qt draws boxes instead of letters
)
WINDOW_PACKAGES = (
    "libxcb-cursor0",
    "libxcb-icccm4",
    "libxcb-image0",
    "libxcb-keysyms1",
    "libxcb-randr0",
    "libxcb-render-util0",
    "libxcb-shape0",
    "libxcb-xfixes0",
    "libxcb-xkb1",
    "libxkbcommon-x11-0",
    "libwayland-cursor0",  # the only additional library for Wayland
)
QT_PACKAGES = OFFSCREEN_PACKAGES + WINDOW_PACKAGES

# Programs that tests use, and their packages. The compiler compiles exported sketches, and the
# message bus reports that the screen is locked. Tests of sketches are skipped without a compiler.
TEST_PROGRAMS = {"g++": "g++", "dbus-daemon": "dbus"}

# pip builds the project with these packages from `.venv/`, because the constraints do not apply to
# an isolated environment.
BUILD_REQUIREMENTS = ("hatchling", "editables")

OFFSCREEN = {"QT_QPA_PLATFORM": "offscreen"}
COMPILE_ONCE = {"PYTHONDONTWRITEBYTECODE": ""}  # the tests start the program dozens of times
TEST_ENVIRONMENT = {
    **OFFSCREEN,
    **COMPILE_ONCE,
    "OPENBLAS_NUM_THREADS": "1",  # numpy's idle threads spin for a while
}
PLATFORMS_WITHOUT_WINDOW = ("offscreen", "minimal")

QT_START = """
from PySide6 import QtSvg
from PySide6.QtGui import QFontDatabase
from PySide6.QtWidgets import QApplication
application = QApplication([])
print("started", application.platformName(), len(QFontDatabase.families()))
"""
QT_START_SECONDS = 60


class BootstrapError(Exception):
    """Error that ends the command. The user sees its text."""


def say(text: str) -> None:
    """Print immediately, before the output of the next program."""
    print(text, flush=True)


# --- Running other programs ------------------------------------------------------------------


@dataclass(frozen=True)
class Outcome:
    """Status and output of a program."""

    status: int
    output: str = ""
    errors: str = ""


# Runs a command with additional environment variables and captures its output.
Runner = Callable[[Sequence[str], Mapping[str, str]], Outcome]


def run_captured(
    command: Sequence[str], extra_env: Mapping[str, str], timeout: float | None = None
) -> Outcome:
    """Run a command and capture its output. A missing or hanging command has failed."""
    try:
        done = subprocess.run(
            command,
            env={**os.environ, **extra_env},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            errors="replace",
            check=False,
            timeout=timeout,
        )
    except OSError as error:
        return Outcome(127, errors=str(error))
    except subprocess.TimeoutExpired:
        return Outcome(124, errors=f"no response within {timeout:.0f} seconds")
    return Outcome(done.returncode, done.stdout, done.stderr)


def run_visibly(command: Sequence[str], extra_env: Mapping[str, str]) -> int:
    """Run a command in the project's folder on the user's terminal. Return its exit code.

    Ctrl-C reaches the command, too. It then has a few seconds to exit.
    """
    with subprocess.Popen(command, cwd=ROOT, env={**os.environ, **extra_env}) as process:
        try:
            return process.wait()
        except KeyboardInterrupt:
            try:
                process.wait(timeout=5)
            except subprocess.TimeoutExpired:
                process.kill()
            raise


# --- System packages on Debian -----------------------------------------------------------------


def packages_in(listing: str) -> set[str]:
    """Return the names of installed packages, and the names that they provide.

    Args:
        listing: lines of dpkg-query, `status<TAB>name<TAB>provided (= version), ...`.
    """
    names: set[str] = set()
    for line in listing.splitlines():
        status, name, provided = line.split("\t")
        if status == "installed":
            names.add(name)
            names.update(entry.split()[0] for entry in provided.split(",") if entry.strip())
    return names


def last_lines(text: str, count: int = 5) -> str:
    """Return the last lines of a program's output, which usually contain the error."""
    return "\n".join(text.strip().splitlines()[-count:])


class Debian:
    """Package tools of Debian and its derivatives."""

    def __init__(self, run: Runner, *, is_root: bool) -> None:
        self._run = run
        self._is_root = is_root

    def missing(self, wanted: Iterable[str]) -> list[str]:
        """Return the wanted packages that no installed package provides."""
        row = "${db:Status-Status}\t${Package}\t${Provides}\n"
        outcome = self._run(["dpkg-query", "--show", f"--showformat={row}"], {})
        installed = packages_in(outcome.output)
        return [name for name in wanted if name not in installed]

    def install_missing(self, wanted: Iterable[str]) -> None:
        """Install missing packages, or print the command if that needs a password."""
        missing = self.missing(wanted)
        if not missing:
            return
        by_user = f"sudo apt-get install {' '.join(missing)}"
        prefix = self._privilege()
        if prefix is None:
            say(f"Some system packages are missing. Install them with: {by_user}")
            return
        say(f"Installing system packages: {' '.join(missing)}")
        apt = [*prefix, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "--quiet"]
        # After a failed update, the installation may still succeed.
        self._run([*apt, "update"], {})
        outcome = self._run([*apt, "install", "--yes", "--no-install-recommends", *missing], {})
        if outcome.status != 0:
            say(last_lines(outcome.errors))
            say(f"apt-get could not install them. Install them with: {by_user}")

    def _privilege(self) -> list[str] | None:
        """Return the command prefix for apt-get, or None without the permission to install."""
        if self._is_root:
            return []
        sudo = ["sudo", "-n"]  # never prompts for a password
        return sudo if self._run([*sudo, "true"], {}).status == 0 else None


def find_debian() -> Debian | None:
    """Return the package tools if this system has them."""
    if not (shutil.which("dpkg-query") and shutil.which("apt-get")):
        return None
    return Debian(run_captured, is_root=hasattr(os, "geteuid") and os.geteuid() == 0)


def missing_test_programs() -> list[str]:
    """Return the packages of missing test programs."""
    return [package for program, package in TEST_PROGRAMS.items() if shutil.which(program) is None]


# --- Start of Qt -------------------------------------------------------------------------------


@dataclass(frozen=True)
class QtStart:
    """Result of an attempt to start Qt.

    Attributes:
        platform: name of the Qt platform, such as "xcb", or None if Qt did not start.
        fonts: number of font families.
        reason: error message, or an empty text.
    """

    platform: str | None
    fonts: int = 0
    reason: str = ""

    @property
    def has_window(self) -> bool:
        """True if the platform shows windows."""
        return self.platform is not None and self.platform not in PLATFORMS_WITHOUT_WINDOW


def read_qt_start(outcome: Outcome) -> QtStart:
    """Parse the output of `QT_START`."""
    started = re.search(r"^started (\S+) (\d+)$", outcome.output, re.MULTILINE)
    if outcome.status == 0 and started:
        return QtStart(started[1], int(started[2]))
    library = re.search(r"(\S+\.so[.\d]*): cannot open shared object file", outcome.errors)
    if library:
        return QtStart(None, reason=f"the system has no {library[1]}")
    if "could not connect to display" in outcome.errors:
        return QtStart(None, reason="the display does not respond")
    return QtStart(None, reason=last_lines(outcome.errors) or f"status {outcome.status}")


def start_qt(run: Runner, extra_env: Mapping[str, str]) -> QtStart:
    """Start Qt briefly with the interpreter of `.venv/`."""
    return read_qt_start(run([str(venv_python()), "-c", QT_START], extra_env))


def require_qt(run: Runner) -> None:
    """Check that Qt starts without a display.

    Raises:
        BootstrapError: it does not start. The text names what is missing.
    """
    start = start_qt(run, OFFSCREEN)
    if start.platform is None:
        raise BootstrapError(
            f"Qt does not start: {start.reason}\n"
            f"On Debian, these packages contain its libraries: {' '.join(QT_PACKAGES)}"
        )
    if start.fonts == 0:
        say("Qt found no font and will draw boxes. Install a font, such as DejaVu.")


# --- The virtual environment -------------------------------------------------------------------

UNFINISHED = ""  # `requirements` of an environment whose packages are not all installed


@dataclass(frozen=True)
class Stamp:
    """Everything that determines `.venv/`. With the same stamp, it is up to date.

    Attributes:
        interpreter: version and folder of the base interpreter.
        project: folder of the project, because scripts in `.venv/bin` contain this path.
        requirements: hash of everything that determines the installed packages.
    """

    interpreter: str
    project: str
    requirements: str

    def can_keep_venv(self, earlier: "Stamp | None") -> bool:
        """Return whether an existing environment needs at most other packages."""
        return (
            earlier is not None
            and earlier.interpreter == self.interpreter
            and earlier.project == self.project
        )


def current_stamp() -> Stamp:
    """Return the stamp of an environment that is created now."""
    digest = hashlib.sha256()
    for path in (PROJECT_FILE, CONSTRAINTS, Path(__file__)):
        content = path.read_bytes()
        digest.update(b"%d\n" % len(content))
        digest.update(content)
    version = ".".join(str(part) for part in sys.version_info[:2])
    # The base is the same in `.venv/` and in the Python that created it.
    return Stamp(f"{version} {sys.base_prefix}", str(ROOT), digest.hexdigest())


def read_stamp(path: Path) -> Stamp | None:
    """Return the stamp in a file, or None if it cannot be read."""
    try:
        return Stamp(**json.loads(path.read_text(encoding="utf-8")))
    except (OSError, ValueError, TypeError):
        return None


def write_stamp(path: Path, stamp: Stamp) -> None:
    path.write_text(json.dumps(asdict(stamp), indent=2) + "\n", encoding="utf-8")


def venv_program(name: str) -> Path:
    """Return the path of a program in the environment."""
    if sys.platform == "win32":
        return VENV / "Scripts" / f"{name}.exe"
    return VENV / "bin" / name


def venv_python() -> Path:
    return venv_program("python")


def venv_package() -> str:
    """Return the Debian package with the module venv of this interpreter."""
    return "python{}.{}-venv".format(*sys.version_info[:2])


def can_create_venv(run: Runner) -> bool:
    """Return whether this interpreter has venv, which is a separate package on Debian."""
    return run([sys.executable, "-c", "import ensurepip, venv"], {}).status == 0


def create_venv(run: Runner) -> None:
    """Create the environment. An existing environment is replaced.

    Raises:
        BootstrapError: Python could not create it.
    """
    if not can_create_venv(run):
        raise BootstrapError(
            "This Python cannot create virtual environments: it lacks its modules venv and "
            f"ensurepip. On Debian, run: sudo apt-get install {venv_package()}"
        )
    say(f"Creating {VENV.name}/ with Python {sys.version.split()[0]}.")
    outcome = run([sys.executable, "-m", "venv", "--clear", str(VENV)], {})
    if outcome.status != 0:
        reason = last_lines(outcome.errors or outcome.output)
        raise BootstrapError(f"Python could not create {VENV}: {reason}")


def pip_commands(pip: Sequence[str], constraints: Path = CONSTRAINTS) -> list[list[str]]:
    """Return the commands that install the build backend, then the project.

    Python compiles modules on their first import, because only a few are ever imported.
    """
    install = [*pip, "install", "--no-compile", "--constraint", str(constraints)]
    return [
        [*install, *BUILD_REQUIREMENTS],
        [*install, "--no-build-isolation", "--editable", f"{ROOT}[gui,gamepad,mcap,remote,test]"],
    ]


def install_packages() -> None:
    """Install the project and its test tools into the environment.

    Raises:
        BootstrapError: pip failed.
    """
    say("Installing the pinned packages. The first time, this takes a minute or two.")
    pip = [str(venv_python()), "-m", "pip", "--disable-pip-version-check", "--no-input"]
    if not sys.stdout.isatty():
        pip.append("-qq")  # errors only
    for command in pip_commands(pip):
        # In an environment, pip cannot install for the user, which may be the default.
        if run_visibly(command, {"PIP_USER": "0"}) != 0:
            raise BootstrapError("pip could not install the packages. See its message above.")


def is_set_up(stamp: Stamp) -> bool:
    """Return whether the environment exists and has this stamp."""
    return read_stamp(STAMP_FILE) == stamp and venv_python().exists()


def set_up(run: Runner = run_captured) -> bool:
    """Update the environment. Return False if it was up to date.

    Raises:
        BootstrapError: the environment cannot be created, or Qt does not start.
    """
    stamp = current_stamp()
    if is_set_up(stamp):
        return False
    if VENV.is_symlink():
        raise BootstrapError(
            f"{VENV} is a symbolic link. The setup would empty its target, {VENV.resolve()}. "
            "Remove the link first."
        )
    debian = find_debian()
    if debian:
        needed = [] if can_create_venv(run) else [venv_package()]
        debian.install_missing([*needed, *QT_PACKAGES])
    if not (venv_python().exists() and stamp.can_keep_venv(read_stamp(STAMP_FILE))):
        create_venv(run)
    write_stamp(STAMP_FILE, replace(stamp, requirements=UNFINISHED))
    install_packages()
    require_qt(partial(run_captured, timeout=QT_START_SECONDS))
    write_stamp(STAMP_FILE, stamp)
    return True


# --- Commands ----------------------------------------------------------------------------------


def command_setup() -> int:
    """Create `.venv/` and print how to start the program."""
    if set_up():
        program = venv_program("trex-gui").relative_to(ROOT)
        say(f"Ready. Start the program with {program}, or with --demo to try it without a board.")
    else:
        say(f"{VENV.name}/ is up to date.")
    return 0


def may_have_display(environment: Mapping[str, str], system: str) -> bool:
    """Return whether a window can perhaps be opened."""
    if environment.get("QT_QPA_PLATFORM") in PLATFORMS_WITHOUT_WINDOW:
        return False
    if system in {"win32", "darwin"}:
        return True
    return bool(environment.get("DISPLAY") or environment.get("WAYLAND_DISPLAY"))


def reason_without_window(run: Runner) -> str | None:
    """Return the reason why no window can be shown, or None if a window can be shown."""
    if not may_have_display(os.environ, sys.platform):
        return "There is no display here"
    start = start_qt(run, {})
    if start.has_window:
        return None
    debian = find_debian()
    missing = debian.missing(QT_PACKAGES) if debian else []
    if missing:
        say(f"These system packages are missing: {' '.join(missing)}")
    return f"The display cannot be opened ({start.reason})"


def screenshots() -> dict[Path, int]:
    """Return the screenshots with their modification times."""
    return {path: path.stat().st_mtime_ns for path in sorted(SCREENSHOTS.glob("*.png"))}


def command_demo() -> int:
    """Show the program with a simulated TReX, in a window or in screenshots."""
    set_up()
    demo = [str(venv_python()), "-m", "trex_gui", "--demo"]
    reason = reason_without_window(partial(run_captured, timeout=QT_START_SECONDS))
    if reason is None:
        return run_visibly(demo, {})
    say(f"{reason}, so the demonstration runs offscreen and saves a screenshot of every page.")
    before = screenshots()
    status = run_visibly([*demo, "--tour", SCREENSHOTS.name], OFFSCREEN)
    written = [path for path, modified in screenshots().items() if before.get(path) != modified]
    if status != 0 or not written:
        raise BootstrapError(f"The demonstration failed with status {status}.")
    say("Written:")
    for path in written:
        say(f"  {path.relative_to(ROOT)}")
    return 0


@dataclass(frozen=True)
class Check:
    """Check that every change must pass."""

    name: str
    command: tuple[str, ...]
    environment: Mapping[str, str] = field(default_factory=dict)
    is_tests: bool = False


@dataclass(frozen=True)
class CheckResult:
    name: str
    passed: bool
    seconds: float
    tests: int | None = None


def checks(pytest_arguments: Sequence[str], *, every: bool = False) -> list[Check]:
    """Return all checks, with the tests last.

    With `every`, the slow tests run, too, and hypothesis searches for new examples.
    """
    ruff, typos, mypy, lint_imports, pytest = (
        str(venv_program(name)) for name in ("ruff", "typos", "mypy", "lint-imports", "pytest")
    )
    return [
        Check("ruff check", (ruff, "check", ".")),
        Check("ruff format", (ruff, "format", "--check", ".")),
        Check("typos", (typos,)),
        Check("mypy", (mypy,)),
        Check("lint-imports", (lint_imports,)),
        *(
            Check(
                name,
                (pytest, *how, "--durations=10", *(["--all"] if every else []), *pytest_arguments),
                {"HYPOTHESIS_PROFILE": "all" if every else "gate"},
                is_tests=True,
            )
            for name, how in (("virtual time", VIRTUAL), ("real time", REALTIME))
        ),
    ]


def summary(results: Iterable[CheckResult]) -> str:
    """Return a line for each check: result, name, number of tests, and seconds."""
    return "\n".join(
        f"{'ok' if result.passed else 'FAILED':<7}{result.name:<13}"
        f"{'' if result.tests is None else result.tests:>6}{result.seconds:8.1f} s"
        for result in results
    )


def count_tests(report: Path) -> int | None:
    """Return the number of tests in a report of pytest, or None without a report."""
    try:
        suite = ElementTree.parse(report).getroot().find("testsuite")
    except (OSError, ElementTree.ParseError):
        return None
    return None if suite is None else int(suite.get("tests", "0"))


def memory_folder() -> str | None:
    """Return a folder in memory with space for the files of the tests, about 100 MB.

    On a disk, the tests would spend a tenth of their time flushing thousands of files.
    """
    folder = "/dev/shm"
    try:
        has_space = shutil.disk_usage(folder).free > 1e9 and os.access(folder, os.W_OK)
    except OSError:
        has_space = False
    return folder if has_space else None


def run_check(check: Check) -> CheckResult:
    """Run a check on the user's terminal."""
    say(f"\n--- {check.name}")
    started = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="trex-tests", dir=memory_folder()) as folder:
        report = Path(folder) / "report.xml"
        files = (f"--junitxml={report}", f"--basetemp={Path(folder) / 'tests'}")
        to_report = files if check.is_tests else ()
        environment = {**TEST_ENVIRONMENT, **check.environment}
        status = run_visibly((*check.command, *to_report), environment)
        tests = count_tests(report) if check.is_tests else None
    passed = status == 0 or (check.is_tests and status == NO_TESTS)
    return CheckResult(check.name, passed, time.monotonic() - started, tests)


def compile_tests() -> subprocess.Popen[bytes]:
    """Start compiling all tests. A `with` block waits for the end.

    In a new clone, compiling takes 15 s. It runs in parallel with checks that use only one core.
    Errors in a test are reported when the test runs.
    """
    return subprocess.Popen(
        [venv_program("pytest"), "--collect-only", "-qq"],
        cwd=ROOT,
        env={**os.environ, **TEST_ENVIRONMENT},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )


def command_test(pytest_arguments: Sequence[str], *, every: bool = False) -> int:
    """Run all checks, even after a failure. It is a failure if no test is selected."""
    set_up()
    debian = find_debian() if missing_test_programs() else None
    if debian:
        debian.install_missing(missing_test_programs())
    all_checks = checks(pytest_arguments, every=every)
    with compile_tests():
        results = [run_check(check) for check in all_checks if not check.is_tests]
    results += [run_check(check) for check in all_checks if check.is_tests]
    say("\n" + summary(results))
    ran = sum(result.tests or 0 for result in results)
    return 0 if ran and all(result.passed for result in results) else 1


def command_lowest(pytest_arguments: Sequence[str]) -> int:
    """Run the tests with the lowest allowed versions of the dependencies."""
    set_up()
    return run_visibly([str(venv_python()), str(LOWEST), *pytest_arguments], {})


def command_bench(pytest_arguments: Sequence[str], compare: Path | None = None) -> int:
    """Run the benchmarks and print their figures.

    With `compare`, the saved output of an earlier run, also print the ratios.
    """
    set_up()
    how = ["-s", "-p", "no:randomly", "--timeout=0"]
    if compare is not None:
        how.append(f"--compare={compare.resolve()}")  # pytest runs in the project's folder
    pytest = [str(venv_program("pytest")), str(BENCHMARKS), *how, *pytest_arguments]
    # The program runs offscreen by default and is compiled as in an installation.
    run_visibly([str(venv_python()), "-m", "compileall", "-q", "trex_gui"], COMPILE_ONCE)
    return run_visibly(pytest, {**OFFSCREEN, **os.environ, **COMPILE_ONCE})


def command_soak(minutes: float, seed: int | None) -> int:
    """Run random faults in real time. The exit code is 1 after a failure."""
    set_up()
    command = [str(venv_python()), "-m", "tests.soak", f"--minutes={minutes:g}"]
    if seed is not None:
        command.append(f"--seed={seed}")
    return run_visibly(command, OFFSCREEN)


def command_mutate(arguments: Sequence[str]) -> int:
    """Measure which single changes to the program make a test fail."""
    set_up()
    install_extra("cosmic-ray")
    return run_visibly([str(venv_python()), str(MUTATE), *arguments], OFFSCREEN)


def command_docs() -> int:
    """Build the documentation site."""
    set_up()
    install_extra("sphinx", "myst-parser", "furo", "sphinx-click", "genson")
    return run_visibly([str(venv_python()), str(DOCS)], {})


def install_extra(*packages: str) -> None:
    """Install packages that only one command needs.

    Raises:
        BootstrapError: pip failed.
    """
    pip = [str(venv_python()), "-m", "pip", "--disable-pip-version-check", "--no-input", "-qq"]
    wanted = ["install", "--constraint", str(CONSTRAINTS), *packages]
    if run_visibly([*pip, *wanted], {"PIP_USER": "0"}) != 0:
        raise BootstrapError(f"pip could not install {packages[0]}. See its message above.")


def command_package(arguments: Sequence[str]) -> int:
    """Build the packages in `dist/`."""
    set_up()
    return run_visibly([str(venv_python()), str(PACKAGES), *arguments], {})


def command_translations() -> int:
    """Update the translation files and compile them."""
    set_up()
    return run_visibly([str(venv_python()), str(PACKAGING / "translations.py")], {})


def command_pictures() -> int:
    """Save the pictures of the help and the animation of the README, with default settings."""
    set_up()
    for script in (PICTURES, ANIMATION):
        with tempfile.TemporaryDirectory() as home:
            folders = {f"XDG_{kind}_HOME": home for kind in ("CONFIG", "DATA", "CACHE")}
            env = {**OFFSCREEN, **folders, "LC_ALL": "C.UTF-8"}
            code = run_visibly([str(venv_python()), str(script)], env)
        if code:
            return code
    return 0


# --- The command line --------------------------------------------------------------------------


def _minutes(text: str) -> float:
    minutes = float(text)
    if not 0 < minutes < 10_000:
        raise ValueError(text)
    return minutes


def create_parser() -> argparse.ArgumentParser:
    """Return the parser of the arguments before `--`."""
    parser = argparse.ArgumentParser(
        description="Set up TReX Studio in .venv/, then show, check or measure it."
    )
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")

    def add(name: str, text: str, usage: str | None = None) -> argparse.ArgumentParser:
        sentence = text[0].upper() + text[1:] + "."
        return commands.add_parser(name, help=text, description=sentence, usage=usage)

    for_bench = "%(prog)s [-h] [--compare FILE] [-- PYTEST_ARGUMENT ...]"
    for_mutate = "%(prog)s [-h] [-- OPTION ...], see packaging/mutate.py"
    for_tests = "%(prog)s [-h] [--all | --lowest] [-- PYTEST_ARGUMENT ...]"
    add("setup", "create .venv/ and install the project and its pinned test tools")
    add("demo", "show the program with a simulated TReX")
    test = add("test", "run all checks", for_tests)
    which = test.add_mutually_exclusive_group()
    which.add_argument(
        "--all",
        action="store_true",
        help="also run slow tests, with random seeds (about 20 minutes)",
    )
    which.add_argument(
        "--lowest",
        action="store_true",
        help="use the lowest allowed versions of the dependencies, in .venv-lowest/",
    )
    bench = add("bench", "run the benchmarks", for_bench)
    bench.add_argument(
        "--compare", metavar="FILE", type=Path, help="print ratios to the saved output of a run"
    )
    soak = add("soak", "run random faults in real time")
    soak.add_argument("--minutes", metavar="N", type=_minutes, default=10.0, help="duration (10)")
    soak.add_argument("--seed", metavar="N", type=int, help="repeat the run that printed this seed")
    add("mutate", "measure which changes to the program make a test fail", for_mutate)
    add("translations", "update the translation files and compile them")
    add("docs", "build the documentation site in build/docs/html")
    add("pictures", "save the pictures of the help and the animation of the README")
    package = add("package", "build the packages in dist/")
    package.add_argument("--check", action="store_true", help="also install and use each package")
    package.add_argument("kinds", nargs="*", metavar="KIND", help="see packaging/packages.py (all)")
    return parser


def split_arguments(arguments: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return the arguments before and after the first `--`."""
    before = list(arguments)
    if "--" not in before:
        return before, []
    cut = before.index("--")
    return before[:cut], before[cut + 1 :]


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command. Return the exit code."""
    own, passed_on = split_arguments(sys.argv[1:] if arguments is None else arguments)
    parser = create_parser()
    options = parser.parse_args(own)
    command = options.command
    if passed_on and command not in {"test", "bench", "mutate"}:
        parser.error(f"{command} accepts no arguments after --")
    without_arguments = {
        "setup": command_setup,
        "demo": command_demo,
        "translations": command_translations,
        "pictures": command_pictures,
        "docs": command_docs,
    }
    try:
        if command in without_arguments:
            return without_arguments[command]()
        if command == "test" and options.lowest:
            return command_lowest(passed_on)
        if command == "test":
            return command_test(passed_on, every=options.all)
        if command == "soak":
            return command_soak(options.minutes, options.seed)
        if command == "mutate":
            return command_mutate(passed_on)
        if command == "package":
            return command_package([*(["--check"] if options.check else []), *options.kinds])
        return command_bench(passed_on, options.compare)
    except BootstrapError as error:
        print(error, file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())
