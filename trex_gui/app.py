"""Start-up of the window."""

import argparse
import logging
import math
import os
import platform
import sys
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from trex_gui import composition
from trex_gui.core.decimals import decimal
from trex_gui.core.transport.urls import url_problem
from trex_gui.version import __version__

if TYPE_CHECKING:
    from trex_gui.core.log_file import ProgramLog
    from trex_gui.ui.program import Program
    from trex_gui.ui.workers.threads import GuiThreadCollector

log = logging.getLogger(__name__)

_FIRST_PAINT_MS = 100  # time for drawing the window before its hidden parts are loaded


def _seconds(text: str) -> float:
    try:
        seconds = decimal(text)
    except ValueError:
        seconds = math.nan
    if not 0 <= seconds <= 60:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of seconds from 0 to 60")
    return seconds


def _url(text: str) -> str:
    if not text:
        raise argparse.ArgumentTypeError("the name of the port is empty")
    if problem := url_problem(text):
        raise argparse.ArgumentTypeError(problem)
    return text


def _path(text: str) -> Path:
    if not text:  # usually an unset shell variable
        raise argparse.ArgumentTypeError("the path is empty")
    return Path(text)


def _arguments(argv: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="trex-gui",
        description="Set up, calibrate, drive and understand a Pololu TReX motor controller.",
    )
    board = parser.add_mutually_exclusive_group()
    board.add_argument("--port", metavar="URL", type=_url, help="connect to this port at start-up")
    board.add_argument("--demo", action="store_true", help="connect to the simulated board")
    parser.add_argument(
        "--device",
        choices=[plugin.key for plugin in composition.PLUGINS],
        help="kind of device for --demo or --port (default: the kind found on the port, "
        f"otherwise {composition.PLUGINS[0].name})",
    )
    parser.add_argument(
        "--settings",
        metavar="FILE",
        type=_path,
        help="settings file to compare with the board once the board is connected (without --port "
        "or --demo, the file is only opened), or a pose file (.ppr) to open in the workspace of "
        "the robot",
    )
    parser.add_argument(
        "--timeout",
        metavar="SECONDS",
        type=_seconds,
        default=0.0,
        help="seconds added to the deadline of every reply, for slow adapters and networks",
    )
    parser.add_argument(
        "--tour",
        metavar="FOLDER",
        type=_path,
        help="save a light and a dark picture of every page in this folder, then exit",
    )
    parser.add_argument(
        "--verbose",
        action="store_true",
        help="write a detailed log to the log file and to the terminal",
    )
    parser.add_argument("--version", action="version", version=f"trex-gui {__version__}")
    return parser.parse_args(argv)


def load_hidden_parts(
    program: "Program", collector: "GuiThreadCollector", *, has_crashed: bool = False
) -> None:
    """Load the parts of the window that are not visible at first.

    Loading blocks the GUI thread for half a second, so call this before the user can arm a motor.
    """
    program.complete()
    program.create_plots()
    collector.freeze()
    program.report_last_run(has_crashed=has_crashed)


def start(program: "Program", arguments: argparse.Namespace) -> None:
    """Schedule the actions that the command line requests."""
    from PySide6.QtCore import QCoreApplication, QTimer  # noqa: PLC0415

    if arguments.tour is not None:
        from trex_gui.ui.tour import Tour  # noqa: PLC0415

        tour = Tour(program, arguments.tour)
        tour.finished.connect(lambda ok: program.end() if ok else QCoreApplication.exit(1))
        QTimer.singleShot(0, tour.start)
    else:
        QTimer.singleShot(0, lambda: connect(program, arguments))
    if arguments.settings is not None:
        is_connecting = bool(arguments.demo or arguments.port) or arguments.tour is not None
        QTimer.singleShot(
            0, lambda: program.open_file(arguments.settings, connecting=is_connecting)
        )


def connect(program: "Program", arguments: argparse.Namespace) -> None:
    """Connect to the port or demo that the command line names, or connect automatically."""
    is_named = arguments.demo or bool(arguments.port)
    program.auto_connect.start(at_once=not is_named)  # also reconnects to a replugged adapter
    if arguments.demo:
        program.connect_to_demo(arguments.device or program.plugins[0].key)
    elif arguments.port:
        program.connect_to_port(arguments.port, arguments.device)


def main(argv: list[str] | None = None) -> int:
    """Run the window until it is closed. Return the exit code."""
    args = sys.argv[1:] if argv is None else argv
    if args[:1] == ["--guardian"]:
        from trex_gui.core.guardian.process import main as run_guardian  # noqa: PLC0415

        return run_guardian(args[1:])
    if args[:1] == ["--simulator"]:
        from trex_gui.cli.simulator import main as run_simulator  # noqa: PLC0415

        run_simulator(args=args[1:], prog_name="trex-sim")
        return 0
    arguments = _arguments(args)
    if any(find_spec(package) is None for package in ("PySide6", "pyqtgraph")):
        sys.exit('The window needs more packages: install "trex-gui[gui]" with pip or pipx.')

    from trex_gui.core.log_file import ProgramLog, log_file  # noqa: PLC0415

    program_log = ProgramLog(log_file(), is_verbose=arguments.verbose)
    code = 1
    try:
        code = _run(arguments, program_log)
    except Exception:
        log.critical("the program cannot continue", exc_info=True, extra={"printed": True})
        raise
    finally:
        log.info("ended with exit code %d", code)
        if not program_log.close():
            os._exit(code)
    return code


def _run(arguments: argparse.Namespace, program_log: "ProgramLog") -> int:
    # Qt is imported here, because --help, --version and the simulator do not need it.
    from PySide6.QtCore import Qt, QTimer, qVersion  # noqa: PLC0415
    from PySide6.QtWidgets import QApplication  # noqa: PLC0415

    from trex_gui.core.crash_detection import RunFile  # noqa: PLC0415
    from trex_gui.core.timing import Timeouts  # noqa: PLC0415
    from trex_gui.supervisor import UNCONFIRMED_STOP, SafetySupervisor  # noqa: PLC0415
    from trex_gui.system.process_exit import skip_exit_handlers  # noqa: PLC0415
    from trex_gui.ui.theme.theme import theme  # noqa: PLC0415
    from trex_gui.ui.translations import install_translations, selected_locale  # noqa: PLC0415
    from trex_gui.ui.workers.threads import GuiThreadCollector  # noqa: PLC0415

    # Not `platform.platform()`, which takes 50 ms. Its result is in the support report.
    system = f"{platform.system()} {platform.release()} {platform.machine()}"
    python, qt = platform.python_version(), qVersion()
    log.info("TReX Studio %s started on %s, Python %s, Qt %s", __version__, system, python, qt)
    QApplication.setApplicationName("TReX Studio")
    QApplication.setOrganizationName("TReX Studio")
    QApplication.setApplicationVersion(__version__)
    QApplication.setDesktopFileName("trex-studio")
    # Native dialogs would consume Esc, which must stop the motors even while a dialog is open.
    QApplication.setAttribute(Qt.ApplicationAttribute.AA_DontUseNativeDialogs)
    app = QApplication(["trex-gui"])
    run_file = RunFile()  # after QApplication, which aborts without a display
    theme().install(app)
    collector = GuiThreadCollector(app)
    collector.setObjectName("collector")
    install_translations(app, selected_locale())
    program = composition.build(Timeouts(extra=arguments.timeout))
    program.window.show()
    supervisor = SafetySupervisor(program, app, end_log=program_log.close)
    if sys.platform == "linux":
        skip_exit_handlers()
    load_rest = partial(load_hidden_parts, program, collector, has_crashed=run_file.found_crash)
    QTimer.singleShot(_FIRST_PAINT_MS, load_rest)
    start(program, arguments)
    code = app.exec()
    # Hide the windows first, because closing the line or a recording may take seconds.
    for window in app.topLevelWidgets():
        window.hide()
    has_ended = program.shut_down()
    if supervisor.report_unconfirmed_stop():
        code = code or UNCONFIRMED_STOP
    if not has_ended:
        run_file.close()
        if sys.stderr is not None:
            sys.stderr.write("A port or a disk does not respond. A file may not have been saved.\n")
            sys.stderr.flush()
        log.error("a port or a disk does not respond: ended with exit code %d", code)
        program_log.close()
        # A normal exit would destroy a running thread, and Qt would abort.
        os._exit(code)
    supervisor.close()
    program.destroy()
    run_file.close()
    return code
