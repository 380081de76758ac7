"""Page of a robot's problems."""

from collections.abc import Sequence
from datetime import datetime

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import Number, tr
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.model.texts import stuck_text
from trex_gui.devices.aracna.session.messages import LineStats
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.diagnostics.problems import Problem, ProblemsPage, Reading
from trex_gui.ui.help.messages import MessageHelp
from trex_gui.ui.log import Log, LogEntry


class RobotProblemsPage(ProblemsPage):
    """Problems in the log, merged by text. The robot itself reports no error bits."""

    def __init__(self, robot: Robot, log: Log, message_help: MessageHelp, parent: QWidget) -> None:
        super().__init__("aracnaErrors", robot.traffic, parent)
        self._robot, self._log, self._message_help = robot, log, message_help
        self._cleared = dict[str, datetime]()  # text → time of the newest cleared entry
        self._stats: LineStats | None = None  # displayed statistics
        log.added.connect(self.show_problems)
        robot.link_changed.connect(self.refresh)
        robot.changed.connect(self._on_changed)

    @Slot()
    def _on_changed(self) -> None:
        """Refresh if necessary. Replies arrive 30 times a second."""
        if self._robot.state.stats != self._stats:
            self._stats = self._robot.state.stats
            self.refresh()

    def _entries(self) -> dict[str, list[LogEntry]]:
        entries = dict[str, list[LogEntry]]()
        for entry in self._log.entries:
            if entry.is_problem:
                entries.setdefault(entry.text, []).append(entry)
        return entries

    def problems(self) -> Sequence[Problem]:
        ordered = sorted(self._entries().items(), key=lambda item: item[1][-1].time, reverse=True)
        return [self._problem_of(text, entries) for text, entries in ordered]

    def _problem_of(self, text: str, entries: Sequence[LogEntry]) -> Problem:
        title, _, more = text.partition(". ")
        stuck, newest = self._robot.state.stuck, entries[-1].time
        is_active = stuck is not None and text == stuck_text(stuck.motor)
        title = title.removesuffix(".")
        return Problem(
            text,
            tr("{0}, active now").format(title) if is_active else title,
            more,
            self.times_text(len(entries), newest),
            is_active=is_active,
            is_cleared=self._cleared.get(text) == newest,
            page="robot",
            topic=self._message_help.topic(text),
        )

    def clear(self, key: str) -> None:
        self._cleared[key] = self._entries()[key][-1].time
        self.show_problems()

    def since(self) -> datetime | None:
        return self._log.entries[0].time if self._log.entries else None

    def readings(self) -> Sequence[Reading]:
        stats = self._robot.state.stats
        finished = stats.replies + stats.timeouts + stats.corrupted
        answered = f"{Number(100 * stats.replies / max(finished, 1)):.1f} %"
        timeouts = tr("Requests: {0}. Requests without a reply: {1}.")
        readings = (
            Reading(tr("Answered"), answered, timeouts.format(stats.requests, stats.timeouts)),
            Reading(
                tr("Slowest reply"),
                f"{1000 * stats.slowest:.0f} ms",
                tr("Motions are not included"),
            ),
            Reading(tr("Restarts detected"), str(stats.restarts)),
            Reading(tr("Corrupted replies"), str(stats.corrupted)),
            Reading(tr("Unrecognized lines"), str(stats.unrecognized)),
        )
        open_links = {ConnectionState.CONNECTED, ConnectionState.NOT_RESPONDING}
        is_valid = stats.requests > 0 and self._robot.link in open_links
        return readings if is_valid else [reading.unknown() for reading in readings]
