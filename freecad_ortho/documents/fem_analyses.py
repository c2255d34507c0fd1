"""Analyses of the FEM workbench from structural checks."""

from __future__ import annotations

import FreeCAD

from freecad_ortho.documents.common import progress, transaction
from freecad_ortho.documents.structural_checks import require_check
from freecad_ortho.objects import fem_analysis, structural_check
from solver.errors import InputError


def add_fem_analysis(
    target: FreeCAD.DocumentObject, combination: str = ""
) -> FreeCAD.DocumentObject:
    """Add the model of a structural check as an analysis of FreeCAD's FEM workbench.

    Line elements, sections, materials, supports, load cases and a solver: *Run solver* there, or
    ``femsolver.run.run_fem_solver``, has CalculiX find displacements. It stays as the check is now.

    Args:
        target: the structural check.
        combination: name of one of its combinations, whose factors the load cases have; without
            one that of ``DiagramsOf``, which uses a member most.

    Raises:
        InputError: no structural check, no such combination, no FEM workbench, or a model that
            CalculiX has not; the document is unchanged.
    """
    require_check(target)
    title = FreeCAD.Qt.translate("Ortho", "FEM analysis")
    with progress(title) as say:
        found, shift = structural_check.checked_in_place(target, say)
    fem_analysis.refuse_missing(found.model)
    chosen = combination or target.DiagramsOf
    factors = {one.combination.name: one.combination.factors for one in found.found}
    if chosen not in factors:
        raise InputError(
            f"combination: {target.Label} has no '{chosen[:60]}'; it has {'; '.join(factors)}"
        )
    with transaction(target.Document, title):
        analysis = fem_analysis.create(target.Document, found.model, factors[chosen], shift)
        analysis.Label = f"{target.Label}: {chosen}"
    return analysis
