"""Commands that make a mesh or turn one mesh into another."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable

from freecad_ortho import api
from freecad_ortho.cli import faces, fitting, forming, offsetting, remeshing, reporting, values
from freecad_ortho.units import millimetres_per
from solver.errors import InputError
from solver.io.points import read_points
from solver.mesh import coarsen, mirror, subdivide, transform
from solver.mesh.diagonal import checkerboard, diagonal_meshes, medial_mesh
from solver.mesh.primitives import PRIMITIVES, Parameter, primitive
from solver.mesh.quadmesh import QuadMesh
from solver.mesh.seams import MEETING

Change = Callable[[QuadMesh, argparse.Namespace], QuadMesh]


def add(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add all commands of this file and of its neighbours for fitting, forming and remeshing."""
    _add_primitive(commands.add_parser("primitive", help="a net that is known exactly"))
    for name, (words, change, options) in _CHANGES.items():
        parser = commands.add_parser(name, help=words)
        parser.add_argument("input", metavar="IN.obj")
        values.add_up(parser)
        for flag, settings in options.items():
            parser.add_argument(flag, **settings)  # type: ignore[arg-type]
        values.add_output(parser)
        parser.set_defaults(run=_changer(change, name not in _PLACED))
    _add_weld(commands.add_parser("weld", help="join patches, or one with itself, into one net"))
    forming.add(commands.add_parser("formfind", help="a membrane or cable net in equilibrium"))
    offsetting.add(commands.add_parser("offset", help="a parallel mesh at a distance"))
    fitting.add(commands.add_parser("fit-multinet", help="the multi-net nearest to a mesh"))
    faces.add(commands.add_parser("faces", help="a net on CAD faces of a STEP file"))
    remeshing.add(commands.add_parser("quads", help="a triangle mesh remeshed to quads"))


def _changer(change: Change, anywhere: bool) -> Callable[[argparse.Namespace], int]:
    """The run of a change; one that is the same ``anywhere`` is made about the local origin."""

    def run(options: argparse.Namespace) -> int:
        values.refuse_unwritable(options.output)
        loaded = reporting.load(options)
        origin = loaded.origin
        made = change(loaded.near if anywhere else loaded.mesh, options)
        made = made if anywhere else origin.near_mesh(made)
        return values.write(options, made, loaded.unit, origin=origin)

    return run


def _add_primitive(parser: argparse.ArgumentParser) -> None:
    lines = [f"{name}: {entry.meaning}" for name, entry in PRIMITIVES.items()]
    parser.description = "Vertex (i, j) is number i*N + j."
    parser.epilog = "\n".join(lines)
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument("name", metavar="NAME", help=", ".join(PRIMITIVES))
    parser.add_argument("--sampling", required=True, metavar="MxN")
    parser.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="PARAMETER=VALUE",
        help="e.g. radius=3, angles=0,180, lines=principal, profile=FILE; may be repeated",
    )
    values.add_output(parser)
    parser.set_defaults(run=_primitive)


def _primitive(options: argparse.Namespace) -> int:
    values.refuse_unwritable(options.output)
    m, n = values.sampling(options.sampling)
    if options.name not in PRIMITIVES:
        raise InputError(f"NAME: expected one of {', '.join(PRIMITIVES)}, got '{options.name}'")
    known = {parameter.name: parameter for parameter in PRIMITIVES[options.name].parameters}
    given = {}
    for setting in options.set:
        key, sign, text = setting.partition("=")
        if not sign or key not in known:
            raise InputError(
                f"--set: expected PARAMETER=VALUE with one of {', '.join(known) or 'none'}, got "
                f"'{setting[:40]}'"
            )
        given[key] = _setting(known[key], text)
    mesh = primitive(options.name, m, n, **given)
    return values.write(options, mesh, options.unit)


def _setting(parameter: Parameter, text: str) -> object:
    option = f"--set {parameter.name}"
    if parameter.kind == "points":
        return read_points(text, (2, 3))
    if isinstance(parameter.default, tuple):
        return values.numbers(option, text, len(parameter.default))
    return text if parameter.kind == "word" else values.numbers(option, text, 1)[0]


def _add_weld(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("inputs", metavar="IN.obj", nargs="+")
    values.add_up(parser)
    parser.add_argument(
        "--tolerance",
        type=float,
        default=MEETING,
        metavar="PART",
        help="merge distance as a part of the size of the whole, less than half the shortest edge "
        "at each vertex (default: 1e-5)",
    )
    values.add_output(parser)
    parser.set_defaults(run=_weld)


def _weld(options: argparse.Namespace) -> int:
    values.refuse_unwritable(options.output)
    if not 0 <= options.tolerance < 0.1:
        raise InputError(f"--tolerance: expected 0 to 0.1, got {options.tolerance:g}")
    loaded = [api.read_mesh(path, options.unit, options.up) for path in options.inputs]
    unit = loaded[0].unit
    patches = [one.mesh.scaled(millimetres_per(one.unit) / millimetres_per(unit)) for one in loaded]
    origin = loaded[0].origin
    patches = [origin.near_mesh(patch) for patch in patches]
    mesh = mirror.welded(patches, options.tolerance)
    merged, *remarks = mirror.weld_remarks(patches, mesh)
    for remark in remarks:
        sys.stderr.write(f"note: {remark}\n")
    return values.write(options, mesh, unit, merged, origin)


def _diagonal(mesh: QuadMesh, options: argparse.Namespace) -> QuadMesh:
    if options.which not in ("1", "2"):
        raise InputError(f"--which: expected 1 or 2, got '{options.which}'")
    pair = diagonal_meshes(mesh, options.boundary)
    part = pair.first if options.which == "1" else pair.second
    return coarsen.compact(part, part.faces)


def _subdivide(mesh: QuadMesh, options: argparse.Namespace) -> QuadMesh:
    rules = {"plain": subdivide.subdivided, "catmull-clark": subdivide.catmull_clark}
    if options.rule not in rules:
        raise InputError(f"--rule: expected {' or '.join(rules)}, got '{options.rule}'")
    return rules[options.rule](mesh, options.levels)


def _coarsen(mesh: QuadMesh, options: argparse.Namespace) -> QuadMesh:
    """Every k-th line of any mesh, or separate steps on one of grid type."""
    if "x" in options.every:
        u, v = values.sampling(options.every, "--every")
        return coarsen.coarsened_grid(mesh, u, v, not options.drop_border)
    return coarsen.coarsened(mesh, values.whole_numbers("--every", options.every, 1)[0])


def _trim(mesh: QuadMesh, options: argparse.Namespace) -> QuadMesh:
    if options.rings:
        return coarsen.without_border(mesh, options.rings)
    counts = values.whole_numbers("--rows", options.rows or "0,0,0,0", 4)
    if not any(counts):
        raise InputError("trim: expected --rows or --rings, got neither; say what to cut off")
    return coarsen.trimmed(mesh, (counts[0], counts[2]), (counts[1], counts[3]))


def _plane(options: argparse.Namespace) -> tuple[tuple[float, ...], tuple[float, ...]]:
    axes = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
    normal = axes.get(options.normal) or values.numbers("--normal", options.normal, 3)
    return normal, values.numbers("--point", options.point, 3)


def _mirror(mesh: QuadMesh, options: argparse.Namespace) -> QuadMesh:
    change = mirror.reflection if options.alone else mirror.mirrored
    return change(mesh, *_plane(options))


def _transform(mesh: QuadMesh, options: argparse.Namespace) -> QuadMesh:
    centre = values.numbers("--centre", options.centre, 3)
    if options.moebius is not None:
        mesh = transform.moebius(mesh, values.numbers("--moebius", options.moebius, 3))
    if options.invert is not None:
        *pole, radius = values.numbers("--invert", options.invert, 4)
        mesh = transform.inverted(mesh, pole, radius)
    return transform.similarity(
        mesh,
        scale=options.scale,
        degrees=values.numbers("--turn", options.turn, 3),
        move=values.numbers("--move", options.move, 3),
        centre=centre,
    )


def _turned(mesh: QuadMesh, options: argparse.Namespace) -> QuadMesh:
    mesh = mirror.reversed_orientation(mesh) if options.reverse else mesh
    return mirror.swapped(mesh) if options.swap else mesh


# Changes whose options name places.
_PLACED = ("mirror", "transform")
_CHANGES: dict[str, tuple[str, Change, dict[str, dict[str, object]]]] = {
    "diagonal": (
        "one of the two diagonal meshes",
        _diagonal,
        {
            "--which": {"default": "1", "metavar": "1|2", "help": "1 holds the first vertex"},
            "--boundary": {"default": "drop", "metavar": "drop|fill", "help": "zigzag or closed"},
        },
    ),
    "medial": ("mesh of the points where medial lines cross", lambda m, o: medial_mesh(m), {}),
    "checkerboard": ("edge midpoints: a parallelogram a face", lambda m, o: checkerboard(m), {}),
    "subdivide": (
        "four faces for each, parameter lines kept",
        _subdivide,
        {
            "--levels": {"type": int, "default": 1, "metavar": "K"},
            "--rule": {"default": "plain", "metavar": "plain|catmull-clark"},
        },
    ),
    "coarsen": (
        "every k-th parameter line",
        _coarsen,
        {
            "--every": {"default": "2", "metavar": "K|KxL", "help": "KxL for meshes of grid type"},
            "--drop-border": {"action": "store_true", "help": "with KxL: leave odd rows out"},
        },
    ),
    "trim": (
        "cut rows or border rings off",
        _trim,
        {
            "--rows": {"metavar": "U0,U1,V0,V1", "help": "rows at the starts and ends of u and v"},
            "--rings": {"type": int, "default": 0, "metavar": "K", "help": "rings of border faces"},
        },
    ),
    "mirror": (
        "a mesh and its mirror image, the seam merged",
        _mirror,
        {
            "--normal": {"default": "x", "metavar": "x|y|z|X,Y,Z"},
            "--point": {"default": "0,0,0", "metavar": "X,Y,Z", "help": "a point of the plane"},
            "--alone": {"action": "store_true", "help": "the image only"},
        },
    ),
    "transform": (
        "move, turn, scale; Moebius transformation",
        _transform,
        {
            "--scale": {"type": float, "default": 1.0, "metavar": "F"},
            "--turn": {"default": "0,0,0", "metavar": "X,Y,Z", "help": "degrees about x, y, z"},
            "--move": {"default": "0,0,0", "metavar": "X,Y,Z"},
            "--centre": {"default": "0,0,0", "metavar": "X,Y,Z", "help": "of scale and turn"},
            "--moebius": {"metavar": "X,Y,Z", "help": "centre; keeps place and size of the mesh"},
            "--invert": {"metavar": "X,Y,Z,R", "help": "inversion in a sphere"},
        },
    ),
    "orient": (
        "reverse the orientation, swap u and v",
        _turned,
        {"--reverse": {"action": "store_true"}, "--swap": {"action": "store_true"}},
    ),
    "convert": ("write a mesh in another format: obj, ply, off, json", lambda m, o: m, {}),
}
