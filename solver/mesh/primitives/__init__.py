"""Nets that are known exactly; the start of a design, and the measure of the measures.

Every function takes its counts first: ``m`` vertices along u, ``n`` along v; vertex (i, j) is
number ``i * n + j``. Lengths are in the model's unit, angles in degrees.
"""

from solver.mesh.primitives.catalogue import PRIMITIVES, Parameter, Primitive, Value, primitive
from solver.mesh.primitives.developable import cone, cylinder, tangent_developable
from solver.mesh.primitives.minimal import catenoid, enneper, helicoid, scherk
from solver.mesh.primitives.plane import rectangle
from solver.mesh.primitives.quadrics import ellipsoid, elliptic_paraboloid
from solver.mesh.primitives.rotational import rotational, sphere, unduloid
from solver.mesh.primitives.translational import translational

__all__ = [
    "PRIMITIVES",
    "Parameter",
    "Primitive",
    "Value",
    "catenoid",
    "cone",
    "cylinder",
    "ellipsoid",
    "elliptic_paraboloid",
    "enneper",
    "helicoid",
    "primitive",
    "rectangle",
    "rotational",
    "scherk",
    "sphere",
    "tangent_developable",
    "translational",
    "unduloid",
]
