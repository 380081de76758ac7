#!/usr/bin/env python3
"""Set the project up in `.venv/`, then show it, check it or measure it.

    python3 packaging/bootstrap.py setup | demo | test [--all | --lowest] | bench | soak | mutate |
                                    translations | pictures | docs | package [--check] [KIND ...]

Needs nothing but Python's standard library. The syntax stays readable to older Pythons, so that
they get as far as the sentence about their age.
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

if sys.version_info < OLDEST_PYTHON:  # users may well have an older one
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

NO_TESTS = 5
"""The status of pytest where none was selected."""
SCREENSHOTS = ROOT / "demo-screenshots"

# What Qt loads from the system, by the names of Debian 12; later releases still provide these
# names. The first group is all that offscreen needs, the second opens a window.
OFFSCREEN_PACKAGES = (
    "libegl1",
    "libgl1",
    "libxkbcommon0",
    "libdbus-1-3",
    "libfontconfig1",
    "libglib2.0-0",
    "fonts-dejavu-core",  # without a font all text is boxes
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
    "libwayland-cursor0",  # all that Wayland needs besides
)
QT_PACKAGES = OFFSCREEN_PACKAGES + WINDOW_PACKAGES

# Programs that tests want, and the packages that hold them: exported sketches are compiled there,
# and a message bus says that the screen is locked. Tests of sketches skip without a compiler.
TEST_PROGRAMS = {"g++": "g++", "dbus-daemon": "dbus"}

# pip builds the project with these from `.venv/`, where the constraints hold, instead of in an
# isolated environment, where they do not.
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
    """Ends the command; its text is shown to the user."""


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


# Runs a command, with additions to the environment, and keeps what it writes.
Runner = Callable[[Sequence[str], Mapping[str, str]], Outcome]


def run_captured(
    command: Sequence[str], extra_env: Mapping[str, str], timeout: float | None = None
) -> Outcome:
    """Run a command without showing its output; a missing or hanging one has failed."""
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
        return Outcome(124, errors=f"no answer within {timeout:.0f} seconds")
    return Outcome(done.returncode, done.stdout, done.stderr)


def run_in_sight(command: Sequence[str], extra_env: Mapping[str, str]) -> int:
    """Run a command from the project's folder on the user's terminal; return its status.

    Ctrl-C reaches the command as well, which gets a few seconds to end in its own way.
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


# --- Libraries of the system, where Debian's tools can find and install them --------------------


def packages_in(listing: str) -> set[str]:
    """Return the names that installed packages have or provide.

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
    """Return the end of a program's output, which says what went wrong."""
    return "\n".join(text.strip().splitlines()[-count:])


class Debian:
    """The package tools of Debian and its relatives."""

    def __init__(self, run: Runner, *, is_root: bool) -> None:
        self._run = run
        self._is_root = is_root

    def missing(self, wanted: Iterable[str]) -> list[str]:
        """Return which of the packages are not installed, under their own or a provided name."""
        listing = "--showformat=${db:Status-Status}\t${Package}\t${Provides}\n"
        outcome = self._run(["dpkg-query", "--show", listing], {})
        installed = packages_in(outcome.output)
        return [name for name in wanted if name not in installed]

    def supply(self, wanted: Iterable[str]) -> None:
        """Install what is missing if that takes no password, otherwise say what to install."""
        missing = self.missing(wanted)
        if not missing:
            return
        by_hand = f"sudo apt-get install {' '.join(missing)}"
        prefix = self._privilege()
        if prefix is None:
            say(f"Some system packages are missing; please install them: {by_hand}")
            return
        say(f"Installing system packages: {' '.join(missing)}")
        apt = [*prefix, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "--quiet"]
        # A list that could not be renewed may still do; the installation shows it.
        self._run([*apt, "update"], {})
        outcome = self._run([*apt, "install", "--yes", "--no-install-recommends", *missing], {})
        if outcome.status != 0:
            say(last_lines(outcome.errors))
            say(f"apt-get could not install them; please do so by hand: {by_hand}")

    def _privilege(self) -> list[str] | None:
        """Return the command prefix for apt-get; None if we may not run it."""
        if self._is_root:
            return []
        sudo = ["sudo", "-n"]  # -n: never ask for a password
        return sudo if self._run([*sudo, "true"], {}).status == 0 else None


def find_debian() -> Debian | None:
    """Return Debian's package tools if this system has them."""
    if not (shutil.which("dpkg-query") and shutil.which("apt-get")):
        return None
    return Debian(run_captured, is_root=hasattr(os, "geteuid") and os.geteuid() == 0)


def missing_test_programs() -> list[str]:
    """Return the packages of missing programs."""
    return [package for program, package in TEST_PROGRAMS.items() if shutil.which(program) is None]


# --- Does Qt start? ----------------------------------------------------------------------------


@dataclass(frozen=True)
class QtStart:
    """Result of an attempt to start Qt.

    Attributes:
        platform: Qt's name of what it draws on ("xcb", "offscreen"), None if it did not start.
        fonts: how many font families Qt found.
        reason: why it did not start, as far as it said so.
    """

    platform: str | None
    fonts: int = 0
    reason: str = ""

    @property
    def has_window(self) -> bool:
        """Whether the platform shows windows."""
        return self.platform is not None and self.platform not in PLATFORMS_WITHOUT_WINDOW


def read_qt_start(outcome: Outcome) -> QtStart:
    """Parse the output of the attempt."""
    started = re.search(r"^started (\S+) (\d+)$", outcome.output, re.MULTILINE)
    if outcome.status == 0 and started:
        return QtStart(started[1], int(started[2]))
    library = re.search(r"(\S+\.so[.\d]*): cannot open shared object file", outcome.errors)
    if library:
        return QtStart(None, reason=f"the system has no {library[1]}")
    if "could not connect to display" in outcome.errors:
        return QtStart(None, reason="nothing answers on the display")
    return QtStart(None, reason=last_lines(outcome.errors) or f"status {outcome.status}")


def start_qt(run: Runner, extra_env: Mapping[str, str]) -> QtStart:
    """Start Qt for a moment with the interpreter of `.venv/`."""
    return read_qt_start(run([str(venv_python()), "-c", QT_START], extra_env))


def require_qt(run: Runner) -> None:
    """Make sure that Qt starts without a display, which needs all libraries but those of a window.

    Raises:
        BootstrapError: it does not start; says what is missing.
    """
    start = start_qt(run, OFFSCREEN)
    if start.platform is None:
        raise BootstrapError(
            f"Qt does not start: {start.reason}\n"
            f"On Debian these packages hold what it needs: {' '.join(QT_PACKAGES)}"
        )
    if start.fonts == 0:
        say("Qt found no font and will draw boxes for letters; please install one, such as DejaVu.")


# --- The virtual environment -------------------------------------------------------------------

UNFINISHED = ""  # as a stamp's requirements: interrupted, but the environment itself will do


@dataclass(frozen=True)
class Stamp:
    """Everything `.venv/` was made from; it is up to date while this is unchanged.

    Attributes:
        interpreter: version and place of the Python beneath.
        project: the project's folder, which scripts in `.venv/bin` name in full.
        requirements: a hash of everything that decides which packages are installed.
    """

    interpreter: str
    project: str
    requirements: str

    def can_keep_venv(self, earlier: "Stamp | None") -> bool:
        """Whether an environment made earlier needs other packages at most."""
        return (
            earlier is not None
            and earlier.interpreter == self.interpreter
            and earlier.project == self.project
        )


def current_stamp() -> Stamp:
    """Return the stamp of an environment made now."""
    digest = hashlib.sha256()
    for path in (PROJECT_FILE, CONSTRAINTS, Path(__file__)):
        content = path.read_bytes()
        digest.update(b"%d\n" % len(content))
        digest.update(content)
    version = ".".join(str(part) for part in sys.version_info[:2])
    # The base: the same whether this runs in the system's Python or in `.venv/` itself.
    return Stamp(f"{version} {sys.base_prefix}", str(ROOT), digest.hexdigest())


def read_stamp(path: Path) -> Stamp | None:
    """Return the stamp in a file, or None if there is none that can be read."""
    try:
        return Stamp(**json.loads(path.read_text(encoding="utf-8")))
    except (OSError, ValueError, TypeError):
        return None


def write_stamp(path: Path, stamp: Stamp) -> None:
    """Record what the environment was made from."""
    path.write_text(json.dumps(asdict(stamp), indent=2) + "\n", encoding="utf-8")


def venv_program(name: str) -> Path:
    """Return where a program of the environment lies on this system."""
    if sys.platform == "win32":
        return VENV / "Scripts" / f"{name}.exe"
    return VENV / "bin" / name


def venv_python() -> Path:
    """Return the interpreter of the environment."""
    return venv_program("python")


def venv_package() -> str:
    """Return the Debian package that gives this interpreter the means to make environments."""
    return "python{}.{}-venv".format(*sys.version_info[:2])


def can_make_venv(run: Runner) -> bool:
    """Whether this interpreter brings what `-m venv` needs, which Debian packs separately."""
    return run([sys.executable, "-c", "import ensurepip, venv"], {}).status == 0


def make_venv(run: Runner) -> None:
    """Make a new environment in place of any that is there.

    Raises:
        BootstrapError: Python could not make one; says why.
    """
    if not can_make_venv(run):
        raise BootstrapError(
            "This Python cannot make virtual environments: it lacks its modules venv and "
            f"ensurepip. On Debian, please run: sudo apt-get install {venv_package()}"
        )
    say(f"Making {VENV.name}/ with Python {sys.version.split()[0]}.")
    outcome = run([sys.executable, "-m", "venv", "--clear", str(VENV)], {})
    if outcome.status != 0:
        said = last_lines(outcome.errors or outcome.output)
        raise BootstrapError(f"Python could not make {VENV}: {said}")


def pip_commands(pip: Sequence[str], constraints: Path = CONSTRAINTS) -> list[list[str]]:
    """Return the commands that install the build backend and then, built with it, the project.

    Python compiles the few modules that are used. To compile all would take longer.
    """
    install = [*pip, "install", "--no-compile", "--constraint", str(constraints)]
    return [
        [*install, *BUILD_REQUIREMENTS],
        [*install, "--no-build-isolation", "--editable", f"{ROOT}[gui,gamepad,mcap,remote,test]"],
    ]


def install_packages() -> None:
    """Install the project and its test tools into the environment.

    Raises:
        BootstrapError: pip could not.
    """
    say("Installing the pinned packages; the first time this takes a minute or two.")
    pip = [str(venv_python()), "-m", "pip", "--disable-pip-version-check", "--no-input"]
    if not sys.stdout.isatty():
        pip.append("-qq")  # errors only
    for command in pip_commands(pip):
        # Installing for the user, which may be the default, does not work in an environment.
        if run_in_sight(command, {"PIP_USER": "0"}) != 0:
            raise BootstrapError("pip could not install the packages; see its message above.")


def is_set_up(stamp: Stamp) -> bool:
    """Whether the environment is there and made from what the stamp says."""
    return read_stamp(STAMP_FILE) == stamp and venv_python().exists()


def set_up(run: Runner = run_captured) -> bool:
    """Bring the environment up to date.

    Returns:
        Whether there was anything to do.

    Raises:
        BootstrapError: something is missing that only the user can supply.
    """
    stamp = current_stamp()
    if is_set_up(stamp):
        return False
    if VENV.is_symlink():
        raise BootstrapError(
            f"{VENV} is a symbolic link, and setting up would empty the folder that it leads to: "
            f"{VENV.resolve()}. Please remove the link first."
        )
    debian = find_debian()
    if debian:
        needed = [] if can_make_venv(run) else [venv_package()]
        debian.supply([*needed, *QT_PACKAGES])
    if not (venv_python().exists() and stamp.can_keep_venv(read_stamp(STAMP_FILE))):
        make_venv(run)
    write_stamp(STAMP_FILE, replace(stamp, requirements=UNFINISHED))
    install_packages()
    require_qt(partial(run_captured, timeout=QT_START_SECONDS))
    write_stamp(STAMP_FILE, stamp)
    return True


# --- Commands ----------------------------------------------------------------------------------


def command_setup() -> int:
    """Make `.venv/` and say how to start the program."""
    if set_up():
        program = venv_program("trex-gui").relative_to(ROOT)
        say(f"Ready: the window starts with {program}, or try it with --demo and no board.")
    else:
        say(f"{VENV.name}/ is up to date.")
    return 0


def may_have_display(environment: Mapping[str, str], system: str) -> bool:
    """Whether it is worth trying to open a window."""
    if environment.get("QT_QPA_PLATFORM") in PLATFORMS_WITHOUT_WINDOW:
        return False
    if system in {"win32", "darwin"}:
        return True
    return bool(environment.get("DISPLAY") or environment.get("WAYLAND_DISPLAY"))


def why_no_window(run: Runner) -> str | None:
    """Return why a window cannot be shown here, or None if it can."""
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


def pictures() -> dict[Path, int]:
    """Return the screenshots and when each was written."""
    return {path: path.stat().st_mtime_ns for path in sorted(SCREENSHOTS.glob("*.png"))}


def command_demo() -> int:
    """Show the program on a simulated TReX, in a window or in pictures."""
    set_up()
    demo = [str(venv_python()), "-m", "trex_gui", "--demo"]
    reason = why_no_window(partial(run_captured, timeout=QT_START_SECONDS))
    if reason is None:
        return run_in_sight(demo, {})
    say(f"{reason}, so the demonstration runs offscreen and takes a picture of every page.")
    before = pictures()
    status = run_in_sight([*demo, "--tour", SCREENSHOTS.name], OFFSCREEN)
    written = [path for path, when in pictures().items() if before.get(path) != when]
    if status != 0 or not written:
        raise BootstrapError(f"The demonstration failed with status {status}.")
    say("Written:")
    for path in written:
        say(f"  {path.relative_to(ROOT)}")
    return 0


@dataclass(frozen=True)
class Check:
    """One of the checks that a change has to pass."""

    name: str
    command: tuple[str, ...]
    environment: Mapping[str, str] = field(default_factory=dict)
    is_tests: bool = False


@dataclass(frozen=True)
class CheckResult:
    """How a check ended."""

    name: str
    passed: bool
    seconds: float
    tests: int | None = None


def checks(pytest_arguments: Sequence[str], *, every: bool = False) -> list[Check]:
    """Return every check, the quick ones first and the tests last.

    With `every` the long tests run, too, and hypothesis looks for new examples.
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
    """Return a line for each check: step, tests, seconds."""
    return "\n".join(
        f"{'ok' if result.passed else 'FAILED':<7}{result.name:<13}"
        f"{'' if result.tests is None else result.tests:>6}{result.seconds:8.1f} s"
        for result in results
    )


def count_tests(report: Path) -> int | None:
    """Return how many tests a report of pytest is about, where there is one."""
    try:
        suite = ElementTree.parse(report).getroot().find("testsuite")
    except (OSError, ElementTree.ParseError):
        return None
    return None if suite is None else int(suite.get("tests", "0"))


def memory_folder() -> str | None:
    """Return a folder in memory if there is one with room for what tests write, some 100 MB.

    They flush thousands of files to the disk, which takes a tenth of their time.
    """
    folder = "/dev/shm"
    try:
        has_room = shutil.disk_usage(folder).free > 1e9 and os.access(folder, os.W_OK)
    except OSError:
        has_room = False
    return folder if has_room else None


def run_check(check: Check) -> CheckResult:
    """Run one check in sight."""
    say(f"\n--- {check.name}")
    started = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="trex-tests", dir=memory_folder()) as folder:
        report = Path(folder) / "report.xml"
        files = (f"--junitxml={report}", f"--basetemp={Path(folder) / 'tests'}")
        to_report = files if check.is_tests else ()
        environment = {**TEST_ENVIRONMENT, **check.environment}
        status = run_in_sight((*check.command, *to_report), environment)
        tests = count_tests(report) if check.is_tests else None
    passed = status == 0 or (check.is_tests and status == NO_TESTS)
    return CheckResult(check.name, passed, time.monotonic() - started, tests)


def compile_tests() -> subprocess.Popen[bytes]:
    """Compile all tests beside the checks that use one core; a `with` block waits for the end.

    In a new clone that takes each process of pytest 15 s, and later ones 3 s. What is wrong with a
    test is found when it runs.
    """
    return subprocess.Popen(
        [venv_program("pytest"), "--collect-only", "-qq"],
        cwd=ROOT,
        env={**os.environ, **TEST_ENVIRONMENT},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )


def command_test(pytest_arguments: Sequence[str], *, every: bool = False) -> int:
    """Run every check, also after one has failed.

    Selecting no test at all is a failure.
    """
    set_up()
    debian = find_debian() if missing_test_programs() else None
    if debian:
        debian.supply(missing_test_programs())
    to_do = checks(pytest_arguments, every=every)
    with compile_tests():
        results = [run_check(check) for check in to_do if not check.is_tests]
    results += [run_check(check) for check in to_do if check.is_tests]
    say("\n" + summary(results))
    ran = sum(result.tests or 0 for result in results)
    return 0 if ran and all(result.passed for result in results) else 1


def command_lowest(pytest_arguments: Sequence[str]) -> int:
    """Run the tests with the lowest versions that the metadata allow."""
    set_up()
    return run_in_sight([str(venv_python()), str(LOWEST), *pytest_arguments], {})


def command_bench(pytest_arguments: Sequence[str], compare: Path | None = None) -> int:
    """Run the benchmarks in their own order, with their figures on the terminal.

    Args:
        pytest_arguments: passed on.
        compare: the saved output of an earlier run, to show ratios to.
    """
    set_up()
    how = ["-s", "-p", "no:randomly", "--timeout=0"]
    if compare is not None:
        how.append(f"--compare={compare.resolve()}")  # pytest runs in the project's folder
    pytest = [str(venv_program("pytest")), str(BENCHMARKS), *how, *pytest_arguments]
    # Offscreen by default and compiled as in an installation, so that figures can be compared.
    run_in_sight([str(venv_python()), "-m", "compileall", "-q", "trex_gui"], COMPILE_ONCE)
    return run_in_sight(pytest, {**OFFSCREEN, **os.environ, **COMPILE_ONCE})


def command_soak(minutes: float, seed: int | None) -> int:
    """Attack the program in real time, in random order; the status is 1 if anything fell short."""
    set_up()
    command = [str(venv_python()), "-m", "tests.soak", f"--minutes={minutes:g}"]
    if seed is not None:
        command.append(f"--seed={seed}")
    return run_in_sight(command, OFFSCREEN)


def command_mutate(arguments: Sequence[str]) -> int:
    """Change the program in one place at a time and measure what the tests notice."""
    set_up()
    install_besides("cosmic-ray")
    return run_in_sight([str(venv_python()), str(MUTATE), *arguments], OFFSCREEN)


def command_docs() -> int:
    """Build the site of the documents."""
    set_up()
    install_besides("sphinx", "myst-parser", "furo", "sphinx-click", "genson")
    return run_in_sight([str(venv_python()), str(DOCS)], {})


def install_besides(*packages: str) -> None:
    """Install what only one command needs.

    Raises:
        BootstrapError: pip could not.
    """
    pip = [str(venv_python()), "-m", "pip", "--disable-pip-version-check", "--no-input", "-qq"]
    wanted = ["install", "--constraint", str(CONSTRAINTS), *packages]
    if run_in_sight([*pip, *wanted], {"PIP_USER": "0"}) != 0:
        raise BootstrapError(f"pip could not install {packages[0]}; see its message above.")


def command_package(arguments: Sequence[str]) -> int:
    """Make what users install, in `dist/`."""
    set_up()
    return run_in_sight([str(venv_python()), str(PACKAGES), *arguments], {})


def command_translations() -> int:
    """Bring the translation files up to date with the texts of the program, and compile them."""
    set_up()
    return run_in_sight([str(venv_python()), str(PACKAGING / "translations.py")], {})


def command_pictures() -> int:
    """Write the pictures of the help and the animation of the README, as at a first start."""
    set_up()
    for script in (PICTURES, ANIMATION):
        with tempfile.TemporaryDirectory() as home:
            folders = {f"XDG_{kind}_HOME": home for kind in ("CONFIG", "DATA", "CACHE")}
            env = {**OFFSCREEN, **folders, "LC_ALL": "C.UTF-8"}
            code = run_in_sight([str(venv_python()), str(script)], env)
        if code:
            return code
    return 0


# --- The command line --------------------------------------------------------------------------


def _minutes(text: str) -> float:
    minutes = float(text)
    if not 0 < minutes < 10_000:
        raise ValueError(text)
    return minutes


def make_parser() -> argparse.ArgumentParser:
    """Return the parser of the command line, without the arguments after `--`."""
    parser = argparse.ArgumentParser(
        description="Set TReX Studio up in .venv/, then show it, check it or measure it."
    )
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")

    def add(name: str, text: str, usage: str | None = None) -> argparse.ArgumentParser:
        sentence = text[0].upper() + text[1:] + "."
        return commands.add_parser(name, help=text, description=sentence, usage=usage)

    for_bench = "%(prog)s [-h] [--compare FILE] [-- PYTEST_ARGUMENT ...]"
    for_mutate = "%(prog)s [-h] [-- OPTION ...], see packaging/mutate.py"
    for_tests = "%(prog)s [-h] [--all | --lowest] [-- PYTEST_ARGUMENT ...]"
    add("setup", "make .venv/ and install the project and its test tools, pinned")
    add("demo", "set up if needed and show the program on a simulated TReX")
    test = add("test", "set up if needed and run every check", for_tests)
    which = test.add_mutually_exclusive_group()
    which.add_argument(
        "--all", action="store_true", help="the long tests, too, with random seeds: some 20 minutes"
    )
    which.add_argument(
        "--lowest",
        action="store_true",
        help="the tests with the lowest versions of the dependencies, in .venv-lowest/",
    )
    bench = add("bench", "set up if needed and run the benchmarks", for_bench)
    bench.add_argument(
        "--compare", metavar="FILE", type=Path, help="show ratios to the saved output of a run"
    )
    soak = add("soak", "set up if needed and let everything go wrong, in random order")
    soak.add_argument("--minutes", metavar="N", type=_minutes, default=10.0, help="how long (10)")
    soak.add_argument("--seed", metavar="N", type=int, help="repeats a run; it prints its seed")
    add("mutate", "set up if needed and measure what the tests catch", for_mutate)
    add("translations", "set up if needed, update the translation files and compile them")
    add("docs", "set up if needed and build the site of the documents, in build/docs/html")
    add("pictures", "set up if needed and make the pictures of the help")
    package = add("package", "set up if needed and make what users install, in dist/")
    package.add_argument("--check", action="store_true", help="try each package as a user does")
    package.add_argument("kinds", nargs="*", metavar="KIND", help="see packaging/packages.py (all)")
    return parser


def split_arguments(arguments: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return the arguments before the first `--` and those after it."""
    own = list(arguments)
    if "--" not in own:
        return own, []
    cut = own.index("--")
    return own[:cut], own[cut + 1 :]


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its status."""
    own, for_pytest = split_arguments(sys.argv[1:] if arguments is None else arguments)
    parser = make_parser()
    options = parser.parse_args(own)
    command = options.command
    if for_pytest and command not in {"test", "bench", "mutate"}:
        parser.error(f"{command} takes nothing after --")
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
            return command_lowest(for_pytest)
        if command == "test":
            return command_test(for_pytest, every=options.all)
        if command == "soak":
            return command_soak(options.minutes, options.seed)
        if command == "mutate":
            return command_mutate(for_pytest)
        if command == "package":
            return command_package([*(["--check"] if options.check else []), *options.kinds])
        return command_bench(for_pytest, options.compare)
    except BootstrapError as error:
        print(error, file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())
