"""A message at the start: the last run did not end properly, or the guardian stopped motors."""

from functools import partial

from trex_gui.core.guardian.log import LoggedStop, StopResult, last_stop
from trex_gui.core.translation import tr
from trex_gui.ui.files import in_background
from trex_gui.ui.notifier import Notifier, Remedy
from trex_gui.ui.preferences import Preferences

_SEEN = "guardian/seen"


def report_last_run(notifier: Notifier, *, has_crashed: bool) -> None:
    """Report the newest stop in the guardian's log, or that the program did not end properly.

    A stop is reported once; it may be one of `trexcmd`. Each offers a report for support.
    """
    store = Preferences()
    seen = store.integer(_SEEN, 0, 0, 2**31 - 1)

    def report(found: tuple[int, LoggedStop | None]) -> None:
        size, stop = found
        if size != seen:
            store.set(_SEEN, size)
        result = None if stop is None else stop.result
        if stop is not None and result is StopResult.CONFIRMED:
            text = tr(
                "The program could not stop the motors itself. The guardian process stopped them "
                "at {0}, and the board confirmed that."
            )
            notifier.info.emit(text.format(stop.time))
        elif stop is not None and result is StopResult.UNCONFIRMED:
            text = tr(
                "The program could not stop the motors itself. The guardian process sent a stop "
                "at {0}, which the board did not confirm. If a motor still turns, cut its power."
            )
            notifier.error.emit(text.format(stop.time))
        elif has_crashed:
            notifier.info.emit(
                tr(
                    "TReX Studio did not end properly the last time. If it crashed, a report for "
                    "support says where."
                )
            )
        else:
            return
        notifier.remedies_offered.emit((Remedy.REPORT,))

    in_background(notifier, partial(last_stop, seen), report, lambda _error: None)
