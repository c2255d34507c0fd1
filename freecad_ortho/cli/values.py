"""Values of options that are more than one number, and where a result goes."""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections.abc import Sequence

import numpy as np

from freecad_ortho import api
from freecad_ortho.cli.endings import past_stopping
from freecad_ortho.mesh_files import UP
from freecad_ortho.units import MILLIMETRES
from freecad_ortho.words import counted
from solver.errors import InputError, OutputError
from solver.io.polygons import keeps_border, refuse_unknown_extension
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import FloatArray, QuadMesh


def allow_negative_lists(parser: argparse.ArgumentParser) -> None:
    """Let ``--range -5,-2`` be a value: by default such a word is taken for an option."""
    parser._negative_number_matcher = re.compile(r"^-[\d.]")


def numbers(option: str, text: str, count: int) -> tuple[float, ...]:
    """The ``count`` numbers of ``1,2,3``.

    Raises:
        InputError: other than that many finite numbers.
    """
    try:
        values = tuple(float(word) for word in text.split(","))
    except ValueError:
        values = ()
    if len(values) != count or any(value != value or abs(value) > 1e300 for value in values):
        wanted = f"{count} finite numbers separated by commas" if count > 1 else "a finite number"
        raise InputError(f"{option}: expected {wanted}, got '{text[:40]}'")
    return values


def whole_numbers(option: str, text: str, count: int | None = None) -> tuple[int, ...]:
    """The whole numbers of ``1,2,3``, ``count`` of them where that is given.

    Raises:
        InputError: other than that many whole numbers.
    """
    found = numbers(option, text, text.count(",") + 1 if count is None else count)
    if any(number != int(number) for number in found):
        wanted = "a whole number" if count == 1 else "whole numbers separated by commas"
        raise InputError(f"{option}: expected {wanted}, got '{text[:40]}'")
    return tuple(int(number) for number in found)


def sampling(text: str, option: str = "--sampling", written: str = "MxN") -> tuple[int, int]:
    """The two counts of ``MxN``, which is ``written`` so in the help.

    Raises:
        InputError: not two positive whole numbers.
    """
    match = re.fullmatch(r"(\d{1,7})[x,](\d{1,7})", text.strip().lower())
    if match is None:
        raise InputError(f"{option}: expected {written}, e.g. 20x15, got '{text[:40]}'")
    return int(match[1]), int(match[2])


def add_output(parser: argparse.ArgumentParser) -> None:
    """Options that every source of meshes has."""
    parser.add_argument(
        "-o", "--output", required=True, metavar="OUT.obj", help="the net; its name says the format"
    )
    add_origin(parser)
    parser.add_argument(
        "--unit", choices=tuple(MILLIMETRES), help="unit of the coordinates, noted in the file"
    )


def add_origin(parser: argparse.ArgumentParser, keep: bool = True) -> None:
    """The option that says what coordinates in files are measured from, by default as before."""
    allow_negative_lists(parser)
    parser.add_argument(
        "--origin",
        type=_origin,
        default=LocalOrigin(np.zeros(3)) if keep else None,
        metavar="keep|local|X,Y,Z",
        help="what coordinates in files are measured from: the same as before (keep), a round "
        "point near a mesh that is far from the origin (local), or a point of yours, in the mesh's "
        f"unit (default: {'keep' if keep else 'local'})",
    )


def origin_of(options: argparse.Namespace, automatic: LocalOrigin) -> LocalOrigin:
    """What is taken off coordinates in files, in the unit of the mesh.

    Args:
        options: with the option ``origin``.
        automatic: the local origin of the mesh.
    """
    return automatic if options.origin is None else options.origin


def _origin(text: str) -> LocalOrigin | None:
    """What ``--origin`` says; None for the local origin of whatever the mesh will be."""
    word = text.strip().lower()
    if word in ("keep", "local"):
        return LocalOrigin(np.zeros(3)) if word == "keep" else None
    try:
        return LocalOrigin(np.array(numbers("--origin", word, 3)))
    except InputError:
        raise argparse.ArgumentTypeError(
            f"expected keep, local or X,Y,Z, got '{text[:40]}'"
        ) from None


def add_up(parser: argparse.ArgumentParser) -> None:
    """The option that says which axis points up in the files that are read."""
    parser.add_argument(
        "--up", choices=UP, default="z", help="axis that points up in the files read (default: z)"
    )


def refuse_unwritable(output: str, *others: str | None) -> None:
    """Say before the work, not after it, that a mesh, a report or the like has nowhere to go.

    Args:
        output: where the mesh goes.
        others: where other files go; None for those that are not asked for.

    Raises:
        InputError: a path is a folder or a device, or two are one, or the mesh's name says no
            format.
        OutputError: a folder is missing or cannot be written.
    """
    paths = [output, *(path for path in others if path is not None)]
    for number, path in enumerate(paths):
        if os.path.realpath(path) in map(os.path.realpath, paths[:number]):
            raise InputError(f"{path}: is to hold two files; name two files")
        folder = os.path.dirname(os.path.abspath(path))
        if os.path.isdir(path):
            raise InputError(f"{path}: is a folder; name a file in it")
        # A finished file takes the place of the old one, which must not be a device or a pipe.
        if os.path.exists(path) and not os.path.isfile(path):
            raise InputError(f"{path}: is not an ordinary file; name another")
        if not os.path.isdir(folder) or not os.access(folder, os.W_OK):
            raise OutputError(f"{folder}: does not exist or cannot be written; make it first")
    refuse_unknown_extension(output)


def write_mesh(
    options: argparse.Namespace,
    mesh: QuadMesh,
    unit: str | None,
    origin: LocalOrigin,
    border: Sequence[FloatArray] = (),
) -> LocalOrigin:
    """Write a mesh that lies about ``origin``; return what the file's coordinates lie about."""
    wanted = origin_of(options, origin)
    # Their difference is taken first: a file about a local origin has every digit of the work.
    back = LocalOrigin(origin.shift - wanted.shift)
    lines = [back.back(line) for line in border]
    # What is written is done, and so is the command but for what it says of it.
    past_stopping()
    api.write_mesh(options.output, back.back_mesh(mesh), unit, lines)
    if border and not keeps_border(options.output):
        sys.stderr.write(
            "note: the border is kept in a .json file only; parts are trimmed along it\n"
        )
    return wanted


def about(origin: LocalOrigin, unit: str | None) -> str:
    """Words that say what coordinates are measured from."""
    point = ", ".join(f"{value:.12g}" for value in origin.shift.tolist())
    return f"coordinates about {point}" + (f" {unit}" if unit else "")


def write(
    options: argparse.Namespace,
    mesh: QuadMesh,
    unit: str | None,
    words: str = "",
    origin: LocalOrigin | None = None,
    border: Sequence[FloatArray] = (),
) -> int:
    """Write a mesh where the options want it and say so in one line; exit code 0.

    Args:
        options: with ``output`` and ``origin``.
        mesh: the mesh, about ``origin`` where that is given.
        unit: of its coordinates.
        words: what else to say.
        origin: the local origin of what the mesh was made from; by default the mesh's own.
        border: closed polylines (N, 3) along which parts on it are trimmed; about ``origin``.
    """
    if origin is None:
        origin = LocalOrigin.of_mesh(mesh)
        mesh = origin.near_mesh(mesh)
    path = options.output
    wanted = write_mesh(options, mesh, unit, origin, border)
    if wanted.far:
        words = "; ".join(part for part in (words, about(wanted, unit)) if part)
    vertices = counted(len(mesh.vertices), "vertex", "vertices")
    count = f"{vertices}, {counted(len(mesh.faces), 'quad')}"
    sys.stdout.write("; ".join(part for part in (count, words, path) if part) + "\n")
    return 0
