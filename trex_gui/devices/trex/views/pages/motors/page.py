"""Page for driving both motors and the auxiliary by hand."""

from functools import partial
from html import escape

from PySide6.QtCore import QEvent, QSize, Qt, Signal, Slot
from PySide6.QtGui import QHideEvent, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QBoxLayout, QSizePolicy, QWidget

from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.board.drive_status import (
    AUXILIARY,
    DriveInputs,
    SetpointSource,
    drive_statuses,
)
from trex_gui.devices.trex.driving.blockers import DriveBlocker
from trex_gui.devices.trex.driving.timeout_stop import TimeoutStop
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import drive_inputs, setpoint_of
from trex_gui.devices.trex.model.drive_texts import (
    limit_text,
    percent_text,
    report_text,
    setpoint_text,
    timeout_warning,
)
from trex_gui.devices.trex.model.group import BoardGroup
from trex_gui.devices.trex.model.momentary_drive import MomentaryDrive
from trex_gui.devices.trex.model.setup.wiring import Side
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.views.group import GroupCards
from trex_gui.devices.trex.views.motor_controls import LostPanel, focus_stop
from trex_gui.devices.trex.views.pages.motors.current_strip import CurrentStrip
from trex_gui.devices.trex.views.pages.motors.drive_control import DriveControl
from trex_gui.devices.trex.views.pages.motors.drive_pad import DrivePad
from trex_gui.devices.trex.views.pages.motors.key_driver import KeyDriver
from trex_gui.devices.trex.views.pages.motors.options import DriveWith, Options, SpeedCeiling
from trex_gui.ui.runtime import new_timer
from trex_gui.ui.theme.theme import set_look, theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.bar import NO_VALUE, WARNING_SIGN
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.labels import PAGE_MARGINS, LinkLabel, PageHead

_UNLIMITED = 16_777_215  # QWIDGETSIZE_MAX in C++
_NO_ALIGNMENT = Qt.AlignmentFlag(0)
_GAP = 8  # pixels between cards


class MotorsPage(QWidget):
    """Page for driving armed motors. Leaving it while a control is held stops the motors."""

    parameter_requested = Signal(str)  # key of the parameter to show
    plot_requested = Signal()

    def __init__(self, device: Device, group: BoardGroup, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("motorsPage")
        self._group = group
        self._device = device
        self._motors = device.motors
        self._pad_drive = MomentaryDrive(device.motors, "drive pad")
        self._key_drive = MomentaryDrive(device.motors, "keyboard")
        self._holder = ""
        self._dragged: int | None = None
        self._is_frozen, self._frozen_area = False, QSize()
        self._holder_timer = new_timer(self, 0, self._on_event_handled, single_shot=True)

        self._head = PageHead("", self)
        ui.named(self._head.title, "motorsReason")
        self._drive_box = drive_box = QWidget(self)
        pad_card = ui.Card("", drive_box)
        self._pad = DrivePad(pad_card)
        self._lost = LostPanel(device, "motorsLost", pad_card)
        ignored = QSizePolicy.Policy.Ignored
        self._lost.setSizePolicy(ignored, ignored)
        self._controls = {
            1: DriveControl(tr("Motor 1"), "motor1", drive_box),
            2: DriveControl(tr("Motor 2"), "motor2", drive_box),
            AUXILIARY: DriveControl(tr("Auxiliary"), "aux", drive_box, two_way=False),
        }
        self._side = side = QWidget(self)
        title = f"{tr('Motor currents')}, 10 s"
        currents = ui.named(ui.Card("", side), "currentsCard", accessible=title)
        self._strip = CurrentStrip(device, currents)
        plot = ui.button(currents, "openPlot", tr("&Open plot"), on_click=self.plot_requested)
        set_look(plot, "link")
        self._options = Options(device.motors, side)
        self._options.hide()
        self._drive_with = DriveWith(device, side)
        stored = ui.Card(tr("How the board applies commands"), self)
        self._stored = LinkLabel("motorsStored", stored)
        self._stored.setAlignment(Qt.AlignmentFlag.AlignTop)
        ceiling = SpeedCeiling(device.motors, stored)
        self._keys = KeyDriver(self._key_drive, device.motors, self, self._pad)

        layers = ui.grid(pad_card, margins=0)
        layers.addWidget(self._pad, 0, 0)
        layers.addWidget(self._lost, 0, 0)
        controls = ((control, 1) for control in self._controls.values())
        ui.row((pad_card, 4), *controls, into=drive_box, margins=0, spacing=_GAP)
        heading = ui.row((ui.label(currents, text=title, size="heading"), 1), plot)
        ui.column(heading, (self._strip, 1), into=currents, margins=0, spacing=0)
        cards = (currents, 1), (self._options, 1), self._drive_with
        self._beside = ui.column(*cards, into=side, margins=0, spacing=_GAP)
        ui.row((self._stored, 3), (ceiling, 2), into=stored, margins=0, spacing=24)
        self._body = ui.grid(margins=0, spacing=(_GAP, _GAP), stretch=((0, 5), (1, 2)))
        self._body.setRowStretch(0, 1)
        parts = self._head, GroupCards(group, self), (self._body, 1), stored
        ui.column(*parts, into=self, margins=PAGE_MARGINS, spacing=_GAP)
        self._place_side()

        for number, control in self._controls.items():
            control.speed_requested.connect(partial(self._on_speed_requested, number))
            control.brake_requested.connect(partial(self._on_brake_requested, number))
            control.slider.grabbed.connect(partial(self._on_grabbed, number))
            control.slider.released.connect(partial(self._on_released, number))
        self._pad.steered.connect(self._on_pad_steered)
        self._pad.released.connect(self._pad_drive.release)
        self._drive_with.keys.toggled.connect(self._keys.set_enabled)
        self._drive_with.more.toggled.connect(self._options.setVisible)
        self._drive_with.more.toggled.connect(currents.setHidden)
        self._stored.linkActivated.connect(self.parameter_requested)
        motors = self._motors
        motors.holder_changed.connect(self._on_holder_changed)
        motors.setpoints_changed.connect(self._show_setpoints)
        motors.arming_changed.connect(self._update_freeze)
        for signal in (motors.arming_changed, motors.options_changed, device.link_changed):
            signal.connect(self._show_options)
        motors.stop_requested.connect(self._on_stop_requested)
        device.link_changed.connect(self._show_stored)
        device.state_changed.connect(self._on_state_changed)
        group.changed.connect(self._on_state_changed)
        theme().changed.connect(self._on_state_changed)
        device.telemetry.frame_due.connect(self._on_frame_due)
        device.telemetry.text_due.connect(self._on_text_due)
        self._on_state_changed()

    # --- Layout -------------------------------------------------------------------------

    def minimumSizeHint(self) -> QSize:
        hint = super().minimumSizeHint()
        return QSize(self._drive_box.minimumSizeHint().width() + 32, hint.height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place_side()
        if self._is_frozen and self._scroll_area_size() != self._frozen_area:
            self._set_frozen(frozen=False)  # the next frame freezes the layout again

    def _scroll_area_size(self) -> QSize:
        viewport = self.parentWidget()
        area = viewport.parentWidget() if viewport is not None else None
        return self.size() if area is None else area.size()

    def _place_side(self) -> None:
        cards = self._options, self._drive_with
        side_width = max(card.minimumSizeHint().width() for card in cards)
        wide = self.width() >= self.minimumSizeHint().width() + _GAP + side_width
        direction = QBoxLayout.Direction.TopToBottom if wide else QBoxLayout.Direction.LeftToRight
        if not self._body.count() or direction is not self._beside.direction():
            self._beside.setDirection(direction)
            self._side.setMinimumWidth(side_width if wide else 0)
            alignment = Qt.AlignmentFlag.AlignTop if self._is_frozen else _NO_ALIGNMENT
            self._body.addWidget(self._drive_box, 0, 0, 1, 1 if wide else 2, alignment)
            self._body.addWidget(self._side, *((0, 1, 1, 1) if wide else (1, 0, 1, 2)))

    @Slot()
    def _update_freeze(self) -> None:
        """Freeze the layout while the motors are armed, so that no control moves."""
        frozen, area = self._motors.armed and self.isVisible(), self._scroll_area_size()
        is_shrinking = self.height() > max(area.height(), self.minimumSizeHint().height())
        if frozen is not self._is_frozen and not (frozen and is_shrinking):
            self._set_frozen(frozen=frozen)

    def _set_frozen(self, *, frozen: bool) -> None:
        box = self._drive_box
        self._is_frozen, self._frozen_area = frozen, self._scroll_area_size()
        if (layout := self.layout()) is not None:
            layout.activate()  # the layout is still pending after a show or resize event
        height = box.height()
        box.setMinimumHeight(height if frozen else 0)
        box.setMaximumHeight(height if frozen else _UNLIMITED)
        self._body.setAlignment(box, Qt.AlignmentFlag.AlignTop if frozen else _NO_ALIGNMENT)

    # --- User actions -------------------------------------------------------------------

    def _on_speed_requested(self, number: int, speed: int) -> None:
        holder = _holder_name(number) if self._motors.holder == _holder_name(number) else ""
        if number == AUXILIARY:
            self._motors.set_auxiliary(speed, holder)
        else:
            self._motors.set_speed(number, speed, holder)
        self._show_setpoints()  # the slider must not show a rejected speed

    def _on_brake_requested(self, number: int) -> None:
        self._motors.set_brake(number, self._motors.release_brake)

    def _on_grabbed(self, number: int) -> None:
        self._dragged = number
        if self._options.return_to_zero.isChecked():
            self._motors.acquire(_holder_name(number))

    def _on_released(self, number: int) -> None:
        self._holder_timer.start()
        self._motors.release(_holder_name(number))
        self._show_setpoints()

    @Slot(float, float)
    def _on_pad_steered(self, forward: float, turn: float) -> None:
        if not self._pad_drive.steer(forward, turn):
            self._pad.release()

    @Slot()
    def _on_stop_requested(self) -> None:
        for control in self._controls.values():
            control.release()
        self._pad.release()

    @Slot()
    def _on_state_changed(self) -> None:
        joint = self._device.board.is_joint and not self._group.wheels
        for drive in (self._pad_drive, self._key_drive):
            drive.joint = joint
        titles = (tr("Left"), tr("Right")) if self._group.wheels else (tr("Motor 1"), tr("Motor 2"))
        self._controls[1].set_title(tr("Motor (joint)") if joint else titles[0])
        self._controls[2].set_title(titles[1])
        self._show_stored()
        self._show_options()

    @Slot()
    def _show_stored(self) -> None:
        device, is_connected = self._device, self._device.is_connected
        facts = _stored_facts(device)
        self._stored.setText(_table(facts, linked=is_connected))
        self._stored.setEnabled(is_connected)
        self._stored.setAccessibleName("" if facts else NO_VALUE)
        warning = timeout_warning(device)
        self._stored.setToolTip("" if warning is None else ui.plain(warning.text))
        sentences = [f"{title}: {', '.join(texts)}" for title, texts in facts.items()]
        sentences += [] if warning is None else [warning.text]
        self._stored.setAccessibleDescription(". ".join(sentences))

    @Slot()
    def _on_holder_changed(self) -> None:
        """Save the holder for `hideEvent`. Controls lose their hold before `hideEvent` runs."""
        own = {self._pad_drive.name, self._key_drive.name, *map(_holder_name, self._controls)}
        if self._motors.holder in own:
            self._holder = self._motors.holder
        elif self._holder:
            self._holder_timer.start()
        if self._pad.held and not self._pad_drive.held:
            self._pad.release()

    # --- Displays -----------------------------------------------------------------------

    @Slot()
    def _show_options(self) -> None:
        motors = self._motors
        focused = self.window().focusWidget()
        group = focused.parentWidget() if focused is not None else None
        is_driving = focused is self._pad or isinstance(group, DriveControl)
        if not motors.armed and is_driving:
            focus_stop(self)  # otherwise Qt would focus a link, and arrow keys would open pages
        self._pad.setEnabled(motors.armed)
        self._pad.set_can_turn(self._pad_drive.can_turn)
        brake = tr("Brake with {0}").format(percent_text(motors.release_brake))
        for number, control in self._controls.items():
            control.set_usable(motors.armed and not self._is_unused(number))
            control.brake.setToolTip(ui.plain(brake))
        self._show_setpoints()
        self._on_text_due()

    def _is_unused(self, number: int) -> bool:
        return number == 2 and self._device.board.is_joint and not self._group.wheels

    @Slot()
    def _show_setpoints(self) -> None:
        inputs = drive_inputs(self._device)
        board = inputs.board if inputs.link is None else None
        by_channels = board is not None and not board.by_serial
        ceiling = FULL_SCALE if by_channels else self._motors.ceiling
        self._pad.set_ceiling(ceiling)
        speeds = []
        for number, control in self._controls.items():
            control.set_ceiling(ceiling)
            speed, text = self._setpoint_of(number, inputs)
            control.show_setpoint(speed, text)
            if number != AUXILIARY:
                side = Side.LEFT if number == 1 else Side.RIGHT
                speeds.append(speed)
                motor = 1 if self._is_unused(number) else number
                turns = 0 if board and motor in board.shut_down else speed
                self._pad.show_wheel(side, turns / FULL_SCALE, f"motor{motor}")
        self._pad.show_setpoints(*speeds)

    def _setpoint_of(self, number: int, inputs: DriveInputs) -> tuple[int, str]:
        telemetry, setpoint = self._device.telemetry, setpoint_of(self._device, number, inputs)
        if self._group.wheels and number != AUXILIARY and inputs.armed:  # here `number` is a side
            drive = self._motors.drive(number)
            return drive.signed if drive else 0, setpoint_text(drive)
        match setpoint.source:
            case SetpointSource.JOINT:
                return self._setpoint_of(1, inputs)[0], tr("works with motor 1")
            case SetpointSource.SAFE_START:
                return 0, tr("held by safe-start")
            case SetpointSource.CHANNEL if telemetry.raw and telemetry.raw_of(number) is None:
                return 0, tr("no signal")
            case SetpointSource.SERIAL if number != AUXILIARY:
                return setpoint.speed, setpoint_text(self._motors.drive(number))
            case SetpointSource.SERIAL | SetpointSource.CHANNEL | SetpointSource.OTHER_DRIVER:
                return setpoint.speed, percent_text(setpoint.speed)
        return 0, "" if setpoint.source is SetpointSource.NOT_ARMED else NO_VALUE

    @Slot()
    @only_when_visible
    def _on_frame_due(self) -> None:
        self._update_freeze()
        self._show_setpoints()
        self._strip.draw_if_due()

    @Slot()
    @only_when_visible
    def _on_text_due(self) -> None:
        device = self._device
        self._show_status()
        board = drive_inputs(device).board
        currents = dict(enumerate(device.telemetry.motor_currents or (), 1))
        is_sensed = device.is_connected and not device.board.is_joint
        for number, control in self._controls.items():
            report = "" if self._is_unused(number) else report_text(device, number)
            default_text = tr("one way") if number == AUXILIARY else limit_text(device, number)
            amps = currents.get(number) if is_sensed else None
            if self._group.wheels and number != AUXILIARY:  # the group cards show these values
                amps, report, default_text = None, "", ""
            is_off = board is not None and number in board.shut_down
            limit = device.current_limit(number)
            control.show_current(amps, limit, report or default_text, alarming=is_off)
        self._strip.draw()

    def _show_status(self) -> None:
        first, *others = drive_statuses(drive_inputs(self._device))
        title = first.text
        if first.blocker is DriveBlocker.RUNNING:
            title = tr("Armed: these controls move the motors.")
        details = " ".join(filter(None, (first.remedy, *(status.text for status in others))))
        self._head.show_title(title)
        self._head.show_state(details)
        self._head.title.setAccessibleName(f"{title} {details}")
        self._lost.show_loss(f"{first.text} {first.remedy}".strip())

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._show_options()

    def hideEvent(self, event: QHideEvent) -> None:
        """Stop the motors if a control is held or dragged, or if `stop_on_leaving` is checked."""
        is_dragged = self._dragged is not None and self._motors.armed
        self._dragged = None
        if self._holder or is_dragged:
            self._motors.stop(tr("The Motors page was left while a control was held."))
        elif self._options.stop_on_leaving.isChecked() and self._motors.armed:
            self._motors.stop(tr("The Motors page was left."))
        super().hideEvent(event)
        self._update_freeze()

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.ActivationChange and self.isActiveWindow():
            self._holder_timer.start()
        super().changeEvent(event)

    @Slot()
    def _on_event_handled(self) -> None:
        sliders = [control.slider for control in self._controls.values()]
        if self.isActiveWindow() and not any(slider.held for slider in sliders):
            self._dragged = None
        if self._motors.holder != self._holder:
            self._holder = ""


def _holder_name(number: int) -> str:
    return "auxiliary slider" if number == AUXILIARY else f"motor {number} slider"


_Facts = dict[str, dict[str, str]]

_SILENCE = {
    TimeoutStop.EXPECTED: tr_noop("stop after {0}"),
    TimeoutStop.TRIED: tr_noop("stop after {0}"),
    TimeoutStop.DOUBTFUL: tr_noop("may keep turning"),
}


def _stored_facts(device: Device) -> _Facts:
    """Return the stored settings: title → text of each value → key of its parameter."""
    values, motors = device.parameters.values, (1,) if device.board.is_joint else (1, 2)

    def both(name: str) -> dict[str, str]:
        texts: dict[str, str] = {}
        for key in (f"motor{motor}_{name}" for motor in motors):
            if (wire := values.stored.get(key)) is not None:
                texts.setdefault(values.specs[key].text(wire), key)
        return texts

    silence: dict[str, str] = {}
    if (wire := values.stored.get(key := ParameterKey.SERIAL_TIMEOUT)) is not None:
        stop = device.board.timeout_stop
        text = tr(_SILENCE.get(stop, tr_noop("keep turning"))).format(values.specs[key].text(wire))
        silence[text if stop.is_reliable else f"{text} {WARNING_SIGN}"] = key
    facts = {
        tr("Ramp"): both("acceleration"),
        tr("Brake before reversal"): both("brake_duration"),
        tr("Current limit"): both("current_limit"),
        tr("If the cable fails"): silence,
    }
    return {title: texts for title, texts in facts.items() if texts}


def _table(facts: _Facts, *, linked: bool) -> str:
    """Return HTML with titles above values. If `linked`, each value links to its parameter."""

    def link(text: str, key: str) -> str:
        color = theme().color("warning" if WARNING_SIGN in text else "link").name()
        style = f"color:{color}; text-decoration:none"
        return f'<a href="{key}" style="{style}">{escape(text)}</a>' if linked else escape(text)

    cell = '<td style="padding-right:28px; white-space:pre; {0}">{1}</td>'
    titles = "".join(cell.format("", f"<small>{escape(title)}</small>") for title in facts)
    texts = (" · ".join(link(*value) for value in values.items()) for values in facts.values())
    row = "".join(cell.format("font-weight:600", text) for text in texts)
    muted = theme().color("muted").name()
    rows = f'<tr style="color:{muted}">{titles}</tr><tr>{row}</tr>'
    return f'<table cellspacing="0" width="100%">{rows}</table>'
