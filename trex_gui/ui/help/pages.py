"""Help pages in Markdown."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, partial

from trex_gui.core.resource_files import resource
from trex_gui.core.translation import tr
from trex_gui.ui.help.search import Findable, Kind

INDEX = "README.md"  # page that lists the other pages in order
MESSAGES = "messages.md"

_HEADING = re.compile(r"#{1,6} +(?P<title>.+)")
_LINK = re.compile(r"!?\[(?P<text>[^\]]*)\]\([^)]*\)")
_PAGE_LINK = re.compile(r"\((?P<name>\w+\.md)\)")


@dataclass(frozen=True, slots=True)
class Section:
    page: str
    title: str
    anchor: str
    text: str

    @property
    def topic(self) -> str:
        """Link target, such as `page.md#anchor`."""
        return f"{self.page}#{self.anchor}"


@dataclass(frozen=True, slots=True)
class HelpPage:
    name: str  # file name
    text: str  # Markdown
    sections: tuple[Section, ...]

    @property
    def title(self) -> str:
        return self.sections[0].title


def anchor_of(heading: str) -> str:
    """Return the anchor of a heading, as GitHub computes it."""
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


def _page(name: str) -> HelpPage:
    text = resource(f"help/{name}").read_text(encoding="utf-8")
    return HelpPage(name, text, tuple(_sections(name, text)))


@cache
def pages() -> Sequence[HelpPage]:
    index = _page(INDEX)
    names = dict.fromkeys(_PAGE_LINK.findall(index.text))
    return (index, *map(_page, names))


def help_findables(
    headings: Mapping[str, str], show: Callable[[str], object]
) -> Iterator[Findable]:
    """Yield the search entries of the help.

    `headings`: topic → translated heading of a message. `show`: opens a topic.
    """
    for page in pages():
        for section in page.sections:
            title = headings.get(section.topic, section.title)
            place = tr("Help") if title == page.title else f"{tr('Help')} · {page.title}"
            kind: Kind = "message" if page.name == MESSAGES else "help"
            key = section.anchor if kind == "message" else section.topic
            yield Findable(kind, key, title, place, section.text, partial(show, section.topic))
