"""All targets of the fuzzer.

`python -m tests.fuzz.targets SECONDS [SEED] [NAME ...]` prints the findings and stores them in the
corpus.
"""

import logging
import os
import secrets
import signal
import sys

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtCore import QCoreApplication, QSettings
from PySide6.QtWidgets import QApplication

from tests.fuzz import fuzzing
from tests.fuzz.files import FILE_TARGETS
from tests.fuzz.fuzzing import Finding, Target
from tests.fuzz.programs import PROGRAM_TARGETS
from tests.fuzz.wire import WIRE_TARGETS

TARGETS: tuple[Target, ...] = (*FILE_TARGETS, *WIRE_TARGETS, *PROGRAM_TARGETS)


def run(seconds: float, seed: int, targets: tuple[Target, ...] = TARGETS) -> list[Finding]:
    """Fuzz for some seconds. Print the findings, store them in the corpus and return them."""

    out = sys.stdout  # a command that hangs can replace `sys.stdout`

    def report(message: Finding | str) -> None:
        text = message
        if isinstance(message, Finding) and message.data:
            text = f"{message}\nsaved as {message.save()}\n"
        print(text, file=out, flush=True)

    signal.signal(signal.SIGINT, signal.default_int_handler)  # otherwise ignored in the background
    app = QCoreApplication.instance() or QApplication(["fuzz"])
    app.setOrganizationName("TReX Studio tests")
    app.setApplicationName("TReX Studio")
    QSettings.setDefaultFormat(QSettings.Format.IniFormat)
    logging.getLogger().addHandler(logging.NullHandler())
    print(f"Fuzzing for {seconds:g} s with seed {seed}.", file=out, flush=True)
    return fuzzing.run(seconds, seed, targets, report)


def main(arguments: list[str]) -> int:
    seed = int(arguments[1]) if len(arguments) > 1 else secrets.randbits(32)
    selected = tuple(target for target in TARGETS if target.name in arguments[2:]) or TARGETS
    return 1 if run(float(arguments[0]), seed, selected) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
