"""The command ``build``: from a design surface to the files of its parts, stage by stage."""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from freecad_ortho import __version__, api, building
from freecad_ortho.cli import aligning, fabricating, net_options, optimising, values
from freecad_ortho.cli.endings import EXIT_NOT_CONVERGED, EXIT_OK
from freecad_ortho.fabrication.files import REPORT
from freecad_ortho.stages import (
    ALIGN,
    FABRICATE,
    OPTIMISE,
    Stages,
    digest,
    files_among,
    key_of,
)
from freecad_ortho.surface_files import SurfaceFile
from freecad_ortho.units import MILLIMETRES, millimetres_per
from solver import Outcome
from solver.analysis.form_check import Finding
from solver.io.atomic import no_new_folders_on_failure
from solver.report import STOPPED


def add(parser: argparse.ArgumentParser) -> None:
    """Options of the command: those of its stages."""
    parser.description = (
        "The whole way: a net along the lines of a surface, made exact near to it, its form "
        "checked, then its parts and their files. What a stage needs is taken from DIR where it "
        "is there already, so that a run that ended early goes on."
    )
    parser.add_argument("input", metavar="SURFACE.step|stl|obj|ply|off|glb")
    parser.add_argument(
        "--unit",
        choices=tuple(MILLIMETRES),
        help="unit of the surface (default: what the file says, else mm); lengths of the net are "
        "in it, those of parts in mm",
    )
    values.add_up(parser)
    parser.add_argument(
        "--net", default="principal", help=f"{', '.join(building.LINES)} (default: principal)"
    )
    aligning.add_settings(parser.add_argument_group("net on the surface"))
    net_options.add_most(parser.add_argument_group("exact net"))
    fabricating.add_settings(parser)
    fabricating.add_workers(parser)
    parser.add_argument("-o", "--output", required=True, metavar="DIR", help="folder of the files")
    values.add_origin(parser, keep=False)
    parser.add_argument("--again", action="store_true", help="make every stage anew")
    parser.add_argument(
        "--go-on", action="store_true", help="make parts even where the form check fails"
    )
    parser.add_argument("-v", "--verbose", action="store_true", help="say what is being done")
    parser.set_defaults(run=run, close_to=None)


def run(options: argparse.Namespace) -> int:
    """Make the stages that are not there yet."""
    # What no surface is needed for is refused before minutes are spent on one.
    lines = building.lines_of(options.net)
    net_options.refuse_unfit(options)
    net_options.refuse_unreadable(_with_planes(options, ""))
    fabricating.refuse_unfit(options)
    folder = Path(options.output)
    head = {"surface": Path(options.input).name, "version": __version__}
    stages = Stages(folder, _keys(options), head, options.again)
    with no_new_folders_on_failure(folder):
        _stage(stages, ALIGN, options, lambda: _align(options, lines, stages))
    _stage(stages, OPTIMISE, options, lambda: _optimise(options, stages))
    if not _form_holds(stages) and not options.go_on:
        return EXIT_NOT_CONVERGED
    _stage(stages, FABRICATE, options, lambda: _fabricate(options, stages))
    return EXIT_OK


def _settings(
    options: argparse.Namespace, add_settings: Callable[[argparse.ArgumentParser], None]
) -> dict[str, Any]:
    """What was said of the settings of a stage, by name."""
    alone = argparse.ArgumentParser(add_help=False)
    add_settings(alone)
    usual = vars(alone.parse_args([]))
    return {
        name: getattr(options, name)
        for name, default in usual.items()
        if getattr(options, name) != default
    }


def _asked(options: argparse.Namespace, name: str) -> dict[str, Any]:
    """Settings of a stage that are not the usual ones."""
    if name == ALIGN:
        told = {"unit": options.unit, "up": None if options.up == "z" else options.up}
        given = {key: value for key, value in told.items() if value}
        return given | _settings(options, aligning.add_settings)
    if name == OPTIMISE:
        return {"net": options.net} | _settings(options, net_options.add_most)
    return _settings(options, fabricating.add_settings)


def _keys(options: argparse.Namespace) -> dict[str, str]:
    """Keys of the stages; each is made from the one before it."""
    origin = None if options.origin is None else options.origin.shift.tolist()
    before = {ALIGN: [digest(options.input), building.lines_of(options.net)], FABRICATE: [origin]}
    keys: dict[str, str] = {}
    key = ""
    for name in (ALIGN, OPTIMISE, FABRICATE):
        asked = _asked(options, name)
        key = keys[name] = key_of(key, before.get(name), asked, files_among(asked))
    return keys


def _stage(
    stages: Stages, name: str, options: argparse.Namespace, make: Callable[[], object]
) -> None:
    """Make a stage, or say that it is as before."""
    entry = stages.entry(name)
    if entry is not None:
        sys.stdout.write(f"{name}: as before, {entry['words']}\n")
        return
    sys.stdout.write(f"{name} ...\n")
    sys.stdout.flush()
    make()


def _align(options: argparse.Namespace, lines: str, stages: Stages) -> None:
    begin = time.monotonic()
    with stages.made(ALIGN) as (folder, entry):
        found = aligning.align(argparse.Namespace(**{**vars(options), "net": lines}))
        building.keep_aligned(found, folder, entry)
        entry |= _told(options, ALIGN, begin)
    sys.stdout.write(f"{ALIGN}: {entry['words']}; {stages.folder / building.ALIGNED}\n")


def _optimise(options: argparse.Namespace, stages: Stages) -> None:
    begin = time.monotonic()
    read = api.read_mesh(stages.folder / building.ALIGNED)
    planes = building.mirror_planes(read.near, options.symmetry)
    exact = _with_planes(options, planes)
    settings = net_options.settings(exact, read, _surface(options, read.unit))
    with stages.made(OPTIMISE) as (folder, entry):
        outcome = optimising.optimised(options, read, settings)
        _pass_on_interrupt(outcome, settings["max_steps"])
        back = replace(outcome, mesh=read.origin.back_mesh(outcome.mesh))
        building.keep_outcome_of(read, back, folder, entry)
        entry |= _told(options, OPTIMISE, begin)
    optimising.tell(outcome, str(stages.folder / building.NET), read)


def _with_planes(options: argparse.Namespace, letters: str) -> argparse.Namespace:
    """The options of an exact net, which names its mirror planes by letters."""
    return argparse.Namespace(**{**vars(options), "symmetry": letters})


def _surface(options: argparse.Namespace, unit: str) -> net_options.Triangles:
    """The surface to stay near, in the unit of the net."""
    numbers = values.whole_numbers("--faces", options.faces) if options.faces else ()
    return SurfaceFile.read(options.input, unit, options.up, numbers).triangles


def _pass_on_interrupt(outcome: Outcome, max_steps: int) -> None:
    """A run that was stopped ends well, with what it reached; here it is to be gone on with."""
    if outcome.report.status == STOPPED and outcome.report.iterations < max_steps:
        raise KeyboardInterrupt


def _form_holds(stages: Stages) -> bool:
    """Say how the form check ends: whether the net is exact and fit to be built."""
    if not building.failures(stages):
        sys.stdout.write(f"form: {building.form_words(stages)}\n")
        return True
    entry = stages.entry(OPTIMISE) or {}
    if not entry["exact"]:
        sys.stderr.write(f"form: the net is not exact: {entry['words']}\n")
    for finding in building.findings_of(stages):
        if finding.met:
            continue
        place = ", ".join(f"{x:.4g}" for x in finding.place)
        sys.stderr.write(
            f"form: {building.measured(finding, entry['unit'])}, at {finding.where} near "
            f"({place}), where {_limit(finding, entry['unit'])}; try: {finding.remedy}\n"
        )
    return False


def _limit(finding: Finding, unit: str) -> str:
    if finding.measure == "folded faces":
        return f"{finding.limit:g} are allowed"
    if finding.measure in ("off the surface", "off the border"):
        return f"{finding.limit * millimetres_per(unit):,.3g} mm are allowed"
    return f"{finding.limit:.2f} is wanted"


def _fabricate(options: argparse.Namespace, stages: Stages) -> None:
    begin = time.monotonic()
    net = api.read_mesh(stages.folder / building.NET)
    way = building.way_of(stages)
    words = fabricating.fabricated(options, net, Path(options.input).stem, way)
    report = json.loads((stages.folder / REPORT).read_text(encoding="utf-8"))
    entry = {"words": words} | _told(options, FABRICATE, begin)
    stages.enter(FABRICATE, entry, report["files"])
    sys.stdout.write(f"{FABRICATE}: {words}\n")


def _told(options: argparse.Namespace, name: str, begin: float) -> dict[str, Any]:
    return {"settings": _asked(options, name), "seconds": round(time.monotonic() - begin, 3)}
