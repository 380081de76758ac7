"""Help pages in Markdown, their sections and the search; a forge shows the same files."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache

from trex_gui.core.resource_files import resource

INDEX = "README.md"  # the page that lists the others in their order

_LEAST_OF_MESSAGE = 12
"""Characters of a heading that is looked for in what was typed: shorter ones are common words."""

_HEADING = re.compile(r"#{1,6} +(?P<title>.+)")
_LINK = re.compile(r"!?\[(?P<text>[^\]]*)\]\([^)]*\)")
_PAGE_LINK = re.compile(r"\((?P<name>\w+\.md)\)")


@dataclass(frozen=True, slots=True)
class Section:
    """A heading with the text below it, without marks of Markdown."""

    page: str
    title: str
    anchor: str
    text: str

    @property
    def topic(self) -> str:
        """Its place, as links to it spell it: `page.md#anchor`."""
        return f"{self.page}#{self.anchor}"


@dataclass(frozen=True, slots=True)
class Page:
    name: str  # of its file
    text: str  # Markdown
    sections: tuple[Section, ...]

    @property
    def title(self) -> str:
        return self.sections[0].title


def anchor_of(heading: str) -> str:
    """Return the anchor that forges give to a heading."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def _plain(markdown: str) -> str:
    return re.sub(r"[*`|]|^\s*[#>-]+ ", "", _LINK.sub(r"\g<text>", markdown), flags=re.MULTILINE)


def _sections(name: str, text: str) -> Iterator[Section]:
    title, lines, is_code = "", list[str](), False
    for line in [*text.splitlines(), "# end"]:
        is_code ^= line.startswith("```")
        heading = None if is_code else _HEADING.fullmatch(line)
        if heading is None:
            lines.append(line)
            continue
        if title:
            yield Section(name, title, anchor_of(title), _plain("\n".join(lines)).strip())
        title, lines = _plain(heading["title"]), []


def _page(name: str) -> Page:
    text = resource(f"help/{name}").read_text(encoding="utf-8")
    return Page(name, text, tuple(_sections(name, text)))


@cache
def pages() -> Sequence[Page]:
    """Return every page, in the order of the index."""
    index = _page(INDEX)
    names = dict.fromkeys(_PAGE_LINK.findall(index.text))
    return (index, *map(_page, names))


def search(words: str, topic: str = "") -> list[Section]:
    """Return the sections with all of these words, those with all in their heading first.

    `words` may also be a message: the section on it (`topic`, where that is known), and those
    whose heading is in it, come before.
    """
    wanted = words.casefold().split()

    def has_all(text: str) -> bool:
        folded = text.casefold()
        return all(word in folded for word in wanted)

    sections = [section for page in pages() for section in page.sections]
    headed = [section for section in sections if _is_headed_by(words, section.title)]
    headed.sort(key=lambda section: len(section.title), reverse=True)
    known = [section for section in sections if section.topic == topic]
    found = [section for section in sections if has_all(f"{section.title} {section.text}")]
    found.sort(key=lambda section: not has_all(section.title))
    return list(dict.fromkeys((*known, *headed, *found)))


def _is_headed_by(message: str, title: str) -> bool:
    """Whether a title, in which … stands for anything, is part of a message."""
    pattern = ".+?".join(map(re.escape, title.strip("… ").split("…")))
    is_long = len(title.replace("…", "")) >= _LEAST_OF_MESSAGE
    return is_long and re.search(pattern, message, re.IGNORECASE) is not None
