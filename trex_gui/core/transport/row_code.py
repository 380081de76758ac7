"""Export of traffic rows as source code."""

from collections.abc import Sequence

from trex_gui.core.code import Language, hexadecimal, plain, render
from trex_gui.core.texts import hex_text
from trex_gui.core.transport.traffic import Decoder, Transaction
from trex_gui.version import __version__


def rows_as_code(rows: Sequence[Transaction], decoder: Decoder, language: Language) -> str:
    """Return source code that sends the requests of these rows.

    The code waits for each reply. Line events and unsolicited bytes become comments. If the
    requests may move motors, a comment warns of this.
    """
    line = next((row.settings.line.text() for row in rows if row.settings is not None), "")
    return render(
        f"code/rows{language.suffix}.jinja",
        version=__version__,
        line=plain(line or "the line settings are not known"),
        rows=[_row(row, decoder) for row in rows],
        moves=any(decoder.may_move(row.sent) for row in rows),
    )


def _row(row: Transaction, decoder: Decoder) -> dict[str, object]:
    meaning = plain(decoder.decoded(row).text.replace("→", "->"))
    if not row.sent:
        return {"note": meaning or "-"}
    return {
        "note": "",
        "sent": hex_text(row.sent),
        "bytes": ", ".join(map(hexadecimal, row.sent)),
        "size": len(row.received),
        "received": hex_text(row.received),
        "meaning": meaning,
    }
