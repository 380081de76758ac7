"""`python -m trex_gui.cli`: run trexcmd."""

from trex_gui.cli.program import main

if __name__ == "__main__":
    main(prog_name="trexcmd")
