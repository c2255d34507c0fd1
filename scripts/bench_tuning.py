"""Doubles and halves every number of the solver and prints what changes on the authors' meshes.

Run with the project's Python:
    python scripts/bench_tuning.py [--write] [--quick] [--only way|last-phase|words] [NUMBER ...]

Numbers of the way to a net are tried on one case for each mesh, those of the last phase on the
first case with one that heeds them, those of what is said of a result on three of these. A case is
*elsewhere* where a vertex of its mesh comes to lie more than 0.01 mean edges from its usual place,
and *says otherwise* where the words of its warnings and remarks are others. ``--write`` puts
the tables into docs/tuning.md, or rows of some numbers into those that stand there; ``--quick``
leaves large and hard cases out.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, replace
from functools import partial
from itertools import islice
from typing import Any, ClassVar

import numpy as np
from bench import ROOT, SHARED, write

from freecad_ortho import api
from freecad_ortho.words import counted
from solver import Constraints, NetOptions, Outcome, QuadMesh, optimise
from solver.analysis.form import surface_of
from solver.tuning import Tuning

# What the paper's authors made their meshes for.
CASES = {
    "heart": "principal",
    "conical1": "conical",
    "botanic-garden-bubble-0": "principal",
    "complete01": "asymptotic --diagonal",
    "cmc1": "cmc",
    "knet1": "asymptotic",
    "enneper2": "asymptotic --diagonal",
    "chebyshev_sphere": "chebyshev",
    "quad_dome": "stress",
    "6-sub-lifted": "stress",
    "wein99_diag": "cmc --diagonal",
    "helical-minimal": "asymptotic",
    "gnet1": "geodesic",
}
# Those of fewer than a thousand vertices that are near to their net.
QUICK = ("heart", "cmc1", "knet1", "chebyshev_sphere", "quad_dome", "6-sub-lifted")
WAY, LAST_PHASE, WORDS = "way", "last-phase", "words"
FIRST = {WAY: "fade", LAST_PHASE: "along_evenness", WORDS: "crumpled"}
PAGE = ROOT / "docs" / "tuning.md"
MOST_STEPS = 200
MOVED = 0.01


@dataclass(frozen=True)
class Case:
    """A mesh and the net that it is to become, and what else is wanted.

    Attributes:
        pulled: a handle that is drawn aside.
        near: the surface that was drawn, to within this part of a mean edge.
        kinds: so many kinds of panels.
    """

    name: str
    mesh: QuadMesh
    net: str
    pulled: bool = False
    near: float | None = None
    kinds: int | None = None

    def outcome(self, tuning: Tuning) -> Outcome:
        """Optimise with these numbers."""
        net, _, diagonal = self.net.partition(" --")
        wanted = None
        if self.pulled:
            middle = len(self.mesh.vertices) // 2
            lift = self.mesh.mean_edge * self.mesh.vertex_normals[middle]
            wanted = Constraints(handles={middle: self.mesh.vertices[middle] + lift})
        if self.near is not None:
            drawn = surface_of(self.mesh)
            wanted = Constraints(close_to=(drawn.vertices, drawn.triangles))
        return optimise(
            self.mesh,
            net,
            options=NetOptions(diagonal=bool(diagonal)),
            constraints=wanted,
            within=None if self.near is None else self.near * self.mesh.mean_edge,
            repeat="none" if self.kinds is None else "panels",
            kinds=self.kinds,
            max_steps=MOST_STEPS,
            tuning=tuning,
        )


def cases(quick: bool) -> Iterator[Case]:
    """All cases whose mesh is there."""
    for name, net in CASES.items():
        path = SHARED / f"{name}.obj"
        if path.is_file() and (name in QUICK or not quick):
            yield Case(f"{name} {net}", api.read_mesh(path).mesh, net)
    dome = SHARED / "quad_dome.obj"
    if dome.is_file():
        yield Case("quad_dome, a handle", api.read_mesh(dome).mesh, "principal", pulled=True)


def cases_of_the_last_phase() -> Iterator[Case]:
    """Near to a surface, with a handle, with few kinds of panels, and led on early."""
    path = SHARED / "quad_dome.obj"
    if path.is_file():
        dome = api.read_mesh(path).mesh
        yield Case("planar", dome, "planar", near=0.005)
        yield Case("a handle", dome, "asymptotic", pulled=True)
        yield Case("few kinds", dome, "planar", kinds=6)
        yield Case("stress", dome, "stress", near=0.02)


def cases_of_words() -> Iterator[Case]:
    """Near to a surface, with a handle, and one of which the shape becomes another."""
    yield from islice(cases_of_the_last_phase(), 2)
    yield from (case for case in cases(True) if case.net == "chebyshev")


class Recorded(Tuning):
    """The numbers as they are, and which of them were asked for."""

    heeded: ClassVar[set[str]] = set()

    def __getattribute__(self, name: str) -> Any:
        """A number; its name is noted."""
        Recorded.heeded.add(name)
        return super().__getattribute__(name)


def scaled(value: Any, factor: float) -> Any:
    """A number, or several of them, times a factor; counts stay whole and at least one."""
    if isinstance(value, tuple):
        return tuple(factor * part for part in value)
    return max(1, round(factor * value)) if isinstance(value, int) else factor * value


def effect(found: dict[str, Outcome], usual: dict[str, Outcome]) -> str:
    """What is different from usual, in words."""
    before, after = (
        sum(outcome.report.iterations for outcome in each.values()) for each in (usual, found)
    )
    words = [] if before == after else [f"{after} steps"]
    moved = {}
    for name, outcome in found.items():
        old = usual[name]
        if outcome.report.status != old.report.status:
            words.append(f"{name}: {outcome.report.status}")
        else:
            ways = np.linalg.norm(outcome.mesh.vertices - old.mesh.vertices, axis=1)
            moved[name] = ways.max() / old.report.mean_edge
    far = {name: way for name, way in moved.items() if way > MOVED}
    if far:
        most = max(far, key=far.__getitem__)
        words.append(f"{counted(len(far), 'case')} elsewhere, {most} by {far[most]:.2g}")
    others = [name for name in moved if said(found[name]) != said(usual[name])]
    if others:
        words.append(f"{counted(len(others), 'case')} saying otherwise, {others[0]}")
    return "; ".join(words) or "nothing"


def said(outcome: Outcome) -> tuple[bool, set[str]]:
    """Whether a shape is another one, and what else is said of it but for numbers."""
    report = outcome.report
    texts = (*report.warnings, *report.remarks)
    return report.far, {re.sub(r"[-+.e\d]*\d", "", text) for text in texts}


def written(value: Any) -> str:
    """A number or several as they stand in the table."""
    return ", ".join(f"{part:g}" for part in (value if isinstance(value, tuple) else (value,)))


def numbers() -> dict[str, list[str]]:
    """Names of the numbers of each table, in the order in which they are explained."""
    names = [item.name for item in fields(Tuning)]
    begins = [names.index(first) for first in FIRST.values()]
    ends = [*begins[1:], len(names)]
    return {which: names[begin:end] for which, begin, end in zip(FIRST, begins, ends, strict=True)}


def table(asked: Sequence[Case], names: Sequence[str], first: bool) -> Iterator[str]:
    """Lines of a table of these numbers; the first says how the cases are.

    Args:
        asked: on which they are varied.
        names: of the numbers.
        first: each on the first case only that heeds it.
    """
    plain, usual, heeds = Tuning(), {}, {}
    for case in asked:
        Recorded.heeded.clear()
        usual[case.name] = case.outcome(Recorded())
        heeds[case.name] = set(Recorded.heeded)
    steps = sum(outcome.report.iterations for outcome in usual.values())
    yield f"{len(asked)} cases, {steps} steps as it is."
    yield from ("", "| number | value | halved | doubled |", "| --- | ---: | --- | --- |")
    for name in names:
        value, effects = getattr(plain, name), []
        heeding = [case for case in asked if name in heeds[case.name]]
        for factor in (0.5, 2.0):
            other = replace(plain, **{name: scaled(value, factor)})
            tried = heeding[:1] if first else heeding
            found = {case.name: case.outcome(other) for case in tried}
            effects.append(effect({**usual, **found}, usual))
        yield f"| {name} | {written(value)} | {effects[0]} | {effects[1]} |"


def named(lines: Sequence[str]) -> dict[str, str]:
    """Rows of a table by the numbers that they are of."""
    rows = (line for line in lines if re.match(r"\| \w+ \|", line))
    found = {line.split(" | ")[0].removeprefix("| "): line for line in rows}
    found.pop("number", None)
    return found


def rows_of(which: str) -> dict[str, str]:
    """Rows that stand in a table of the page."""
    text = PAGE.read_text(encoding="utf-8")
    return named(text.partition(f"<!-- {which} table: begin -->")[2].split("<!--")[0].splitlines())


def main() -> None:
    """Print a row a number."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true", help="update docs/tuning.md")
    parser.add_argument("--quick", action="store_true", help="without large and hard cases")
    parser.add_argument("--only", choices=tuple(FIRST), help="numbers of one table")
    parser.add_argument("names", nargs="*", metavar="NUMBER", help="only these numbers")
    options = parser.parse_args()
    made = {
        WAY: partial(cases, options.quick),
        LAST_PHASE: cases_of_the_last_phase,
        WORDS: cases_of_words,
    }
    for which, names in numbers().items():
        if options.only not in (None, which):
            continue
        asked = list(made[which]())
        if not asked:
            sys.exit(f"{SHARED} is missing: these are the meshes that the numbers are tried on")
        wanted = [name for name in names if not options.names or name in options.names]
        lines = []
        for line in table(asked, wanted, which == LAST_PHASE) if wanted else ():
            print(line, flush=True)
            lines.append(line)
        if options.write and lines:
            before = rows_of(which) if options.names else {}
            rows = {**before, **named(lines)}
            text = [*lines[: -len(wanted)], *(rows[name] for name in names if name in rows)]
            write(PAGE, which, "\n".join(text))


if __name__ == "__main__":
    main()
