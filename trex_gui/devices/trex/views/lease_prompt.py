"""Questions about who drives a board that several programs use."""

from functools import partial

from PySide6.QtCore import QObject, Slot

from trex_gui.core.translation import tr
from trex_gui.devices.trex.driving.requests import MotorsStopped
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.session.messages import HandOver, TakeLease
from trex_gui.ui.notifier import Answer
from trex_gui.ui.widgets.messages import InlinePrompt


class LeasePrompt(QObject):
    """Prompts the driver to hand over, and an owner to take over."""

    def __init__(self, device: Device, question: InlinePrompt, parent: QObject) -> None:
        super().__init__(parent)
        self._device, self._question = device, question
        self._offered: tuple[str, ...] = ()  # waiting users at the last prompt
        self._waits = False  # this program has asked to drive
        device.lease_changed.connect(self._on_lease_changed)
        device.connection.motors_stopped.connect(self._on_motors_stopped)
        device.connection.line_closed.connect(self._on_line_closed)

    @Slot()
    def _on_lease_changed(self) -> None:
        lease = self._device.board.lease
        if lease is None:
            return
        if lease.is_mine and self._waits:
            self._waits = False
            self._device.notifier.info.emit(tr("You may drive now: arm the motors."))
        if not lease.is_mine:
            self._offered = ()
        elif lease.waiting != self._offered:
            self._offered = lease.waiting
            if lease.waiting:
                self._prompt_to_hand_over(lease.waiting[0])
        self._question.reconsider()

    def _prompt_to_hand_over(self, user: str) -> None:
        def still() -> bool:
            lease = self._device.board.lease
            return lease is not None and lease.is_mine and user in lease.waiting

        text = tr("{0} asks to drive. Handing over stops the motors.").format(user)
        submit = partial(self._device.connection.submit, HandOver(user))
        self._question.prompt(text, Answer("handOver", tr("Hand over"), submit), still=still)

    @Slot(object)
    def _on_motors_stopped(self, report: MotorsStopped) -> None:
        """Offer an owner to take over if arming failed because another user drives."""
        if report.reason is not ErrorCode.OTHER_DRIVES:
            return
        self._waits = True
        lease = self._device.board.lease
        if lease is None or not lease.may_take or lease.is_mine:
            return

        def still() -> bool:
            lease = self._device.board.lease
            return lease is not None and not lease.is_mine and bool(lease.driver)

        text = tr("{0} drives. Taking over stops the motors.").format(lease.driver)
        submit = partial(self._device.connection.submit, TakeLease())
        self._question.prompt(text, Answer("takeOver", tr("Take over"), submit), still=still)

    @Slot()
    def _on_line_closed(self) -> None:
        self._offered, self._waits = (), False
        self._question.reconsider()
