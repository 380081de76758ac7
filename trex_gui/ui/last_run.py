"""Startup message about a crash, a stop by the guardian, or boards that are still running."""

from functools import partial

from trex_gui.core.errors import StudioError
from trex_gui.core.guardian.guardian import watching_since
from trex_gui.core.guardian.log import StopResult, logged_stops
from trex_gui.core.translation import tr, tr_noop
from trex_gui.core.transport.driven import DrivenBoards, driven_boards, left_running_text, port_of
from trex_gui.core.transport.serial_port import SerialTransport
from trex_gui.ui.files import in_background
from trex_gui.ui.notifier import Notifier, Remedy
from trex_gui.ui.preferences import Preferences

_SEEN = "guardian/seen"

_STOPS = {
    StopResult.UNCONFIRMED: tr_noop(
        "The program could not stop the motors itself. The guardian process sent a stop at "
        "{0}, but the board did not confirm the stop. If a motor is still turning, cut its "
        "power."
    ),
    StopResult.CONFIRMED: tr_noop(
        "The program could not stop the motors itself. The guardian process stopped them at "
        "{0}, and the board confirmed the stop."
    ),
}


def report_last_run(
    notifier: Notifier, errors: str = "", *, has_crashed: bool = False, until: str = ""
) -> None:
    """Report boards that are still running, and stops by the guardian.

    If there is neither, report a crash. Each stop is reported only once, except while a board is
    still running. Stops during a run of `trexcmd` are included.

    `errors`: reasons why boards are still running, one per line. `until`: time after which events
    are ignored. The default is the time when this program could first move motors.
    """
    until = until or watching_since()
    store = Preferences()
    seen = store.integer(_SEEN, 0, 0, 2**31 - 1)

    def report(last_run: tuple[int, list[tuple[str, StopResult]], DrivenBoards]) -> None:
        size, stops, boards = last_run
        stops = [stop for stop in stops if stop[0] < until]
        boards = {
            file: board for file, board in boards.items() if board is None or board.since < until
        }
        if store.integer(_SEEN, 0, 0, 2**31 - 1) != seen and not (boards or errors):
            return  # another call has reported these stops
        if size != seen and not boards:
            store.set(_SEEN, size)
        texts = [*(left_running_text(*item) for item in boards.items()), *errors.splitlines()]
        for result, text in _STOPS.items():
            if times := [time for time, stop_result in stops if stop_result is result]:
                texts.append(tr(text).format(", ".join(times)))
        if has_crashed and not texts:
            texts.append(
                tr(
                    "TReX Studio did not end properly last time. If it crashed, the support "
                    "report shows where."
                )
            )
        notifier.resolved.emit(Remedy.STOP_MOTORS)
        if texts:
            is_problem = errors or any(result is StopResult.UNCONFIRMED for _, result in stops)
            signal = notifier.error if is_problem else notifier.info
            (notifier.danger if boards else signal).emit("\n".join(texts))
            notifier.remedies_offered.emit(
                (Remedy.STOP_MOTORS,) * any(boards.values()) + (Remedy.REPORT,)
            )

    in_background(notifier, lambda: (*logged_stops(seen), driven_boards()), report, lambda _: None)


def stop_running_boards(notifier: Notifier) -> None:
    """Open the ports of running boards, which stops the boards. Report the result."""

    def stop() -> str:
        errors = []
        for file, board in driven_boards().items():
            try:
                if board is not None:
                    SerialTransport(port_of(file, board)).close()
            except StudioError as error:
                errors.append(str(error).removeprefix(left_running_text(file, board)).strip())
        return "\n".join(errors)

    report = partial(report_last_run, notifier, until="9999")  # ignores no event
    in_background(notifier, stop, report, lambda error: report(str(error)))
