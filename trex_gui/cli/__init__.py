"""trexcmd: the board from the shell, without Qt."""

from trex_gui.cli.program import main as main
