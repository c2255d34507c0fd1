"""The command ``multinet``: an exact orthogonal multi-net from a few numbers and a curve."""

from __future__ import annotations

import argparse

from freecad_ortho.cli import options as arguments
from freecad_ortho.cli import values
from freecad_ortho.sources.multinets import ELLIPTIC_NET, MULTI_NET
from freecad_ortho.sources.source import Source
from solver.errors import InputError
from solver.io.points import read_points
from solver.mesh.quadmesh import FloatArray
from solver.multinet.presets import PRESETS

# The option that says which of the two it is: the net of a curve in elliptic coordinates, or that
# of a polyline on a quadric.
_KINDS = {"moving": ELLIPTIC_NET, "quadric": MULTI_NET}


def add(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.description = (
        "Orthogonal multi-net: equal diagonals in every rectangle of parameter lines. "
        "Vertex (i, j), i along the curve, j along t, is number i*N + j."
    )
    which = parser.add_mutually_exclusive_group(required=True)
    for name, entry in _KINDS.items():
        arguments.add(which, entry.option(name), usual="")
    offered = {option.name: option for entry in _KINDS.values() for option in entry.options}
    for name, option in offered.items():
        users = [kind for kind, entry in _KINDS.items() if _has(entry, name)]
        if name not in _KINDS:
            before = "" if len(users) == len(_KINDS) else f"with --{users[0]}: "
            arguments.add(parser, option, before)
    # Points are set onto the quadric in any case now.
    parser.add_argument("--snap", action="store_true", help=argparse.SUPPRESS)
    values.add_output(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Build the net and write it."""
    values.refuse_unwritable(options.output)
    entry = MULTI_NET if options.quadric else ELLIPTIC_NET
    _take_apart(options, entry)
    for other in _KINDS.values():
        for option in other.options:
            told = getattr(options, option.name, None) is not None
            if told and not _has(entry, option.name):
                flag = arguments.flag_of(option)
                raise InputError(f"{flag}: the {entry.name} has no such option; leave it out")
    unit = options.unit or "m"
    made = entry.make(arguments.given(entry.options, options, unit), unit)
    (said,) = made.remarks
    # Numbers without a unit stay without one.
    words = said if options.unit else said.replace(f" {unit}2", "")
    return values.write(options, made.mesh, options.unit, words)


def _has(entry: Source, name: str) -> bool:
    return name in entry.defaults


def _take_apart(options: argparse.Namespace, entry: Source) -> None:
    """Let ``--curve`` name a file, or two formulas, as well."""
    text = options.curve
    if text is None or (entry is ELLIPTIC_NET and text in entry.option("curve").choices):
        return
    if text in PRESETS:
        raise InputError("--curve: expected a file of points on the quadric; presets need --moving")
    options.curve = None
    if ";" not in text:
        columns = _points(text).shape[1]
        setattr(options, "points" if columns == 3 or entry is MULTI_NET else "coordinates", text)
        return
    formulas = text.split(";")
    if len(formulas) != 2:
        raise InputError(f"--curve: expected two formulas separated by ';', got {len(formulas)}")
    options.curve, (options.first_formula, options.second_formula) = "formulas", formulas


def _points(path: str) -> FloatArray:
    try:
        return read_points(path, (2, 3))
    except InputError as error:
        if "no such file" in str(error):
            raise InputError(
                f"--curve: '{path}' is neither a file nor one of {', '.join(PRESETS)}"
            ) from None
        raise
