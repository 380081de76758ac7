"""trexcmd: the board from the shell, without Qt.

Data goes to stdout, messages to stderr. Exit codes: 0 done, 1 the device or a file refused,
2 wrong usage.
"""

from trex_gui.cli.program import main

__all__ = ["main"]
