"""Change values in a settings file without reformatting its text.

A round trip through ruamel.yaml preserves comments and order, but not spaces around colons,
margins, plus signs, comments after `...`, line ends, or the layout of mappings in braces that span
several lines. Therefore, the text is edited at the positions of ruamel.yaml's nodes.
"""

import re
from bisect import bisect_right
from collections import defaultdict
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass

from ruamel.yaml.nodes import MappingNode, Node

from trex_gui.core.files import SettingsError
from trex_gui.core.translation import in_english, tr
from trex_gui.devices.trex.protocol.calibration import CALIBRATION_KEYS
from trex_gui.devices.trex.protocol.parameters import ParameterKind
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.notes import lines_of_note, noted_key
from trex_gui.devices.trex.settings.reader import BYTE_ORDER_MARK, read_settings
from trex_gui.devices.trex.settings.writer import (
    calibration_line,
    calibration_text,
    check_keys,
    parameter_line,
    parameter_text,
    plain_text,
)
from trex_gui.devices.trex.settings.yaml_subset import LINE_END, compose

_MIN_GAP = 2  # spaces between a value and its comment


def amend(text: str, settings: Settings, name: str = "settings") -> str:
    """Change the text of a settings file to `settings`. `name` is the file name for errors.

    - Changed values are replaced in place and retain their number base.
    - A comment beside a value is updated if the program wrote it. Comments by the user do not
      change.
    - Notes are changed in place. New notes are inserted above their settings.
    - Missing settings are appended.
    - Removed settings, and values that the board would reject, become comments.
    - Line ends and a byte order mark are retained.
    - A text that already contains the settings does not change.
    - If the file is a single mapping in braces, only values can change.

    Raises:
        SettingsError: the text cannot be read, or cannot be changed in place.
        BadRequest: the settings contain a key that their model and firmware do not have.
    """
    check_keys(settings)
    old, _ = read_settings(text, name)
    target = settings.without_invalid()
    mark = BYTE_ORDER_MARK if text.startswith(BYTE_ORDER_MARK) else ""
    document = _Document(text.removeprefix(BYTE_ORDER_MARK), name)
    with in_english():
        _change_entries(document, old, target)
        unplaced = _change_notes(document, old.notes, target.notes)
        document.append(list(_missing_lines(document, settings, unplaced)))
    amended = mark + document.text()
    if (amended != text or target != old) and not _reads_as(target, amended):
        raise SettingsError.of(
            name,
            tr(
                "the layout of this file cannot be changed in place; save the settings as a "
                "new file"
            ),
        )
    return amended


def _reads_as(settings: Settings, text: str) -> bool:
    try:
        return read_settings(text)[0] == settings
    except SettingsError:
        return False


@dataclass(frozen=True, slots=True)
class _Entry:
    start: int  # position of the first character of a setting
    end: int  # position after its last character
    value: Node


class _Document:
    """Text of a settings file, with the changes collected so far."""

    def __init__(self, body: str, name: str) -> None:
        self.body = body
        self.root = compose(body, name)
        self.entries: dict[str, _Entry] = {}
        for key, value in self.root.value:
            start, end = key.start_mark.index, _end_of(value)
            last = start + len(body[start:end].rstrip())
            self.entries[str(key.value)] = _Entry(start, last, value)
        self._line_starts = [0, *(line_end.end() for line_end in LINE_END.finditer(body))]
        self._line_ends = [*self._line_starts[1:], len(body)]
        # Edits by line number: start column, end column and replacement.
        self._edits: dict[int, list[tuple[int, int, str]]] = defaultdict(list)
        self._comments: dict[int, str] = {}  # line number → new comment
        self._insertions: dict[int, str] = {}  # line number → text to insert before it
        self._removed: set[int] = set()  # numbers of removed lines
        self.notes: dict[str, list[int]] = defaultdict(list)  # key → line numbers of its note
        for number, line in enumerate(LINE_END.split(self.body)):
            if key := noted_key(line):
                self.notes[key].append(number)

    def text(self) -> str:
        """Return the changed text. A comment stays in its column if there is enough space."""
        parts = []
        for number in range(len(self._line_starts)):
            old, gap, comment, end = self._parts(number)
            code = old
            for first, last, new in sorted(self._edits[number], reverse=True):
                code = code[:first] + new + code[last:]
            if comment and len(code) != len(old):
                space = len(gap) + len(old) - len(code)
                gap = " " * max(min(_MIN_GAP, len(gap)), space)
            line = "".join([code, gap, self._comments.get(number, comment), end])
            parts += [self._insertions.get(number, ""), "" if number in self._removed else line]
        return "".join([*parts, self._insertions.get(len(self._line_starts), "")])

    def replace(self, node: Node, old: str, new: str) -> None:
        start = self.body.find(old, node.start_mark.index, node.end_mark.index)
        if old != new and start >= 0:
            self._edit(start, start + len(old), new)

    def set_number(self, node: Node, wire: int) -> None:
        start, end = node.start_mark.index, node.end_mark.index
        old = self.body[start:end]
        if int(old, 0) != wire:
            self._edit(start, end, _spelled_like(old, wire))

    def update_comment(self, key: str, old: Collection[str], new: str) -> None:
        """Replace the comment beside a setting if its text is in `old`."""
        if new in old:
            return
        for number in self._lines_of(self.entries[key]):
            code, _, comment, _ = self._parts(number)
            line_end = self._line_starts[number] + len(code)
            is_last = not any(
                self.entries[key].start < entry.start < line_end for entry in self.entries.values()
            )
            if code and is_last and comment.removeprefix("# ") in old and comment:
                self._comments[number] = f"# {new}"

    def comment_out(self, key: str) -> None:
        for number in self._lines_of(self.entries[key]):
            if self._parts(number)[0]:
                self._edit(self._line_starts[number], self._line_starts[number], "# ")

    def append(self, lines: list[str]) -> None:
        if not lines:
            return
        line_end, margin = self._line_end, " " * self.root.start_mark.column
        text = line_end.join(margin + line for line in lines)
        ends = [
            n for n, start in enumerate(self._line_starts) if self.body.startswith("...", start)
        ]
        number = ends[-1] if ends else len(self._line_starts)
        has_line_end = bool(ends) or self._line_starts[-1] == len(self.body)
        text = text + line_end if has_line_end else line_end + text
        self._insertions[number] = self._insertions.get(number, "") + text

    def set_note(self, key: str, lines: list[str]) -> bool:
        """Replace a note, or insert it above its setting. An empty list removes it.

        Returns False if the text does not contain the setting.
        """
        old = self.notes.get(key, [])
        self._removed.update(old)
        if not lines:
            return True
        if not old and key not in self.entries:
            return False
        number = old[0] if old else self._line_at(self.entries[key].start)
        start = self._line_starts[number]
        indented = self.body[start:]
        margin = indented[: len(indented) - len(indented.lstrip(" "))]
        text = "".join(margin + line + self._line_end for line in lines)
        self._insertions[number] = self._insertions.get(number, "") + text
        return True

    @property
    def _line_end(self) -> str:
        """First line end of the text if it is CR, LF or CRLF. Otherwise, LF."""
        end = LINE_END.search(self.body)
        return end[0] if end and end[0] in {"\r\n", "\n", "\r"} else "\n"

    def _edit(self, start: int, end: int, new: str) -> None:
        number = self._line_at(start)
        offset = self._line_starts[number]
        self._edits[number].append((start - offset, end - offset, new))

    def _line_at(self, position: int) -> int:
        return bisect_right(self._line_starts, position) - 1

    def _lines_of(self, entry: _Entry) -> range:
        return range(self._line_at(entry.start), self._line_at(entry.end - 1) + 1)

    def _parts(self, number: int) -> tuple[str, str, str, str]:
        """Return the code, gap, comment and line end of a line.

        In a valid settings file, no key or value contains a `#`.
        """
        line = self.body[self._line_starts[number] : self._line_ends[number]]
        before, sign, text = line.partition("#")
        code, comment = before.rstrip(), (sign + text).rstrip()
        gap = before[len(code) :]
        return code, gap, comment, line[len(before) + len(comment) :]


def _end_of(node: Node) -> int:
    """Return the position after a node, or after the last value of a block mapping."""
    if isinstance(node, MappingNode) and not node.flow_style:
        return _end_of(node.value[-1][1])
    return int(node.end_mark.index)


def _spelled_like(old: str, wire: int) -> str:
    """Return `wire` in the number format of `old`. If `old` is `0x0f`, 123 becomes `0x7b`."""
    if old[:2] not in {"0x", "0X"}:
        return f"+{wire}" if old.startswith("+") else str(wire)
    digits = old[2:]
    letters = "x" if re.search("[a-f]", digits) else "X"
    return f"{old[:2]}{wire:0{len(digits)}{letters}}"


def _change_entries(document: _Document, old: Settings, new: Settings) -> None:
    for key, entry in document.entries.items():
        calibration_key = CALIBRATION_KEYS.get(key)
        if key == "product":
            document.replace(entry.value, old.product.name, new.product.name)
        elif key == "firmware" and old.firmware and new.firmware:
            document.replace(entry.value, old.firmware, new.firmware)
        elif key in new.parameters:
            wire = new.parameters[key]
            document.set_number(entry.value, wire)
            old_wire = old.parameters[key]
            spec = old.specs[key]
            texts = {parameter_text(spec, old_wire, old), plain_text(spec, old_wire)}
            if spec.kind is ParameterKind.ACCELERATION:  # texts of earlier program versions
                texts.add(f"{old_wire} {spec.unit}")
                texts.add(f"{old_wire} {spec.unit}, {spec.text(old_wire)}")
            document.update_comment(key, texts, parameter_text(new.specs[key], wire, new))
        elif calibration_key is not None and calibration_key in new.calibrations:
            calibrations = [side.calibrations[calibration_key] for side in (old, new)]
            for part, node in entry.value.value:
                document.set_number(node, getattr(calibrations[1], str(part.value)))
            before, after = (calibration_text(calibration_key.source, c) for c in calibrations)
            document.update_comment(key, {before}, after)
        else:
            document.comment_out(key)


def _change_notes(
    document: _Document, old: Mapping[str, str], new: Mapping[str, str]
) -> dict[str, str]:
    """Change, add or remove notes. Return the notes whose settings are not in the text."""
    changed = [key for key in {**old, **new} if old.get(key) != new.get(key)]
    return {key: new[key] for key in changed if not document.set_note(key, lines_of_note(key, new))}


def _missing_lines(
    document: _Document, settings: Settings, notes: Mapping[str, str]
) -> Iterator[str]:
    if settings.firmware is not None and "firmware" not in document.entries:
        yield f"firmware: {settings.firmware}"
    lines = [
        (spec.key, parameter_line(spec, wire, settings))
        for spec, wire in settings.parameter_items()
    ]
    lines += [(key, calibration_line(key, c)) for key, c in settings.calibration_items()]
    present = {line.strip() for line in document.body.splitlines()}
    for key, line in lines:
        is_rejected = line.startswith("#")
        is_missing = line not in present if is_rejected else key not in document.entries
        if is_missing:
            yield from lines_of_note(key, notes)
            yield line
    for key in sorted(notes.keys() - {key for key, _ in lines}):
        yield from lines_of_note(key, notes)
