"""What was known at the position of a recording: motors, channels, control."""

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QGridLayout, QLabel, QWidget

from trex_gui.devices.trex.model.recordings.playback import Playback
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.recording.replay import Latest
from trex_gui.ui.widgets.bar import MINUS

_NONE = "–"


class ValuesPanel(QWidget):
    """Values as text; a dash where nothing was known yet."""

    def __init__(self, playback: Playback, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._playback = playback
        self._cells: dict[str, QLabel] = {}
        self._names: dict[str, str] = {}

        self._control = QLabel(self)
        self._control.setObjectName("controlAtPosition")
        self._control.setWordWrap(True)
        self._control.setTextFormat(Qt.TextFormat.PlainText)
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setVerticalSpacing(2)
        self._grid.addWidget(self._control, 0, 0, 1, 4)
        self._grid.setRowMinimumHeight(0, 2 * self.fontMetrics().lineSpacing())
        self._head(1, "", self.tr("Current"), self.tr("Asked for"))
        for motor in (1, 2):
            name = self.tr("Motor {0}").format(motor)
            self._row(1 + motor, name, f"motor{motor}", "current", "wish")
        self._row(4, self.tr("Auxiliary"), "auxiliary", "", "wish")
        self._grid.setRowMinimumHeight(5, 6)
        self._head(6, "", self.tr("Signal"), self.tr("Counts"), self.tr("Remapped"))
        for channel in CHANNELS:
            name = self.tr("Channel {0}").format(channel)
            self._row(6 + channel, name, f"channel{channel}", "physical", "raw", "remapped")
        self._grid.setColumnStretch(3, 1)

        playback.moved.connect(self.refresh)
        playback.loaded.connect(self.refresh)
        self.refresh()

    def _head(self, row: int, *texts: str) -> None:
        for column, text in enumerate(texts):
            label = QLabel(text, self)
            label.setAlignment(Qt.AlignmentFlag.AlignRight)
            self._grid.addWidget(label, row, column)

    def _row(self, row: int, title: str, key: str, *parts: str) -> None:
        self._grid.addWidget(QLabel(title, self), row, 0)
        for column, part in enumerate(parts, 1):
            if not part:
                continue
            label = QLabel(_NONE, self)
            name = f"{key}{part.capitalize()}"
            label.setObjectName(f"{name}AtPosition")
            label.setAlignment(Qt.AlignmentFlag.AlignRight)
            wide = self.fontMetrics().horizontalAdvance("1500.0 ")
            label.setMinimumWidth(wide)
            self._names[name] = f"{title}, {part}"
            self._cells[name] = label
            self._grid.addWidget(label, row, column)

    @Slot()
    def refresh(self) -> None:
        """Show what was known at the position."""
        latest = self._playback.latest()
        self._show_motors(latest)
        self._show_channels(latest)
        self._control.setText(self._control_text(latest))

    def _control_text(self, latest: Latest) -> str:
        inputs = latest.mode.source.value
        if latest.mode.is_serial:
            mode = self.tr("Serial mode with {0} inputs").format(inputs)
        else:
            mode = self.tr("{0} mode").format(inputs)
        match latest.by_serial:
            case None:
                return self.tr("{0}.").format(mode)
            case True:
                return self.tr("{0}; serial commands reach the motors.").format(mode)
            case False:
                return self.tr("{0}; the channels control the motors.").format(mode)

    def _show_motors(self, latest: Latest) -> None:
        unit = self._playback.header.model.current_unit
        for motor in (1, 2):
            text = _NONE
            if latest.currents is not None:
                text = f"{latest.currents[motor - 1] * unit:.2f} A"
            self._set(f"motor{motor}Current", text)
            self._set(f"motor{motor}Wish", self._drive_text(latest.wishes.get(motor)))
        auxiliary = latest.auxiliary
        self._set("auxiliaryWish", _NONE if auxiliary is None else str(auxiliary))

    def _drive_text(self, drive: Drive | None) -> str:
        if drive is None:
            return _NONE
        if drive.is_brake:
            return self.tr("brake {0}").format(drive.speed)
        return _signed(drive.signed)

    def _show_channels(self, latest: Latest) -> None:
        source = latest.mode.source
        for place, channel in enumerate(CHANNELS):
            raw = latest.raw[place] if latest.raw is not None else None
            known = latest.raw is not None
            silent = self.tr("no signal") if known else _NONE
            self._set(f"channel{channel}Raw", silent if raw is None else str(raw))
            self._set(f"channel{channel}Physical", _NONE if raw is None else source.text(raw))
            remapped = latest.remapped
            text = _NONE if remapped is None else _signed(remapped[place])
            self._set(f"channel{channel}Remapped", text)

    def _set(self, name: str, text: str) -> None:
        label = self._cells[name]
        if label.text() != text:
            label.setText(text)
            label.setAccessibleName(f"{self._names[name]}: {text}")


def _signed(value: int) -> str:
    return f"{value:+d}".replace("-", MINUS) if value else "0"
