"""Another language: the window opens again, as it was."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.ui.translations import chosen_language

_REOPEN = """
import sys
from trex_gui import app
from trex_gui.ui.translations import choose_language

begin, languages = app.begin, iter(["de"])

def begin_and_choose(program, arguments):
    def connected():
        window, manager = program.window, program.device_manager
        print(window.menuBar().actions()[0].text(), manager.current.port.url, flush=True)
        language = next(languages, None)
        if language is None:
            program.end()
        else:
            choose_language(language)
            window.reopen()
    program.device_manager.when_connected(connected)
    begin(program, arguments)

app.begin = begin_and_choose
sys.exit(app.main(["--port", sys.argv[1]]))
"""


def choose(window: WindowDriver, code: str) -> None:
    window.trigger("preferences")
    dialog = window.dialog("preferencesDialog")
    dialog.select("languageBox", code)


def test_same_language_leaves_window_open_and_another_opens_it_again(
    connected_window: WindowDriver,
) -> None:
    window, port = connected_window, connected_window.program.device_manager.current.port
    choose(window, "system")
    assert window.window.isVisible()
    assert not window.window.reopens

    window.motors.arm()
    window.device.parameters.edit("serial_timeout", 15)
    choose(window, "fr")
    window.wait(lambda: window.has("keepAndClose"))
    assert not window.window.reopens, "edits are asked about before"
    window.click("keepAndClose")
    window.wait(lambda: window.window.reopens)
    assert chosen_language() == "fr"
    assert window.window.port_to_reopen == port
    assert not window.device.motors.armed


def test_window_that_stays_open_is_not_opened_again(connected_window: WindowDriver) -> None:
    window = connected_window
    window.device.parameters.edit("serial_timeout", 15)
    choose(window, "de")
    window.wait(lambda: window.has("keepAndClose"))
    window.device.draft.discard_edits()
    window.wait(lambda: not window.has("keepAndClose"))
    assert window.window.isVisible()
    window.window.close()
    assert not window.window.reopens


@pytest.mark.realtime
def test_program_opens_again_in_another_language(
    simulator: SimulatedDevice, tmp_path: Path
) -> None:
    done = subprocess.run(
        [sys.executable, "-c", _REOPEN, simulator.url],
        env={**os.environ, "XDG_CONFIG_HOME": str(tmp_path)},  # remembers the language
        capture_output=True,
        text=True,
        timeout=50,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    titles = [line.split() for line in done.stdout.splitlines()]
    assert titles == [[title, simulator.url] for title in ("&File", "&Datei")]
