"""The bar of a gamepad's axis, or of what it asks for, in per cent."""

from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.views.output_bar import OutputBar
from trex_gui.ui.widgets.bar import with_sign


class PartBar(OutputBar):
    """Shows -1 to 1 from the centre; nothing is shown while nothing is read."""

    def __init__(self, label: str, parent: QWidget | None = None) -> None:
        super().__init__(parent, label=label)

    def set_part(self, part: float | None) -> None:
        """Show a part of the way to an end."""
        self.set_connected(part is not None)
        if part is not None:
            self.set_value(round(part * FULL_SCALE))

    def _value_text(self) -> str:
        value = self.value
        return "" if value is None else f"{with_sign(round(100 * value / FULL_SCALE))} %"

    def _spoken_value(self) -> str:
        return self._value_text()

    def _widest_value(self) -> str:
        return f"{with_sign(-100)} %"
