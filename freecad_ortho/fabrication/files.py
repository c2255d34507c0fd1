"""All fabrication files of a structure, whole or not at all."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from freecad_ortho.fabrication.dxf import write_dxf
from freecad_ortho.fabrication.step import write_step
from freecad_ortho.fabrication.structure import Progress, Structure, build
from freecad_ortho.fabrication.systems.system import System
from freecad_ortho.fabrication.tables import write_parts, write_report
from solver.errors import OutputError
from solver.io.atomic import staged_folder
from solver.mesh.quadmesh import QuadMesh

FILES = ("structure.step", "flat.dxf", "parts.csv", "report.json")


def write(
    structure: Structure, folder: str | os.PathLike[str], progress: Progress | None = None
) -> list[Path]:
    """Write structure.step, flat.dxf, parts.csv and report.json.

    Args:
        structure: what to write.
        folder: made when missing; other files in it stay.
        progress: called with a fraction and words; whatever it raises stops the writing, and then
            the folder is as it was before.

    Returns:
        The files, in the order above.

    Raises:
        OutputError: the folder cannot be made or written.
        OrthoError: a solid cannot be translated.
    """
    say = progress or (lambda fraction, words: None)
    target = Path(folder)
    _refuse_folders_in_the_way(target)
    with _no_new_folders_on_failure(target), staged_folder(target) as staging:
        structure.solids(lambda fraction, words: say(0.2 * fraction, words))
        say(0.2, "structure.step")
        write_step(staging / "structure.step", structure.parts)
        say(0.8, "flat.dxf")
        write_dxf(staging / "flat.dxf", structure.parts)
        say(0.97, "parts.csv")
        write_parts(staging / "parts.csv", structure.parts, structure.verdicts)
        write_report(staging / "report.json", structure.report())
        say(1.0, "written")
    return [target / name for name in FILES]


def stage_seconds(mesh_mm: QuadMesh, systems: Sequence[System]) -> dict[str, float]:
    """Time the stages of building and writing once, for benchmarks.

    Returns:
        Seconds of ``build``, ``solids``, ``step`` (the STEP writer's own time), ``dxf``, ``tables``
        and ``total``.
    """
    seconds: dict[str, float] = {}

    def timed(name: str, work: Callable[[], object]) -> None:
        start = time.perf_counter()
        work()
        seconds[name] = time.perf_counter() - start

    import cadquery  # noqa: F401  its import, a second or two, is nobody's stage
    import ezdxf  # noqa: F401

    structures: list[Structure] = []
    timed("build", lambda: structures.append(build(mesh_mm, systems)))
    structure = structures[0]
    timed("solids", structure.solids)
    with TemporaryDirectory() as name:
        folder = Path(name)
        timed("step", lambda: write_step(folder / FILES[0], structure.parts))
        timed("dxf", lambda: write_dxf(folder / FILES[1], structure.parts))
        verdicts = structure.verdicts
        timed("tables", lambda: write_parts(folder / FILES[2], structure.parts, verdicts))
    seconds["total"] = sum(seconds.values())
    return seconds


def _refuse_folders_in_the_way(target: Path) -> None:
    for name in FILES:
        if (target / name).is_dir():
            raise OutputError(f"{target / name}: is a folder; remove it or choose another place")


@contextmanager
def _no_new_folders_on_failure(target: Path) -> Iterator[None]:
    missing = [path for path in (target, *target.parents) if not path.exists()]
    try:
        yield
    except BaseException:
        for path in missing:
            try:
                path.rmdir()
            except OSError:
                break
        raise
