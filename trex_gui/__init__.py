"""TReX Studio: set up, calibrate, drive and understand a Pololu TReX motor controller.

Import the programming interface of a board from this package, which does not need Qt:

    from trex_gui import Trex

    with Trex("/dev/ttyUSB0") as trex:
        print(trex.status().currents)

The names in `__all__` are the public interface. Everything else may change. For example programs,
see `resources/examples`.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from trex_gui.version import __version__

if TYPE_CHECKING:
    from trex_gui.core.errors import BadReply, BadRequest, NoReply, PortUnavailable, StudioError
    from trex_gui.core.events import Event
    from trex_gui.devices.trex.board.drive_status import MotorSetpoint, SetpointSource
    from trex_gui.devices.trex.board.errors import ErrorEntry
    from trex_gui.devices.trex.library import BoardStatus, ChannelStatus, Trex, TrexLine, snapshots
    from trex_gui.devices.trex.open_board import MotorsStoppedError
    from trex_gui.devices.trex.protocol.calibration import Calibration
    from trex_gui.devices.trex.protocol.errors import Rejected
    from trex_gui.devices.trex.settings.comparison import ComparisonRow
    from trex_gui.devices.trex.settings.history import Snapshot

__all__ = (
    "BadReply",
    "BadRequest",
    "BoardStatus",
    "Calibration",
    "ChannelStatus",
    "ComparisonRow",
    "ErrorEntry",
    "Event",
    "MotorSetpoint",
    "MotorsStoppedError",
    "NoReply",
    "PortUnavailable",
    "Rejected",
    "SetpointSource",
    "Snapshot",
    "StudioError",
    "Trex",
    "TrexLine",
    "__version__",
    "snapshots",
)


_MODULES = (
    "trex_gui.core.errors",
    "trex_gui.devices.trex.protocol.errors",
    "trex_gui.devices.trex.board.drive_status",
    "trex_gui.devices.trex.open_board",
    "trex_gui.devices.trex.library",
)


if not TYPE_CHECKING:  # hidden from type checkers, which then report misspelled names

    def __getattr__(name: str) -> Any:
        """Import the library on first use, so that the window and `trexcmd` start fast."""
        for module in _MODULES if name in __all__ else ():
            if (value := getattr(import_module(module), name, None)) is not None:
                return value
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
