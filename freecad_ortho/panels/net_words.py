"""Names of the nets in the user's language, what each is for, and what the advisor thinks of it."""

from __future__ import annotations

import FreeCAD

from freecad_ortho import convert
from freecad_ortho.objects.net import asked_of_diagonals
from freecad_ortho.panels.fields import length_words
from solver.analysis.advisor import advise
from solver.analysis.start import Remark
from solver.nets import NETS

translate = FreeCAD.Qt.translate


def net_words(any_faces: bool = False) -> dict[str, str]:
    """What each net is called, by its name; only those for faces of any size where that is said."""
    return {
        name: translate("Ortho", net.title)
        for name, net in NETS.items()
        if net.any_faces or not any_faces
    }


def short_word(net: str) -> str:
    """What a net is called where there is little room."""
    return NETS[net].abbreviation or net_words()[net].split(":")[0].strip()


def explain(net: str) -> str:
    """One sentence on what a net gives its builder."""
    return translate("Ortho", NETS[net].gives)


def outlook(net: FreeCAD.DocumentObject, kind: str) -> str:
    """One sentence on how the net's shape suits a kind of net; empty where all is well."""
    for advice in advise(convert.quad_mesh(net)):
        if advice.net == kind and advice.diagonal == asked_of_diagonals(net):
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
        "bent": translate(
            "Ortho",
            "the lines bend with the surface, where this net asks for asymptotic lines: begin with "
            "a net along curvature with lines for asymptotic-angle, near to the surface",
        ),
        "bulging": translate(
            "Ortho",
            "the surface has asymptotic lines, as this net asks for, only where it bends both "
            "ways: take one that is a saddle all over, or another net",
        ),
        "variant": translate(
            "Ortho", "the other variant of this net, on or off the diagonals, is much nearer"
        ),
    }[cause]


def remark_words(remark: Remark) -> str:
    """What stands in the way of a run, in the user's language."""
    if remark.cause == "coarse":
        return translate(
            "Ortho",
            "faces of this size leave the surface by {} between their corners: take a finer mesh, "
            "or allow as much",
        ).format(length_words(remark.numbers[0]))
    if remark.cause != "border":
        return reason_words(remark.cause)
    return translate(
        "Ortho",
        "the border that is held twists the surface by {:.1f} degrees between the vertices {} and "
        "{}, where this net allows hardly any: let the border leave its curve and trim it "
        "afterwards",
    ).format(*remark.numbers)
