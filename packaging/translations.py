"""Update and compile the Linguist files of `resources/translations`.

    python3 packaging/bootstrap.py translations

The texts come from the calls of `tr` and `tr_noop` in the program, and from the parameter table.
`lupdate` of PySide6 6.11 misses some calls in expressions, so this script searches the syntax tree.
All texts are in one context: a text has the same translation wherever it is used,
unless a comment distinguishes its uses.
"""

import ast
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from xml.etree import ElementTree
from xml.sax.saxutils import escape

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "trex_gui"
PARAMETERS = ROOT / "resources" / "trex_parameters.toml"
FOLDER = ROOT / "resources" / "translations"

CONTEXT = "trex_gui"
MARKS = {"tr", "tr_noop"}  # functions whose first argument is a text

PARAMETER_TEXTS = ("name", "description", "zero", "doubt")  # keys of the table
ONLY_PLURALS = "en"  # language with translations of plural forms only
PLURAL_FORMS = {"en": 2, "de": 2, "fr": 2}

HEAD = """<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="{language}" sourcelanguage="en">
<context>
    <name>{context}</name>
"""
TAIL = "</context>\n</TS>\n"


@dataclass(frozen=True)
class Text:
    """Text of the program. `comment` distinguishes uses that need different translations."""

    source: str
    comment: str = ""
    is_plural: bool = field(default=False, compare=False)


Translations = dict[Text, tuple[str, ...]]  # values: one string, or one for each plural form


def texts_of_module(source: str) -> Iterator[Text]:
    """Yield the translatable texts in a module."""
    if not any(f"{mark}(" in source for mark in MARKS):
        return  # most modules have no texts, and parsing takes time
    for node in ast.walk(ast.parse(source)):
        if not isinstance(node, ast.Call):
            continue
        function = node.func
        name = function.attr if isinstance(function, ast.Attribute) else None
        name = function.id if isinstance(function, ast.Name) else name
        if name not in MARKS or not node.args:
            continue
        values = [arg.value if isinstance(arg, ast.Constant) else None for arg in node.args]
        if isinstance(values[0], str):
            comment = values[1] if len(values) > 1 else None
            yield Text(values[0], comment if isinstance(comment, str) else "", len(values) > 2)


def texts_of_parameters(table: str) -> Iterator[Text]:
    for parameter in tomllib.loads(table)["parameter"]:
        for key in PARAMETER_TEXTS:
            if parameter.get(key):
                yield Text(parameter[key], parameter.get(f"{key}_of", ""))
        yield Text(re.sub("^Motor [12] ", "", parameter["name"]))
        for word in parameter.get("values", {}).values():
            yield Text(word)


def program_texts() -> list[Text]:
    """Return every text of the program once."""
    found = dict.fromkeys(
        text
        for path in sorted(PROGRAM.rglob("*.py"))
        for text in texts_of_module(path.read_text("utf-8"))
    )
    found |= dict.fromkeys(texts_of_parameters(PARAMETERS.read_text("utf-8")))
    return list(found)


def read(path: Path) -> Translations:
    """Return the finished translations of a Linguist file."""
    found: Translations = {}
    for message in ElementTree.parse(path).getroot().iter("message"):
        text = Text(message.findtext("source") or "", message.findtext("comment") or "")
        entry = message.find("translation")
        if entry is None or entry.get("type") == "unfinished":
            continue
        forms = [form.text or "" for form in entry.iter("numerusform")] or [entry.text or ""]
        if all(forms):
            found[text] = tuple(forms)
    return found


def write(path: Path, texts: Iterable[Text], known: Translations) -> int:
    """Write a Linguist file. Return the number of missing translations."""
    language = path.stem.rpartition("_")[2]
    missing = 0
    lines = [HEAD.format(language=language, context=CONTEXT)]
    for text in texts:
        forms = known.get(text, ())
        missing += not forms
        state = "" if forms else ' type="unfinished"'
        if text.is_plural:
            forms = forms or ("",) * PLURAL_FORMS.get(language, 2)
            inner = "".join(f"<numerusform>{escape(form)}</numerusform>" for form in forms)
        else:
            inner = escape(forms[0]) if forms else ""
        plural = ' numerus="yes"' if text.is_plural else ""
        comment = f"<comment>{escape(text.comment)}</comment>" if text.comment else ""
        lines.append(
            f"    <message{plural}><source>{escape(text.source)}</source>{comment}\n"
            f"        <translation{state}>{inner}</translation></message>\n"
        )
    lines.append(TAIL)
    path.write_text("".join(lines), encoding="utf-8", newline="\n")
    return missing


def update(path: Path, texts: Iterable[Text]) -> tuple[int, int]:
    """Update the texts of a file. Return the numbers of missing translations and of texts.

    Translations of removed texts are lost.
    """
    only_plurals = path.stem.endswith(f"_{ONLY_PLURALS}")
    wanted = [text for text in texts if text.is_plural or not only_plurals]
    return write(path, wanted, read(path)), len(wanted)


def compile_file(path: Path) -> None:
    release = Path(sys.executable).with_name("pyside6-lrelease")
    subprocess.run([release, "-silent", path], check=True)


def main() -> int:
    texts = program_texts()
    for path in sorted(FOLDER.glob("*.ts")):
        missing, count = update(path, texts)
        compile_file(path)
        print(f"{path.name}: {missing} of {count} translations are missing")
    return 0


if __name__ == "__main__":
    sys.exit(main())
