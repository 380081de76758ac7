"""A message at the start: the guardian stopped motors since the last one."""

from functools import partial

from trex_gui.core.guardian.log import LoggedStop, StopResult, last_stop
from trex_gui.core.translation import tr
from trex_gui.ui.files import in_background
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.preferences import Preferences

_SEEN = "guardian/seen"


def report_last_stop(notifier: Notifier) -> None:
    """Report the newest stop in the guardian's log, once; it may be one of `trexcmd`."""
    store = Preferences()
    seen = store.integer(_SEEN, 0, 0, 2**31 - 1)

    def report(found: tuple[int, LoggedStop | None]) -> None:
        size, stop = found
        if size != seen:
            store.set(_SEEN, size)
        if stop is None:
            return
        if stop.result is StopResult.CONFIRMED:
            text = tr(
                "The program could not stop the motors itself. The guardian process stopped them "
                "at {0}, and the board confirmed that."
            )
            notifier.info.emit(text.format(stop.time))
        elif stop.result is StopResult.UNCONFIRMED:
            text = tr(
                "The program could not stop the motors itself. The guardian process sent a stop "
                "at {0}, which the board did not confirm. If a motor still turns, cut its power."
            )
            notifier.error.emit(text.format(stop.time))

    in_background(notifier, partial(last_stop, seen), report, lambda _error: None)
