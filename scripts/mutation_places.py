"""Where a source file can be changed by a small mistake, and what the change is."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass

_COMPARED: dict[type[ast.cmpop], tuple[str, str]] = {
    ast.Lt: ("<", ">="),
    ast.LtE: ("<=", ">"),
    ast.Gt: (">", "<="),
    ast.GtE: (">=", "<"),
    ast.Eq: ("==", "!="),
    ast.NotEq: ("!=", "=="),
    ast.Is: ("is", "is not"),
    ast.IsNot: ("is not", "is"),
    ast.In: ("in", "not in"),
    ast.NotIn: ("not in", "in"),
}
# Counts are compared one off, as people do.
_ONE_OFF = {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}
_CALCULATED: dict[type[ast.operator], tuple[str, str]] = {
    ast.Add: ("+", "-"),
    ast.Sub: ("-", "+"),
    ast.Mult: ("*", "/"),
    ast.Div: ("/", "*"),
    ast.FloorDiv: ("//", "*"),
    ast.Mod: ("%", "*"),
    ast.Pow: ("**", "*"),
    ast.MatMult: ("@", "*"),
}


@dataclass(frozen=True)
class Mutation:
    """One small change of one file.

    Attributes:
        file: path from the root of the project.
        start, end: what is replaced, in characters from the beginning of the file.
        text: what takes its place.
        lines: numbers of the lines concerned, from 1.
        was: what stood there, on one line.
    """

    file: str
    start: int
    end: int
    text: str
    lines: range
    was: str

    def applied(self, source: str) -> str:
        """Return the source with the change."""
        return source[: self.start] + self.text + source[self.end :]

    def __str__(self) -> str:
        return f"{self.file}:{self.lines.start}: {self.was} -> {self.text or 'nothing'}"


def mutations_of(file: str, source: str) -> list[Mutation]:
    """List all changes of a file that leave it readable to Python, in the order of their places."""
    return sorted(_Places(file, source).found(), key=lambda one: (one.start, one.end, one.text))


class _Places:
    """Walks through the syntax tree of one file."""

    def __init__(self, file: str, source: str) -> None:
        self.file, self.source = file, source
        self.tree = ast.parse(source)
        # The tree counts columns in bytes.
        self.rows = source.encode().splitlines(keepends=True)
        self.begins = [0]
        for row in self.rows:
            self.begins.append(self.begins[-1] + len(row.decode()))

    def found(self) -> Iterator[Mutation]:
        for node in self._nodes(self.tree):
            yield from self._of_node(node)

    def _nodes(self, node: ast.AST) -> Iterator[ast.AST]:
        """All nodes but those of types, of words for people and of what only types need."""
        yield node
        for name, value in ast.iter_fields(node):
            if name in ("annotation", "returns", "decorator_list") or _types_only(node):
                continue
            for child in value if isinstance(value, list) else [value]:
                if isinstance(child, ast.AST) and not isinstance(child, ast.JoinedStr):
                    yield from self._nodes(child)

    def _of_node(self, node: ast.AST) -> Iterator[Mutation]:
        if isinstance(node, ast.Compare) and len(node.ops) == 1:
            yield from self._comparison(node)
        elif isinstance(node, ast.BinOp) and not (_is_text(node.left) or _is_text(node.right)):
            if type(node.op) in _CALCULATED:
                old, new = _CALCULATED[type(node.op)]
                yield from self._between(node.left, node.right, old, new)
        elif isinstance(node, ast.BoolOp):
            old, new = ("and", "or") if isinstance(node.op, ast.And) else ("or", "and")
            yield from self._between(node.values[0], node.values[1], old, new)
        elif isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.Not, ast.USub)):
            start = self._place(node)
            yield self._at(start, start + (3 if isinstance(node.op, ast.Not) else 1), "")
        elif isinstance(node, ast.Constant):
            yield from self._constant(node)
        elif isinstance(node, (ast.Raise, ast.AugAssign)) or _is_call(node):
            yield self._at(self._place(node), self._end(node), "pass")

    def _comparison(self, node: ast.Compare) -> Iterator[Mutation]:
        old, new = _COMPARED[type(node.ops[0])]
        right = node.comparators[0]
        if old in _ONE_OFF and (_is_count(node.left) or _is_count(right)):
            new = _ONE_OFF[old]
        yield from self._between(node.left, right, old, new)

    def _constant(self, node: ast.Constant) -> Iterator[Mutation]:
        value = node.value
        if isinstance(value, bool):
            yield self._at(self._place(node), self._end(node), str(not value))
        elif isinstance(value, int):
            yield self._at(self._place(node), self._end(node), str(value + 1))
        elif isinstance(value, float):
            yield self._at(self._place(node), self._end(node), repr(2 * value or 1.0))

    def _between(self, left: ast.expr, right: ast.expr, old: str, new: str) -> Iterator[Mutation]:
        """Replace an operator between two operands, where brackets may stand too."""
        first, last = self._end(left), self._place(right)
        words = r"\s+".join(map(re.escape, old.split()))
        pattern = rf"\b{words}\b" if old[0].isalpha() else words
        match = re.search(pattern, self.source[first:last])
        if match:
            yield self._at(first + match.start(), first + match.end(), new)

    def _at(self, start: int, end: int, text: str) -> Mutation:
        rows = self.source.count("\n", 0, start) + 1, self.source.count("\n", 0, end) + 1
        was = " ".join(self.source[start:end].split())
        line = " ".join(self.source.splitlines()[rows[0] - 1].split())
        words = was if len(was) > 12 else f"{was} in «{line}»"
        return Mutation(self.file, start, end, text, range(rows[0], rows[1] + 1), words)

    def _place(self, node: ast.expr | ast.stmt) -> int:
        return self._characters(node.lineno, node.col_offset)

    def _end(self, node: ast.expr | ast.stmt) -> int:
        return self._characters(node.end_lineno or node.lineno, node.end_col_offset or 0)

    def _characters(self, line: int, column: int) -> int:
        return self.begins[line - 1] + len(self.rows[line - 1][:column].decode())


def _types_only(node: ast.AST) -> bool:
    """A block that only type checkers read, or a name for a type."""
    if isinstance(node, ast.If):
        return isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING"
    return False


def _is_text(node: ast.expr) -> bool:
    return isinstance(node, ast.JoinedStr) or (
        isinstance(node, ast.Constant) and isinstance(node.value, str)
    )


def _is_count(node: ast.expr) -> bool:
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        return node.func.id == "len"
    return isinstance(node, ast.Constant) and isinstance(node.value, int)


def _is_call(node: ast.AST) -> bool:
    """A statement that is nothing but a call."""
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Call)
