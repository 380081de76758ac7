"""Python -m trex_gui.cli."""

from trex_gui.cli.program import main

if __name__ == "__main__":
    main(prog_name="trexcmd")
