"""Which files of tests are near a source file, by names alone: nothing is run."""

from __future__ import annotations

import ast
import re
from collections.abc import Mapping
from pathlib import PurePosixPath


class Nearest:
    """Ranks files of tests for a source file.

    What names the module, what it defines or what its users define is near, and so is what is
    called like it or like its folder.

    Args:
        sources: text of each source file, by its path from the root.
        tests: text of each file of tests, likewise.
    """

    def __init__(self, sources: Mapping[str, str], tests: Mapping[str, str]) -> None:
        self._sources, self._tests = sources, tests
        self._words = {
            file: {*re.findall(r"[\w.]+", text), *re.findall(r"\w+", text)}
            for file, text in tests.items()
        }
        self._known: dict[str, dict[str, int]] = {}
        self._definitions: dict[str, set[str]] = {}

    def ranks(self, file: str) -> dict[str, int]:
        """Count the files of tests from the nearest to a source file, 0, to the farthest."""
        if file not in self._known:
            path = PurePosixPath(file)
            module = ".".join(path.with_suffix("").parts).removesuffix(".__init__")
            imported = re.compile(rf"^from \.+.*\b{re.escape(path.stem)}\b", re.MULTILINE)
            users = [
                other
                for other, text in self._sources.items()
                if other != file and (module in text or imported.search(text))
            ]
            theirs = {name for user in users for name in self._defined(user)}
            scores = {test: self._score(test, path, module, theirs) for test in self._tests}
            order = sorted(scores, key=lambda test: (-scores[test], test))
            self._known[file] = {test: rank for rank, test in enumerate(order)}
        return self._known[file]

    def _score(self, test: str, path: PurePosixPath, module: str, theirs: set[str]) -> float:
        words = self._words[test]
        called = PurePosixPath(test).stem.removeprefix("test_")
        folder = path.parts[-2] if len(path.parts) > 1 else ""
        score = 6.0 if module in words else 0.0
        if module.rpartition(".")[0] in words and path.stem in words:
            score += 4.0
        score += min(3.0 * len(words & self._defined(str(path))), 9.0)
        if called.rstrip("s") == path.stem.rstrip("s"):
            score += 6.0
        elif any(part in called for part in path.stem.split("_") if len(part) > 3):
            score += 2.0
        if folder and folder.rstrip("s") in called:
            score += 3.0
        score += len(set(PurePosixPath(test).parts[1:-1]) & set(path.parts[:-1]))
        score += min(0.7 * len(theirs & words), 3.0)
        # A long file of tests has many words.
        return score - len(self._tests[test]) / 1e6

    def _defined(self, file: str) -> set[str]:
        if file not in self._definitions:
            self._definitions[file] = {
                node.name
                for node in ast.parse(self._sources[file]).body
                if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and node.name[0] != "_"
            }
        return self._definitions[file]
