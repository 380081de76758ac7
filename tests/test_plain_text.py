"""Text from outside is shown literally, even where Qt would parse markup."""

import ast
from collections.abc import Iterator
from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtGui import QTextDocumentFragment

from trex_gui.ui.widgets.builders import plain

_PROGRAM = Path(__file__).parents[1] / "trex_gui"
_SETTERS = {"setToolTip": 0, "showText": 1, "setLabelText": 0, "setInformativeText": 0}
_WORDS = {"QLabel", "QMessageBox", "ToolTipRole", *_SETTERS}  # names in files that show texts
_BOXES = {"about", "critical", "information", "question", "warning"}  # methods of QMessageBox
_ESCAPED = {"self.text.tool_tip"}  # markup written by the program
_OWN_VALUES = {"__version__", "spec.short_range()", "f'25 {spec.unit}'", "seconds"}  # no markup
_WITHOUT_TEXT = {"Sign"}  # labels without text
_BUILDERS = "ui/widgets/builders.py"


def _is_safe(text: ast.expr, scope: ast.AST) -> bool:
    """Return whether a text is constant or escaped."""
    match text:
        case ast.Constant():
            return True
        case ast.Call(func=ast.Name(id="plain" | "tr") | ast.Attribute(attr="plain" | "tr")):
            return True
        case ast.Call(func=ast.Attribute(value=template, attr="format"), args=values):
            arguments = {ast.unparse(value) for value in values}
            return arguments <= _OWN_VALUES and _is_safe(template, scope)
        case ast.IfExp(body=body, orelse=other):
            return _is_safe(body, scope) and _is_safe(other, scope)
        case ast.BoolOp(values=values):
            return all(_is_safe(value, scope) for value in values)
        case ast.Name(id=name):
            assigned = list(_assigned_values(name, scope))
            return bool(assigned) and all(_is_safe(value, scope) for value in assigned)
    return ast.unparse(text) in _ESCAPED


def _assigned_values(name: str, scope: ast.AST) -> Iterator[ast.expr]:
    for node in ast.walk(scope):
        match node:
            case ast.Assign(targets=[ast.Name(id=target)], value=value) if target == name:
                yield value


def _displayed_texts(node: ast.AST) -> Iterator[ast.expr]:
    """Yield the texts of a node that Qt would parse as markup."""
    match node:
        case ast.Call(func=ast.Attribute(attr=setter), args=args) if setter in _SETTERS:
            yield args[_SETTERS[setter]]
        case ast.Call(
            func=ast.Attribute(value=ast.Name(id="QMessageBox"), attr=box), args=[_, _, text, *_]
        ) if box in _BOXES:
            yield text
        case ast.Call(func=ast.Name(id="QMessageBox"), args=[_, _, text, *_]):
            yield text
        case ast.Call(func=ast.Attribute(attr="setData"), args=[*_, role, text]) if _is_tip_role(
            role
        ):
            yield text
        case ast.Dict(keys=keys, values=values):
            yield from (v for k, v in zip(keys, values, strict=True) if k and _is_tip_role(k))
        case ast.match_case(pattern=pattern, body=body) if _is_tip_role(pattern):
            yield from _returned_values(body)
        case ast.If(test=test, body=body) if _is_tip_role(test):
            yield from _returned_values(body)
        case ast.IfExp(test=test, body=text) if _is_tip_role(test):
            yield text


def _is_tip_role(node: ast.AST) -> bool:
    return any(isinstance(n, ast.Attribute) and n.attr == "ToolTipRole" for n in ast.walk(node))


def _returned_values(body: list[ast.stmt]) -> Iterator[ast.expr]:
    for statement in body:
        for node in ast.walk(statement):
            if isinstance(node, ast.Return) and node.value is not None:
                yield node.value


def _unsafe_texts(tree: ast.Module) -> Iterator[ast.expr]:
    """Yield external texts that Qt may parse as markup."""
    classes = [node for node in tree.body if isinstance(node, ast.ClassDef)]
    functions = [node for node in tree.body if not isinstance(node, ast.ClassDef)]
    for scope in (*functions, *(method for kind in classes for method in kind.body)):
        for node in ast.walk(scope):
            yield from (text for text in _displayed_texts(node) if not _is_safe(text, scope))


def _unformatted_labels(tree: ast.AST) -> Iterator[ast.expr | ast.ClassDef]:
    """Yield labels that guess their format."""
    for node in ast.walk(tree):
        match node:
            case ast.Call(func=ast.Name(id="QLabel")):
                yield node
            case ast.ClassDef(name=name, bases=[ast.Name(id="QLabel"), *_]):
                if "setTextFormat(" not in ast.unparse(node) and name not in _WITHOUT_TEXT:
                    yield node


def _parsed_files() -> Iterator[tuple[str, ast.Module]]:
    for path in sorted(_PROGRAM.rglob("*.py")):
        source = path.read_text(encoding="utf-8")
        if any(word in source for word in _WORDS):
            yield path.relative_to(_PROGRAM).as_posix(), ast.parse(source)


def test_no_external_text_is_parsed_as_markup() -> None:
    assert [
        f"{name}:{node.lineno}: {ast.unparse(node)[:60]}"
        for name, tree in _parsed_files()
        for node in (*_unsafe_texts(tree), *_unformatted_labels(tree))
        if name != _BUILDERS
    ] == []


@given(st.text(st.sampled_from("<>/&;bimg \n\xa0'=\"")))
def test_plain_text_is_shown_as_it_was_written(text: str) -> None:
    shown = plain(text)
    if shown != text:
        shown = QTextDocumentFragment.fromHtml(shown).toPlainText()
        text = text.replace("\xa0", " ").strip("\n")
    assert shown == text
