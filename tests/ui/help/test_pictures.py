"""The pictures of the help; that they are up to date is in `tests/test_app.py`, with the tour."""

import json
import re
from pathlib import Path

from PySide6.QtGui import QImage

ROOT = Path(__file__).parents[3]
PICTURES = ROOT / "resources" / "help" / "pictures"
MOST_BYTES = 2_000_000


def shown() -> set[str]:
    pages = [ROOT / "README.md", *(ROOT / "resources" / "help").glob("*.md")]
    link = re.compile(r"pictures/(\S+?)\.png")
    return {name for page in pages for name in link.findall(page.read_text(encoding="utf-8"))}


def test_each_picture_is_shown_and_has_both_schemes() -> None:
    names = {name.removesuffix("-light") for name in shown()}
    files = {path.name for path in PICTURES.glob("*.png")}
    assert files == {f"{name}-{scheme}.png" for name in names for scheme in ("light", "dark")}
    digests = json.loads((PICTURES / "digests.json").read_text(encoding="utf-8"))
    assert digests.keys() == names


def test_pictures_are_small() -> None:
    sizes = [path.stat().st_size for path in PICTURES.iterdir()]
    assert sum(sizes) < MOST_BYTES


def test_dark_picture_is_darker() -> None:
    for light in PICTURES.glob("*-light.png"):
        dark = light.with_name(light.name.replace("-light", "-dark"))
        corners = [QImage(str(path)).pixelColor(1, 1).lightness() for path in (light, dark)]
        assert corners[0] > 200, light.name
        assert corners[1] < 100, dark.name
