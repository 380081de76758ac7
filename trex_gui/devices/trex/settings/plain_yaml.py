"""The part of YAML that settings files use, with the line of every word.

No Python object is ever made from a file: what comes out are scalars, lists and mappings as
written. Anchors, tags, merge keys and deep nesting, which settings do not need and which
turn small files into large ones, are refused.
"""

import re
from dataclasses import dataclass
from typing import ClassVar

import yaml

from trex_gui.core.files.errors import Finding, SettingsError

LARGEST_FILE = 256 * 1024
"""Bytes; a complete settings file has about 3000."""

MOST_NODES = 2000
"""Words and groups of words; a complete settings file has about 160."""

LINE_END = re.compile(r"\r\n|[\n\r\x85\u2028\u2029]")
_PLAIN_YAML = "settings are plain 'key: value' lines"
_MERGE_TAG = "tag:yaml.org,2002:merge"


def line_of(node: yaml.Node) -> int:
    """Return the line where a node begins, counted from 1."""
    mark = node.start_mark
    return 1 if mark is None else mark.line + 1


def shortened(text: str, longest: int = 40) -> str:
    """Return text of a file so that it fits into a sentence."""
    shown = "".join(c if c.isprintable() else "�" for c in text[: longest + 1])
    return shown if len(shown) <= longest else f"{shown[:longest]}…"


def decode(data: str | bytes, name: str) -> str:
    """Return the text of a file.

    Raises:
        SettingsError: it is too large, or no text.
    """
    raw = data if isinstance(data, bytes) else data.encode("utf-8", "surrogatepass")
    if len(raw) > LARGEST_FILE:
        limit = LARGEST_FILE // 1024
        raise _refusal(name, None, f"is larger than {limit} KiB; settings are not that long")
    if (found := raw.find(b"\0")) >= 0:
        line = raw.count(b"\n", 0, found) + 1
        raise _refusal(name, line, "this is a binary file; settings are text")
    try:
        return raw.decode("utf-8").removeprefix("\ufeff")
    except UnicodeDecodeError as error:
        line = raw.count(b"\n", 0, error.start) + 1
        raise _refusal(name, line, "this is not UTF-8 text") from None


def compose(text: str, name: str) -> yaml.MappingNode:
    """Return the one mapping that a text consists of; at most one level of mappings inside.

    Raises:
        SettingsError: the text is no YAML, or more of it than settings use.
    """
    try:
        loader = _Loader(text)
    except yaml.reader.ReaderError as error:
        line = len(LINE_END.findall(text, 0, error.position)) + 1
        character = f"U+{ord(text[error.position]):04X}"
        message = f"the character {character} has no place in a text file"
        raise _refusal(name, line, message) from None
    try:
        node = loader.compose_only_document()
    except _RefusedError as error:
        raise _refusal(name, error.line, error.message) from None
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line = 1 if mark is None else mark.line + 1
        problem = shortened(error.problem or error.context or "no YAML", 100)
        message = f"the text breaks off or is damaged here ({problem}); {_PLAIN_YAML}"
        raise _refusal(name, line, message) from None
    except (ValueError, OverflowError):
        # PyYAML passes on what chr() and int() say of absurd escapes and version numbers.
        line = loader.get_mark().line + 1
        raise _refusal(name, line, f"this number cannot be read; {_PLAIN_YAML}") from None
    finally:
        loader.dispose()
    if node is None:
        raise _refusal(name, 1, "there are no settings here; the first is 'product: TReX'")
    if not isinstance(node, yaml.MappingNode):
        raise _refusal(name, line_of(node), f"this is no setting; {_PLAIN_YAML}")
    return node


@dataclass(frozen=True, slots=True)
class Word:
    """A piece of text that is neither space nor comment: a value, a colon, a brace.

    Attributes:
        start: where it begins, in characters.
        end: where it ends.
    """

    kind: type[yaml.Token]
    start: int
    end: int


def decoded(text: str) -> list[Word]:
    """Return the words of a text that `compose` takes, in their order.

    Between two of them there are only white space and comments.
    """
    found = []
    for token in yaml.scan(text, yaml.SafeLoader):
        start, end = token.start_mark, token.end_mark
        if start is not None and end is not None and end.index > start.index:
            found.append(Word(type(token), start.index, end.index))
    return found


def _refusal(name: str, line: int | None, message: str) -> SettingsError:
    return SettingsError(name, [Finding(line, None, message)])


class _RefusedError(Exception):
    def __init__(self, mark: yaml.Mark | None, message: str) -> None:
        super().__init__(message)
        self.line = 1 if mark is None else mark.line + 1
        self.message = message


class _Loader(yaml.SafeLoader):
    """Composes nodes of the small YAML only; checked before each node is made."""

    deepest: ClassVar[int] = 2
    depth = 0
    nodes = 0

    def compose_only_document(self) -> yaml.Node | None:
        self.get_event()  # type: ignore[no-untyped-call]  # the stubs lack it
        if self.check_event(yaml.StreamEndEvent):
            return None
        node = self.compose_document()
        if not self.check_event(yaml.StreamEndEvent):
            second = self.peek_event()  # type: ignore[no-untyped-call]  # the stubs lack it
            raise _RefusedError(
                second.start_mark, "a second document begins here; settings are one"
            )
        return node

    def compose_node(self, parent: yaml.Node | None, index: int) -> yaml.Node | None:
        event = self.peek_event()  # type: ignore[no-untyped-call]  # the stubs lack it
        mark = event.start_mark
        if isinstance(event, yaml.AliasEvent) or getattr(event, "anchor", None) is not None:
            raise _RefusedError(mark, f"anchors (& and *) are not allowed; {_PLAIN_YAML}")
        if getattr(event, "tag", None) is not None:
            raise _RefusedError(mark, f"tags (!) are not allowed; {_PLAIN_YAML}")
        self.nodes += 1
        if self.nodes > MOST_NODES:
            raise _RefusedError(mark, "there is more here than any board can be set to")
        is_collection = isinstance(event, yaml.CollectionStartEvent)
        if is_collection and self.depth == self.deepest:
            raise _RefusedError(mark, f"this is nested too deeply; {_PLAIN_YAML}")
        self.depth += is_collection
        node = super().compose_node(parent, index)
        self.depth -= is_collection
        if node is not None and node.tag == _MERGE_TAG:
            raise _RefusedError(mark, f"merge keys (<<) are not allowed; {_PLAIN_YAML}")
        return node
