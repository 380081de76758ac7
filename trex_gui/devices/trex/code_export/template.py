"""Templates that look like the code that they become.

`@name@` stands for a value; one of several lines repeats what stands before it, such as the
indentation or a comment sign. Lines of their own choose what is left in, and may be nested:
`@if name@` or `@if not name@`, `@else@`, `@end@`.
"""

import re
from collections.abc import Iterator, Mapping

_VALUE = re.compile(r"@([a-z][a-z0-9_]*)@")
_DIRECTIVE = re.compile(r"@(?:if (?P<not>not )?(?P<name>[a-z0-9_]+)|(?P<word>else|end))@")


class TemplateError(Exception):
    """A template of ours is wrong: a mistake of the developer, not of the person."""


def fill(template: str, values: Mapping[str, str], flags: Mapping[str, bool]) -> str:
    """Return the text that a template becomes.

    Raises:
        TemplateError: it names a value or a flag that is not given, or its conditions do not
            pair.
    """
    return "".join(f"{line}\n" for line in _lines(template, values, flags))


def _lines(template: str, values: Mapping[str, str], flags: Mapping[str, bool]) -> Iterator[str]:
    holds: list[bool] = []  # of each condition around this line
    for number, line in enumerate(template.splitlines(), 1):
        try:
            directive = _DIRECTIVE.fullmatch(line)
            if directive is None:
                if all(holds):
                    yield _filled(line, values)
            elif name := directive["name"]:
                holds.append(flags[name] != bool(directive["not"]))
            else:
                condition = holds.pop()
                if directive["word"] == "else":
                    holds.append(not condition)
        except LookupError as error:
            message = f"line {number} of the template, {line!r}: {error}"
            raise TemplateError(message) from error
    if holds:
        raise TemplateError(f"{len(holds)} conditions of the template have no end")


def _filled(line: str, values: Mapping[str, str]) -> str:
    def value(found: re.Match[str]) -> str:
        return values[found[1]].replace("\n", "\n" + line[: found.start()])

    return _VALUE.sub(value, line)
