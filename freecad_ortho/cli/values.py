"""Values of options that are more than one number, and where a result goes."""

from __future__ import annotations

import argparse
import os
import re
import sys

from freecad_ortho import api
from freecad_ortho.units import MILLIMETRES
from solver.errors import InputError, OutputError
from solver.io.polygons import refuse_unknown_extension
from solver.mesh.quadmesh import QuadMesh


def allow_negative_lists(parser: argparse.ArgumentParser) -> None:
    """Let ``--range -5,-2`` be a value: by default such a word is taken for an option."""
    parser._negative_number_matcher = re.compile(r"^-[\d.]")  # type: ignore[attr-defined]


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


def sampling(text: str, option: str = "--sampling") -> tuple[int, int]:
    """The two counts of ``MxN``.

    Raises:
        InputError: not two positive whole numbers, or more than ten million vertices.
    """
    match = re.fullmatch(r"(\d{1,7})[x,](\d{1,7})", text.strip().lower())
    if match is None:
        raise InputError(f"{option}: expected MxN, e.g. 20x15, got '{text[:40]}'")
    m, n = int(match[1]), int(match[2])
    if m * n > 10_000_000:
        raise InputError(f"{option}: {m} x {n} are more than ten million vertices; take fewer")
    return m, n


def add_output(parser: argparse.ArgumentParser) -> None:
    """Options that every source of meshes has."""
    parser.add_argument("-o", "--output", required=True, metavar="OUT.obj")
    parser.add_argument(
        "--unit", choices=tuple(MILLIMETRES), help="unit of the coordinates, noted in the file"
    )
    allow_negative_lists(parser)


def refuse_unwritable(output: str, report: str | None = None) -> None:
    """Say before the work, not after it, that a mesh or a report has nowhere to go.

    Raises:
        InputError: a path is a folder or a device, or both are one, or the mesh's name says no
            format.
        OutputError: a folder is missing or cannot be written.
    """
    if report is not None and os.path.realpath(output) == os.path.realpath(report):
        raise InputError(f"{report}: is to hold both mesh and report; name two files")
    for path in (output, report):
        if path is None:
            continue
        folder = os.path.dirname(os.path.abspath(path))
        if os.path.isdir(path):
            raise InputError(f"{path}: is a folder; name a file in it")
        # A finished file takes the place of the old one, which must not be a device or a pipe.
        if os.path.exists(path) and not os.path.isfile(path):
            raise InputError(f"{path}: is not an ordinary file; name another")
        if not os.path.isdir(folder) or not os.access(folder, os.W_OK):
            raise OutputError(f"{folder}: does not exist or cannot be written; make it first")
    refuse_unknown_extension(output)


def counted(number: int, noun: str, plural: str = "") -> str:
    """``1 quad``, ``2 quads``."""
    return f"{number} {noun if number == 1 else plural or noun + 's'}"


def write(path: str, mesh: QuadMesh, unit: str | None, words: str = "") -> int:
    """Write a mesh and say so in one line; exit code 0."""
    api.write_mesh(path, mesh, unit)
    vertices = counted(len(mesh.vertices), "vertex", "vertices")
    count = f"{vertices}, {counted(len(mesh.faces), 'quad')}"
    sys.stdout.write("; ".join(part for part in (count, words, path) if part) + "\n")
    return 0
