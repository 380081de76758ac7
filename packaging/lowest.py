"""Run the tests with the lowest versions in `pyproject.toml`.

    python3 packaging/bootstrap.py test --lowest [-- PYTEST_ARGUMENT ...]

The dependencies are installed in `.venv-lowest/`. The test tools have the pinned versions.
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

ENVIRONMENT = ROOT / ".venv-lowest"
EXTRAS = ("gui", "gamepad", "mcap", "remote")


def lowest_versions(project: str) -> dict[str, str]:
    """Return the lowest versions of dependencies, by normalized name."""
    table = tomllib.loads(project)["project"]
    dependencies = [*table["dependencies"]]
    for extra in EXTRAS:
        dependencies += table["optional-dependencies"][extra]
    found = {}
    for requirement in map(Requirement, dependencies):
        (lowest,) = (limit.version for limit in requirement.specifier if limit.operator == ">=")
        found[canonicalize_name(requirement.name)] = lowest
    return found


def constraints(pinned: str, lowest: dict[str, str]) -> Iterator[str]:
    """Yield the lines of a constraints file.

    The lowest versions are followed by the pinned versions of other packages. Omits shiboken6,
    because PySide6-Essentials determines its version.
    """
    yield from (f"{name}=={version}" for name, version in lowest.items())
    for line in pinned.splitlines():
        name = canonicalize_name(line.partition("==")[0])
        if line.strip() and name not in lowest and name != "shiboken6":
            yield line


def main() -> int:
    lowest = lowest_versions(PROJECT_FILE.read_text(encoding="utf-8"))
    say(", ".join(f"{name} {version}" for name, version in lowest.items()))
    venv.create(ENVIRONMENT, clear=True, with_pip=True)
    programs = ENVIRONMENT / ("Scripts" if sys.platform == "win32" else "bin")
    file = ENVIRONMENT / "constraints.txt"
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
