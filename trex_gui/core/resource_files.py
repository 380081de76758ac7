"""Paths of the program's resource files, in a checkout, wheel or bundle."""

import sys
from functools import cache
from pathlib import Path


@cache
def _root() -> Path:
    package = Path(__file__).resolve().parents[1]
    bundle = getattr(sys, "_MEIPASS", None)  # set by PyInstaller's loader
    candidates = [package / "_resources", package.parent / "resources"]
    if bundle is not None:
        candidates.insert(0, Path(bundle) / "resources")
    for candidate in candidates:
        if candidate.is_dir():
            return candidate
    message = "the program's files are missing; looked in " + ", ".join(map(str, candidates))
    raise FileNotFoundError(message)


def resource(name: str) -> Path:
    """Return the path of a resource. `name`: path in `resources/`, such as `icons/stop.svg`."""
    path = _root() / name
    if not path.exists():
        message = f"{name} is missing from {_root()}; install the program again"
        raise FileNotFoundError(message)
    return path
