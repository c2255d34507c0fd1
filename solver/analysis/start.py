"""What is to be known of a start before the first step: why a net will be hard to reach from it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from solver.analysis.directions import across_asymptotic, asymptotic_share, directions
from solver.analysis.form import off_surface
from solver.mesh.closest import TriangleSurface
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.nets import NETS

# Where more than this part of the bending is twist along the lines, nets whose lines follow the
# principal directions flatten the shape or stall; where the diagonals have less than that of it,
# the diagonal mesh is a start for them.
_TWISTED, _FOLLOWING = 0.45, 0.2
# A part of the area this large where lines have to turn for flat faces is worth a word; from the
# second on other lines are the better start, if those of the diagonal mesh are.
_HARDLY, _MOSTLY = 0.05, 0.5
# Lines that bend by more than this part of what lines of curvature do are no asymptotic ones, if
# the surface is a saddle on this part of it.
_BENT, _SADDLE = 0.5, 0.8
# Degrees that the normal may turn about a border that is held: more were not made up for.
_TURN = 1.0
# Sine of the angle of a border that makes a corner.
_CORNER = 0.2
# Least divisor where a border runs back on itself.
_BACK = 1e-9
# A variant of a net that starts this many times closer deserves a remark.
_CLOSER = 10.0


@dataclass(frozen=True)
class Remark:
    """Something about a start that stands in the way of a net.

    Attributes:
        cause: one word for programs: ``diagonal``, ``oblique``, ``bent``, ``bulging``,
            ``border``, ``variant`` or ``coarse``.
        fact: what is so, in words that end no sentence.
        remedy: what to do, likewise.
        numbers: of a border: degrees, and the vertices at both its ends; of faces that are coarse
            how far they leave the surface, in model units.
    """

    cause: str
    fact: str
    remedy: str
    numbers: tuple[float, int, int] = (0.0, 0, 0)

    def __str__(self) -> str:
        """Fact and remedy in one sentence."""
        return f"{self.fact}; try: {self.remedy}"


def start_remarks(
    mesh: QuadMesh,
    net: str,
    diagonal: bool = False,
    held: BoolArray | None = None,
    asymptotic: bool = False,
) -> tuple[Remark, ...]:
    """Say what stands in the way of a net.

    Args:
        mesh: the start.
        net: name of the net.
        diagonal: whether the star property is asked of the diagonal net.
        held: (V,) true for vertices that are fixed or glide along a curve; none by default.
        asymptotic: its lines are asymptotic ones, whatever angle these have.
    """
    if mesh.connectivity.mixed:
        return tuple(filter(None, [threes_on_saddles(mesh)]))
    found = [closer_variant(mesh, net, diagonal)]
    if asymptotic:
        found.append(bent_lines(mesh, diagonal))
    if NETS[net].conjugate:
        found.append(asymptotic_lines(mesh))
    if NETS[net].along_curvature:
        found.append(twisted_lines(mesh))
        if held is not None:
            found.append(_turned_border(mesh, held))
    return tuple(remark for remark in found if remark is not None)


def threes_on_saddles(mesh: QuadMesh) -> Remark | None:
    """Say where three faces meet on a saddle, where they cannot be flat and without recesses.

    The normals of three flat convex faces that meet go around as the faces do: such a corner bulges
    or is hollow. On a saddle they go around the other way.
    """
    net, normals = mesh.connectivity, mesh.face_normals
    inner = ~net.boundary_vertices & (net.face_valence == 3)
    half = np.flatnonzero(inner[net.half_edges[:, 0]])
    if not len(half):
        return None
    # Each face at such a vertex and the one across its side that begins there.
    beside = net.half_faces[net.twins[half]]
    around = np.cross(normals[beside], normals[net.half_faces[half]])
    vertex = net.half_edges[half, 0]
    turn = np.zeros(net.vertex_count)
    np.add.at(turn, vertex, np.einsum("hk,hk->h", around, mesh.vertex_normals[vertex]))
    share = float((turn[inner] < 0).mean())
    if share <= _HARDLY:
        return None
    return Remark(
        "oblique",
        f"at {100 * share:.0f} % of the inner vertices where three faces meet the surface is a "
        "saddle, where three flat faces without recesses cannot meet",
        "quads there, or a surface that bulges all over",
    )


def bent_lines(mesh: QuadMesh, diagonal: bool = False) -> Remark | None:
    """Say where lines that are to be asymptotic bend with the surface, so that it would flatten."""
    bent, saddle = across_asymptotic(mesh, diagonal)
    if bent <= _BENT:
        return None
    lines = "diagonals" if diagonal else "lines"
    if saddle < _SADDLE:
        return Remark(
            "bulging",
            f"the {lines} bend with the surface, which has asymptotic lines on {100 * saddle:.0f} "
            "% of its area only, where it bends both ways",
            "a surface that is a saddle all over, or another net",
        )
    return Remark(
        "bent",
        f"the {lines} bend with the surface, {100 * bent:.0f} % as much as lines of curvature do, "
        "where this net asks for asymptotic lines, which do not: the surface would flatten instead",
        "a start along its asymptotic lines: align it with lines for asymptotic-angle, then "
        "optimise that, close to the surface",
    )


def twisted_lines(mesh: QuadMesh) -> Remark | None:
    """Say where lines run so far from the principal directions that they will not turn there."""
    lines = directions(mesh)
    if lines.twist <= _TWISTED:
        return None
    fact = (
        f"the lines run at {lines.angle:.0f} degrees to the curvature directions of the surface, "
        "which this net has to follow"
    )
    return _other_lines(mesh, fact, "a start whose lines follow them")


def asymptotic_lines(mesh: QuadMesh) -> Remark | None:
    """Say where lines run so that no mesh of flat faces is near."""
    share = asymptotic_share(mesh)
    if share <= _HARDLY:
        return None
    fact = (
        f"on {100 * share:.0f} % of the surface the lines run along its asymptotic directions, "
        "straight on a saddle, where faces are flat only once the lines have turned away"
    )
    otherwise = "a start whose lines follow the curvature, or a larger --flatness"
    if share < _MOSTLY:
        return Remark("oblique", fact, otherwise)
    return _other_lines(mesh, fact, otherwise)


def _other_lines(mesh: QuadMesh, fact: str, otherwise: str) -> Remark:
    """Advise the diagonal mesh where that follows the curvature."""
    if directions(mesh, diagonal=True).twist < _FOLLOWING:
        return Remark("diagonal", fact, "its diagonal mesh (diagonal IN.obj -o OUT.obj)")
    return Remark("oblique", fact, otherwise)


def coarse_faces(mesh: QuadMesh, surface: TriangleSurface, within: float) -> Remark | None:
    """Say where faces leave a surface between their corners by more than is allowed.

    Args:
        mesh: the start.
        surface: the design surface.
        within: how far from it the result may be, in model units.
    """
    sag = float(off_surface(mesh.with_vertices(surface.closest(mesh.vertices)[0]), surface).max())
    # Half of it is left where corners stand out by the other half.
    if within >= 0.5 * sag:
        return None
    fact = (
        f"faces of this size leave the surface by {sag:.2g}, in the mesh's unit, between corners "
        "that lie on it"
    )
    return Remark("coarse", fact, f"a finer mesh (subdivide), or --within {sag:.2g}", (sag, 0, 0))


def closer_variant(mesh: QuadMesh, net: str, diagonal: bool) -> Remark | None:
    """Say where the other variant of a net starts ten times closer."""
    if len(NETS[net].variants) == 1 or not len(mesh.connectivity.stars):
        return None
    # Right angles say little: nets of both kinds start with lines that are nearly orthogonal.
    own = next(one for one in NETS[net].measures if one.across and not one.square)
    asked, other = (float(own.on(mesh, across).mean()) for across in (diagonal, not diagonal))
    if asked <= _CLOSER * other:
        return None
    fact = f"{net}: the start is {asked:.1e} from this net but {other:.1e} from the other variant"
    return Remark("variant", fact, "without --diagonal" if diagonal else "with --diagonal")


def _turned_border(mesh: QuadMesh, held: BoolArray) -> Remark | None:
    """Say where a border that is held cannot be a line of curvature.

    The normals along a line of curvature are parallel in the sense of Bishop: they turn no more
    about it than its bending makes them. On a border that is held the normals at its corners are
    known, and so is the turn between them, whatever the surface in between.

    Source: Bishop (1975), There is more than one way to frame a curve.
    """
    turns = []
    for side in _sides(mesh):
        closed = side[0] == side[-1]
        if held[side].all():
            turns.append((abs(_turn(mesh.vertices[side], closed)), side))
    if not turns:
        return None
    turn, side = max(turns, key=lambda each: each[0])
    if turn <= _TURN:
        return None
    first, last = (side[0], side[0]) if side[0] == side[-1] else (side[1], side[-2])
    where = f"between corners {first} and {last}" if first != last else f"once around from {first}"
    return Remark(
        "border",
        f"the border that is held twists the surface by {turn:.1f} degrees {where}, where this net "
        "allows hardly any",
        "a border that may leave its curve, to be trimmed afterwards",
        (turn, int(first), int(last)),
    )


def _sides(mesh: QuadMesh) -> Iterator[IntArray]:
    """Vertices of each border from corner to corner, and one more beyond each of the two corners.

    A loop without corners comes whole and begins and ends with the same vertex.
    """
    corner = mesh.connectivity.corners
    for loop in mesh.connectivity.boundary_loops:
        corners = np.flatnonzero(corner[loop])
        if not len(corners):
            yield np.append(loop, loop[0])
            continue
        turned = np.roll(loop, -corners[0])
        places = [*np.flatnonzero(corner[turned]).tolist(), len(loop)]
        for first, last in pairwise(places):
            yield turned[np.arange(first - 1, last + 2) % len(loop)]


def _turn(points: FloatArray, closed: bool) -> float:
    """Degrees by which the normals at both ends of a side differ about it, -90 to 90.

    Zero where a border has no angle at a corner, so that no normal is known.
    """
    edges = unit_rows(np.diff(points, axis=0))
    if closed:
        edges = np.concatenate([edges, edges[:1]])
        first = last = np.cross(edges[0], np.eye(3)[np.argmin(np.abs(edges[0]))])
    else:
        first, last = np.cross(edges[0], edges[1]), np.cross(edges[-2], edges[-1])
        if min(np.linalg.norm(first), np.linalg.norm(last)) < _CORNER:
            return 0.0
        edges = edges[1:-1]
    for before, after in pairwise(edges):
        first = _parallel(first, before, after)
    turn = np.arctan2(np.cross(first, last) @ edges[-1], first @ last)
    # A corner that points inwards has its normal on the other side.
    return float((np.degrees(turn) + 90) % 180 - 90)


def _parallel(normal: FloatArray, before: FloatArray, after: FloatArray) -> FloatArray:
    """The normal of a curve, turned by the smallest rotation of one of its edges to the next."""
    axis = np.cross(before, after)
    turned = normal * (before @ after) + np.cross(axis, normal)
    along = float(axis @ normal) / max(1.0 + float(before @ after), _BACK)
    return np.asarray(turned + along * axis)
