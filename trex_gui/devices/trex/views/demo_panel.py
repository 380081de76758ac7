"""Panel of the Demo TReX."""

from collections.abc import Callable
from functools import partial
from typing import TypeVar

from PySide6.QtCore import QPointF, QRectF, QRegularExpression, Qt
from PySide6.QtGui import QKeySequence, QPaintEvent, QPen, QShortcut
from PySide6.QtWidgets import QLayout, QWidget

from trex_gui.core.translation import Number, tr, tr_noop
from trex_gui.devices.trex.driving.board_reasons import LED_TEXTS, PACKETS
from trex_gui.devices.trex.model.channel_text import CHANNEL_NAMES
from trex_gui.devices.trex.model.controller import TrexController
from trex_gui.devices.trex.model.demo import (
    BOOT_TEXTS,
    STICK_ENDS,
    DemoBoard,
    DemoMotor,
    DemoSnapshot,
)
from trex_gui.devices.trex.model.drive_texts import direction_text
from trex_gui.devices.trex.protocol.descriptions import CHANNEL_ROLES, describe_control
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, Mode, channels_in
from trex_gui.devices.trex.views.board.parts import (
    PLUG_GAP,
    BoardPart,
    JumperPart,
    MotorPart,
    PlugPart,
)
from trex_gui.ui.devices.demo_panel import Columns, DemoPanelBody, Rows, add_cable
from trex_gui.ui.theme.theme import follow_theme, theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.circuit import paint_block, paint_body, text_width
from trex_gui.ui.widgets.labels import LiveLabel, Muted
from trex_gui.ui.widgets.leds import Leds
from trex_gui.ui.widgets.painted import Animation, Painter, never_mirror
from trex_gui.ui.widgets.sliders import StickSlider

BoardRows = Rows[DemoSnapshot]
OnClick = Callable[[], object]
PartT = TypeVar("PartT", bound=BoardPart)

_TRAVEL = 1200  # slider positions of a stick, one per µs
_STALL_CURRENT, _STEPS_PER_AMPERE = 30, 10  # A; slider positions per A
_STEPS_PER_VOLT = 10  # slider positions per V
_BATTERY = 40, 160  # slider range: 4 to 16 V. A TReX resets below about 6 V.
_MODES = ("serial", "rc", "analog")
_MIXED = tr_noop("&Turn"), tr_noop("&Forward")  # roles of inputs 1 and 2 with the mix jumper
_FLASHES = {  # LED texts while the board learns or runs its boot loader
    "blink": tr_noop("blink {0}/s"),
    "alternate": tr_noop("alternate {0}/s"),
    "short flash": tr_noop("short flash {0}/s"),
}


def led_patterns(snapshot: DemoSnapshot) -> tuple[str, str]:
    """Return the red and green LED patterns. An LED that flickers with each packet is `PACKETS`."""
    red, green = snapshot.leds.red, snapshot.leds.green
    if snapshot.power and snapshot.boot_mode is None:
        if snapshot.serial_controls and green in {"on", "off"}:
            green = PACKETS
        elif not snapshot.serial_controls and red in {"on", "off"}:
            red = PACKETS
    return red, green


def led_words(pattern: str) -> str:
    if pattern == PACKETS:
        return tr("flickers")
    kind, _, rate = pattern.rpartition(" ")
    if kind in _FLASHES:
        return tr(_FLASHES[kind]).format(rate.removesuffix("/s"))
    return tr(LED_TEXTS[pattern], "LED")


def state_text(snapshot: DemoSnapshot) -> str:
    if not snapshot.power:
        return tr("The power is off: the board does not reply.")
    if snapshot.boot_mode is not None:
        return tr(BOOT_TEXTS[snapshot.boot_mode])
    if snapshot.serial_controls and not snapshot.safe_start:
        return describe_control(snapshot.mode, True, joint=False)
    mode = tr("RC mode.") if snapshot.mode is Mode.RC else tr("Analog mode.")
    control = tr("The sticks control the motors.")
    return f"{mode} {_safe_start_text(snapshot) if snapshot.safe_start else control}"


def _safe_start_text(snapshot: DemoSnapshot) -> str:
    required = channels_in(snapshot.required if snapshot.mode is Mode.RC else 0)
    missing = [str(number) for number in required if snapshot.channels[number - 1].raw is None]
    if missing:
        text = tr("Safe-start: the motors wait for a signal on input {0}.")
        return text.format(", ".join(missing))
    if snapshot.override:
        return tr("Safe-start: the motors wait until channel 5 no longer requests override.")
    return tr("Safe-start: the motors wait until the sticks are centred.")


def motor_text(motor: DemoMotor) -> str:
    if motor.direction == "brake":
        return f"{tr('brake')} {motor.speed}" if motor.speed else tr("coast")
    return direction_text(motor.speed if motor.direction == "forward" else -motor.speed)


class DemoBoardView(DemoPanelBody[DemoSnapshot]):
    def __init__(self, controller: TrexController, parent: QWidget) -> None:
        board = controller.demo_board
        super().__init__(board, controller, "demoState", state_text, parent)
        tip = tr(
            "Resets everything: stored settings, jumpers, sticks, loads and serial line faults"
        )
        factory = ui.button(self, "demoFactory", tr("Factory state"), icon="reload", tip=tip)
        factory.clicked.connect(board.restore_factory)
        self._drawing = Drawing(board, self)
        self.arrange([self._drawing, _other_rows(board, self)], factory)

    def show_header(self, snapshot: DemoSnapshot | None) -> None:
        self._drawing.show_leds(snapshot)


def _other_rows(board: DemoBoard, parent: QWidget) -> BoardRows:
    rows = BoardRows("", Columns(value="30.0\u00a0V"), parent)
    text, tip = tr("Power on", "state"), tr("The board's power switch")
    power = rows.check_box("demoPower", text, tip, board.set_power, lambda state: state.power)
    tip = tr(
        "Switches the power off for a second. At power-up, the board reads its jumpers "
        "and activates the stored settings"
    )
    cycle = ui.button(rows, "demoPowerCycle", tr("Power cycle"), tip=tip, icon="power")
    cycle.clicked.connect(board.power_cycle)
    volts = LiveLabel("demoBatteryValue", tr("Battery"), rows)
    battery = StickSlider(*_BATTERY, _BATTERY[0], "bar", rows)
    tip = tr("A weak battery sags when the motors start, and the board resets")
    ui.named(battery, "demoBattery", accessible=tr("Battery"), tip=tip)
    battery.positions_per_unit = _STEPS_PER_VOLT
    battery.setSingleStep(5)
    rows.connect_slider(
        battery,
        board.set_battery,
        lambda snapshot: snapshot.battery,
        lambda value: volts.setText(f"{Number(value):.1f}\u00a0V"),
    )
    automatic = rows.check_box(
        "demoAutomatic",
        tr("Move automatically"),
        tr("All sticks swing slowly. A stick that you move stays where you put it."),
        board.set_automatic,
        lambda _snapshot: len(board.automatic) == len(CHANNELS),
    )
    tip = tr("Hold all sticks centred, as safe-start requires")
    centre = ui.button(rows, "demoCentre", tr("Centre"), tip=tip, on_click=board.center_sticks)

    rows.add_wide((power, 1), (cycle, 0))
    rows.add_wide(Muted(tr("Mode is read at power-up; Mix takes effect at once."), rows))
    rows.add_row(tr("Battery"), battery, volts)
    rows.add_wide((automatic, 1), (centre, 0))
    once_tip = tr(
        "The next byte reaches the board with this error, which the Problems page counts. "
        "Only a board with parity detects a parity error."
    )
    framing, parity = (tr("Framing error"), "framing"), (tr("Parity error"), "parity")
    error_tip = tr("An error of the serial line that the board reports")
    add_cable(
        rows,
        board,
        "demo",
        mute=tr("The wire from SO is broken: the board executes commands, but no reply arrives"),
        noise=tr(
            "This percentage of the bytes in each direction is corrupted. CRC detects the errors"
        ),
        faults=(framing, parity, (tr("Overrun"), "overrun")),
        choice=("demoByteError", tr("Error in one byte"), error_tip),
        once=("demoCorrupt", tr("Corrupt one byte"), once_tip),
        cause=board.corrupt,
    )
    return rows


class Drawing(BoardRows):
    def __init__(self, board: DemoBoard, parent: QWidget) -> None:
        super().__init__("", Columns(), parent)
        never_mirror(self)
        ui.named(self, "demoDrawing", accessible=tr("The board"))
        self._demo = board
        self._plugs: list[PlugPart] = []
        self._motion = Animation(self, self._on_frame)
        self._inputs = inputs = ui.grid(margins=0, spacing=(2, 0), stretch=[(0, 1)])
        for channel in CHANNELS:
            self._add_input(channel)
        inputs.addWidget(self._create_cable(), 2 * len(CHANNELS), 0, 1, 3)
        self._leds, self._body = Leds(self, stacked=True), QWidget(self)
        self._fill_body()
        self._motors = {number: self._create_motor(number) for number in (1, 2)}
        above = ui.row((inputs, 1), (self._body, 1), spacing=0)
        self.controls += self._plugs[-1], self._body
        columns = [
            (ui.column(motor, self._create_load(number), spacing=0), 1)
            for number, motor in self._motors.items()
        ]
        picture = ui.column(above, ui.row(*columns, spacing=8), spacing=12)
        self._grid.addLayout(picture, 0, 0, 1, -1)
        follow_theme(self, "space", self._update_space)

    def _update_space(self) -> None:
        line, width = self.fontMetrics().height(), self.fontMetrics().horizontalAdvance
        names = (tr(name).replace("&", "") for name in (*_MIXED, *CHANNEL_NAMES.values()))
        self._inputs.setColumnMinimumWidth(0, max(width(f"5\u2002{name}") for name in names))
        self._inputs.setColumnMinimumWidth(1, width("2100\u00a0µs"))
        for label in self.findChildren(LiveLabel, QRegularExpression("demoLoadValue.")):
            label.setMinimumWidth(width("30.0\u00a0A"))
        for plug in self._plugs:
            plug.setMinimumSize(PLUG_GAP + 12, round(2.7 * line))
        for jumper in self._body.findChildren(JumperPart):
            jumper.setMinimumHeight(2 * line)
        for motor in self._motors.values():
            motor.setMinimumSize(8 * line, round(4.6 * line))
        words = f"{tr('Mode: off')} {tr('Mix: off')} {tr('SO–G: off')}".split(" ")
        self._body.setMinimumWidth(round(3.7 * line) + 20 + text_width(self.font(), *words))
        self._body.setContentsMargins(8, round(2.3 * line), 4, round(1.4 * line))

    def _create_part(
        self, kind: type[PartT], name: str, accessible: str, tip: str, on_click: OnClick
    ) -> PartT:
        return ui.named(kind("", accessible, on_click, self), name, tip=tip)

    def _add_input(self, channel: int) -> None:
        source, board, grid = InputSource.RC, self._demo, self._inputs
        value = LiveLabel(f"demoValue{channel}", tr("Input {0}").format(channel), self)
        slider = StickSlider(0, _TRAVEL, _TRAVEL // 2, "bar", self)
        spoken = tr("Stick of input {0}").format(channel)
        tip = tr(
            "Input {0}: {1}. Double-click to centre the stick, or press Delete to unplug the input."
        )
        tip = tip.format(channel, tr(CHANNEL_ROLES[channel]))
        ui.named(slider, f"demoInput{channel}", accessible=spoken, tip=tip)
        slider.positions_per_unit = _TRAVEL / 100  # one unit is one per cent, for screen readers
        slider.setSingleStep(10)
        slider.setPageStep(_TRAVEL // 10)
        slider.value_label = value
        name = ui.label(self, buddy=slider)
        name.setTextFormat(Qt.TextFormat.RichText)
        plug = self._create_part(
            PlugPart,
            f"demoNoSignal{channel}",
            tr("Plug of input {0}").format(channel),
            tr("Unplug input {0}: an RC input becomes invalid after 0.1 s").format(channel),
            lambda: board.set_silent(channel, not plug.is_out),
        )
        delete = QShortcut(QKeySequence.StandardKey.Delete, slider, plug.click)
        delete.setContext(Qt.ShortcutContext.WidgetShortcut)

        def position(per_cent: float) -> float:
            low, high = STICK_ENDS[source]
            return low + per_cent / 100 * (high - low)

        def read(snapshot: DemoSnapshot) -> float:
            nonlocal source
            source = snapshot.source
            low, high = STICK_ENDS[source]
            if (stick := snapshot.channels[channel - 1].stick(source)) is None:
                return slider.value() * 100 / _TRAVEL
            return (stick - low) / (high - low) * 100

        def show(per_cent: float) -> None:
            decimals = 0 if source is InputSource.RC else 2
            value.setText(f"{Number(position(per_cent)):.{decimals}f}\u00a0{source.unit}")

        def update(snapshot: DemoSnapshot) -> None:
            state = snapshot.channels[channel - 1]
            role = tr(CHANNEL_NAMES[channel])
            if snapshot.jumpers.mix and channel <= len(_MIXED):
                role = tr(_MIXED[channel - 1]).replace("&", "")
            name.setText(f"<b>{channel}</b>\u2002{role}")
            is_in = state.has_signal
            slider.setEnabled(is_in)
            plug.show_plug(tr("plugged in") if is_in else tr("no signal"), out=not is_in)
            if state.stick(source) is None:
                value.setText("–")

        self.connect_slider(
            slider, lambda per_cent: board.hold_stick(channel, position(per_cent)), read, show
        )
        self.on_snapshot(update)
        row = 2 * (channel - 1)
        grid.addWidget(name, row, 0)
        grid.addWidget(value, row, 1, Qt.AlignmentFlag.AlignRight)
        grid.addWidget(slider, row + 1, 0, 1, 2)
        grid.addWidget(plug, row, 2, 2, 1)
        self._plugs.append(plug)
        self.controls += slider, plug

    def _create_cable(self) -> PlugPart:
        tip = tr(
            "If the cable is unplugged, the port disappears. Serial Timeout and UART-Error "
            "Shutdown should then stop the motors"
        )
        plug = self._create_part(
            PlugPart, "demoCable", tr("Cable"), tip, lambda: self._demo.set_plugged(plug.is_out)
        )
        plug.is_labelled, plug.spoken_from = True, 1

        def update(snapshot: DemoSnapshot) -> None:
            is_in = snapshot.line.plugged
            state = tr("plugged in") if is_in else tr("unplugged")
            plug.show_plug(tr("Cable"), state, out=not is_in)

        self.on_snapshot(update)
        self._plugs.append(plug)
        return plug

    def _fill_body(self) -> None:
        board = self._demo
        ui.named(self._leds, "demoLeds", accessible=tr("LEDs of the board"))
        supply = LiveLabel("demoSupply", tr("Supply"), self)
        supply.setAlignment(Qt.AlignmentFlag.AlignCenter)

        def next_mode() -> None:
            if (snapshot := board.snapshot) is not None:
                index = _MODES.index(snapshot.jumpers.mode) + 1
                board.set_mode_jumper(_MODES[index % len(_MODES)])

        jumper = partial(self._create_part, JumperPart)
        tip = tr("The mode jumper, which the board reads at power-up")
        mode = jumper("demoMode", tr("Mode jumper"), tip, next_mode)
        tip = tr(
            "The mix jumper: input 2 drives forward and input 1 turns. A change takes "
            "effect at once"
        )
        mix: JumperPart = jumper(
            "demoMix", tr("Mix jumper"), tip, lambda: board.set_mix(not mix.is_on)
        )
        tip = tr(
            "Connects SO to ground. If the mix jumper is also on, the board learns the "
            "calibration of its inputs at power-up"
        )
        name, switch = tr("SO–G jumper"), board.set_so_ground
        ground: JumperPart = jumper("demoSoGround", name, tip, lambda: switch(not ground.is_on))

        def update(snapshot: DemoSnapshot) -> None:
            text = f"{Number(snapshot.supply):.1f}\u00a0V"
            supply.setText(text if snapshot.power else tr("switched off"))
            jumpers = snapshot.jumpers
            mode_name = {"rc": tr("RC"), "analog": tr("Analog")}.get(jumpers.mode)
            mode_text = tr("Mode: {0}").format(mode_name) if mode_name else tr("Mode: off")
            mode.show_jumper(mode_name is not None, mode_text)
            mix.show_jumper(jumpers.mix, tr("Mix: on") if jumpers.mix else tr("Mix: off"))
            is_on = jumpers.so_ground
            ground.show_jumper(is_on, tr("SO–G: on") if is_on else tr("SO–G: off"))

        self.on_snapshot(update)
        parts = self._leds, 1, mode, mix, ground, 1, supply
        ui.column(*parts, into=self._body, margins=0, spacing=2)

    def _create_motor(self, number: int) -> MotorPart:
        name = tr("Motor {0}").format(number)
        tip = tr("Makes the driver of motor {0} shut down, as when it is hot or shorted").format(
            number
        )
        part = self._create_part(
            MotorPart,
            f"demoFault{number}",
            name,
            tip,
            lambda: self._demo.set_fault(number, not part.alarm),
        )
        part.color = f"motor{number}"

        def update(snapshot: DemoSnapshot) -> None:
            motor = snapshot.motors[number - 1]
            turns = {"forward": 1, "reverse": -1}.get(motor.direction, 0)
            part.show_speed(0 if motor.fault else turns * motor.speed)
            current = f"{Number(motor.current):.1f}\u00a0A"
            fault = (tr("Fault"),) if motor.fault else ()
            part.show_lines(
                name, motor_text(motor), current, *fault, alarm="danger" if fault else ""
            )

        self.on_snapshot(update)
        return part

    def _create_load(self, number: int) -> QLayout:
        spoken = tr("Load of motor {0}").format(number)
        tip = tr(
            "The current that motor {0} draws at full speed. At the right end of the slider, "
            "the motor stalls, which triggers current limits and faults"
        ).format(number)
        value = LiveLabel(f"demoLoadValue{number}", spoken, self)
        slider = StickSlider(0, _STALL_CURRENT * _STEPS_PER_AMPERE, 0, f"motor{number}", self)
        ui.named(slider, f"demoLoad{number}", accessible=spoken, tip=tip)
        slider.positions_per_unit = _STEPS_PER_AMPERE
        slider.setSingleStep(_STEPS_PER_AMPERE // 2)
        slider.setPageStep(2 * _STEPS_PER_AMPERE)
        slider.value_label = value
        self.connect_slider(
            slider,
            partial(self._demo.set_load, number),
            lambda snapshot: snapshot.motors[number - 1].load,
            lambda amperes: value.setText(f"{Number(amperes):.1f}\u00a0A"),
        )
        self.controls += self._motors[number], slider
        label = ui.label(self, text=tr("Load"), buddy=slider)
        return ui.row(label, (slider, 1), value, margins=0, spacing=3)

    # --- Updates ------------------------------------------------------------------------

    def show_leds(self, snapshot: DemoSnapshot | None) -> None:
        if snapshot is None:
            self._leds.show_patterns(("off", "off"))
            return
        red, green = led_patterns(snapshot)
        shown = snapshot.leds.red, snapshot.leds.green
        self._leds.show_patterns(shown, (led_words(red), led_words(green)))

    def show_snapshot(self, snapshot: DemoSnapshot) -> None:
        super().show_snapshot(snapshot)
        self._motion.run(any(motor.speed for motor in self._motors.values()))

    def _on_frame(self, seconds: float) -> None:
        for motor in self._motors.values():
            motor.turn(seconds)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        body, color = QRectF(self._body.geometry()), theme().color
        with Painter(self) as painter:
            painter.setPen(QPen(color("board_edge"), 4))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            starts = []
            for motor in self._motors.values():
                top = QPointF(motor.x() + 2 * self.fontMetrics().height(), motor.y() + 14)
                start = QPointF(max(top.x(), body.left() + 12), body.bottom())
                bend = start + QPointF(0, 7)
                painter.drawPolyline([start, bend, QPointF(top.x(), bend.y()), top])
                starts.append(start)
            paint_body(painter, body, "TReX")
            for start in starts:
                paint_block(painter, QRectF(start.x() - 9, start.y() - 5, 18, 10))
            for plug in self._plugs:
                y = plug.y() + plug.wire_y
                paint_block(painter, QRectF(body.left() - 4, y - 9, 10, 18))
