"""Command-line programs without Qt: trexcmd and trex-sim."""

from trex_gui.cli.program import main as main
