"""Names of the nets in the user's language, what each is for, and what the advisor thinks of it."""

from __future__ import annotations

import FreeCAD

from freecad_ortho import convert
from solver.analysis.advisor import advise
from solver.analysis.start import Remark

translate = FreeCAD.Qt.translate


def net_words() -> dict[str, str]:
    """What each net is called, by recipe."""
    return {
        "principal": translate("Ortho", "principal: flat panels"),
        "orthogonal": translate("Ortho", "orthogonal"),
        "circular": translate("Ortho", "circular"),
        "conical": translate("Ortho", "conical"),
        "geodesic": translate("Ortho", "geodesic: developable"),
        "dog": translate("Ortho", "geodesic, four equal angles"),
        "chebyshev": translate("Ortho", "Chebyshev: equal edges"),
        "geodesic-chebyshev": translate("Ortho", "geodesic and Chebyshev"),
        "asymptotic": translate("Ortho", "asymptotic: minimal"),
        "cmc": translate("Ortho", "constant mean curvature"),
        "snet": translate("Ortho", "spherical stars"),
        "stress": translate("Ortho", "principal stress: equilibrium"),
        "isometric": translate("Ortho", "isometric: faces keep shape"),
    }


def short_word(net: str) -> str:
    """What a net is called where there is little room."""
    return "CMC" if net == "cmc" else net_words()[net].split(":")[0].strip()


def explain(net: str) -> str:
    """One sentence on what a net gives its builder."""
    return {
        "principal": translate("Ortho", "Flat faces with right angles; torsion-free beams."),
        "orthogonal": translate("Ortho", "Lines that cross at right angles, faces not flat."),
        "circular": translate("Ortho", "Flat faces, each with a circle through its corners."),
        "conical": translate("Ortho", "Flat faces with an exact offset at constant thickness."),
        "geodesic": translate("Ortho", "A developable surface: it is bent from flat sheet."),
        "dog": translate("Ortho", "A developable surface, by the stricter definition."),
        "chebyshev": translate("Ortho", "A developable surface of squares, all edges equal."),
        "geodesic-chebyshev": translate("Ortho", "A developable surface of geodesic squares."),
        "asymptotic": translate("Ortho", "A minimal surface with straight upright lamellas."),
        "cmc": translate("Ortho", "Constant mean curvature; lamellas unroll to equal arcs."),
        "snet": translate("Ortho", "Each vertex lies on one sphere with its neighbours."),
        "stress": translate("Ortho", "Edges along the principal stresses, in equilibrium."),
        "isometric": translate("Ortho", "Faces keep the shape they have: paper that is bent."),
    }[net]


def outlook(net: FreeCAD.DocumentObject, kind: str) -> str:
    """One sentence on how the net's shape suits a kind of net; empty where all is well."""
    for advice in advise(convert.quad_mesh(net)):
        if advice.net == kind and advice.diagonal == net.DiagonalNet:
            reason = reason_words(advice.cause)
            if not advice.possible:
                return translate("Ortho", "Hardly possible: {}").format(reason)
            return reason
    return ""


def reason_words(cause: str) -> str:
    """The advisor's reason in the user's language; empty where it has none."""
    return {
        "": "",
        "bends": translate(
            "Ortho", "the shape is doubly curved and will be bent towards a developable surface"
        ),
        "bulges": translate(
            "Ortho",
            "most of the surface bulges (positive Gauss curvature), and there it has no asymptotic "
            "lines",
        ),
        "diagonal": translate(
            "Ortho",
            "the lines do not follow the curvature of the surface, as this net has to, but those "
            "of its diagonal mesh do: make a diagonal mesh first",
        ),
        "oblique": translate(
            "Ortho",
            "the lines do not follow the curvature of the surface, as this net has to: take a "
            "start whose lines do",
        ),
        "variant": translate(
            "Ortho", "the other variant of this net, on or off the diagonals, is much nearer"
        ),
    }[cause]


def remark_words(remark: Remark) -> str:
    """What stands in the way of a run, in the user's language."""
    if remark.cause != "border":
        return reason_words(remark.cause)
    return translate(
        "Ortho",
        "the border that is held twists the surface by {:.1f} degrees between the vertices {} and "
        "{}, where this net allows hardly any: let the border leave its curve and trim it "
        "afterwards",
    ).format(*remark.numbers)
