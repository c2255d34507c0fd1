"""Writing a check: tables, the model for other programs, and a page to read."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from pathlib import Path

from freecad_ortho.fabrication.tables import write_report, write_table
from freecad_ortho.structural.calculix import input_file
from freecad_ortho.structural.check import StructuralCheck
from freecad_ortho.structural.numbers import check_numbers, combination_numbers, model_numbers
from freecad_ortho.structural.page import check_page
from freecad_ortho.structural.sizing import Try
from freecad_ortho.structural.tables import TABLES, sizing
from solver.io.atomic import no_new_folders_on_failure, refuse_in_the_way, staged_folder

CHECK, MODEL, COMBINATIONS = "check.json", "model.json", "combinations.json"
PAGE, CALCULIX, SIZING = "check.html", "model.inp", "sizing.csv"
FILES = (PAGE, CHECK, MODEL, COMBINATIONS, *TABLES)
_SOMETIMES = (CALCULIX, SIZING)


def write_check(
    check: StructuralCheck,
    folder: str | os.PathLike[str],
    project: str = "",
    tries: Sequence[Try] = (),
) -> list[Path]:
    """Write all files of a check, or none.

    Args:
        check: what was found.
        folder: made when missing; other files in it stay.
        project: what the page is headed by.
        tries: sections that were tried.

    Returns:
        The files; ``model.inp`` only where CalculiX has such beams, ``sizing.csv`` only where
        sections were tried.

    Raises:
        OutputError: the folder cannot be written.
    """
    target = Path(folder)
    for name in (*FILES, *_SOMETIMES):
        refuse_in_the_way(target, name)
    beams = input_file(check.model)
    # What an earlier check left and this one has not would be taken for its own.
    gone = [name for name in _SOMETIMES if (target / name).exists()]
    with no_new_folders_on_failure(target), staged_folder(target, gone) as staging:
        (staging / PAGE).write_text(check_page(check, project), encoding="utf-8")
        write_report(staging / CHECK, check_numbers(check))
        combinations = [one.combination for one in check.found]
        write_report(staging / COMBINATIONS, combination_numbers(combinations))
        model = json.dumps(model_numbers(check.model), allow_nan=False) + "\n"
        (staging / MODEL).write_text(model, encoding="utf-8")
        for name, table in TABLES.items():
            columns, rows = table(check)
            write_table(staging / name, columns, rows)
        if beams is not None:
            (staging / CALCULIX).write_text(beams, encoding="utf-8")
        if tries:
            columns, rows = sizing(tries)
            write_table(staging / SIZING, columns, rows)
        more = [name for name in _SOMETIMES if (staging / name).exists()]
    return [target / name for name in (*FILES, *more)]
