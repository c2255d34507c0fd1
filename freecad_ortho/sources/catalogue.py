"""All sources by name, and the groups that they are offered in."""

from __future__ import annotations

from freecad_ortho.sources.aligning import ALIGNED
from freecad_ortho.sources.changes import CHANGES
from freecad_ortho.sources.faces import FACES
from freecad_ortho.sources.forming import FORM
from freecad_ortho.sources.multinets import ELLIPTIC_NET, MULTI_NET
from freecad_ortho.sources.primitives import primitive_sources
from freecad_ortho.sources.source import Source
from solver.option import one_of

_PRIMITIVES = primitive_sources()

SOURCES: dict[str, Source] = {
    **_PRIMITIVES,
    **{entry.name: entry for entry in (MULTI_NET, ELLIPTIC_NET, FACES, ALIGNED, FORM, *CHANGES)},
}

GROUPS: dict[str, tuple[str, ...]] = {
    "primitive": tuple(_PRIMITIVES),
    "multi-net": (MULTI_NET.name,),
    "elliptic multi-net": (ELLIPTIC_NET.name,),
    "faces": (FACES.name,),
    "along curvature": (ALIGNED.name,),
    "form-finding": (FORM.name,),
    "derived": ("diagonal mesh", "medial mesh", "checkerboard", "Christoffel dual"),
    "refine": ("subdivide", "coarsen", "trim"),
    "transform": ("transform", "mirror", "Moebius transformation", "inversion", "orient"),
    "offset": ("offset",),
    "weld": ("weld",),
}


def source(name: str) -> Source:
    """The source of a name.

    Raises:
        InputError: there is none.
    """
    one_of("source", name, SOURCES)
    return SOURCES[name]
