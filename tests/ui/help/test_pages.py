"""Help pages, their links and their pictures."""

import json
import re
from pathlib import Path

import pytest
from PySide6.QtGui import QImage

from trex_gui.cli.program import COMMANDS
from trex_gui.ui.help.pages import INDEX, anchor_of, pages

ROOT = Path(__file__).parents[3]
HELP = ROOT / "resources" / "help"
PICTURES = HELP / "pictures"
LINK = re.compile(r"\[[^\]]*\]\((?P<target>[^)]+)\)")


def test_links_of_help_pages_have_targets() -> None:
    for page in pages():
        for file in check_links(page.text, HELP / page.name):
            assert file.is_relative_to(ROOT / "resources"), "the package contains no other folder"


@pytest.mark.parametrize(
    "name",
    [
        "README.md",
        "CONTRIBUTING.md",
        "SECURITY.md",
        "tests/README.md",
        "trex_gui/README.md",
        "trex_gui/devices/trex/README.md",
    ],
)
def test_links_of_document_have_targets(name: str) -> None:
    check_links((ROOT / name).read_text(encoding="utf-8"), ROOT / name)


def check_links(text: str, path: Path) -> list[Path]:
    """Check that files and anchors exist. Return the files."""
    files = []
    anchors = {page.name: {section.anchor for section in page.sections} for page in pages()}
    for target in LINK.findall(text):
        if target.startswith(("http", "../../actions/", "../../releases")):  # pages on GitHub
            continue
        name, _, anchor = target.partition("#")
        file = (path.parent / name).resolve() if name else path
        assert file.exists(), target
        files.append(file)
        if anchor:
            assert file.parent == HELP, target
            assert anchor in anchors[file.name], target
    return files


def test_index_lists_every_page_once() -> None:
    names = [page.name for page in pages()]
    assert names[0] == INDEX
    assert sorted(names) == sorted(path.name for path in HELP.glob("*.md"))


def test_every_page_has_its_title_and_unique_headings() -> None:
    for page in pages():
        assert page.text.startswith(f"# {page.title}\n")
        anchors = [section.anchor for section in page.sections]
        assert len(anchors) == len(set(anchors))


def test_command_line_page_names_every_command() -> None:
    (page,) = (page for page in pages() if page.name == "command_line.md")
    rows = "\n".join(line for line in page.text.splitlines() if line.startswith("|"))
    named = set(re.findall(r"`([\w-]+)`", rows))
    assert named == COMMANDS.keys()


def test_anchor_of_a_heading_equals_that_of_github() -> None:
    assert anchor_of("Edit, review, apply") == "edit-review-apply"
    assert anchor_of("1. Look at the LEDs") == "1-look-at-the-leds"
    assert anchor_of("No reply to …") == "no-reply-to-"


def test_sections_have_plain_text_and_ignore_comments_in_code() -> None:
    (library,) = (page for page in pages() if page.name == "library.md")
    titles = [section.title for section in library.sections]
    assert titles == [library.title, "Examples", "Tests of your own"]
    assert "**" not in library.sections[0].text
    (cli,) = (page for page in pages() if page.name == "command_line.md")
    assert "snapshot, write, verify" in cli.sections[0].text, "a comment in code is not a heading"


def test_each_picture_is_used_and_has_both_schemes() -> None:
    texts = [path.read_text(encoding="utf-8") for path in (ROOT / "README.md", *HELP.glob("*.md"))]
    used = set(re.findall(r"pictures/(\S+?)\.png", "".join(texts)))
    names = {name.removesuffix("-light") for name in used}
    files = {path.name for path in PICTURES.glob("*.png")}
    assert files == {f"{name}-{scheme}.png" for name in names for scheme in ("light", "dark")}
    digests = json.loads((PICTURES / "digests.json").read_text(encoding="utf-8"))
    assert digests.keys() == names


def test_pictures_are_small() -> None:
    sizes = [path.stat().st_size for path in PICTURES.iterdir()]
    assert sum(sizes) < 2_000_000


def test_dark_picture_is_darker() -> None:
    for light in PICTURES.glob("*-light.png"):
        dark = light.with_name(light.name.replace("-light", "-dark"))
        corners = [QImage(str(path)).pixelColor(1, 1).lightness() for path in (light, dark)]
        assert corners[0] > 200, light.name
        assert corners[1] < 100, dark.name
