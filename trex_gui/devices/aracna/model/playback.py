"""A recording of a robot that is played back."""

import math
from collections.abc import Iterable, Sequence
from copy import copy
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PySide6.QtCore import QCoreApplication, QObject

from trex_gui.core.recording.kinds import Marker
from trex_gui.core.recording.store import Recording
from trex_gui.devices.aracna.model.robot_state import RobotState
from trex_gui.devices.aracna.protocol.units import degrees
from trex_gui.devices.aracna.recording import FORMAT, Header, Record, StoppedResponding
from trex_gui.devices.aracna.session.messages import (
    Moved,
    Moving,
    NotResponding,
    Passed,
    PlayEnded,
    StepBegun,
)
from trex_gui.ui.event_log import Event
from trex_gui.ui.playback.player import Curves, RecordingPlayer
from trex_gui.ui.plotting.data.history import SampleHistory
from trex_gui.ui.plotting.data.traces import TraceInfo, Traces

COLORS = ("motor1", "motor2", "good", "dirty", "danger", "muted", "warning", "plot_text")
"""Theme colours of the curves, motor 0 first; each curve has its number, too."""

MAX_ROWS = 2_000_000
"""Rows that are drawn: two hours of a sequence at the robot's highest rate, 144 MB."""

_NO_GAP = math.inf
"""The robot reports positions only while it moves; between motions they do not change."""

_Row = tuple[float, ...]
"""A time (s) and a position for each motor (degrees; NaN if unknown)."""


@dataclass(slots=True)
class Moment:
    """What was known at one time; `step` is `None` while nothing was played."""

    known: RobotState
    step: StepBegun | None = None

    def __copy__(self) -> "Moment":
        return Moment(copy(self.known), self.step)

    def take(self, record: Record) -> None:
        match record:
            case StoppedResponding():
                self.known.take(NotResponding())
                self.step = None
            case StepBegun():
                self.step = record
            case PlayEnded():
                self.step = None
            case Marker():
                pass
            case _:
                self.known.take(record)


class RobotPlayback(RecordingPlayer[Header, Record, Moment]):
    def __init__(
        self,
        recording: Recording[Header, Record],
        parent: QObject | None = None,
        *,
        max_rows: int = MAX_ROWS,
    ) -> None:
        motors = recording.header.motors
        curves = Curves(motors, _rows, max_rows, _NO_GAP)
        super().__init__(recording, Moment(RobotState(motors)), curves, parent)

    @classmethod
    def open(cls, path: Path, parent: QObject | None = None) -> "RobotPlayback":
        """Open a recording and start loading it.

        Raises:
            RecordingError: the file cannot be opened.
        """
        playback = cls(Recording(path, FORMAT), parent)
        playback.start_loading()
        return playback

    def traces_of(self, history: SampleHistory, events: Sequence[Event]) -> Traces:
        return Traces([_trace(motor) for motor in range(self.header.motors)], history, events)


def _trace(motor: int) -> TraceInfo:
    label = QCoreApplication.translate("RobotPlayback", "Motor {0}").format(motor)
    color = COLORS[motor % len(COLORS)]
    return TraceInfo(f"motor_{motor}", label, "°", color, str(motor))


def _rows(moment: Moment, records: Iterable[Record]) -> list[_Row]:
    """Return a row at the start of a motion, for each answer, and for events between motions.

    From the start of a motion to its answer a motor's curve is straight; its real path is unknown.
    """
    rows = list[_Row]()
    motion = list[tuple[int, int]]()  # place of each row of a motion, and how many had answered
    for record in records:
        moment.take(record)
        match record:
            case Moving():
                motion = [(len(rows), 0)]
            case Passed(present=present) if motion:
                motion.append((len(rows), len(present)))
            case Moved() if motion:
                motion.append((len(rows), moment.known.motors))
            case _ if moment.known.moving is not None:
                continue
        positions = (math.nan if each is None else degrees(each) for each in moment.known.present)
        rows.append((record.time, *positions))
        if moment.known.moving is None:
            _straighten(rows, motion)
            motion = []
    return rows


def _straighten(rows: list[_Row], motion: Sequence[tuple[int, int]]) -> None:
    """Draw each motor straight to its own answer."""
    if len(motion) < 3:
        return
    table = np.array([rows[place] for place, _ in motion])
    times = table[:, 0]
    for motor in range(table.shape[1] - 1):
        answer = next((n for n, (_, count) in enumerate(motion) if count > motor), 0)
        ends = table[[0, answer], motor + 1]
        between = slice(1, answer)
        table[between, motor + 1] = np.interp(times[between], times[[0, answer]], ends)
    for (place, _), row in zip(motion, table.tolist(), strict=True):
        rows[place] = tuple(row)
