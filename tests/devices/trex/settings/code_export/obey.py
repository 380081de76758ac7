"""Call functions of an exported Python program by lines on standard input.

Usage: obey.py PROGRAM PORT
"""

import importlib.util
import sys
from pathlib import Path
from typing import Any


def load(path: Path) -> Any:
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def obey(module: Any, trex: Any, word: str, a: int, b: int) -> None:
    """Execute one line."""
    match word:
        case "check":
            trex.check_board()
        case "calibrate":
            trex.apply_calibration(*module.CALIBRATIONS[0])
        case "parameter":
            trex.apply_parameter(*module.PARAMETERS[0])
        case "apply":
            trex.apply()
        case "set":
            trex.set_motor(a, b)
        case "accelerate":
            trex.accelerate_motor(a, b)
        case "brake":
            trex.brake(a, b)
        case "both":
            trex.set_motors(a, b)
        case "aux":
            trex.set_aux(a)
        case "stop":
            trex.stop()
        case "status":
            print_line(trex.status())
        case "currents":
            print_line(*(round(ampere * 1000) for ampere in trex.currents()))


def print_line(*values: object) -> None:
    """Print a line at once."""
    sys.stdout.write(" ".join(map(str, values)) + "\n")
    sys.stdout.flush()


if __name__ == "__main__":
    module = load(Path(sys.argv[1]))
    trex = module.Trex(sys.argv[2])
    for line in sys.stdin:
        word, a, b = line.split()
        try:
            obey(module, trex, word, int(a), int(b))
        except module.TrexError as error:
            print_line(error)
        print_line("done")
