"""Commands, library and examples run without the packages of the window.

For commands that are slow, use the network or need an Aracna, only the help is printed.
"""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.simulator import StartSimulator
from trex_gui.cli.program import COMMANDS

_SCRIPT = """
import json, runpy, sys
for package in ("PySide6", "shiboken6", "numpy", "pyqtgraph"):
    sys.modules[package] = None  # importing it fails
from click.testing import CliRunner
from trex_gui.app import main as open_window
from trex_gui.cli import main
from trex_gui.core.resource_files import resource

lines, examples, port = json.loads(sys.argv[1])
for line in lines:
    result = CliRunner().invoke(main, line.split(), input="y", env={"TREX_PORT": port})
    print(line.split()[0], result.exit_code, result.output if result.exit_code else "", flush=True)
for name, *words in examples:
    sys.argv = [name, port, *words]
    runpy.run_path(str(resource(f"examples/{name}.py")), run_name="__main__")
open_window([])
"""
_LINES = [
    "list",
    "find",
    "boards --help",  # takes 10 s
    "status",
    "stream --limit 2",
    "get serial_timeout",
    "set serial_timeout 0.5s",
    "get-settings board.txt",
    "check-settings board.txt",
    "set-settings --dry-run board.txt",
    "diff board.txt",
    "audit board.txt",
    "history",
    "provision board.txt",  # ends at the end of its input
    "calibration get",
    "export board.txt --as python",
    "restore-defaults",
    "motor 1 20 --seconds 0.1",
    "stop",
    "serve --install",
    "robots --help",  # uses the network
    "raw 81 --traffic traffic.txt",
    "decode 81",
    "report -",
    "survey --help",  # takes a minute
    "replay traffic.txt",
    "aracna --help",
    "completion bash",
]
_EXAMPLES = (
    ["read_status"],
    ["list_parameters"],
    ["explain"],
    ["set_parameters"],
    ["recover"],
    ["wait_for_line"],
    ["log_currents", "0.2"],
    ["drive", "30"],
)


@pytest.mark.realtime
def test_every_command_and_example_runs(start_simulator: StartSimulator, tmp_path: Path) -> None:
    assert {line.split()[0] for line in _LINES} == set(COMMANDS)
    port = start_simulator("--unpaced").url
    root = Path(__file__).parents[2]
    process = subprocess.run(
        [sys.executable, "-c", _SCRIPT, json.dumps([_LINES, _EXAMPLES, port])],
        cwd=tmp_path,
        env={"HOME": str(tmp_path), "PYTHONPATH": str(root), "PATH": ""},
        capture_output=True,
        text=True,
        check=False,
    )
    rows = [line.split(maxsplit=2) for line in process.stdout.splitlines()]
    failed = [row for row in rows if row and row[0] in COMMANDS and row[1:] != ["0"]]
    assert not failed, process.stdout
    assert "The board has confirmed the stop." in process.stdout
    assert process.stderr.endswith(
        'The window needs more packages: install "trex-gui[gui]" with pip or pipx.\n'
    )
    assert process.returncode == 1
