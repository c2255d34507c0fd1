"""Structural checks in documents: added to nets, changed, written to files."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import FreeCAD

from freecad_ortho import convert
from freecad_ortho.documents.common import (
    changing,
    progress,
    removed_on_failure,
    require_net,
    transaction,
)
from freecad_ortho.objects import places, structural_check
from freecad_ortho.standing import write_structural_check
from freecad_ortho.structural.design import Design
from freecad_ortho.structural.sizing_groups import ALL, FAMILIES
from solver.errors import InputError
from solver.option import one_of

if TYPE_CHECKING:
    # Of the standard library from Python 3.11 on.
    from typing_extensions import Unpack

    from freecad_ortho.keywords import CheckSettings, DesignSettings

# What a check may be told beside its design -> its property.
_LINKS = {"beams": "Members", "cladding": "Cladding"}


def add_structural_check(
    net: FreeCAD.DocumentObject,
    *,
    beams: FreeCAD.DocumentObject | None = None,
    cladding: FreeCAD.DocumentObject | None = None,
    combinations: Sequence[str] = (),
    **design: Unpack[DesignSettings],
) -> FreeCAD.DocumentObject:
    """Check the grid shell on a Net, z upwards; the check follows the net and the structures.

    Args:
        net: the Net, whose edges are the members.
        beams: a Structure of beams on it whose section and material the members have, in place of
            ``section`` and ``material``.
        cladding: a Structure whose weight is a load by the surface, such as panels.
        combinations: lines as ``"strength: 1.35 self-weight + 1.5 snow"``; those of EN 1990 where
            there are none.
        design: members, supports and loads by name, see
            :class:`freecad_ortho.keywords.DesignSettings`; kN and m, or quantities.

    Raises:
        InputError: what cannot be checked, such as a mechanism; the document is unchanged.
        OrthoError: Esc was pressed; the document is unchanged.
    """
    require_net(net)
    given = {**design, "beams": beams, "cladding": cladding, "combinations": combinations}
    properties = _properties(given, {})
    document, title = net.Document, FreeCAD.Qt.translate("Ortho", "Structural check")
    with transaction(document, title):
        feature = structural_check.create(document, net, properties)
        places.join_container(feature, net)
        with removed_on_failure(feature), progress(title) as say:
            structural_check.rebuild(feature, say)
        feature.purgeTouched()
        # Members are drawn where the net's edges are, and inside of beams.
        for item in (net, beams, cladding):
            if item is not None:
                item.Visibility = False
    return feature


def change_structural_check(
    target: FreeCAD.DocumentObject, /, **settings: Unpack[CheckSettings]
) -> None:
    """Check with other settings.

    Args:
        target: the structural check.
        settings: as for :func:`add_structural_check`; what is not given stays.

    Raises:
        InputError: no structural check, or what cannot be checked; it is unchanged.
        OrthoError: Esc was pressed; it is unchanged.
    """
    require_check(target)
    properties = _properties(settings, structural_check.design_of(target))
    with changing(target, properties), progress(target.Label) as say:
        structural_check.rebuild(target, say)


def size_structural_check(
    target: FreeCAD.DocumentObject, sections: str = "tubes", *, groups: str = "all"
) -> str:
    """Give a structural check the lightest section with which it passes.

    Args:
        target: the structural check, whose members are not those of beams.
        sections: a list (tubes, plates, glulam) or names of sections joined by "+".
        groups: ``all`` members have the same one, or those of ``families`` (u, v, border, inner)
            their own.

    Returns:
        What was found, in a line.

    Raises:
        InputError: no structural check, none of the sections passes, or what cannot be checked; it
            is unchanged.
        OrthoError: Esc was pressed; it is unchanged.
    """
    require_check(target)
    one_of("groups", groups, (ALL, FAMILIES))
    title = FreeCAD.Qt.translate("Ortho", "Finding the lightest section")
    with progress(title) as say:
        found = structural_check.sized(target, sections, groups, say)
    if not found.check.passed:
        raise InputError(f"{target.Label}: {found.verdict}")
    change_structural_check(target, section=found.check.model.design.section)
    return found.verdict


def write_check_files(target: FreeCAD.DocumentObject, folder: str | os.PathLike[str]) -> list[Path]:
    """Write the tables, the page to read and the model of a structural check.

    Args:
        target: the structural check.
        folder: made when missing; other files in it stay.

    Returns:
        The files.

    Raises:
        InputError: no structural check, or what cannot be checked.
        OutputError: the folder cannot be written.
    """
    require_check(target)
    title = FreeCAD.Qt.translate("Ortho", "Writing files of the check")
    with progress(title) as say:
        found = structural_check.checked(target, say)
        return write_structural_check(found, folder, target.Net.Label)


def require_check(target: FreeCAD.DocumentObject) -> None:
    """Raise InputError unless a document object is a structural check."""
    places.refuse_link(target)
    if not structural_check.is_check(target):
        label = getattr(target, "Label", target)
        raise InputError(f"structural check: {label} is none; select a structural check first")


def _properties(given: Mapping[str, Any], present: Mapping[str, Any]) -> dict[str, Any]:
    """Values of properties for what is given, checked as far as the net does not matter."""
    own = {*_LINKS, "combinations"}
    options = {option.name: option for option in Design.options}
    design = {
        name: convert.option_value(options[name], value) if name in options else value
        for name, value in given.items()
        if name not in own
    }
    Design.of({**present, **design})
    found = structural_check.written(design)
    found |= {word: given[name] for name, word in _LINKS.items() if name in given}
    if "combinations" in given:
        found["Combinations"] = list(given["combinations"])
    return found
