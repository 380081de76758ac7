"""Setting for the order of physical values and the device's own numbers in texts."""

from functools import cache

from PySide6.QtCore import QObject, Signal

from trex_gui.ui.preferences import Preferences

_KEY = "units/own_first"


class Units(QObject):
    """Setting for the whole program. `units()` returns the only instance."""

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.own_first = Preferences().flag(_KEY, default=False)

    def set_order(self, *, own_first: bool) -> None:
        Preferences().set(_KEY, own_first)
        if own_first != self.own_first:
            self.own_first = own_first
            self.changed.emit()

    def ordered(self, physical: str, own: str) -> tuple[str, str]:
        return (own, physical) if self.own_first else (physical, own)


@cache
def units() -> Units:
    return Units()
