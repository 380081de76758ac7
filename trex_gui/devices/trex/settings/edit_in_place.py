"""New values in a file that a person wrote: what they wrote around the values stays.

A writer that starts from nothing would lose comments, order and spelling. This one looks up
where each value stands and exchanges only those that differ.
"""

import re
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import yaml

from trex_gui.core.files.errors import Finding, SettingsError
from trex_gui.devices.trex.settings.document import CALIBRATION_KEYS, Settings
from trex_gui.devices.trex.settings.plain_yaml import LINE_END, Word, compose, decoded
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import (
    calibration_line,
    calibration_text,
    check_keys,
    parameter_line,
    parameter_text,
)

_MARK = "\ufeff"
_SMALLEST_GAP = 2
"""Spaces that the writer leaves between a value and its comment."""


def amend(text: str, settings: Settings, name: str = "settings") -> str:
    """Return the text of a settings file with other settings in it.

    Values that differ are exchanged where they stand, in the base in which they are written. A
    comment beside a value is renewed when it is what the program wrote there; a person's comment
    stays. What the text lacks is appended; what the settings lack becomes a comment, as does a
    value that the board would refuse. With the settings that it has, a text does not change.

    Args:
        text: what the file holds, line ends and byte order mark included.
        settings: what the result reads back as.
        name: what errors call the file.

    Raises:
        SettingsError: the text cannot be read, or is written in a way that cannot be changed
            in place.
        BadRequest: the settings hold a key that their model and firmware do not have.
    """
    check_keys(settings)
    old, _ = read_settings(text, name)
    wanted = _without_refused(settings)
    mark = _MARK if text.startswith(_MARK) else ""
    page = _Document.of(text.removeprefix(_MARK), name)
    _exchange_values(page, old, wanted)
    page.align_comments()
    _renew_comments(page, old, wanted)
    _remove(page, wanted)
    page.append(list(_missing_lines(page, settings)))
    amended = mark + page.text()
    if amended != text and not _reads_as(wanted, amended):
        message = (
            "this file is written in a way that cannot be changed in place; save the settings as "
            "a new file"
        )
        raise SettingsError(name, [Finding(None, None, message)])
    return amended


def _reads_as(settings: Settings, text: str) -> bool:
    try:
        return read_settings(text)[0] == settings
    except SettingsError:
        return False


def _without_refused(settings: Settings) -> Settings:
    """Return the settings that a file can hold: those that the board would take."""
    given, places = settings.parameters, settings.calibrations
    valid = {spec.key: spec.valid for spec in settings.specs.readable}
    return replace(
        settings,
        parameters={key: wire for key, wire in given.items() if wire in valid[key]},
        calibrations={at: found for at, found in places.items() if found.problem() is None},
    )


@dataclass(frozen=True, slots=True)
class _Entry:
    """Where one setting stands: numbers of its first and last word, and its value."""

    first: int
    last: int
    value: yaml.Node


@dataclass(slots=True)
class _Document:
    """A text, what stands where in it, and the changes collected so far."""

    body: str
    root: yaml.MappingNode
    words: list[Word]
    entries: dict[str, _Entry]
    line_starts: list[int]
    edits: list[tuple[int, int, str]] = field(default_factory=list)

    @classmethod
    def of(cls, body: str, name: str) -> "_Document":
        root, words = compose(body, name), decoded(body)
        by_start = {word.start: number for number, word in enumerate(words)}
        by_end = {word.end: number for number, word in enumerate(words)}
        entries = {}
        for key, value in root.value:
            first = by_start[_span(key)[0]]
            if first > 0 and words[first - 1].kind is yaml.KeyToken:  # "? key"
                first -= 1
            entries[str(key.value)] = _Entry(first, by_end[_span(value)[1]], value)
        line_starts = [0, *(end.end() for end in LINE_END.finditer(body))]
        return cls(body, root, words, entries, line_starts)

    def text(self) -> str:
        """Return the text with every change made."""
        parts, position = [], 0
        for start, end, new in sorted(self.edits, key=lambda edit: edit[:2]):
            parts += [self.body[position:start], new]
            position = end
        return "".join([*parts, self.body[position:]])

    def put(self, node: yaml.Node, new: str) -> None:
        """Exchange a word for another, in the quotes that it has."""
        start, end = _span(node)
        style = node.style if isinstance(node, yaml.ScalarNode) else None
        if style in {"|", ">"}:  # a block of text; its content begins after the first line
            source = self.body[start:end].rstrip()
            header = LINE_END.search(source)
            content = source[header.end() if header else 0 :].lstrip()
            start, end = start + len(source) - len(content), start + len(source)
            style = None
        self.edits.append((start, end, f"{style or ''}{new}{style or ''}"))

    def put_number(self, node: yaml.Node, wire: int) -> None:
        """Exchange a number for another, in the base in which it is written."""
        start, end = _span(node)
        self.edits.append((start, end, _spelled_like(self.body[start:end], wire)))

    def comment_after(self, number: int) -> tuple[int, int] | None:
        """Return from where to where the comment stands that follows a word in its line."""
        word = self.words[number]
        if LINE_END.match(self.body, word.end - 1):  # a block of text ends with its line
            return None
        following = self.words[number + 1].start if number + 1 < len(self.words) else None
        gap = LINE_END.split(self.body[word.end : following], maxsplit=1)[0]
        start = gap.find("#")
        return None if start < 0 else (word.end + start, word.end + len(gap.rstrip()))

    def line_of(self, position: int) -> int:
        """Return the number of the line, from 0, in which a character stands."""
        return bisect_right(self.line_starts, position) - 1

    def align_comments(self) -> None:
        """Keep comments in their columns while the values before them change their length."""
        grown: dict[int, int] = {}
        for start, end, new in self.edits:
            line = self.line_of(start)
            grown[line] = grown.get(line, 0) + len(new) - (end - start)
        for number, word in enumerate(self.words):
            growth, comment = grown.get(self.line_of(word.end), 0), self.comment_after(number)
            if not growth or comment is None:
                continue
            gap = comment[0] - word.end  # spaces: YAML allows no tabs there
            spaces = max(min(_SMALLEST_GAP, gap), gap - growth)
            self.edits.append((word.end, comment[0], " " * spaces))

    def renew_comment(self, key: str, old: str, new: str) -> None:
        """Exchange the comments beside a setting that say `old`, and nothing else."""
        entry = self.entries[key]
        last = entry.last + self._is_comma(entry.last + 1)
        for number in range(entry.first, last + 1):
            comment = self.comment_after(number)
            if comment is not None and self.body[slice(*comment)] == f"# {old}":
                self.edits.append((*comment, f"# {new}"))

    def remove(self, key: str) -> None:
        """Make a comment of a setting's lines; where many share a line, take its words away."""
        entry = self.entries[key]
        first, last = self.words[entry.first], self.words[entry.last]
        if self.root.flow_style:
            end = entry.last + self._is_comma(entry.last + 1)
            gone = self.words[entry.first : end + 1]
            self.edits += [(word.start, word.end, "") for word in gone]
            return
        end = first.start + len(self.body[first.start : last.end].rstrip())
        for line in range(self.line_of(first.start), self.line_of(end - 1) + 1):
            start = self.line_starts[line]
            rest = LINE_END.split(self.body[start:], maxsplit=1)[0].strip()
            if rest and not rest.startswith("#"):
                self.edits.append((start, start, "# "))

    def append(self, lines: list[str]) -> None:
        """Add lines at the end: settings, and comments beside them or of their own."""
        if self.root.flow_style:
            self._append_to_flow([line for line in lines if not line.startswith("#")])
            lines = [line for line in lines if line.startswith("#")]
        if not lines:
            return
        margin = 0 if self.root.start_mark is None else self.root.start_mark.column
        found = LINE_END.search(self.body)
        line_end = found[0] if found and found[0] in {"\r\n", "\n", "\r"} else "\n"
        text = line_end.join(" " * margin + line for line in lines)
        stops = [word.start for word in self.words if word.kind is yaml.DocumentEndToken]
        place = stops[0] if stops else len(self.body)
        is_line_start = place in self.line_starts
        self.edits.append((place, place, text + line_end if is_line_start else line_end + text))

    def _append_to_flow(self, lines: list[str]) -> None:
        """Add settings before the brace that ends the file's one mapping."""
        settings = [line.partition("#")[0].rstrip() for line in lines]
        if not settings:
            return
        gone = {start for start, end, new in self.edits if not new and end > start}
        brace = max(n for n, w in enumerate(self.words) if w.kind is yaml.FlowMappingEndToken)
        before = next(w for w in reversed(self.words[:brace]) if w.start not in gone)
        comma = " " if before.kind is yaml.FlowEntryToken else ", "
        self.edits.append((before.end, before.end, comma + ", ".join(settings)))

    def _is_comma(self, number: int) -> bool:
        return number < len(self.words) and self.words[number].kind is yaml.FlowEntryToken


def _span(node: yaml.Node) -> tuple[int, int]:
    """Return where a node begins and ends, in characters, without what follows its last word."""
    start, end = node.start_mark, node.end_mark
    if isinstance(node, yaml.MappingNode) and not node.flow_style:
        return _span(node.value[0][0])[0], _span(node.value[-1][1])[1]
    return (0 if start is None else start.index), (0 if end is None else end.index)


def _spelled_like(old: str, wire: int) -> str:
    """Return a number as another one is written: `0x0f` makes `0x7b` of 123."""
    if old[:2] not in {"0x", "0X"}:
        return f"+{wire}" if old.startswith("+") else str(wire)
    digits = old[2:]
    letters = "x" if re.search("[a-f]", digits) else "X"
    return f"{old[:2]}{wire:0{len(digits)}{letters}}"


def _exchange_values(page: _Document, old: Settings, new: Settings) -> None:
    if old.product != new.product:
        page.put(page.entries["product"].value, new.product.name)
    if old.firmware != new.firmware and None not in {old.firmware, new.firmware}:
        page.put(page.entries["firmware"].value, str(new.firmware))
    for key, wire in new.parameters.items():
        if old.parameters.get(key, wire) != wire:
            page.put_number(page.entries[key].value, wire)
    for key, place in CALIBRATION_KEYS.items():
        before, after = old.calibrations.get(place), new.calibrations.get(place)
        if before is None or after is None:
            continue
        for part, node in page.entries[key].value.value:
            field_name = str(part.value)
            if getattr(before, field_name) != (wire := getattr(after, field_name)):
                page.put_number(node, wire)


def _renew_comments(page: _Document, old: Settings, new: Settings) -> None:
    """Renew what the program itself wrote beside values; the model decides some of it."""
    for spec in new.specs.readable:
        if spec.key in old.parameters and spec.key in new.parameters:
            before = parameter_text(old.specs[spec.key], old.parameters[spec.key])
            after = spec.text(new.parameters[spec.key])
            if before not in {"", after}:
                page.renew_comment(spec.key, before, after)
    for key, place in CALIBRATION_KEYS.items():
        if place in old.calibrations and place in new.calibrations:
            before = calibration_text(place[0], old.calibrations[place])
            after = calibration_text(place[0], new.calibrations[place])
            if before != after:
                page.renew_comment(key, before, after)


def _remove(page: _Document, wanted: Settings) -> None:
    for key in page.entries:
        if not _has(wanted, key):
            page.remove(key)


def _has(settings: Settings, key: str) -> bool:
    if key in CALIBRATION_KEYS:
        return CALIBRATION_KEYS[key] in settings.calibrations
    if key == "firmware":
        return settings.firmware is not None
    return key == "product" or key in settings.parameters


def _missing_lines(page: _Document, settings: Settings) -> Iterator[str]:
    """Yield a line for each setting that the page lacks, in the order of the table."""
    if settings.firmware is not None and "firmware" not in page.entries:
        yield f"firmware: {settings.firmware}"
    lines = [
        (spec.key, parameter_line(spec, settings.parameters[spec.key]))
        for spec in settings.specs.readable
        if spec.key in settings.parameters
    ]
    lines += [
        (key, calibration_line(key, settings.calibrations[place]))
        for key, place in CALIBRATION_KEYS.items()
        if place in settings.calibrations
    ]
    there = {line.strip() for line in page.body.splitlines()}
    for key, line in lines:
        is_comment = line.startswith("#")  # a value that the board would refuse
        if (is_comment and line not in there) or (not is_comment and key not in page.entries):
            yield line
