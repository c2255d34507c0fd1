"""Where changes are reached while tests run, and how loaded code is changed in its place."""

from __future__ import annotations

import ast
import gc
import importlib.machinery
import re
from collections import defaultdict
from collections.abc import Iterable, Mapping
from pathlib import Path
from types import CodeType, FunctionType

from mutation_map import read_at
from mutation_places import Mutation

# What a statement that was put before another one calls, with the number of a change.
CALLED = "_mutation_reached"


class Places:
    """The statements at which each change shows.

    A change in a function shows where it stands. What runs on import, a constant or a table, shows
    wherever its name is read in a function.

    Attributes:
        rows: file -> line -> numbers of changes.
        on_import: numbers of the changes that a loaded module does not show in its functions.
    """

    def __init__(self, drawn: Mapping[int, Mutation], sources: Mapping[str, str]) -> None:
        self.rows: dict[str, dict[int, set[int]]] = defaultdict(lambda: defaultdict(set))
        self.on_import: set[int] = set()
        self.sources = sources
        for number, change in drawn.items():
            first = change.lines.start
            names, lines = read_at(sources[change.file], first)
            if lines is None:
                self.rows[change.file][first].add(number)
                continue
            self.on_import.add(number)
            if not names:
                self.rows[change.file][lines.start].add(number)
                continue
            word = re.compile(rf"\b({'|'.join(names)})\b")
            for file, text in sources.items():
                for row, line in enumerate(text.splitlines(), 1):
                    if word.search(line):
                        self.rows[file][row].add(number)

    def code(self, root: Path) -> dict[str, CodeType]:
        """Compile the files anew so that they say which change is reached."""
        return {
            str(root / file): compile(
                with_calls(self.sources[file], rows), str(root / file), "exec", dont_inherit=True
            )
            for file, rows in self.rows.items()
        }


def with_calls(source: str, rows: Mapping[int, Iterable[int]]) -> ast.Module:
    """Put a call before each statement of a function at one of these lines."""
    tree = ast.parse(source)
    found: dict[tuple[int, int], tuple[list[ast.stmt], set[int]]] = {}
    for row, numbers in rows.items():
        place = _statement_at(tree.body, row)
        if place is not None:
            body, index = place
            found.setdefault((id(body), index), (body, set()))[1].update(numbers)
    # The last first: what stands before keeps its index.
    for (_, index), (body, numbers) in sorted(found.items(), key=lambda one: -one[0][1]):
        before = body[index]
        calls = ast.parse("\n".join(f"{CALLED}({number})" for number in sorted(numbers))).body
        for call in calls:
            for node in ast.walk(call):
                if isinstance(node, (ast.expr, ast.stmt)):
                    node.lineno = node.end_lineno = before.lineno
        body[index:index] = calls
    return tree


def _statement_at(
    body: list[ast.stmt], row: int, inside: bool = False
) -> tuple[list[ast.stmt], int] | None:
    """Find the innermost statement of a function at a line."""
    for index, each in enumerate(body):
        if not each.lineno <= row <= (each.end_lineno or 0):
            continue
        if isinstance(each, (ast.FunctionDef, ast.AsyncFunctionDef)):
            return _statement_at(each.body, row, True)
        if isinstance(each, ast.ClassDef):
            return _statement_at(each.body, row, inside)
        for under in _bodies(each):
            deeper = _statement_at(under, row, inside)
            if deeper is not None:
                return deeper
        words = isinstance(each, ast.Expr) and isinstance(each.value, ast.Constant)
        return (body, index) if inside and not words else None
    return None


def _bodies(statement: ast.stmt) -> list[list[ast.stmt]]:
    own = [getattr(statement, name, []) for name in ("body", "orelse", "finalbody")]
    parts = [*getattr(statement, "handlers", []), *getattr(statement, "cases", [])]
    return [*own, *(part.body for part in parts)]


class Loaded:
    """The functions of some files as they are loaded, and what is loaded of them from now on.

    Args:
        files: paths of the files whose code may be changed.
    """

    def __init__(self, files: Iterable[str]) -> None:
        self._files = set(files)
        self._functions: list[FunctionType] = []

    def look(self) -> None:
        """Remember the functions that are loaded by now."""
        self._functions = [
            one
            for one in gc.get_objects()
            if isinstance(one, FunctionType) and one.__code__.co_filename in self._files
        ]

    def replace(self, code: Mapping[str, CodeType]) -> int:
        """Give functions the code of their files as they are now; return of how many it changed.

        A function is known again by its name and its first line.
        """
        load_as(code)
        new = {file: dict(_inner(whole)) for file, whole in code.items()}
        changed = 0
        for function in self._functions:
            old = function.__code__
            found = new.get(old.co_filename, {}).get((old.co_qualname, old.co_firstlineno))
            if found is None or found == old or found.co_freevars != old.co_freevars:
                continue
            function.__code__ = found
            changed += 1
        return changed


def _inner(code: CodeType) -> Iterable[tuple[tuple[str, int], CodeType]]:
    for each in code.co_consts:
        if isinstance(each, CodeType):
            yield (each.co_qualname, each.co_firstlineno), each
            yield from _inner(each)


_INSTEAD: dict[str, CodeType] = {}
_get_code = importlib.machinery.SourceFileLoader.get_code


def _code_of(loader: importlib.machinery.SourceFileLoader, name: str) -> CodeType | None:
    path = str(loader.get_filename(name))
    return _INSTEAD.get(path) or _get_code(loader, name)


def load_as(code: Mapping[str, CodeType]) -> None:
    """Load these files, when they are imported later, as this code."""
    importlib.machinery.SourceFileLoader.get_code = _code_of  # type: ignore[method-assign]
    _INSTEAD.update(code)
