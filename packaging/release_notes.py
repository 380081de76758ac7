"""Print the section of a version in CHANGELOG.md, for its release.

    python3 packaging/release_notes.py v1.2.3

Fails if the tag differs from the version of the program, if the version has no section, or if
`[Unreleased]` has entries.
"""

import re
import sys

from bootstrap import ROOT
from packages import version


def section(changelog: str, version: str) -> str | None:
    """Return the text below the heading of a version.

    Example of a heading: `## [1.2.3] - 2026-01-31`. None if there is no such heading.
    """
    heading = rf"^## \[?{re.escape(version)}\]?(?: [^\n]*)?\n(.*?)(?=^## |\Z)"
    found = re.search(heading, changelog, re.MULTILINE | re.DOTALL)
    return found[1].strip() if found else None


def release_notes(tag: str, version: str, changelog: str) -> str:
    """Return the text of a release.

    Raises:
        ValueError: the tag, the version and the changelog contradict each other.
    """
    if tag != f"v{version}":
        raise ValueError(f"The tag is {tag}, but the version of the program is {version}.")
    if section(changelog, "Unreleased"):
        raise ValueError(f"CHANGELOG.md has entries in [Unreleased]. Move them to [{version}].")
    text = section(changelog, version)
    if not text:
        raise ValueError(f"CHANGELOG.md has no section [{version}] or the section is empty.")
    return text


def main() -> None:
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    try:
        text = release_notes(sys.argv[1], version(), changelog)
    except ValueError as error:
        sys.exit(str(error))
    print(text)


if __name__ == "__main__":
    main()
