"""YAML subset of settings files.

A file is a mapping whose values are scalars or mappings of scalars. It is parsed into nodes with
positions, never into Python objects. Anchors, tags, merge keys and deep nesting are rejected,
because they allow a small file to expand to a huge one.
"""

import re
from typing import Any

from ruamel.yaml import YAML
from ruamel.yaml.composer import Composer
from ruamel.yaml.error import MarkedYAMLError, StreamMark
from ruamel.yaml.events import AliasEvent, CollectionStartEvent, StreamEndEvent
from ruamel.yaml.nodes import MappingNode, Node
from ruamel.yaml.reader import ReaderError
from ruamel.yaml.scanner import Scanner
from ruamel.yaml.tokens import Token

from trex_gui.core.files import SettingsError
from trex_gui.core.translation import tr, tr_noop

MAX_NODES = 2000  # scalars and collections; a complete settings file has about 160
_MAX_DEPTH = 2  # levels of mappings

LINE_END = re.compile(r"\r\n|[\n\r\x85\u2028\u2029]")
_TAB = re.compile(r"((?:^|(?<=\r))[ \t]*\t[ \t]*(?![ \t#\r\n]|\Z))|\t", re.MULTILINE)
"""A tab. If tabs indent a setting, group 1 matches the indentation."""

_UNSPACED = re.compile(r"^ *\w+:(?![ \t\r\n]|\Z)", re.MULTILINE)
_PRODUCT = re.compile(r"^\W*product\b", re.MULTILINE)
_PLAIN_YAML = tr_noop("settings are plain 'key: value' lines")
_TOO_DEEP = tr_noop("this is nested too deeply; {0}")


def line_of(node: Node) -> int:
    """Return the first line of a node, counted from 1."""
    return int(node.start_mark.line) + 1


def shortened(text: str, max_length: int = 40) -> str:
    """Return printable text of limited length, for a message."""
    printable = "".join(c if c.isprintable() else "�" for c in text[: max_length + 1])
    return printable if len(printable) <= max_length else f"{printable[:max_length]}…"


def compose(text: str, name: str) -> MappingNode:
    """Return the root mapping of a text. Its values are scalars or flat mappings.

    Raises:
        SettingsError: the text is not YAML, or uses YAML features that settings do not use.
    """
    yaml = YAML(typ="safe", pure=True)
    yaml.Composer = _Composer
    yaml.Scanner = _Scanner
    try:
        # ruamel.yaml rejects all tabs. YAML allows them, except in indentation.
        node = yaml.compose(_TAB.sub(lambda tab: tab[1] or " ", text))
    except ReaderError as error:
        line = len(LINE_END.findall(text, 0, error.position)) + 1
        message = tr("the character U+{0:04X} is not allowed in a text file").format(
            error.character
        )
        raise SettingsError.of(name, message, line) from None
    except _UnsupportedError as error:
        raise SettingsError.of(name, str(error), error.line) from None
    except MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line = 1 if mark is None else mark.line + 1
        problem = shortened(error.problem or error.context or "not YAML", 100)
        message = tr("the text is incomplete or damaged here ({0}); {1}").format(
            problem, tr(_PLAIN_YAML)
        )
        if "'\\t'" in problem:
            message = tr("a tab indents this line; indent it with spaces")
        raise _damaged(text, name, message, line) from None
    if node is None:
        raise SettingsError.of(
            name, tr("there are no settings here; the first must be 'product: TReX'"), 1
        )
    if not isinstance(node, MappingNode):
        message = tr("this is not a setting; {0}").format(tr(_PLAIN_YAML))
        raise _damaged(text, name, message, line_of(node))
    return node


def _damaged(text: str, name: str, message: str, line: int) -> SettingsError:
    """Return the error for invalid YAML, with the likely cause if known."""
    if not _PRODUCT.search(text):
        line, message = 1, tr("these are not settings of a TReX, which begin with 'product: TReX'")
    elif match := _UNSPACED.search(text):  # YAML reads a word here and rejects a later line
        first = len(LINE_END.findall(text, 0, match.start())) + 1
        if first <= line:
            line, message = first, tr("there must be an ordinary space after the colon")
    return SettingsError.of(name, message, line)


class _UnsupportedError(Exception):
    def __init__(self, mark: StreamMark, message: str) -> None:
        super().__init__(message)
        self.line = mark.line + 1


class _Scanner(Scanner):
    """Scanner that limits the nesting of brackets. Scanning 50,000 brackets takes a second."""

    def fetch_flow_collection_start(self, token: type[Token], to_push: str) -> None:
        if len(self.flow_context) == _MAX_DEPTH:
            mark = self.reader.get_mark()
            raise _UnsupportedError(mark, tr(_TOO_DEEP).format(tr(_PLAIN_YAML)))
        super().fetch_flow_collection_start(token, to_push)


class _Composer(Composer):
    """Composer that checks every event before it creates a node."""

    open_collections = 0
    nodes = 0

    def get_single_node(self) -> Node | None:
        try:
            self.parser.get_event()
            if self.parser.check_event(StreamEndEvent):
                return None
            node: Node = self.compose_document()
            if not self.parser.check_event(StreamEndEvent):
                mark = self.parser.peek_event().start_mark
                raise _UnsupportedError(
                    mark, tr("a second document begins here; a settings file has only one")
                )
        except (ValueError, OverflowError):
            # ruamel.yaml does not catch errors of chr() for huge escapes, or int() for versions.
            mark = self.loader.reader.get_mark()
            raise _UnsupportedError(
                mark, tr("this number cannot be read; {0}").format(tr(_PLAIN_YAML))
            ) from None
        return node

    def compose_node(self, parent: Node | None, index: int | None) -> Node:
        event = self.parser.peek_event()
        self._check(event)
        is_collection = isinstance(event, CollectionStartEvent)
        self.open_collections += is_collection
        node: Node = super().compose_node(parent, index)
        self.open_collections -= is_collection
        return node

    def _check(self, event: Any) -> None:
        self.nodes += 1
        is_collection = isinstance(event, CollectionStartEvent)
        if isinstance(event, AliasEvent) or event.anchor is not None:
            problem = tr("anchors (& and *) are not allowed; {0}").format(tr(_PLAIN_YAML))
        elif event.tag is not None:
            problem = tr("tags (!) are not allowed; {0}").format(tr(_PLAIN_YAML))
        elif getattr(event, "value", None) == "<<" and not event.style:
            problem = tr("merge keys (<<) are not allowed; {0}").format(tr(_PLAIN_YAML))
        elif self.nodes > MAX_NODES:
            problem = tr("there are more settings here than any board has")
        elif is_collection and self.open_collections == _MAX_DEPTH:
            problem = tr(_TOO_DEEP).format(tr(_PLAIN_YAML))
        else:
            return
        raise _UnsupportedError(event.start_mark, problem)
