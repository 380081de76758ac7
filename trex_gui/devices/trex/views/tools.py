"""Windows beside the pages. This module is imported when the first of them is opened."""

from functools import cached_property

from PySide6.QtCore import QObject

from trex_gui.devices.trex.model.bench import Bench
from trex_gui.devices.trex.model.boards import BoardList
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.views.bench.dialog import BenchDialog
from trex_gui.devices.trex.views.changes.boards import ApplyToSeveral
from trex_gui.devices.trex.views.changes.review import Review
from trex_gui.devices.trex.views.check_board import CheckBoardFlow
from trex_gui.devices.trex.views.history_dialog import HistoryDialog
from trex_gui.devices.trex.views.setup.flow import SetupFlow
from trex_gui.devices.trex.views.steps import Steps
from trex_gui.ui.frame.main_window import MainWindow
from trex_gui.ui.notifier import Remedy


class Tools(QObject):
    """The windows; each is created when it is first opened, and then reused."""

    def __init__(
        self,
        device: Device,
        boards: BoardList,
        learning: Learning,
        review: Review,
        frame: MainWindow,
    ) -> None:
        super().__init__(frame)
        self._device = device
        self._boards = boards
        self._learning = learning
        self._review = review
        self._frame = frame

    @cached_property
    def bench(self) -> BenchDialog:
        dialog = BenchDialog(self._device, Bench(self._device, self), self._frame)
        dialog.apply_requested.connect(self._review.review)
        return dialog

    @cached_property
    def history(self) -> HistoryDialog:
        dialog = HistoryDialog(self._device, self._frame)
        dialog.restore_requested.connect(self._review.review)
        return dialog

    @cached_property
    def setup(self) -> SetupFlow:
        flow = SetupFlow(self._device, self._learning)
        flow.apply_requested.connect(self._review.review)
        Steps(self._device, flow, self._frame)
        return flow

    @cached_property
    def apply_to_boards(self) -> ApplyToSeveral:
        return ApplyToSeveral(self._boards, self._device, self._frame)

    @cached_property
    def check_board(self) -> CheckBoardFlow:
        flow = CheckBoardFlow(self._device)
        flow.find_requested.connect(lambda: self._frame.apply_remedy(Remedy.FIND))
        flow.connect_requested.connect(self._frame.apply_remedy)
        Steps(self._device, flow, self._frame)
        return flow
