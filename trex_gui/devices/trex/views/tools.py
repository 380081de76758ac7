"""Windows that are created on first use. The workspace imports this module only then."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TypeVar

from trex_gui.devices.trex.model.bench import Bench
from trex_gui.devices.trex.model.boards import BoardList
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.views.bench.dialog import BenchDialog
from trex_gui.devices.trex.views.changes.boards import ApplyToBoardsDialog
from trex_gui.devices.trex.views.check_board import CheckBoardFlow
from trex_gui.devices.trex.views.history_dialog import HistoryDialog
from trex_gui.devices.trex.views.learning.flow import LearnFlow
from trex_gui.devices.trex.views.provision import ProvisionFlow
from trex_gui.devices.trex.views.robots import RobotsDialog
from trex_gui.devices.trex.views.setup.flow import SetupFlow
from trex_gui.devices.trex.views.steps import Flow, Steps
from trex_gui.ui.frame.main_window import MainWindow
from trex_gui.ui.notifier import Remedy

FlowT = TypeVar("FlowT", bound=Flow)


@dataclass
class Tools:
    device: Device
    boards: BoardList
    learning: Learning
    review: Callable[[], object]
    frame: MainWindow

    @cached_property
    def bench(self) -> BenchDialog:
        dialog = BenchDialog(self.device, Bench(self.device, self.frame), self.frame)
        dialog.apply_requested.connect(self.review)
        return dialog

    @cached_property
    def history(self) -> HistoryDialog:
        dialog = HistoryDialog(self.device, self.frame)
        dialog.restore_requested.connect(self.review)
        return dialog

    @cached_property
    def learn(self) -> LearnFlow:
        flow = LearnFlow(self.learning)
        flow.apply_requested.connect(self.review)
        return self._in_dialog(flow)

    @cached_property
    def setup(self) -> SetupFlow:
        flow = SetupFlow(self.device, self.learning)
        flow.apply_requested.connect(self.review)
        return self._in_dialog(flow)

    @cached_property
    def provision(self) -> ProvisionFlow:
        return self._in_dialog(ProvisionFlow(self.device))

    @cached_property
    def robots(self) -> RobotsDialog:
        ports = self.frame.ports

        def connect(url: str) -> None:
            self.frame.connection.connect_to(ports.add_typed(url))

        return RobotsDialog(self.device, connect, ports.set_served, self.frame)

    @cached_property
    def apply_to_boards(self) -> ApplyToBoardsDialog:
        return ApplyToBoardsDialog(self.boards, self.device, self.frame)

    @cached_property
    def check_board(self) -> CheckBoardFlow:
        flow = CheckBoardFlow(self.device)
        flow.find_requested.connect(lambda: self.frame.apply_remedy(Remedy.FIND))
        flow.connect_requested.connect(self.frame.apply_remedy)
        return self._in_dialog(flow)

    def _in_dialog(self, flow: FlowT) -> FlowT:
        Steps(self.device, flow, self.frame)
        return flow
