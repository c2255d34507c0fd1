"""The model as an input file of CalculiX, which FreeCAD's FEM workbench runs too."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from freecad_ortho.structural.groups import Group
from freecad_ortho.structural.model import Model
from solver.frame.model import Frame, Loads
from solver.mesh.connectivity import IntArray

# Elements a member: they are turned into solids, of which one alone is too stiff.
_PIECES = 4
# Of the load along an element with three nodes: what each of them takes.
_SHARES = (1 / 6, 2 / 3, 1 / 6)


def input_file(model: Model) -> str | None:
    """Beams with three nodes, a static step a load case; N, mm, t.

    None where CalculiX has no such model: sections other than rectangles and tubes, joints that are
    not rigid, springs as supports, panels that stiffen, members that are not on the net.
    """
    sections = [found for found in map(_section, model.groups) if found is not None]
    springs = bool(model.supports.springs.any()) or model.design.panel_shear > 0
    springs = springs or len(model.frame.members) > len(model.families)
    if len(sections) < len(model.groups) or model.design.joints != "rigid" or springs:
        return None
    return "\n".join(_lines(model, sections)) + "\n"


def _section(group: Group) -> tuple[str, str] | None:
    """Kind and sizes; the first size is along the direction that is given with it."""
    profile = group.profile
    height, width, wall = profile.height, profile.width, profile.wall
    if profile.family == "chs":
        return "PIPE", f"{height / 2:g}, {wall:g}"
    if profile.family == "tube":
        return "BOX", f"{height:g}, {width:g}, {wall:g}, {wall:g}, {wall:g}, {wall:g}"
    if len(profile.rings) == 1 and len(profile.rings[0].corners) == 4:
        return "RECT", f"{height:g}, {width:g}"
    return None


def _lines(model: Model, sections: Sequence[tuple[str, str]]) -> Iterator[str]:
    frame = model.frame
    divided = frame.divided(2 * _PIECES)
    chain = divided.members.reshape(-1, 2, 2)
    elements = np.column_stack([chain[:, 0], chain[:, 1, 1]])
    numbers = np.arange(1, len(elements) + 1).reshape(-1, _PIECES)
    yield f"** {model.section_words} of {model.material_words}; N, mm, t; z upwards"
    yield "*NODE, NSET=ALL"
    used = np.unique(divided.members)
    for node in used.tolist():
        x, y, z = divided.nodes[node].tolist()
        yield f"{node + 1}, {x:.9g}, {y:.9g}, {z:.9g}"
    yield "*ELEMENT, TYPE=B32R, ELSET=MEMBERS"
    for number, (one, middle, two) in enumerate(elements.tolist(), 1):
        yield f"{number}, {one + 1}, {middle + 1}, {two + 1}"
    for number, group in enumerate(model.groups, 1):
        material = group.material
        yield f"*MATERIAL, NAME=MATERIAL{number}"
        yield "*ELASTIC"
        poisson = material.youngs_modulus / (2 * material.shear_modulus) - 1
        # What has fibres shears more than any Poisson's ratio says; 0.49 is the most there is.
        yield f"{material.youngs_modulus:g}, {min(poisson, 0.49):.6g}"
        yield "*DENSITY"
        yield f"{material.density * 1e-12:g}"
    up, of_group = frame.axes[:, 2], model.section_numbers.tolist()
    for member, (x, y, z) in enumerate(up.tolist()):
        kind, sizes = sections[of_group[member]]
        material_of = f"MATERIAL{of_group[member] + 1}"
        yield f"*ELSET, ELSET=M{member + 1}"
        yield ", ".join(map(str, numbers[member].tolist()))
        yield f"*BEAM SECTION, ELSET=M{member + 1}, MATERIAL={material_of}, SECTION={kind}"
        yield sizes
        yield f"{x:.9g}, {y:.9g}, {z:.9g}"
    yield "*BOUNDARY"
    for node in np.flatnonzero(model.supports.fixed.any(axis=1)).tolist():
        for direction in np.flatnonzero(model.supports.fixed[node]).tolist():
            yield f"{node + 1}, {direction + 1}"
    for case in model.cases:
        yield f"** {case.name}"
        yield "*STEP"
        yield "*STATIC"
        yield "*CLOAD, OP=NEW"
        yield from _forces(case.loads.divided(frame, 2 * _PIECES), divided, elements)
        yield "*NODE FILE, OUTPUT=2D"
        yield "U, RF"
        yield "*NODE PRINT, NSET=ALL"
        yield "U"
        yield "*END STEP"


def _forces(loads: Loads, divided: Frame, elements: IntArray) -> Iterator[str]:
    force = loads.nodal[:, :3].copy()
    halves = (loads.spread * divided.lengths[:, None]).reshape(-1, 2, 3)
    for at, share in zip(elements.T, _SHARES, strict=True):
        np.add.at(force, at, share * halves.sum(axis=1))
    for node, direction in np.argwhere(force != 0).tolist():
        yield f"{node + 1}, {direction + 1}, {force[node, direction]:.9g}"
