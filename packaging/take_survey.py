"""Import the findings of `trexcmd survey` into the parameter table.

take_survey.py FILE...   updates resources/trex_parameters.toml and prints the other findings
"""

import re
import sys
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

TABLE = Path(__file__).parents[1] / "resources" / "trex_parameters.toml"
_ROW = "[[parameter]]"


def updated(table: str, survey: Mapping[str, Any]) -> str:
    """Return the table with the surveyed ranges and defaults.

    Their grade of evidence becomes "sourced".
    """
    model = survey["board"]["model"]
    head, *rows = table.split(_ROW)
    return _ROW.join([head, *(_row(row, survey, f"default_{model}") for row in rows)])


def _row(row: str, survey: Mapping[str, Any], default: str) -> str:
    number = re.search("^number = (0x..)$", row, re.MULTILINE)
    if number is None:
        return row
    facts: dict[str, int] = {}
    if ends := re.findall(r"\d+", survey["ranges"].get(number[1], "")):
        facts |= {"min": int(ends[0]), "max": int(ends[-1])}
    if survey["board"]["stores_defaults"] and number[1] in survey["stored"]:
        facts[default] = survey["stored"][number[1]]
    head, between, grades = row.partition("\nsource = {")
    for field, value in facts.items():
        head = re.sub(rf"(?m)^{field} = \d+$", f"{field} = {value}", head)
        grades, count = re.subn(rf'\b{field} = "\w+"', f'{field} = "sourced"', grades)
        if not count:
            grades = f' {field} = "sourced",{grades}'
    return head + between + grades


def remarks(table: str, survey: Mapping[str, Any]) -> Iterator[str]:
    """Yield the findings that the table cannot hold."""
    known = {f"0x{row['number']:02X}" for row in tomllib.loads(table)["parameter"]}
    for number in survey["stored"].keys() - known:
        yield f"{number} is not in the table. Stored value: {survey['stored'][number]}"
    for number in survey["ranges"]:
        if len(survey["ranges"][number].split()) > 1:
            yield f"{number} has gaps: {survey['ranges'][number]}"
    for number, text in survey["altered"].items():
        yield f"{number} stores {text}"
    for reply, numbers in survey["unknown"].items():
        yield f"{numbers} are not parameters. Reply to reading them: {reply}"
    for cause, errors in survey["errors"].items():
        yield f"{cause} sets the error bits: {', '.join(errors) or 'none'}"


def main(files: list[str]) -> int:
    for name in files:
        survey = tomllib.loads(Path(name).read_text("utf-8"))
        board = survey["board"]
        table = TABLE.read_text("utf-8")
        TABLE.write_text(updated(table, survey), "utf-8")
        print(f"{name}: {board['model']} {board['firmware']}")
        print(*(f"  {remark}" for remark in remarks(table, survey)), sep="\n")
    return 0 if files else 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
