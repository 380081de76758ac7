"""Exported programs on a simulated board.

The quick tests call each function once in each language. The other tests are slow.
"""

import itertools
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import pytest

from tests.devices.trex.settings.code_export.programs import (
    CALIBRATIONS,
    CHANGED,
    CPP,
    HERE,
    Board,
    Boards,
    Program,
    compile_,
    export_to_file,
    interactive_program,
    link,
    prepared_program,
    settings_for,
)
from tests.devices.trex.simulator.waiting import comes_true
from tests.support.matrix import sampled
from trex_gui.core.code import Language
from trex_gui.devices.trex.protocol.calibration import CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.settings.document import Settings

pytestmark = pytest.mark.realtime

if sys.platform == "win32":
    pytest.skip("Windows has no pseudo-terminals", allow_module_level=True)


Prepare = Callable[..., Program]


@pytest.fixture(params=list(Language), ids=lambda language: language.value)
def language(request: pytest.FixtureRequest) -> Language:
    return Language(request.param)


@pytest.fixture
def prepare(language: Language, tmp_path: Path) -> Prepare:
    """Export settings for a connection in each language, and compile the program."""
    return partial(prepared_program, tmp_path, language=language)


@pytest.fixture(scope="module")
def boards(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Boards]:
    boards = Boards(tmp_path_factory.mktemp("boards"))
    yield boards
    boards.end()


def run_demonstration(program: Program, board: Board) -> tuple[set[tuple[int, int]], str]:
    """Let a program drive. Return the speeds of the motors, and the output.

    Repeats the run if a busy computer misses half a second of movement.
    """
    speeds = set()
    for _ in range(10):
        with program.start(board.url) as process:
            while process.poll() is None:
                speeds.add(board.motors)
                time.sleep(0.03)
            assert process.stdout is not None
            output = process.stdout.read()
        assert process.returncode == 0, output
        if {(20, 0), (0, 20)} <= speeds:
            break
    return speeds, output


def check_that_ctrl_c_stops_motors(program: Program, board: Board) -> None:
    for _ in range(10):  # a busy computer may miss the movement
        with program.start(board.url) as process:
            while not (driven := board.motors == (20, 0)) and process.poll() is None:
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            process.communicate(timeout=30)
        if driven:
            break
    assert driven
    assert comes_true(lambda: board.braking == (127, 127))  # the stop may arrive after the end


@pytest.mark.parametrize(
    ("expanded", "crc", "model"),
    sampled(itertools.product((True, False), (True, False), ("trex", "trexjr")), every=8),
)
def test_program_applies_settings_once_and_sends_all_commands(
    expanded: bool, crc: bool, model: str, boards: Boards, prepare: Prepare
) -> None:
    line = link(expanded=expanded, crc=crc)
    settings = settings_for(line, model)
    program = prepare(settings, line)
    board = boards.board(line, model)

    process = program.run(board.url)
    assert process.returncode == 0, process.stdout
    assert board.has(settings)
    assert process.stdout.count("->") == len(CHANGED)
    assert process.stdout.count("stored") == len(CALIBRATIONS)
    assert process.stdout.count("switch the board off and on") == 1  # for the motor mode

    writes = board.writes
    with interactive_program(program, board.url) as trex:
        output = trex.do("apply")
        assert len(output) == 2, output  # signature, and no changes
        assert board.writes == writes
        board.reset(line)  # clears the current limits
        trex.do("set", 1, 127)
        trex.do("set", 2, -127)
        assert trex.do("status") == ["0"]  # the reply shows that earlier commands were executed
        assert board.motors == (127, -127)
        trex.do("both", -3, 4)
        trex.do("aux", 90)
        trex.do("status")
        assert board.motors == (-3, 4)
        assert board.show()["aux"]["speed"] == 90
        trex.do("both", 200, -200)  # beyond full speed
        trex.do("status")
        assert board.motors == (127, -127)
        trex.do("brake", 2, 64)
        trex.do("status")
        assert board.braking == (-1, 64)
        trex.do("accelerate", 1, 101)
        trex.do("accelerate", 2, -102)
        trex.do("status")
        targets = [
            (motor["target_direction"], motor["target_speed"]) for motor in board.show()["motors"]
        ]
        assert targets == [("forward", 101), ("reverse", 102)]
        trex.do("stop")
        trex.do("status")
        assert board.braking == (127, 127)
        assert board.show()["aux"]["speed"] == 0
    assert board.errors == 0


def test_demonstration_drives_slowly_and_ends_with_stop(
    language: Language, boards: Boards, prepare: Prepare
) -> None:
    line = link(expanded=True, crc=True)
    board = boards.board(line)
    settings = settings_for(line)
    program = prepare(settings, line, drive=True)
    speeds, output = run_demonstration(program, board)
    assert board.has(settings)
    assert {(20, 0), (0, 20)} <= speeds
    assert all(abs(speed) <= 20 for pair in speeds for speed in pair)
    assert comes_true(lambda: board.braking == (127, 127))
    assert board.show()["aux"]["speed"] == 0
    assert board.errors == 0
    assert "status is 0" in output
    if language is not Language.ARDUINO:
        check_that_ctrl_c_stops_motors(program, board)


@pytest.mark.slow
def test_program_moves_no_motor_by_default(boards: Boards, prepare: Prepare) -> None:
    board = boards.board(link())
    settings = settings_for(link())
    program = prepare(settings, link())
    before = board.show()["motors"]
    process = program.run(board.url)
    assert process.returncode == 0, process.stdout
    assert "checked" in process.stdout
    assert "Running" not in process.stdout
    assert "runs" not in process.stdout
    assert board.show()["motors"] == before
    assert board.has(settings)


@pytest.mark.slow
def test_currents_and_faults_can_be_read(boards: Boards, prepare: Prepare) -> None:
    board = boards.board(link(), "trexjr")
    program = prepare(settings_for(link(), "trexjr"), link())
    board.do("current 1 2.4", "current 2 9.92", "fault 1 on")
    with interactive_program(program, board.url) as trex:
        deadline = time.monotonic() + 30
        while trex.do("currents") != ["2400 9920"]:  # the board averages them
            assert time.monotonic() < deadline
        assert trex.do("status") == ["16"]
        assert trex.do("status") in (["0"], ["16"])  # a lasting fault is latched again


@pytest.mark.slow
@pytest.mark.parametrize(
    ("exported", "connected", "mode", "words"),
    [
        ("trex", "trexjr", "serial", ["settings are for a TReX"]),
        ("trexjr", "trex", "serial", ["settings are for a TReX Jr"]),
        ("trex", "trex", "rc", ["not in serial mode", "mode jumper"]),
    ],
)
def test_unsuitable_board_is_neither_written_nor_driven(
    exported: str, connected: str, mode: str, words: list[str], boards: Boards, prepare: Prepare
) -> None:
    line = link(crc=True)
    board = boards.board(line, connected)
    board.do(f"jumper mode {mode}", "power cycle")
    settings = settings_for(line, exported)
    program = prepare(settings, line, drive=True)
    process = program.run(board.url, drive=True)
    assert process.returncode == 1
    assert all(text in process.stdout for text in words)
    assert "Traceback" not in process.stdout
    assert board.writes == 0
    assert board.motors == (0, 0)


@pytest.mark.slow
@pytest.mark.parametrize("cause", ["silent", "other framing", "other number"])
def test_missing_reply_is_reported_with_line_settings(
    cause: str, boards: Boards, prepare: Prepare
) -> None:
    line = link(expanded=True, crc=True)
    board = boards.board(
        {
            "silent": line,
            "other framing": link(expanded=True),
            "other number": link(expanded=True, crc=True, device=12),
        }[cause]
    )
    if cause == "silent":
        board.do("line mute on")
    program = prepare(settings_for(line), line, drive=True, timeout=1)
    process = program.run(board.url, drive=True)
    assert process.returncode == 1
    assert "No board responds" in process.stdout
    assert "19200 baud, CRC-7, 1 stop bit, device number 11" in process.stdout
    assert "Traceback" not in process.stdout


@pytest.mark.slow
def test_unsupported_parameter_is_named(
    language: Language, boards: Boards, prepare: Prepare
) -> None:
    board = boards.board(link(), "trex", "--unpaced", "--firmware", "1.0")
    settings = settings_for(link())
    program = prepare(settings, link(), drive=True, timeout=3)
    process = program.run(board.url, drive=True)
    assert process.returncode == 1
    name = "0x17" if language is Language.ARDUINO else "Enable UART Response Delay"
    assert name in process.stdout
    assert "firmware" in process.stdout
    assert board.motors == (0, 0)


@pytest.mark.slow
def test_program_continues_with_new_device_number(boards: Boards, prepare: Prepare) -> None:
    line = link(expanded=True)
    settings = settings_for(line, device_number=42)
    program = prepare(settings, line, timeout=3)
    board = boards.board(line)
    for writes in (True, False):
        process = program.run(board.url)
        assert process.returncode == 0, process.stdout
        assert ("->" in process.stdout) is writes
        assert board.has(settings)


@pytest.mark.slow
def test_calibration_for_other_input_is_reported_as_skipped(
    boards: Boards, prepare: Prepare
) -> None:
    full = settings_for(link())
    analog = {CalibrationKey.ANALOG_CHANNEL_3: CALIBRATIONS[CalibrationKey.RC_CHANNEL_2]}
    settings = Settings(full.product, full.firmware, calibrations=analog)
    board = boards.board(link())
    program = prepare(settings, link())
    process = program.run(board.url)
    assert process.returncode == 0, process.stdout
    assert "channel 3: skipped" in process.stdout
    assert board.writes == 0


@pytest.mark.slow
def test_board_that_stops_replying_is_reported(boards: Boards, prepare: Prepare) -> None:
    board = boards.board(link())
    program = prepare(settings_for(link()), link(), timeout=3)
    with interactive_program(program, board.url) as trex:
        assert "serial mode" in trex.do("check")[0]
        board.do("line mute on")
        output = trex.do("calibrate")[0]
        assert "no reply" in output or "does not respond" in output
        assert "no reply" in trex.do("parameter")[0]
    assert board.writes == 0


@pytest.mark.slow
def test_echo_is_not_read_as_reply(boards: Boards, tmp_path: Path) -> None:
    line = link(crc=True)
    board = boards.board(line, "trex", "--echo")  # unpaced bytes would collide with the echo
    settings = settings_for(line)
    program = prepared_program(tmp_path, settings, line, Language.PYTHON)
    speeds, _ = run_demonstration(program, board)
    assert board.has(settings)
    assert {(20, 0), (0, 20)} <= speeds
    assert comes_true(lambda: board.braking == (127, 127))


@pytest.mark.slow
def test_baud_rate_and_stop_bits_are_set_on_port(boards: Boards, prepare: Prepare) -> None:
    line = link(baud=57600, stop_bits=2)
    board = boards.board(line)
    program = prepare(settings_for(line), line)
    process = program.run(board.url)
    assert process.returncode == 0, process.stdout
    assert board.errors == 0


@pytest.mark.slow
def test_wrong_usage_and_missing_port_have_own_exit_codes(tmp_path: Path) -> None:
    program = prepared_program(tmp_path, settings_for(link()), link(), Language.PYTHON)
    missing = program.run(str(tmp_path / "no-port"))
    assert missing.returncode == 1
    assert "no-port" in missing.stdout
    assert "Traceback" not in missing.stdout
    wrong = subprocess.run(
        [*program.command, "port", "--drove"], capture_output=True, text=True, check=False
    )
    assert wrong.returncode == 2
    assert "usage" in wrong.stderr


# --- Compilation -------------------------------------------------------------------------


def check_that_sketch_compiles(folder: Path, settings: Settings, line: ConnectionSettings) -> None:
    sketch = export_to_file(folder, settings, line, Language.ARDUINO)
    main = str(HERE / "arduino" / "main.cpp")
    # Newer cores use newer standards.
    for standard in ("-std=gnu++11", "-std=gnu++20"):
        compile_([*CPP, standard, "-fsyntax-only", f'-DSKETCH="{sketch}"', main])


@pytest.mark.slow
@pytest.mark.parametrize("part", ["nothing", "parameters", "calibrations", "invalid"])
def test_partial_settings_compile(part: str, tmp_path: Path) -> None:
    full = settings_for(link())
    settings = Settings(
        full.product,
        None,
        {
            "nothing": {},
            "parameters": {"serial_timeout": 5},
            "calibrations": {},
            "invalid": {"serial_timeout": 5, "uart_settings": 0x0F},
        }[part],
        CALIBRATIONS if part == "calibrations" else {},
    )
    for expanded in (False, True):
        check_that_sketch_compiles(tmp_path, settings, link(expanded=expanded, crc=expanded))


@pytest.mark.slow
@pytest.mark.parametrize("stop_bits", [1, 2])
@pytest.mark.parametrize("detection", list(Detection), ids=lambda value: value.name.lower())
def test_all_line_formats_compile(detection: Detection, stop_bits: int, tmp_path: Path) -> None:
    line = ConnectionSettings("unused", LineSettings(9600, detection, stop_bits))
    check_that_sketch_compiles(tmp_path, settings_for(line), line)
