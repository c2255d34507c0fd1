"""The command ``build``: from a design surface to the files of its parts, stage by stage."""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Any

from freecad_ortho import __version__, api
from freecad_ortho.cli import aligning, fabricating, net_options, optimising, values
from freecad_ortho.cli.endings import EXIT_NOT_CONVERGED, EXIT_OK
from freecad_ortho.cli.stages import (
    ALIGN,
    FABRICATE,
    OPTIMISE,
    Stages,
    digest,
    files_among,
    key_of,
)
from freecad_ortho.fabrication.files import REPORT
from freecad_ortho.fabrication.report.way import Stage, Way
from freecad_ortho.step_faces import is_step, triangles_from_step
from freecad_ortho.triangles import read_triangles
from freecad_ortho.units import MILLIMETRES, millimetres_per
from freecad_ortho.words import counted
from solver import Outcome
from solver.analysis.form_check import Finding, check_form
from solver.errors import InputError
from solver.io.atomic import no_new_folders_on_failure
from solver.io.json_mesh import write_json
from solver.mesh.local_origin import LocalOrigin
from solver.nets import NETS, net_named
from solver.report import CONVERGED, STOPPED

# Nets that have lines on a surface, and as what these are found.
LINES = {name: net.lines for name, net in NETS.items() if net.lines}
_ALIGNED, _NET = "aligned.json", "net.json"


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
        "--net", default="principal", help=f"{', '.join(LINES)} (default: principal)"
    )
    aligning.add_settings(parser.add_argument_group("net on the surface"))
    net_options.add(parser.add_argument_group("exact net"))
    fabricating.add_settings(parser)
    fabricating.add_workers(parser)
    parser.add_argument("-o", "--output", required=True, metavar="DIR")
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
    lines = _lines(options.net)
    net_options.refuse_unfit(options)
    net_options.refuse_unreadable(options)
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


def _lines(net: str) -> str:
    """The lines that a net starts from."""
    asked = net_named(net)
    if asked.name not in LINES:
        raise InputError(
            f"net: a surface has no lines for {asked.name} nets; build makes {', '.join(LINES)}"
        )
    return LINES[asked.name]


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
        return {"net": options.net} | _settings(options, net_options.add)
    return _settings(options, fabricating.add_settings)


def _keys(options: argparse.Namespace) -> dict[str, str]:
    """Keys of the stages; each is made from the one before it."""
    origin = None if options.origin is None else options.origin.shift.tolist()
    before = {ALIGN: [digest(options.input), _lines(options.net)], FABRICATE: [origin]}
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
        keep = LocalOrigin(0.0 * found.origin.shift)
        mesh, unit, border = found.in_file(keep)
        write_json(folder / _ALIGNED, mesh, unit, border)
        api.write_mesh((folder / _ALIGNED).with_suffix(".obj"), mesh, unit)
        words = f"{counted(len(mesh.faces), 'quad')}, {found.words}"
        numbers = found.numbers(keep)
        # The border is in the file of the net.
        del numbers["border"]
        entry |= _told(words, options, ALIGN, begin) | {"numbers": numbers}
    sys.stdout.write(f"{ALIGN}: {words}; {stages.folder / _ALIGNED}\n")


def _optimise(options: argparse.Namespace, stages: Stages) -> None:
    begin = time.monotonic()
    aligned = stages.folder / _ALIGNED
    loaded = api.read_mesh(aligned)
    settings = net_options.settings(options, loaded, _surface(options, loaded.unit))
    with stages.made(OPTIMISE) as (folder, entry):
        outcome = optimising.optimised(options, loaded, settings)
        _pass_on_interrupt(outcome, options.max_steps)
        mesh = loaded.origin.back_mesh(outcome.mesh)
        write_json(folder / _NET, mesh, loaded.unit, loaded.border)
        api.write_mesh((folder / _NET).with_suffix(".obj"), mesh, loaded.unit)
        report = outcome.report
        findings = check_form(loaded.mesh, mesh, report.form, report.within)
        entry |= _told(report.message, options, OPTIMISE, begin) | {
            "numbers": report.as_dict(),
            "exact": report.status == CONVERGED,
            "form": [asdict(finding) for finding in findings],
            "unit": loaded.unit,
        }
    optimising.tell(outcome, str(stages.folder / _NET), loaded)


def _surface(options: argparse.Namespace, unit: str) -> net_options.Triangles:
    """The surface to stay near, in the unit of the net."""
    if not is_step(options.input):
        points, triangles, _ = read_triangles(options.input, options.up)
        return points, triangles
    numbers = values.whole_numbers("--faces", options.faces) if options.faces else ()
    points, triangles = triangles_from_step(options.input, numbers)
    return points / millimetres_per(unit), triangles


def _pass_on_interrupt(outcome: Outcome, max_steps: int) -> None:
    """A run that was stopped ends well, with what it reached; here it is to be gone on with."""
    if outcome.report.status == STOPPED and outcome.report.iterations < max_steps:
        raise KeyboardInterrupt


def _form_holds(stages: Stages) -> bool:
    """Say how the form check ends: whether the net is exact and fit to be built."""
    entry = stages.entry(OPTIMISE) or {}
    findings = [Finding(**told) for told in entry["form"]]
    wrong = [finding for finding in findings if not finding.met]
    if entry["exact"] and not wrong:
        sys.stdout.write(f"form: {_form_words(findings, entry['unit'])}\n")
        return True
    if not entry["exact"]:
        sys.stderr.write(f"form: the net is not exact: {entry['words']}\n")
    for finding in wrong:
        place = ", ".join(f"{x:.4g}" for x in finding.place)
        sys.stderr.write(
            f"form: {_measured(finding, entry['unit'])}, at {finding.where} near ({place}), where "
            f"{_limit(finding, entry['unit'])}; try: {finding.remedy}\n"
        )
    return False


def _form_words(findings: list[Finding], unit: str) -> str:
    return ", ".join(_measured(finding, unit) for finding in findings)


def _measured(finding: Finding, unit: str) -> str:
    """A measure of form in words."""
    if finding.measure == "folded faces":
        return counted(int(finding.value), "folded face") if finding.value else "no folded faces"
    if finding.measure == "off the surface":
        return f"{_millimetres(finding.value, unit)} off the surface at most"
    of_start = " of the start's" * (finding.measure == "shortest edge")
    return f"{finding.measure} {finding.value:.2f}{of_start}"


def _limit(finding: Finding, unit: str) -> str:
    if finding.measure == "folded faces":
        return f"{finding.limit:g} are allowed"
    if finding.measure == "off the surface":
        return f"{_millimetres(finding.limit, unit)} are allowed"
    return f"{finding.limit:.2f} is wanted"


def _millimetres(length: float, unit: str) -> str:
    return f"{length * millimetres_per(unit):,.3g} mm"


def _fabricate(options: argparse.Namespace, stages: Stages) -> None:
    begin = time.monotonic()
    net = api.read_mesh(stages.folder / _NET)
    words = fabricating.fabricated(options, net, Path(options.input).stem, _way(stages))
    report = json.loads((stages.folder / REPORT).read_text(encoding="utf-8"))
    stages.enter(FABRICATE, _told(words, options, FABRICATE, begin), report["files"])
    sys.stdout.write(f"{FABRICATE}: {words}\n")


def _way(stages: Stages) -> Way:
    """The stages before the parts, for the reports."""
    align, optimise = (stages.entry(name) or {} for name in (ALIGN, OPTIMISE))
    findings = [Finding(**told) for told in optimise["form"]]
    form = _form_words(findings, optimise["unit"])
    failed = [finding.measure for finding in findings if not finding.met]
    verdict = "fails: " + ", ".join(failed) if failed else "holds"
    if not optimise["exact"]:
        verdict = "fails: the net is not exact"
    return Way(
        [
            Stage(ALIGN, _words_of(align["settings"]), align["words"]),
            Stage(OPTIMISE, _words_of(optimise["settings"]), optimise["words"]),
            Stage("form check", verdict, form),
        ],
        stages.numbers(),
    )


def _words_of(settings: dict[str, Any]) -> str:
    return ", ".join(f"{name.replace('_', ' ')} {value}" for name, value in settings.items())


def _told(words: str, options: argparse.Namespace, name: str, begin: float) -> dict[str, Any]:
    return {
        "words": words,
        "settings": _asked(options, name),
        "seconds": round(time.monotonic() - begin, 3),
    }
