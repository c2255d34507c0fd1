"""The only crossing between FreeCAD and the rest: plain arrays and BREP text, never pointers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import FreeCAD
import numpy as np

from freecad_ortho import written
from freecad_ortho.sources.source import singular
from freecad_ortho.written import LOADS
from solver.errors import InputError
from solver.mesh.connectivity import Connectivity
from solver.mesh.mixed import MixedConnectivity
from solver.mesh.quadmesh import FloatArray, QuadMesh

if TYPE_CHECKING:
    import cadquery
    import Part

    from freecad_ortho.sources import Source
    from solver.option import Option


def vectors(points: FloatArray) -> list[FreeCAD.Vector]:
    """Make FreeCAD vectors from an (N, 3) array; every bit is kept."""
    return [FreeCAD.Vector(x, y, z) for x, y, z in points.tolist()]


def array(points: list[FreeCAD.Vector]) -> FloatArray:
    """Make an (N, 3) array from FreeCAD vectors; every bit is kept."""
    return np.array([(p.x, p.y, p.z) for p in points], dtype=np.float64).reshape(-1, 3)


def quad_mesh(net: FreeCAD.DocumentObject) -> QuadMesh:
    """Read the mesh of a net, in mm: of quads, or of faces with any number of corners.

    Raises:
        InputError: the net's properties do not make a mesh.
    """
    if not net.Faces:
        raise InputError(f"{net.Label}: the net is empty; import a quad mesh first")
    sizes = sizes_of(net)
    if sizes and sum(sizes) != len(net.Faces):
        raise InputError(
            f"{net.Label}: 'Faces' holds {len(net.Faces)} numbers, 'FaceSizes' says {sum(sizes)}; "
            "undo the change or import the mesh again"
        )
    if not sizes and len(net.Faces) % 4:
        raise InputError(
            f"{net.Label}: 'Faces' holds {len(net.Faces)} numbers, expected four a face; undo the "
            "change or import the mesh again"
        )
    return QuadMesh(array(net.Vertices), _connectivity(net, sizes))


def whole_mesh(net: FreeCAD.DocumentObject) -> QuadMesh | None:
    """The mesh of a net, in mm; None while its properties are being written or read."""
    sizes = sizes_of(net)
    count = sum(sizes) if sizes else len(net.Faces) // 4 * 4
    if not net.Faces or count != len(net.Faces) or max(net.Faces) >= len(net.Vertices):
        return None
    return QuadMesh(array(net.Vertices), _connectivity(net, sizes))


def sizes_of(net: FreeCAD.DocumentObject) -> list[int]:
    """How many corners each face of a net has; empty where all have four."""
    return list(getattr(net, "FaceSizes", ()))


def _connectivity(net: FreeCAD.DocumentObject, sizes: list[int]) -> Connectivity:
    numbers = np.array(net.Faces, dtype=np.int64)
    if not sizes:
        return Connectivity(numbers.reshape(-1, 4), len(net.Vertices))
    polygons = [part.tolist() for part in np.split(numbers, np.cumsum(sizes)[:-1])]
    return MixedConnectivity(polygons, len(net.Vertices))


def store_mesh(net: FreeCAD.DocumentObject, mesh: QuadMesh) -> None:
    """Write a mesh in mm into a net's properties."""
    # Faces first: a view that redraws in between sees faces whose vertices are still to come,
    # never vertices numbered beyond the end.
    net.Faces = []
    net.FaceSizes = mesh.connectivity.face_sizes.tolist() if mesh.connectivity.mixed else []
    net.Vertices = vectors(mesh.vertices)
    net.Faces = mesh.connectivity.half_edges[:, 0].tolist()


def border(net: FreeCAD.DocumentObject) -> tuple[FloatArray, ...]:
    """Read the border along which parts on a net are trimmed: closed polylines (N, 3), in mm."""
    points = array(net.BorderPoints)
    ends = np.cumsum(net.BorderCounts)
    if len(ends) and ends[-1] != len(points):
        raise InputError(
            f"{net.Label}: 'BorderPoints' holds {len(points)} points, 'BorderCounts' says "
            f"{ends[-1]}; undo the change, or empty both"
        )
    return tuple(np.split(points, ends[:-1])) if len(ends) else ()


def store_border(net: FreeCAD.DocumentObject, border: Sequence[FloatArray]) -> None:
    """Write the border along which parts on a net are trimmed, in mm."""
    net.BorderPoints = vectors(np.concatenate(border)) if border else []
    net.BorderCounts = [len(line) for line in border]


def store_vertices(net: FreeCAD.DocumentObject, vertices: FloatArray) -> None:
    """Move a net's vertices, (V, 3) in mm; its faces stay.

    A net that was made by a source no longer follows it: else the next change there, or the next
    recomputation, would take the move back.
    """
    if getattr(net, "FollowSource", False):
        net.FollowSource = False
    net.Vertices = vectors(vertices)


def millimetres(value: float | str | FreeCAD.Units.Quantity, name: str) -> float:
    """Read a length: a number of mm, a quantity, or a text such as ``"0.2 m"``.

    Raises:
        InputError: not a length.
    """
    return _number_of(value, name, FreeCAD.Units.Length, "a length", "12 mm")


def degrees(value: float | str | FreeCAD.Units.Quantity, name: str) -> float:
    """Read an angle: a number of degrees, a quantity, or a text such as ``"0.5 rad"``.

    Raises:
        InputError: not an angle.
    """
    return _number_of(value, name, FreeCAD.Units.Angle, "an angle", "30 deg")


def option_values(source: Source, options: dict[str, Any]) -> dict[str, Any]:
    """Options of a source as plain values in mm and degrees.

    Raises:
        InputError: an option that the source does not have, or a value of the wrong kind.
    """
    read = {name: option_value(source.option(name), value) for name, value in options.items()}
    return source.current(read)


def option_value(option: Option, value: Any) -> Any:
    """A value as a macro gives it, plain, in mm and degrees.

    Raises:
        InputError: not a length, an angle, an area or points where that is wanted.
    """
    if value is None:
        return None
    if option.kind == "placement":
        return placing(value) if isinstance(value, FreeCAD.Placement) else value
    if option.kind == "points":
        return rows(value)
    if option.kind == "polylines":
        return tuple(tuple(map(tuple, rows(line).tolist())) for line in value)
    if option.kind == "singular":
        return singular_rows(value)
    if option.kind == "text" and isinstance(value, (list, tuple)):
        return ",".join(map(str, value))
    if option.kind in LOADS:
        return _load(value, option)
    if option.kind in ("length", "distance", "angle", "area", "pressure"):
        own = {"angle": degrees, "area": square_millimetres, "pressure": kilopascals}
        read = own.get(option.kind, millimetres)
        if option.several and isinstance(value, (tuple, list)):
            return tuple(read(item, option.name) for item in value)
        return read(value, option.name)
    return tuple(value) if isinstance(value, list) else value


def _load(value: Any, option: Option) -> float:
    """A load as the solver takes it, by mm: a number, or a text such as ``"1.5 kN/m2"``."""
    found = written.number(str(value), option.kind, "mm")
    if found is None:
        per = {"force": "5 kN", "per_length": "0.2 kN/m", "per_area": "1.5 kN/m2"}[option.kind]
        raise InputError(f"{option.name}: {value!r} is no such load; give it like '{per}'")
    return found


def square_millimetres(value: float | str | FreeCAD.Units.Quantity, name: str) -> float:
    """Read an area: a number of mm2, a quantity, or a text such as ``"2 m^2"``.

    Raises:
        InputError: not an area.
    """
    return _number_of(value, name, FreeCAD.Units.Area, "an area", "2 m^2")


def kilopascals(value: float | str | FreeCAD.Units.Quantity, name: str) -> float:
    """Read a load by its area: a number of kN/m2, a quantity, or a text such as ``"1.5 kPa"``.

    Raises:
        InputError: not a pressure.
    """
    return _number_of(value, name, FreeCAD.Units.Pressure, "a pressure", "1.5 kPa")


def singular_rows(given: Any) -> tuple[tuple[float, ...], ...] | None:
    """Rows of x, y, z in mm and a number of lines; None where they are to be found.

    Args:
        given: such rows, or texts of them; ``none``, or ``auto``.

    Raises:
        InputError: anything else.
    """
    lines = [given] if isinstance(given, str) else given
    lines = [x.replace(",", " ").split() if isinstance(x, str) else x for x in lines]
    if lines in ([["auto"]], [["none"]]):
        return None if lines == [["auto"]] else ()
    found = singular("singularities", lines)
    pairs = zip(found.places.tolist(), found.valences.tolist(), strict=True)
    return tuple((*place, lines) for place, lines in pairs)


def rows(points: Any) -> FloatArray:
    """(N, 3) array of points given as vectors, sequences of three or two numbers, or an array.

    Raises:
        InputError: not points.
    """
    try:
        table = [tuple(point) for point in points]
        width = len(table[0]) if table else 3
        result = np.array(table, dtype=np.float64).reshape(-1, width)
    except (TypeError, ValueError):
        raise InputError(f"points: expected rows of three numbers, got {points!r}") from None
    if width not in (2, 3) or not np.isfinite(result).all():
        raise InputError("points: expected rows of three finite numbers each; mend them")
    return np.pad(result, ((0, 0), (0, 3 - width)))


def placing(placement: FreeCAD.Placement) -> tuple[FloatArray, FloatArray]:
    """Rotation (3, 3) and origin (3,) in mm of a placement."""
    axes = [FreeCAD.Vector(*(float(k == axis) for k in range(3))) for axis in range(3)]
    turned = array([placement.Rotation.multVec(axis) for axis in axes]).T
    return turned, array([placement.Base])[0]


def placement(placing: tuple[FloatArray, FloatArray]) -> FreeCAD.Placement:
    """Placement of a rotation (3, 3) and an origin (3,) in mm."""
    rotation, origin = (np.asarray(part, dtype=np.float64) for part in placing)
    matrix = FreeCAD.Matrix()
    for i in range(3):
        for j in range(3):
            setattr(matrix, f"A{i + 1}{j + 1}", float(rotation[i, j]))
        setattr(matrix, f"A{i + 1}4", float(origin[i]))
    return FreeCAD.Placement(matrix)


def _number_of(value: Any, name: str, unit: Any, what: str, example: str) -> float:
    """A plain number of FreeCAD's own unit from a number, a quantity or a text."""
    complaint = f"{name}: {value!r} is not {what}; give it like '{example}'"
    if isinstance(value, str):
        try:
            value = FreeCAD.Units.Quantity(value)
        except (ValueError, ArithmeticError, OSError) as error:
            raise InputError(complaint) from error
    if isinstance(value, FreeCAD.Units.Quantity):
        if value.Unit not in (unit, FreeCAD.Units.Unit()):
            raise InputError(complaint)
        value = value.Value
    try:
        return float(value)
    except (TypeError, ValueError):
        raise InputError(complaint) from None


def part_shape(shape: cadquery.Shape) -> Part.Shape:
    """Carry a cadquery shape over into FreeCAD."""
    import Part

    from freecad_ortho.fabrication import brep_text

    result = Part.Shape()
    result.importBrepFromString(brep_text(shape))
    return result
