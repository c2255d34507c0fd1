"""The quick pass over a draw of changes, what came of it kept in a file, and a table of that."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path

from mutation_map import LEFT_OUT, copy_of_tree
from mutation_nearest import Nearest
from mutation_places import Mutation
from mutation_probes import Places


@dataclass
class Record:
    """What came of a draw so far.

    Attributes:
        changes: the draw in words; of another draw nothing is taken over.
        noticed: number -> the test that noticed it.
        asked: number -> how many tests did not notice it, or did not before one did.
        files: files of tests that are done.
    """

    changes: list[str]
    noticed: dict[str, str] = field(default_factory=dict)
    asked: dict[str, int] = field(default_factory=dict)
    files: list[str] = field(default_factory=list)

    @staticmethod
    def of(path: Path, drawn: Sequence[Mutation]) -> Record:
        """Take up what a file says of this draw, or begin."""
        changes = [str(one) for one in drawn]
        if path.exists():
            kept = Record(**json.loads(path.read_text(encoding="utf-8")))
            if kept.changes == changes:
                return kept
        return Record(changes)

    def keep(self, path: Path) -> None:
        """Write it down."""
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(asdict(self), indent=1), encoding="utf-8")

    def table(self) -> str:
        """All changes and what noticed them, a table in Markdown."""
        rows = ["| no. | change | noticed by |", "|---|---|---|"]
        for number, words in enumerate(self.changes, 1):
            by = self.noticed.get(str(number))
            none = f"none of {self.asked.get(str(number), 0)} tests"
            shown = words.replace("|", "\\|")
            rows.append(f"| {number} | `{shown}` | {f'`{by}`' if by else none} |")
        return "\n".join(rows)


def try_quickly(drawn: Sequence[Mutation], path: Path) -> dict[int, Mutation]:
    """Try changes in forks of one process, and go on where that was broken off.

    Args:
        drawn: the changes.
        path: where the record is kept.

    Returns:
        what no test noticed, by its number from 1.
    """
    # pytest and what else is loaded once for all forks.
    import cadquery  # noqa: F401
    from mutation_forks import Tried, Warm

    record = Record.of(path, drawn)
    with tempfile.TemporaryDirectory() as name:
        root = copy_of_tree(Path(name))
        left = {
            number: one for number, one in enumerate(drawn, 1) if str(number) not in record.noticed
        }
        sources = _texts(root, ("solver", "freecad_ortho"), "*.py")
        tests = {
            file: text
            for file, text in _texts(root, ("tests",), "test_*.py").items()
            if not file.startswith(LEFT_OUT)
        }
        near = Nearest(sources, tests)
        warm = Warm(
            root,
            left,
            Places(left, sources),
            {number: near.ranks(one.file) for number, one in left.items()},
        )

        def done(file: str, found: Mapping[int, Tried]) -> None:
            for number, tried in found.items():
                key = str(number)
                record.asked[key] = record.asked.get(key, 0) + tried.tests
                if tried.by:
                    record.noticed[key] = tried.by
                    print(f"{number:4d} {left[number]}: noticed by {tried.by}", flush=True)
            record.files.append(file)
            record.keep(path)
            remaining = len(drawn) - len(record.noticed)
            print(f"     {file}: {len(found)} tried, {remaining} left", flush=True)

        warm.try_all([file for file in tests if file not in record.files], done)
    return {number: one for number, one in left.items() if str(number) not in record.noticed}


def _texts(root: Path, folders: Sequence[str], pattern: str) -> dict[str, str]:
    paths = sorted(path for folder in folders for path in (root / folder).rglob(pattern))
    return {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8") for path in paths}
