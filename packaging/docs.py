"""Build the site of the documents in `build/docs/html`, from the files that the program ships.

    python3 packaging/bootstrap.py docs

Sphinx reads a folder of copies, so that the pages of the help are the same files as in the window.
A dead link is an error. The search works from files, without a server.
"""

import shutil
import sys
from collections.abc import Iterator

from bootstrap import BUILD_DOCS, PACKAGING, ROOT, run_visibly, say
from json_schemas import schemas

from trex_gui.devices.trex.protocol.parameters import ParameterSpec, parameters_of

SOURCE, SITE = BUILD_DOCS / "source", BUILD_DOCS / "html"
MODEL, FIRMWARE = "trex", "1.2"


def parameter_rows() -> Iterator[str]:
    """Return the table of the parameters with the evidence for each."""
    yield "| number | key | range | default | meaning | evidence |"
    yield "|---|---|---|---|---|---|"
    for spec in parameters_of(MODEL, FIRMWARE):
        yield (
            f"| {spec.number:02X} | `{spec.key}` | {spec.minimum}–{spec.maximum} | {spec.default} "
            f"| {spec.description} | {evidence_of(spec)} |"
        )


def evidence_of(spec: ParameterSpec) -> str:
    """Return what is inferred or from the twin; empty if a document says all of it."""
    grades = (
        (name, spec.grade(*fields))
        for name, fields in (("range", ("min", "max")), ("default", ("default",)))
    )
    return ", ".join(f"{name} {grade.name.lower()}" for name, grade in grades if grade)


def gather() -> None:
    """Copy what the site is made of."""
    shutil.rmtree(BUILD_DOCS, ignore_errors=True)
    shutil.copytree(PACKAGING / "docs", SOURCE)
    for name in ("help", "examples"):
        ignored = shutil.ignore_patterns("__pycache__")
        shutil.copytree(ROOT / "resources" / name, SOURCE / name, ignore=ignored)
    shutil.copy(ROOT / "trex_gui" / "README.md", SOURCE / "built.md")
    shutil.copy(ROOT / "resources" / "icons" / "trex-studio.svg", SOURCE)
    with (SOURCE / "json.md").open("a", encoding="utf-8") as file:
        for command, schema in schemas():
            file.write(f"\n## trexcmd {command}\n\n```json\n{schema}\n```\n")
    with (SOURCE / "parameters.md").open("a", encoding="utf-8") as file:
        file.write("\n".join(["", *parameter_rows(), ""]))


def main() -> int:
    gather()
    sphinx = [sys.executable, "-m", "sphinx", "-W", "--keep-going", "-q", "-b", "html"]
    status = run_visibly([*sphinx, str(SOURCE), str(SITE)], {})
    if status == 0:
        say(f"Open {SITE / 'index.html'}")
    return status


if __name__ == "__main__":
    sys.exit(main())
