"""What is seen of solids from one side: their edges and contours, without what is behind others."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from solver.mesh.quadmesh import FloatArray

# Largest distance of a polyline from a bent edge, mm.
_CHORD = 0.1


def seen_lines(shapes: Sequence[Any], frame: FloatArray) -> list[FloatArray]:
    """Polylines (n, 2) to the right and up, mm.

    Args:
        shapes: of the CAD kernel.
        frame: (3, 3) rows to the right, up and towards the eye.
    """
    from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
    from OCP.HLRAlgo import HLRAlgo_Projector
    from OCP.HLRBRep import HLRBRep_Algo, HLRBRep_HLRToShape

    hidden = HLRBRep_Algo()
    for shape in shapes:
        hidden.Add(shape)
    eye = gp_Ax2(gp_Pnt(), gp_Dir(*frame[2].tolist()), gp_Dir(*frame[0].tolist()))
    hidden.Projector(HLRAlgo_Projector(eye))
    hidden.Update()
    hidden.Hide()
    found = HLRBRep_HLRToShape(hidden)
    lines: list[FloatArray] = []
    for seen in (found.VCompound(), found.OutLineVCompound()):
        if not seen.IsNull():
            lines += _polylines(seen)
    return lines


def _polylines(compound: Any) -> list[FloatArray]:
    from OCP.BRepAdaptor import BRepAdaptor_Curve
    from OCP.BRepLib import BRepLib
    from OCP.GCPnts import GCPnts_QuasiUniformDeflection
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    # What comes of the projection has no curves in space yet.
    BRepLib.BuildCurves3d_s(compound)
    found = []
    edges = TopExp_Explorer(compound, TopAbs_ShapeEnum.TopAbs_EDGE)
    while edges.More():
        points = GCPnts_QuasiUniformDeflection(
            BRepAdaptor_Curve(TopoDS.Edge_s(edges.Current())), _CHORD
        )
        if points.IsDone() and points.NbPoints() > 1:
            places = [points.Value(k + 1) for k in range(points.NbPoints())]
            found.append(np.array([[place.X(), place.Y()] for place in places]))
        edges.Next()
    return found
