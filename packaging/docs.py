"""Build the documentation website in `build/docs/html`.

    python3 packaging/bootstrap.py docs

Sphinx reads copies of the files that the program ships, such as the pages of the help. A dead link
is an error. The search of the website needs no server.
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
    """Yield the lines of the table of parameters."""
    yield "| number | key | range | default | meaning | evidence |"
    yield "|---|---|---|---|---|---|"
    for spec in parameters_of(MODEL, FIRMWARE):
        yield (
            f"| {spec.number:02X} | `{spec.key}` | {spec.minimum}–{spec.maximum} | {spec.default} "
            f"| {spec.description} | {evidence_of(spec)} |"
        )


def evidence_of(spec: ParameterSpec) -> str:
    """Return the grades of the fields that no document specifies.

    Example: "range inferred, default twin". Empty if a document specifies every field.
    """
    grades = (
        (name, spec.grade(*fields))
        for name, fields in (("range", ("min", "max")), ("default", ("default",)))
    )
    return ", ".join(f"{name} {grade.name.lower()}" for name, grade in grades if grade)


def copy_sources() -> None:
    """Copy and generate the sources of the website."""
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
    copy_sources()
    sphinx = [sys.executable, "-m", "sphinx", "-W", "--keep-going", "-q", "-b", "html"]
    status = run_visibly([*sphinx, str(SOURCE), str(SITE)], {})
    if status == 0:
        say(f"Open {SITE / 'index.html'}")
    return status


if __name__ == "__main__":
    sys.exit(main())
