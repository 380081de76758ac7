"""Run the tests with the lowest versions of the dependencies that `pyproject.toml` allows.

    python3 packaging/bootstrap.py test --lowest [-- PYTEST_ARGUMENT ...]

They go into an environment of their own, `.venv-lowest/`; the tools of the tests stay as pinned.
"""

import sys
import tomllib
import venv
from collections.abc import Iterator
from dataclasses import replace

from bootstrap import (
    CONSTRAINTS,
    PROJECT_FILE,
    ROOT,
    checks,
    pip_commands,
    run_check,
    run_visibly,
    say,
    summary,
)
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

HERE = ROOT / ".venv-lowest"
EXTRAS = ("gui", "gamepad", "mcap", "remote")


def lowest_versions(project: str) -> dict[str, str]:
    """Return the lowest version of each dependency, by its normalized name."""
    table = tomllib.loads(project)["project"]
    wanted = [*table["dependencies"]]
    for extra in EXTRAS:
        wanted += table["optional-dependencies"][extra]
    found = {}
    for requirement in map(Requirement, wanted):
        (lowest,) = (each.version for each in requirement.specifier if each.operator == ">=")
        found[canonicalize_name(requirement.name)] = lowest
    return found


def constraints(pinned: str, lowest: dict[str, str]) -> Iterator[str]:
    """Return the lines of a constraints file: the lowest versions, then what else is pinned.

    Parts of a dependency, such as shiboken6 of PySide6-Essentials, follow from it and are left out.
    """
    yield from (f"{name}=={version}" for name, version in lowest.items())
    for line in pinned.splitlines():
        name = canonicalize_name(line.partition("==")[0])
        if line.strip() and name not in lowest and name != "shiboken6":
            yield line


def main() -> int:
    lowest = lowest_versions(PROJECT_FILE.read_text(encoding="utf-8"))
    say(", ".join(f"{name} {version}" for name, version in lowest.items()))
    venv.create(HERE, clear=True, with_pip=True)
    programs = HERE / ("Scripts" if sys.platform == "win32" else "bin")
    file = HERE / "constraints.txt"
    text = CONSTRAINTS.read_text(encoding="utf-8")
    file.write_text("\n".join(constraints(text, lowest)) + "\n", encoding="utf-8")
    for command in pip_commands([str(programs / "python"), "-m", "pip", "-qq"], file):
        if run_visibly(command, {"PIP_USER": "0"}) != 0:
            return 1
    results = [
        run_check(replace(check, command=(str(programs / "pytest"), *check.command[1:])))
        for check in checks(sys.argv[1:])
        if check.is_tests
    ]
    say("\n" + summary(results))
    ran = sum(result.tests or 0 for result in results)
    return 0 if ran and all(result.passed for result in results) else 1


if __name__ == "__main__":
    sys.exit(main())
