"""`python -m trex_gui.emulator` is trex-sim."""

from trex_gui.emulator.server import main

if __name__ == "__main__":
    main(prog_name="trex-sim")
