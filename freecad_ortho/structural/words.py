"""What the check is, what it assumes and what it leaves out, for its reports."""

from __future__ import annotations

from freecad_ortho.structural.check import ENOUGH, StructuralCheck
from freecad_ortho.structural.groups import Group
from freecad_ortho.structural.model import SNOW, WIND
from freecad_ortho.structural.stances import BEAMS, LYING, bends
from freecad_ortho.words import counted
from solver.mesh.quadmesh import FloatArray

_STANDING = {
    BEAMS: "upright along its axes",
    "standing": "as lamellas that stand on the net and follow its normals",
    "lying": "as lamellas that lie in the net and follow its normals",
    "tilted": "as lamellas that tilt and twist as the net wants it",
}
# Modes with factors that are no further apart, by each other, act together.
_NEAR = 1.2
NOT_CHECKED = (
    "the nodes and their bolts and welds, the supports and what is below them",
    "the panels and their fixings, whether they are weight and area only or stiffen the shell too",
    "local buckling of thin walls (class 4 sections), warping torsion, joints that are more "
    "eccentric than was given",
    "erection, fatigue, fire, earthquake, temperature, settlement, accidental loads",
    "pressure coefficients, gusts and drifted snow by EN 1991: loads act as they are given",
    "the sag of members between their nodes: displacements are those of nodes",
    "the weight of nodes",
)


def assumptions(check: StructuralCheck) -> list[str]:
    """What was taken for granted, a sentence each."""
    model, design = check.model, check.model.design
    by = [f"{one.rules.words} (partial factor {one.rules.factor:g})" for one in model.groups]
    rules = "; ".join(dict.fromkeys(by))
    words = [
        f"Members are straight between vertices, {model.section_words}, their middle "
        f"{_place(check)}, {_STANDING[design.position]}.",
        *dict.fromkeys(map(_of_material, model.groups)),
        f"Joints are {_joints(design.joints)}; supports: {design.supports}, pinned where nothing "
        f"else is said, {counted(_held(check), 'node')} in all.",
        f"Sections and members are checked by {rules}; buckling length "
        f"{design.buckling_length:g} times the length.",
        "Partial factors, and those of combinations that are not given, are the ones that the "
        "Eurocodes recommend; national annexes may have others.",
        "Loads of faces lie on their edges, each carries the part of the face nearest to it, "
        "spread evenly.",
        f"Buckling is linear, with {counted(design.pieces, 'piece')} a member.",
    ]
    if not design.layers and design.crossings != "rigid":
        words.append(
            f"Lines u and v cross on one level, {_joints(design.crossings)} about their axis there."
        )
    if design.layers:
        along, across = (force / 1e3 for force in check.arm_forces)
        words.append(
            f"Lines u and v are joined where they cross, {_joints(design.crossings)} about the "
            f"bolt; by first order a bolt takes up to {across:.1f} kN across and {along:.1f} kN "
            "along, from the net to the middle of a section."
        )
    if design.panel_shear:
        words.append(
            f"Panels stiffen the shell with G t = {design.panel_shear:g} kN/mm, in every "
            f"combination; by first order up to {check.panel_shear:.1f} kN/m run along their "
            "sides, which they and their fixings have to bear."
        )
    if check.imperfection is not None:
        words.append(
            "Forces are first order, and where the buckling factor is below "
            f"{ENOUGH:g} in the deformed shape too, with an imperfection of "
            f"{check.imperfection:.1f} mm like the first buckling mode, to either side."
        )
    else:
        words.append("Forces are first order, in the shape as drawn.")
    return words


def _of_material(group: Group) -> str:
    material = group.material
    return (
        f"{material.name}: E {material.youngs_modulus:g} MPa, G {material.shear_modulus:.0f} MPa, "
        f"strength {material.bending_limit:g} MPa."
    )


def _held(check: StructuralCheck) -> int:
    supports = check.model.supports
    return int((supports.fixed | (supports.springs > 0)).any(axis=1).sum())


def loads(check: StructuralCheck) -> list[tuple[str, str, FloatArray]]:
    """Load cases: name, what was given, and the sum of the forces along x, y, z, kN."""
    model, design = check.model, check.model.design
    given = {
        "self-weight": f"{model.mass / 1000:.2f} t of members, no nodes",
        "panels": f"{design.panels:g} kN/m2 of surface",
        "snow": f"{design.snow:g} kN/m2 of plan",
        "snow on one half": f"{design.snow:g} kN/m2 of plan, on one half",
        "point loads": f"{counted(len(design.load), 'force')} on nodes",
    }
    usual = "pressure by how far a face looks into the wind, kN/m2"
    return [
        (case.name, given.get(case.name, usual), case.loads.total(model.frame) / 1e3)
        for case in model.cases
    ]


def _place(check: StructuralCheck) -> str:
    design = check.model.design
    if not design.eccentric and not design.layers:
        return "on the net"
    middle = (
        f"{design.eccentric:g} mm above the net" if design.eccentric else "on both sides of the net"
    )
    if not design.layers:
        return middle
    return f"in two layers {design.layers:g} mm apart, u over v, {middle}"


def _joints(joints: str) -> str:
    return joints if joints in ("rigid", "hinged") else f"springs of {joints} kNm/rad"


def warnings(check: StructuralCheck) -> list[str]:
    """What the reader has to know of this model in particular."""
    model, found = check.model, []
    found += [words for words in map(_thin, model.groups) if words]
    factor = check.factor
    if factor is not None and 1 < factor < ENOUGH:
        found.append(
            "Displacements and forces of supports are first order: in the deformed shape they are "
            f"larger, by up to about {1 / (1 - 1 / factor):.1f} times at a buckling factor of "
            f"{factor:.2f}."
        )
    found += _loads_left_out(check)
    nearest = _next_factor(check)
    if check.imperfection is not None and nearest is not None:
        found.append(
            f"The next buckling factor, {nearest:.2f}, is near the first: an imperfection like "
            "that mode, or like a mix of modes, may take more out of the members; only one like "
            "the first is looked at."
        )
    found += _of_lamellas(check)
    if not model.design.self_weight:
        found.append("The weight of the members is left out.")
    if not model.design.panels:
        found.append("Panels weigh nothing here; give their weight in kN/m2.")
    used = {name for one in check.strength for name in one.combination.factors}
    for case in model.cases:
        if case.name not in used:
            found.append(f"Load case '{case.name}' is in no combination for strength.")
    return found


def _of_lamellas(check: StructuralCheck) -> list[str]:
    """What lamellas have to bear before any load, and what slots leave of them."""
    model, design = check.model, check.model.design
    if design.position == BEAMS:
        return []
    of_group, most, place = model.section_numbers, 0.0, 0
    for member, bend in bends(model.mesh, model.bare):
        group = model.groups[of_group[member]]
        stress = 0.5 * group.material.youngs_modulus * group.profile.width * bend
        if stress > most:
            most, place = stress, member
    limit = model.groups[of_group[place]].material.bending_limit
    found = [
        f"Straight lamellas that are bent into place have up to {most:.0f} MPa in them from that, "
        f"of {limit:g} MPa (E t / 2 R, at member {place}), and more from twisting; utilisation "
        "leaves that out."
    ]
    if not design.layers and design.position == LYING:
        found.append("Lying lamellas cannot cross in one layer; give layers, their distance.")
    elif not design.layers:
        found.append(
            f"Where lamellas cross in slots, {design.slots:g} of their height is taken for what is "
            "left, bent by N beside its middle as well; that slots make lamellas softer is left "
            "out."
            if design.slots < 1
            else "Where lamellas cross in slots, less than their whole height is left, often half "
            "of it: sections are checked without slots."
        )
    return found


def _loads_left_out(check: StructuralCheck) -> list[str]:
    """Loads that roofs of this kind usually have and this one has not."""
    kinds = [case.kind for case in check.model.cases]
    if not any(kind != "permanent" for kind in kinds):
        return ["There is no snow, no wind and no other load that comes and goes."]
    found = []
    if SNOW in kinds and kinds.count(SNOW) == 1:
        found.append(
            "Snow lies on the whole roof in every case; on one half (--snow-side) it bends a "
            "shell more."
        )
    if WIND not in kinds:
        found.append("There is no wind.")
    elif kinds.count(WIND) == 1:
        found.append("Wind blows one way only; give it from every side from which it comes.")
    return found


def _next_factor(check: StructuralCheck) -> float | None:
    """The second buckling factor where it is near the first, and balance was sought deformed."""
    first = check.first_to_buckle
    if first is None or first.buckling is None or len(first.buckling.factors) < 2:
        return None
    one, two = first.buckling.factors[:2].tolist()
    return two if one < ENOUGH and two < _NEAR * one else None


def _thin(group: Group) -> str:
    """Walls that buckle before they yield: EN 1993-1-1, table 5.2, for sections in compression."""
    profile, material = group.profile, group.material
    if profile.series not in ("tube", "chs") or material.youngs_modulus < 190_000:
        return ""
    epsilon = (235 / material.bending_limit) ** 0.5
    if profile.series == "chs":
        ratio, limit = profile.height / profile.wall, 90 * epsilon**2
    else:
        ratio = max(profile.height, profile.width) / profile.wall - 3
        limit = 42 * epsilon
    if ratio <= limit:
        return ""
    return (
        f"{profile.name} is of class 4 in compression (width by wall {ratio:.0f}, limit "
        f"{limit:.0f}): its walls buckle before they yield, which is not checked."
    )
