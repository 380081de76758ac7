"""The curves that a board gives, connected or recorded: currents, wished speeds, channels."""

from PySide6.QtCore import QCoreApplication

from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.ui.plotting.data.source import TraceInfo

_CHANNEL_COLORS = {1: "good", 2: "warning", 3: "dirty", 4: "muted", 5: "plot_text"}


def board_traces() -> list[TraceInfo]:
    """Return what the columns of `telemetry.Series` are, in that order."""

    def tr(text: str, number: int) -> str:
        return QCoreApplication.translate("board_traces", text).format(number)

    currents = [
        TraceInfo(f"motor{m}_current", tr("Motor {0}", m), "A", f"motor{m}", str(m)) for m in (1, 2)
    ]
    wishes = [
        TraceInfo(
            f"motor{m}_wish", tr("Speed {0} wished", m), "", f"motor{m}", tr("S{0}", m), shown=False
        )
        for m in (1, 2)
    ]
    channels = [
        TraceInfo(
            f"channel{c}", tr("Channel {0}", c), "", _CHANNEL_COLORS[c], tr("C{0}", c), shown=False
        )
        for c in CHANNELS
    ]
    return [*currents, *wishes, *channels]
