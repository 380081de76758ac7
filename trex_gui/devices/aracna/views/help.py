"""Help on the Aracna: its pages, the limits of its link, and its keys."""

from collections.abc import Mapping
from html import escape

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication
from PySide6.QtGui import QAction, QKeySequence

from trex_gui.devices.aracna.protocol.commands import BAUD
from trex_gui.ui.frame.workspace import Menus, entries_of

_OF_THE_FRAME = ("connect", "disconnect", "find")

_TEXT = QT_TRANSLATE_NOOP(
    "AracnaHelp",
    """<h3>The pages</h3>
<p><b>Robot</b> shows the robot from above, and for each joint its slider, its limits and what the
servo has reported. Sliders set the goals; <i>Move</i> sends them. With <i>Send while dragging</i>
the robot follows a dragged slider.</p>
<p><b>Poses</b> edits poses and sequences of them with a time for each step, and plays these and the
built-in gaits: once, several times or in a loop.</p>
<p><b>Log</b> lists events and the statistics of the line. <b>Traffic</b> lists every command and
every reply.</p>
<h3>What this robot's link cannot do</h3>
<p>There is <b>no stop and no relax</b>. The red button and Esc end the sequence and send nothing
more; a running motion ends only by itself, or by <b>cutting the servo power</b>. While it moves,
the robot reads nothing. Keep steps short and speeds low.</p>
<p>Positions are known only from the reply to a move, so the first move is slow. A joint is never
sent beyond its limits; legs can still collide with each other.</p>
<h3>Files</h3>
<p>Pose files end in <b>.ppr</b>: open them from the menu <i>Poses</i>, or drop one on the window.
Recordings open in their own windows, which export them to CSV.</p>
<h3>Keys</h3>
{keys}
<h3>The line</h3>
<p>{baud} baud, no error detection, 1 stop bit; the firmware supports no other. A wire to the
board, or a pair of radios on the same channel. On some adapters opening the port resets the board,
which replies about a second later.</p>
<p>Facts about the robot come from the wiki page “Communication Protocol” of 22 September 2012 and
from the firmware published as CreativeMachinesLab/aracna; where they differ, the firmware
counts.</p>""",
)


def help_text(menus: Menus, actions: Mapping[str, QAction]) -> str:
    """Return rich text; keys and names come from the workspace's `menus` and all `actions`."""
    tr = QCoreApplication.translate
    esc = tr("AracnaHelp", "End the sequence and send nothing more; works in every window")
    rows = [(tr("AracnaHelp", "Esc"), esc)]
    mine = [entry for entry in entries_of(menus) if entry.shortcut]
    rows += [_row(QKeySequence(entry.shortcut), entry.text) for entry in mine]
    rows += [_row(actions[key].shortcut(), actions[key].text()) for key in _OF_THE_FRAME]
    cells = "".join(
        f"<tr><td><b>{escape(key)}</b>&nbsp;&nbsp;</td><td>{escape(what)}</td></tr>"
        for key, what in rows
    )
    keys = f"<table cellspacing='3'>{cells}</table>"
    return tr("AracnaHelp", str(_TEXT)).format(keys=keys, baud=BAUD)


def _row(keys: QKeySequence, text: str) -> tuple[str, str]:
    native = keys.toString(QKeySequence.SequenceFormat.NativeText)
    return native, text.replace("&", "").removesuffix("…")
