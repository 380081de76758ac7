"""Python packages that the program can do without."""

import sys
from pathlib import Path


def install_command(package: str) -> str:
    """Return the command that adds a package to the environment of the program."""
    is_of_pipx = (Path(sys.prefix) / "pipx_metadata.json").exists()
    if is_of_pipx:
        return f"pipx inject trex-gui {package}"
    return f'"{sys.executable}" -m pip install {package}'
