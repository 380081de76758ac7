"""Panel of the Demo TReX: a simulated board that is operated like a real one."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import Number, tr, tr_noop
from trex_gui.devices.trex.driving.board_reasons import LED_TEXTS, PACKETS
from trex_gui.devices.trex.model.controller import TrexController
from trex_gui.devices.trex.model.demo import (
    STICK_ENDS,
    BootStep,
    DemoBoard,
    DemoMotor,
    DemoSnapshot,
)
from trex_gui.devices.trex.protocol.descriptions import CHANNEL_ROLES
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, Mode, channels_in
from trex_gui.ui.devices.demo_panel import (
    CableTexts,
    Columns,
    DemoDock,
    DemoPanelBody,
    Rows,
    cable_rows,
)
from trex_gui.ui.widgets.builders import button, named
from trex_gui.ui.widgets.labels import LiveLabel
from trex_gui.ui.widgets.leds import Leds

BoardRows = Rows[DemoSnapshot]

_MAX_LOAD = 30.0  # A, before the stall current is known
_LOWEST, _HIGHEST = 4.0, 16.0  # V; below about 6 a TReX resets
_STEPS = {InputSource.RC: 1, InputSource.ANALOG: 100}  # slider positions per µs, and per V
_SINGLE_STEP = {InputSource.RC: 10, InputSource.ANALOG: 5}
_FLASHES = {  # while the board learns or is in the boot loader
    "blink": tr_noop("blink {0}/s"),
    "alternate": tr_noop("alternate {0}/s"),
    "short flash": tr_noop("short flash {0}/s"),
}


def led_patterns(snapshot: DemoSnapshot) -> tuple[str, str]:
    """Return the patterns of the red and the green LED, steady while packets arrive."""
    red, green = snapshot.leds.red, snapshot.leds.green
    if snapshot.power and snapshot.boot_mode is None:
        if snapshot.serial_controls and green in {"on", "off"}:
            green = PACKETS
        elif not snapshot.serial_controls and red in {"on", "off"}:
            red = PACKETS
    return red, green


def led_words(pattern: str) -> str:
    """Return the words of the Status page, of which only the first has room here."""
    if pattern == PACKETS:
        return tr("flickers")
    kind, _, rate = pattern.rpartition(" ")
    if kind in _FLASHES:
        return tr(_FLASHES[kind]).format(rate.removesuffix("/s"))
    return tr(LED_TEXTS[pattern], "LED")


def led_meaning(snapshot: DemoSnapshot, pattern: str) -> str:
    if not snapshot.power:
        return tr("off: the power is off")
    if snapshot.boot_mode is not None:
        return f"{led_words(pattern)}. {state_text(snapshot)}"
    by_serial = tr("on: serial commands control the motors")
    by_channels = tr("on: the channels control the motors")
    return {
        PACKETS: tr("lit while a packet arrives"),
        "fast flash": tr("fast flash: safe-start, the motors wait"),
        "on": by_serial if snapshot.serial_controls else by_channels,
    }.get(pattern) or led_words(pattern)


def state_text(snapshot: DemoSnapshot) -> str:
    if not snapshot.power:
        return tr("The power is off: the board does not reply.")
    if snapshot.boot_mode is not None:
        return _boot_text(snapshot.boot_mode)
    mode = {
        Mode.RC: tr("RC mode."),
        Mode.ANALOG: tr("Analog mode."),
        Mode.SERIAL_RC: tr("Serial mode."),
        Mode.SERIAL_ANALOG: tr("Serial mode, inputs read as voltages."),
    }[snapshot.mode]
    if snapshot.safe_start:
        doing = _safe_start_text(snapshot)
    elif snapshot.mode.is_serial:
        doing = tr("Serial commands control the motors.")
    elif snapshot.serial_controls:
        doing = tr("Channel 5 hands control to serial commands.")
    else:
        doing = tr("The sticks control the motors.")
    return f"{mode} {doing}"


def _safe_start_text(snapshot: DemoSnapshot) -> str:
    required = channels_in(snapshot.required if snapshot.mode is Mode.RC else 0)
    missing = [str(number) for number in required if snapshot.channels[number - 1].raw is None]
    if missing:
        text = tr("Safe-start: the motors wait for a signal on input {0}.")
        return text.format(", ".join(missing))
    if snapshot.override:
        return tr("Safe-start: the motors wait until channel 5 no longer requests override.")
    return tr("Safe-start: the motors wait until the sticks are centred.")


def _boot_text(step: BootStep) -> str:
    return {
        BootStep.LEARN_READY: tr("Learning: remove the Mix jumper to begin."),
        BootStep.LEARN_WAITING: tr("Learning: waits for a signal on any input."),
        BootStep.LEARN_NEUTRALS: tr("Learning: leave the sticks centred for two seconds."),
        BootStep.LEARN_NEUTRALS_SHOWN: tr("Learning: one flash per input; green is learned."),
        BootStep.LEARN_EXTREMES: tr("Learning: hold each stick at both ends, ten seconds in all."),
        BootStep.LEARN_DONE: tr("Learned; green is good. Remove SO–G, then power cycle."),
        BootStep.UPGRADE_REQUESTED: tr("Boot loader: remove Mix, then SO–G."),
        BootStep.UPGRADE_READY: tr("Boot loader: waits for firmware. Power cycle to leave."),
    }[step]


def jumper_hint(snapshot: DemoSnapshot) -> str:
    """Return what a power cycle would change; empty if nothing."""
    jumpers = snapshot.jumpers
    if snapshot.boot_mode is not None:
        return ""
    when = tr("Power cycle") if snapshot.power else tr("Power on")
    if jumpers.mix and jumpers.so_ground:
        if jumpers.mode == "serial":
            return tr("{0} to start the boot loader.").format(when)
        return tr("{0} to learn the inputs.").format(when)
    if jumpers.mode != snapshot.active_mode_jumper:
        wanted = {"serial": tr("serial"), "rc": tr("RC"), "analog": tr("analog")}
        return tr("{0} to enter {1} mode.").format(when, wanted.get(jumpers.mode, jumpers.mode))
    if jumpers.so_ground:
        return tr("SO–G holds the serial output to ground: no reply gets out.")
    return ""


def motor_text(motor: DemoMotor) -> str:
    """Return what a motor does: `forward 64, 3.1 A`."""
    direction = {
        "forward": tr("forward"),
        "reverse": tr("reverse"),
        "brake": tr("brake") if motor.speed else tr("coast"),
    }.get(motor.direction, motor.direction)
    speed = f" {motor.speed}" if motor.speed else ""
    return f"{direction}{speed}, {Number(motor.current):.1f}\u00a0A"


class DemoPanel(DemoDock):
    def __init__(self, controller: TrexController, parent: QWidget | None = None) -> None:
        super().__init__("demoPanel", "demo_panel/wanted", controller, parent)
        self.setWindowTitle(tr("Demo TReX"))
        self.hold(DemoBoardView(controller, self))


class DemoBoardView(DemoPanelBody[DemoSnapshot]):
    def __init__(self, controller: TrexController, parent: QWidget | None = None) -> None:
        board = controller.demo_board
        super().__init__(board, controller, "demoState", state_text, parent)
        self._leds = named(Leds(self), "demoLeds", accessible=tr("LEDs of the board"))
        tip = tr(
            "Resets everything: stored settings, jumpers, sticks, loads and faults of the line"
        )
        factory = button(self, "demoFactory", tr("Factory state"), icon="reload", tip=tip)
        factory.clicked.connect(board.restore_factory)
        columns = Columns(tr("5 override"), "2100\u00a0µs", (tr("No signal"),))
        makers = (_supply_rows, _input_rows, _motor_rows, _cable_rows)
        self.arrange(self._leds, [make(board, columns, self) for make in makers], factory)

    def show_head(self, snapshot: DemoSnapshot | None) -> None:
        if snapshot is None:
            self._leds.show_patterns(("off", "off"), ("", ""), ("", ""))
            return
        red, green = led_patterns(snapshot)
        words = led_words(red), led_words(green)
        meanings = led_meaning(snapshot, red), led_meaning(snapshot, green)
        self._leds.show_patterns((snapshot.leds.red, snapshot.leds.green), words, meanings)


def _supply_rows(board: DemoBoard, columns: Columns, parent: QWidget) -> BoardRows:
    rows = BoardRows(tr("Power and jumpers"), columns, parent)
    text, tip = tr("Power on", "state"), tr("The board's power switch")
    power = rows.check_box("demoPower", text, tip, board.set_power, lambda seen: seen.power)
    tip = tr("Off for a second: jumpers are read, stored settings take effect")
    cycle = rows.button("demoPowerCycle", tr("Power cycle"), tip, board.power_cycle, icon="power")
    volts = LiveLabel("demoBatteryValue", tr("Battery voltage"), rows)
    battery = rows.slider(
        "demoBattery",
        tr("Battery voltage"),
        highest=_HIGHEST,
        steps=10,
        on_move=board.set_battery,
        read=lambda snapshot: snapshot.battery,
        show=lambda value: volts.setText(f"{Number(value):.1f}\u00a0V"),
        lowest=_LOWEST,
        tip=tr("A weak battery sags when the motors start, and the board resets"),
    )
    battery.setSingleStep(5)
    supply = LiveLabel("demoSupply", tr("Supply"), rows)
    modes = (tr("No jumper: serial"), "serial"), (tr("RC"), "rc"), (tr("Analog"), "analog")
    tip = tr("The mode jumper; the board reads it when power comes on")
    mode = rows.combo_box("demoMode", tr("Mode jumper"), tip, modes)
    mode.activated.connect(lambda index: board.set_mode_jumper(str(mode.itemData(index))))
    tip = tr("The mix jumper: input 2 drives forward, input 1 turns; takes effect at once")
    mix = rows.check_box("demoMix", tr("Mix"), tip, board.set_mix, lambda seen: seen.jumpers.mix)
    tip = tr("Connects SO to ground; with Mix a power-up then learns the inputs' calibration")
    so_ground = rows.check_box(
        "demoSoGround", tr("SO–G"), tip, board.set_so_ground, lambda seen: seen.jumpers.so_ground
    )

    def update(snapshot: DemoSnapshot) -> None:
        text = tr("{0:.1f}\u00a0V at the board").format(Number(snapshot.supply))
        supply.setText(text if snapshot.power else tr("switched off"))
        index = mode.findData(snapshot.jumpers.mode)
        if index != mode.currentIndex() and not mode.view().isVisible():
            mode.setCurrentIndex(index)

    def hint(snapshot: DemoSnapshot) -> tuple[str, bool]:
        text = jumper_hint(snapshot)
        return text or tr("Mode is read at power-up; Mix takes effect at once."), bool(text)

    rows.on_snapshot(update)
    rows.add_wide((power, 1), (cycle, 0))
    rows.add_row(tr("Battery"), battery, volts)
    rows.add_text(supply)
    rows.add_wide((mode, 1))
    rows.add_wide(mix, so_ground)
    rows.note("demoHint", 1, hint)
    return rows


def _input_rows(board: DemoBoard, columns: Columns, parent: QWidget) -> BoardRows:
    rows = BoardRows(tr("Inputs"), columns, parent)
    rows.add_headings("", tr("No signal"))
    for channel in CHANNELS:
        _add_input_row(channel, board, rows)
    automatic = rows.check_box(
        "demoAutomatic",
        tr("Move by themselves"),
        tr("All sticks swing slowly; moving one holds that one"),
        # A click checks a box that is partially checked or unchecked.
        lambda _checked: board.set_automatic(len(board.automatic) < len(CHANNELS)),
    )
    tip = tr("Hold all sticks centred, as safe-start requires")
    centre = rows.button("demoCentre", tr("Centre"), tip, board.centre_sticks)
    centre.setAccessibleName(tr("Centre all sticks"))

    def update(_snapshot: DemoSnapshot) -> None:
        moving = len(board.automatic)
        some = Qt.CheckState.PartiallyChecked if moving else Qt.CheckState.Unchecked
        automatic.setCheckState(Qt.CheckState.Checked if moving == len(CHANNELS) else some)

    rows.on_snapshot(update)
    rows.add_wide((automatic, 1), (centre, 0))
    return rows


def _add_input_row(channel: int, board: DemoBoard, rows: BoardRows) -> None:
    source = InputSource.RC
    value = LiveLabel(f"demoValue{channel}", tr("Input {0}").format(channel), rows)

    def show(position: float) -> None:
        decimals = 0 if source is InputSource.RC else 2
        value.setText(f"{Number(position / _STEPS[source]):.{decimals}f}\u00a0{source.unit}")

    def set_scale() -> None:
        low, high = (round(end * _STEPS[source]) for end in STICK_ENDS[source])
        slider.set_scale(low, high, (low + high) // 2)
        slider.positions_per_unit = _STEPS[source]
        slider.setSingleStep(_SINGLE_STEP[source])
        slider.setPageStep((high - low) // 10)

    def read(snapshot: DemoSnapshot) -> float:
        nonlocal source
        if snapshot.source is not source:
            source = snapshot.source
            set_scale()
        stick = snapshot.channels[channel - 1].stick(source)
        return slider.value() if stick is None else stick * _STEPS[source]

    def update(snapshot: DemoSnapshot) -> None:
        seen = snapshot.channels[channel - 1]
        mixed, separate = (tr("turn"), tr("forward")), (tr("motor 1"), tr("motor 2"))
        first = mixed if snapshot.jumpers.mix else separate
        roles = (*first, tr("auxiliary"), tr("flip"), tr("override"))
        name.setText(f"<b>{channel}</b>\u2002{roles[channel - 1]}")
        slider.setEnabled(seen.has_signal)
        if seen.stick(source) is None:
            value.setText(tr("invalid"))

    tip = tr(
        "Input {0}: {1} in RC and analog mode, only measured in serial mode. "
        "A double click centres it."
    )
    slider = rows.slider(
        f"demoInput{channel}",
        tr("Stick of input {0}").format(channel),
        highest=0,  # until set_scale
        steps=1,
        on_move=lambda position: board.hold_stick(channel, position / _STEPS[source]),
        read=read,
        show=show,
        tip=tip.format(channel, tr(CHANNEL_ROLES[channel])),
    )
    set_scale()
    silent = rows.check_box(
        f"demoNoSignal{channel}",
        "",
        tr("Unplug input {0}: an RC input is invalid 0.1 s later").format(channel),
        lambda checked: board.set_silent(channel, checked),
        lambda snapshot: not snapshot.channels[channel - 1].has_signal,
        accessible=tr("No signal at input {0}").format(channel),
    )
    name = rows.add_row("", slider, value, (silent,))
    rows.on_snapshot(update)


def _motor_rows(board: DemoBoard, columns: Columns, parent: QWidget) -> BoardRows:
    rows = BoardRows(tr("Motors"), columns, parent)
    rows.add_headings(tr("Load"), tr("Fault"))
    for number in (1, 2):
        _add_motor_row(number, board, rows)
    return rows


def _add_motor_row(number: int, board: DemoBoard, rows: BoardRows) -> None:
    steps = 10  # slider positions per ampere
    motor_name = tr("Motor {0}").format(number)
    value = LiveLabel(f"demoLoadValue{number}", tr("Load of motor {0}").format(number), rows)
    state = LiveLabel(f"demoMotor{number}", motor_name, rows)

    def update(snapshot: DemoSnapshot) -> None:
        motor = snapshot.motors[number - 1]
        load.set_scale(0, round(motor.stall * steps), 0)
        state.setText(motor_text(motor))

    rows.on_snapshot(update)  # the scale before the value
    load = rows.slider(
        f"demoLoad{number}",
        tr("Load of motor {0}").format(number),
        highest=_MAX_LOAD,
        steps=steps,
        on_move=lambda amperes: board.set_load(number, amperes),
        read=lambda snapshot: snapshot.motors[number - 1].load,
        show=lambda amperes: value.setText(f"{Number(amperes):.1f}\u00a0A"),
        color=f"motor{number}",
        tip=tr(
            "The current that motor {0} draws at full speed; at the right end it stalls, which "
            "triggers current limits and faults"
        ).format(number),
    )
    load.setSingleStep(steps // 2)
    load.setPageStep(2 * steps)
    fault = rows.check_box(
        f"demoFault{number}",
        "",
        tr("The driver of motor {0} shuts down, as when hot or shorted").format(number),
        lambda checked: board.set_fault(number, checked),
        lambda snapshot: snapshot.motors[number - 1].fault,
        accessible=tr("Driver fault of motor {0}").format(number),
    )
    rows.add_row(motor_name, load, value, (fault,))
    rows.add_text(state)


def _cable_rows(board: DemoBoard, columns: Columns, parent: QWidget) -> BoardRows:
    plugged = tr(
        "Unplugged, the port is gone: Serial Timeout and UART-Error Shutdown should stop motors"
    )
    error_tip = tr("An error of the serial line that the board reports")
    once_tip = tr(
        "The next byte reaches the board with this error; Problems counts it. "
        "Only a board with parity detects a parity error."
    )
    framing, parity = (tr("Framing error"), "framing"), (tr("Parity error"), "parity")
    texts = CableTexts(
        plugged=plugged,
        mute=tr("The wire from SO is broken: the board executes commands, no reply arrives"),
        noise=tr("This share of the bytes is corrupted in either direction; CRC detects them"),
        fault_name=("demoByteError", tr("Error of one byte"), error_tip),
        faults=(framing, parity, (tr("Overrun"), "overrun")),
        once=("demoCorrupt", tr("Corrupt one byte"), once_tip),
    )
    return cable_rows(board, "demo", columns, texts, cause=board.corrupt, parent=parent)
