"""All fabrication files of a structure, whole or not at all."""

from __future__ import annotations

import json
import os
import re
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from freecad_ortho.fabrication.different import different_patterns
from freecad_ortho.fabrication.dxf import write_dxf, write_sheet
from freecad_ortho.fabrication.exchange import WRITERS
from freecad_ortho.fabrication.formats import FORMATS
from freecad_ortho.fabrication.hardware import Hardware
from freecad_ortho.fabrication.nesting.sheet import file_words
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.production import Production, produce
from freecad_ortho.fabrication.report import overview, report_page
from freecad_ortho.fabrication.report.way import StagesBefore
from freecad_ortho.fabrication.step import write_step
from freecad_ortho.fabrication.stl import write_stl
from freecad_ortho.fabrication.structure import Progress, Structure, build
from freecad_ortho.fabrication.systems.system import System, SystemParts
from freecad_ortho.fabrication.tables import (
    lists,
    write_bends,
    write_bevels,
    write_report,
    write_table,
)
from freecad_ortho.fabrication.workshop import Workshop
from solver.io.atomic import no_new_folders_on_failure, refuse_in_the_way, staged_folder
from solver.mesh.quadmesh import QuadMesh

REPORT = "report.json"
_FLAT = "flat.dxf"
_STEP = "structure.step"
FILES = (
    _STEP,
    _FLAT,
    "parts.csv",
    "nodes.csv",
    "stock.csv",
    "bevels.csv",
    REPORT,
    "report.html",
)
BENDS = "bends.csv"
HARDWARE = "hardware.csv"
SHEETS = "sheets"
JOINTS = "joints"
PARTS = "parts"
# What an earlier report may name for removal: nothing but such names is ever written beside FILES.
_OF_FORMATS = "|".join(re.escape(each.file).replace(r"\*", r"[^/\\]+") for each in FORMATS.values())
_REMOVABLE = re.compile(
    rf"{re.escape(_FLAT)}|structure(-[^/\\]+)?\.step|[^/\\]+\.csv|{_OF_FORMATS}"
    rf"|({SHEETS}|{JOINTS}|{PARTS})/[^/\\]+\.(dxf|svg|stl)"
)


def write(
    structure: Structure,
    folder: str | os.PathLike[str],
    progress: Progress | None = None,
    *,
    workshop: Workshop | None = None,
    executor: Executor | None = None,
    project: str = "",
    way: StagesBefore | None = None,
    check: Mapping[str, Any] | None = None,
) -> list[Path]:
    """Write solids, flat patterns, lists and reports; with a sheet size the folder ``sheets`` too.

    Args:
        structure: what to write.
        folder: made when missing; files in it that no earlier run wrote stay.
        progress: called with a fraction and words; whatever it raises stops the writing, and then
            the folder is as it was before.
        workshop: sizes of sheets and bars, width of the cut.
        executor: for work on parts; the files are the same with any and without.
        project: what the readable report is headed by.
        way: how the net came to be, which the reports begin with.
        check: numbers of a structural check of the net, which the reports tell.

    Returns:
        The files, in the order of ``FILES`` (``flat.dxf`` only where a part has a flat pattern and
        not in files of single parts, ``structure.step`` only where it holds all), then the lists of
        bends and of hardware where there are some, the lists and solids of single systems, the
        files of the sheets, of the joints to be printed and of parts.

    Raises:
        InputError: sheets or stock on which no part fits, a kerf that closes a slot.
        OutputError: the folder cannot be made or written.
        OrthoError: a solid cannot be translated.
    """
    say = progress or (lambda fraction, words: None)
    target = Path(folder)
    solids = _step_files(structure, workshop or Workshop())
    formats = [each.file for each in FORMATS.values()]
    for name in (*FILES, *formats, *solids, f"{SHEETS}/*", f"{JOINTS}/*", f"{PARTS}/*"):
        refuse_in_the_way(target, name)
    production = produce(structure, workshop, executor, lambda f, words: say(0.2 * f, words))
    with no_new_folders_on_failure(target), staged_folder(target, earlier(target)) as staging:
        structure.solids(lambda fraction, words: say(0.2 + 0.2 * fraction, words), executor)
        for number, (name, (parts, hardware)) in enumerate(solids.items()):
            say(0.4 + 0.4 * number / len(solids), name)
            tolerance = production.workshop.step_tolerance
            in_place = production.workshop.step == "in-place"
            words = production.on_site
            write_step(staging / name, parts, structure.place, tolerance, words, in_place, hardware)
        if production.named_patterns:
            say(0.8, "flat patterns")
            _write_patterns(staging, production)
        if production.sheets:
            say(0.9, SHEETS)
            _write_sheets(staging / SHEETS, production)
        _write_formats(staging, production, project, say)
        say(0.95, "lists and reports")
        _write_joints(staging / JOINTS, structure)
        names = write_lists(staging, production, project, way, check)
        say(1.0, "written")
    return [target / name for name in names]


def _step_files(
    structure: Structure, workshop: Workshop
) -> dict[str, tuple[Sequence[Part], Hardware]]:
    """The parts of each file of solids and the hardware drawn in it, by its name."""
    drawn = workshop.hardware == "solids"
    if workshop.step != "systems":
        return {_STEP: (structure.parts, _hardware(structure.results.values(), drawn))}
    return {
        f"{file_words('structure', system, result.parts[0].material.name)}.step": (
            result.parts,
            _hardware([result], drawn),
        )
        for system, result in structure.results.items()
    }


def _hardware(results: Iterable[SystemParts], drawn: bool) -> Hardware:
    """Bolts, gaskets and setting blocks of systems where they are drawn."""
    chosen = list(results) if drawn else []
    return Hardware(
        tuple(each for result in chosen for each in result.fasteners),
        tuple(part for result in chosen for part in result.loose()),
    )


def _beside(folder: Path, structure: Structure) -> list[str]:
    """Names of the files beside those that every structure has."""
    tables = [table.name for result in structure.results.values() for table in result.tables]
    found = [name for name in (BENDS, HARDWARE, *tables) if (folder / name).exists()]
    for each in FORMATS.values():
        found += sorted(path.relative_to(folder).as_posix() for path in folder.glob(each.file))
    found += sorted(path.name for path in folder.glob("structure-*.step"))
    return found + [
        f"{folder_name}/{path.name}"
        for folder_name in (SHEETS, JOINTS, PARTS)
        for path in sorted((folder / folder_name).glob("*"))
    ]


def earlier(target: Path) -> Iterator[str]:
    """Names of the files that an earlier run wrote here and that another one may leave out.

    Looked up when they are asked for: until then that run may not have come to its end.
    """
    try:
        report = json.loads((target / REPORT).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        # Missing, or something else of that name: then nothing here is known to be ours.
        return
    names = report.get("files") if isinstance(report, dict) and "systems" in report else None
    for name in names if isinstance(names, list) else []:
        if isinstance(name, str) and _REMOVABLE.fullmatch(name):
            yield name


def write_lists(
    folder: Path,
    production: Production,
    project: str = "",
    way: StagesBefore | None = None,
    check: Mapping[str, Any] | None = None,
) -> list[str]:
    """Write the lists and reports into a folder that holds all other files.

    Returns:
        Names of all files, which the report lists too.

    Raises:
        OSError: a file cannot be written.
    """
    for name, (columns, rows) in lists(production).items():
        write_table(folder / f"{name}.csv", columns, rows)
    if any(pattern.bends for pattern in production.named_patterns.values()):
        write_bends(folder / BENDS, production.named_patterns)
    write_bevels(folder / "bevels.csv", production.named_patterns)
    for result in production.structure.results.values():
        for table in result.tables:
            write_table(folder / table.name, *table.placed(production.structure.place))
    page = report_page(production, project, way, check)
    (folder / "report.html").write_text(page, encoding="utf-8")
    usual = [name for name in FILES if name not in (_FLAT, _STEP) or (folder / name).exists()]
    names = [*usual, *_beside(folder, production.structure)]
    before = {} if way is None else way.numbers
    after = {} if check is None else {"structural_check": check}
    write_report(folder / REPORT, {**before, **production.report(), **after, "files": names})
    return names


def _write_formats(folder: Path, production: Production, project: str, say: Progress) -> None:
    """Write what other programs read; a format whose package is missing is said by the report."""
    wanted = [each for each in production.workshop.formats if not each.missing]
    for number, each in enumerate(wanted):

        def go_on(done: float, name: str = each.place, before: int = number) -> None:
            say(0.9 + 0.05 * (before + done) / len(wanted), name)

        WRITERS[each.name](folder / each.place, production, project, go_on)


def _write_joints(folder: Path, structure: Structure) -> None:
    joints = [part for result in structure.results.values() for part in result.joints]
    if joints:
        folder.mkdir()
    for part in joints:
        write_stl(folder / f"{part.name}.stl", part)


def _write_patterns(folder: Path, production: Production) -> None:
    """Write flat patterns together, or each of the different ones by itself."""
    form, patterns = production.workshop.dxf_form, production.named_patterns
    if form.layout != "parts":
        write_dxf(folder / _FLAT, patterns, form)
        return
    (folder / PARTS).mkdir()
    for drawing in different_patterns(production):
        write_dxf(folder / PARTS / drawing.file_name, {drawing.name: drawing.pattern}, form)


def _write_sheets(folder: Path, production: Production) -> None:
    folder.mkdir()
    for sheet in production.sheets:
        write_sheet(folder / sheet.file_name, sheet, production.workshop.dxf_form)
    (folder / "overview.svg").write_text(overview(production.sheets), encoding="utf-8")


def stage_seconds(mesh_mm: QuadMesh, systems: Sequence[System]) -> dict[str, float]:
    """Time the stages of building and writing once, for benchmarks.

    Returns:
        Seconds of processor time, so that other work on the machine matters little, of ``build``,
        ``checks`` (all that needs no solids), ``solids``, ``step`` (the STEP writer's own time),
        ``dxf``, ``tables`` and ``total``.
    """
    seconds: dict[str, float] = {}

    def timed(name: str, work: Callable[[], object]) -> None:
        start = time.process_time()
        work()
        seconds[name] = time.process_time() - start

    import cadquery  # noqa: F401  its import, a second or two, is nobody's stage
    import ezdxf  # noqa: F401

    structures: list[Structure] = []
    timed("build", lambda: structures.append(build(mesh_mm, systems)))
    structure = structures[0]
    productions: list[Production] = []
    timed("checks", lambda: productions.append(produce(structure)))
    production = productions[0]
    timed("solids", structure.solids)
    with TemporaryDirectory() as name:
        folder = Path(name)
        timed("step", lambda: write_step(folder / FILES[0], structure.parts))
        timed("dxf", lambda: write_dxf(folder / FILES[1], production.named_patterns))
        timed("tables", lambda: write_lists(folder, production))
    seconds["total"] = sum(seconds.values())
    return seconds
