"""Comparing a saved traffic log with the simulated board, from the menu."""

from functools import partial
from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QWidget

from trex_gui.core.texts import hex_text
from trex_gui.core.translation import tr
from trex_gui.ui.files import in_background
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.widgets.file_questions import last_folder


def compare_traffic(notifier: Notifier, window: QWidget) -> None:
    """Let the user choose a traffic log and replay it in a thread. Nothing reaches a port."""
    title, kinds = tr("Compare a traffic log"), tr("Text (*.txt *.tsv)")
    path, _ = QFileDialog.getOpenFileName(window, title, str(last_folder()), kinds)
    if path:
        work = partial(_first_difference, Path(path))
        in_background(window, work, partial(_report, notifier), notifier.report_error)


def _report(notifier: Notifier, found: tuple[int, tuple[int, str, str, str] | None]) -> None:
    count, difference = found
    if difference is None:
        text = tr("%n transaction(s): the simulated board replies the same.", "", count)
        notifier.info.emit(text)
        return
    text = tr("First difference, line {0}: {1}. The simulated board: {2} ({3}).")
    notifier.error.emit(text.format(*difference))


def _first_difference(path: Path) -> tuple[int, tuple[int, str, str, str] | None]:
    """Return the number of transactions, and line, meaning, and the simulator's reply in words."""
    from trex_gui.devices.trex.replay import RecordedTraffic  # noqa: PLC0415 - the simulator

    recorded = RecordedTraffic.load(path)
    for row, received in recorded.replayed():
        shown = hex_text(received) or "–"
        before, after = recorded.meaning(row, row.received), recorded.meaning(row, received)
        return len(recorded.rows), (row.line, before, after.rpartition("→ ")[2], shown)
    return len(recorded.rows), None
