"""The line to a TReX as the models see it."""

import math

from trex_gui.core.session.messages import Close
from trex_gui.core.transport.traffic_log import logged
from trex_gui.devices.trex.driving.requests import SetAuxiliary, SetMotor, SetMotors, Stop
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.session.messages import Write
from trex_gui.devices.trex.session.session import TrexSession
from trex_gui.ui.runtime import now, open_transport
from trex_gui.ui.workers.session_thread import NOBODY, SessionThread


class Line(SessionThread):
    """One line session after another, and a stop that waits for nobody."""

    def moves(self, request: object) -> bool:
        """Wishes move motors; writing and reading do not."""
        return isinstance(request, (SetMotor, SetMotors, SetAuxiliary))

    def writes(self, request: object) -> bool:
        """The end of the program waits longer for what is being stored."""
        return isinstance(request, Write)

    def open(self, settings: ConnectionSettings, *, may_move: bool) -> None:
        """Start a session; `may_move` says that motors may be turning from an earlier one."""
        self.start(
            lambda inbox, tell: TrexSession(
                settings, inbox, tell, logged(self.log, open_transport, now), may_move=may_move
            ),
            may_move=may_move,
        )

    def stop_now(self, *, ending: bool = False) -> None:
        """Stop every motor, and give the port back where the program is `ending`.

        For emergencies, from any thread: it waits for nobody, and nobody is told how it went but
        by what follows from it. Wishes that pass it on their way are dropped until motors are
        armed anew.
        """
        stop = Stop(NOBODY, lockout=math.inf)
        self.submit_now(*((stop, Close()) if ending else (stop,)))
