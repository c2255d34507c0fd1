"""Commands that make a mesh or turn one mesh into another, from the table of sources."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from freecad_ortho import api
from freecad_ortho.cli import (
    aligning,
    faces,
    fitting,
    forming,
    multinet,
    offsetting,
    remeshing,
    reporting,
    values,
)
from freecad_ortho.cli import options as arguments
from freecad_ortho.sources import GROUPS, Source, source
from freecad_ortho.sources.placing import PLACEMENT
from freecad_ortho.units import millimetres_per
from solver.errors import InputError
from solver.mesh.mirror import size_of
from solver.mesh.seams import MEETING
from solver.option import one_of

# Commands that change a mesh, and what they are called in the table.
_CHANGES = {
    "diagonal": "diagonal mesh",
    "medial": "medial mesh",
    "checkerboard": "checkerboard",
    "dual": "Christoffel dual",
    "subdivide": "subdivide",
    "coarsen": "coarsen",
    "trim": "trim",
    "mirror": "mirror",
    "transform": "transform",
    "moebius": "Moebius transformation",
    "inversion": "inversion",
    "orient": "orient",
}
# What a form begins with and a command does only where it is told to.
_UNTOLD: dict[str, dict[str, Any]] = {"trim": {"rings": 0}, "orient": {"reverse": False}}
# Changes whose options name places.
_PLACED = ("mirror", "transform", "moebius", "inversion")
# What was an option of transform and is a command now.
_MOVED = {
    "moebius": "moebius IN --centre X,Y,Z",
    "invert": "inversion IN --centre X,Y,Z --radius R",
}
# The unit of sizes where none is said: those that are not given are about as large as in metres.
_UNNAMED = "m"


def add(commands: argparse._SubParsersAction[Any]) -> None:
    """Add all commands of this file and of its neighbours for single sources."""
    multinet.add(commands.add_parser("multinet", help="an exact orthogonal multi-net"))
    _add_primitive(commands.add_parser("primitive", help="a net that is known exactly"))
    for name, kind in _CHANGES.items():
        entry, untold = source(kind), _UNTOLD.get(name, {})
        words = entry.meaning[:1].lower() + entry.meaning[1:]
        parser = commands.add_parser(name, help=words)
        _add_input(parser)
        for option in entry.options:
            default = untold.get(option.name, option.default)
            arguments.add(parser, replace(option, default=default))
        values.add_output(parser)
        parser.set_defaults(run=_changer(name, entry, untold))
        if name == "transform":
            for gone in _MOVED:
                parser.add_argument(f"--{gone}", help=argparse.SUPPRESS)
    convert = commands.add_parser("convert", help="another format: obj, ply, off, json")
    _add_input(convert)
    values.add_output(convert)
    convert.set_defaults(run=_convert)
    _add_weld(commands.add_parser("weld", help="join patches, or one with itself, into one net"))
    forming.add(commands.add_parser("formfind", help="a membrane or cable net in equilibrium"))
    offsetting.add(commands.add_parser("offset", help="a parallel mesh at a distance"))
    fitting.add(commands.add_parser("fit-multinet", help="the multi-net nearest to a mesh"))
    faces.add(commands.add_parser("faces", help="a net on CAD faces of a STEP file"))
    aligning.add(commands.add_parser("align", help="a net along a surface's lines of curvature"))
    remeshing.add(commands.add_parser("quads", help="a triangle mesh remeshed to quads"))


def _add_input(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("input", metavar="IN.obj")
    values.add_up(parser)


def _changer(
    name: str, entry: Source, untold: dict[str, Any]
) -> Callable[[argparse.Namespace], int]:
    """The run of a change; one that names no places is made about the local origin."""

    def run(options: argparse.Namespace) -> int:
        for gone, now in _MOVED.items():
            if getattr(options, gone, None) is not None:
                raise InputError(f"--{gone}: is a command of its own now; write {now}")
        values.refuse_unwritable(options.output)
        read = reporting.read_net(options)
        told = arguments.given(entry.options, options, read.unit)
        placed = name in _PLACED
        mesh = read.mesh if placed else read.near
        source_made = entry.make(untold | told, read.unit, meshes=[mesh])
        for remark in source_made.remarks:
            sys.stderr.write(f"note: {remark}\n")
        made = source_made.mesh
        made = read.origin.near_mesh(made) if placed else made
        border = read.near_border if entry.stays else ()
        if read.border and not border:
            sys.stderr.write("note: the border of the surface stays behind\n")
        return values.write(options, made, read.unit, origin=read.origin, border=border)

    return run


def _convert(options: argparse.Namespace) -> int:
    values.refuse_unwritable(options.output)
    read = reporting.read_net(options)
    return values.write(options, read.near, read.unit, origin=read.origin, border=read.near_border)


def _add_primitive(parser: argparse.ArgumentParser) -> None:
    names = GROUPS["primitive"]
    parser.description = "Vertex (i, j) is number i*N + j."
    parser.epilog = "\n".join(f"{name}: {source(name).meaning}" for name in names)
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument("name", metavar="NAME", help=", ".join(names))
    parser.add_argument("--sampling", required=True, metavar="MxN")
    parser.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="PARAMETER=VALUE",
        help="e.g. radius=3, angles=0,180, lines=principal, profile=FILE; may be repeated",
    )
    arguments.add(parser, PLACEMENT)
    values.add_output(parser)
    parser.set_defaults(run=_primitive)


def _primitive(options: argparse.Namespace) -> int:
    values.refuse_unwritable(options.output)
    names = GROUPS["primitive"]
    one_of("NAME", options.name, names)
    entry, unit = source(options.name), options.unit or _UNNAMED
    told = arguments.given((entry.option("sampling"), PLACEMENT), options, unit)
    for setting in options.set:
        key, sign, text = setting.partition("=")
        if not sign:
            raise InputError(f"--set: expected PARAMETER=VALUE, got '{setting[:40]}'")
        option = entry.option(key)
        if option is PLACEMENT:
            raise InputError("--set placement: is said by --centre and --rotate")
        told[key] = arguments.read(option, text, unit, name=f"--set {key}")
    return values.write(options, entry.make(told, unit).mesh, options.unit)


def _add_weld(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("inputs", metavar="IN.obj", nargs="+")
    values.add_up(parser)
    arguments.add(parser, source("weld").option("tolerance"), usual="1e-5 of the size")
    values.add_output(parser)
    parser.set_defaults(run=_weld)


def _weld(options: argparse.Namespace) -> int:
    values.refuse_unwritable(options.output)
    _refuse_part(options.tolerance)
    read = [api.read_mesh(path, options.unit, options.up) for path in options.inputs]
    unit, origin = read[0].unit, read[0].origin
    nets = [one.mesh.scaled(millimetres_per(one.unit) / millimetres_per(unit)) for one in read]
    nets = [origin.near_mesh(net) for net in nets]
    entry = source("weld")
    told = arguments.given(entry.options, options, unit)
    if not told:
        told["tolerance"] = MEETING * size_of(np.concatenate([p.vertices for p in nets]))
    made = entry.make(told, unit, meshes=nets)
    merged, *remarks = made.remarks
    for remark in remarks:
        sys.stderr.write(f"note: {remark}\n")
    return values.write(options, made.mesh, unit, merged, origin)


def _refuse_part(text: str | None) -> None:
    """A tolerance was a part of the size once: a number alone may still be meant so."""
    try:
        float(text or "mm")
    except ValueError:
        return
    raise InputError(f"--tolerance: is a length; say its unit, as {text}mm")
