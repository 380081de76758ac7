"""Print what CHANGELOG.md says about a version, as the text of its release.

    python3 packaging/release_notes.py v1.2.3

Ends with an error if the tag is not the version of the program, the version has no section, or
`[Unreleased]` has entries.
"""

import re
import sys

from bootstrap import ROOT
from packages import version


def section(changelog: str, version: str) -> str | None:
    """Return the text below the heading of a version, such as `## [1.2.3] - 2026-01-31`."""
    heading = rf"^## \[?{re.escape(version)}\]?(?: [^\n]*)?\n(.*?)(?=^## |\Z)"
    found = re.search(heading, changelog, re.MULTILINE | re.DOTALL)
    return found[1].strip() if found else None


def release_notes(tag: str, version: str, changelog: str) -> str:
    """Return the text of a release.

    Raises:
        ValueError: the tag, the version and the changelog do not agree.
    """
    if tag != f"v{version}":
        raise ValueError(f"The tag is {tag}, and the version of the program is {version}.")
    if section(changelog, "Unreleased"):
        raise ValueError(f"CHANGELOG.md has entries in [Unreleased]: move them to [{version}].")
    text = section(changelog, version)
    if not text:
        raise ValueError(f"CHANGELOG.md has no section [{version}], or an empty one.")
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
