"""A quad net on a design surface, along the lines that an exact net has there.

Curvature is fitted to the triangles, a smooth field of directions follows it, a map of the surface
to the plane follows the field, and quads are read from the map. The net overhangs the border by up
to a face, since lines of curvature seldom run along it; or it is bent to the border.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial import cKDTree

from solver.align.cells import crossing, quads
from solver.align.crosses import Crosses, Singular
from solver.align.cut import cut_open
from solver.align.features import Features
from solver.align.field import DirectionField, GuidingField, smooth_field
from solver.align.given import Wanted, given_field
from solver.align.guides import (
    along_features,
    net_guide,
    with_strokes,
)
from solver.align.options import OPTIONS
from solver.align.overhang import carried_on
from solver.align.patches import net_along_creases, net_on_flat_faces
from solver.align.prepare import Work, openings, prepared
from solver.align.remarks import (
    BUNCHED,
    say_border,
    say_bunched,
    say_openings,
    say_strokes,
    short_edges,
)
from solver.align.seamless import FIRM, seamless_map
from solver.align.seams import seams
from solver.align.slide import slid
from solver.align.symmetry import (
    Mirror,
    along_planes,
    mirrors_of,
    symmetric_crosses,
    symmetric_net,
    symmetric_singular,
    symmetric_surface,
    with_images,
)
from solver.align.triangle_mesh import TriangleMesh, one_surface
from solver.align.unfold import unfolded
from solver.analysis.measures import flipped
from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.intake import quad_mesh
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.mesh.triangles import sound_triangles
from solver.sentence import Sentence, at

# Quads that are made, at least and at most.
_FEWEST, _MOST = 6, 100_000
# Powers of two that a grain of coordinates is smaller than the surface.
_GRAINS = 32
_REMEDY = "give a shorter edge, or smooth the surface there"
# In edges, how far apart vertices are that lie in one place.
_TORN = 1e-3
# How much curvature says about directions, less where lines that follow it would cross.
_CALM = (1.0, 0.1, 1e-2, 1e-3)

# Nets whose lines run along curvature, or along creases.
_ALONG = ("principal", "developable")


@dataclass(frozen=True, eq=False)
class Aligned:
    """A net on a surface, not yet exact.

    Attributes:
        mesh: the quads.
        irregular: (K,) inner vertices that have not four faces.
        border: polylines (N, 3) of the surface's border, which the net overhangs, closed, without
            their start at the end; none where it follows the border.
        field: the directions that its lines follow.
        singular: where these cannot be continued.
        remarks: what is to be said about it, in plain words.
    """

    mesh: QuadMesh
    irregular: IntArray
    border: tuple[FloatArray, ...]
    field: Crosses
    singular: Singular
    remarks: tuple[str, ...] = ()


def aligned(
    vertices: ArrayLike,
    triangles: ArrayLike,
    *,
    net: str = "principal",
    edge: float,
    ratio: float = 1.0,
    border: str = "trim",
    stands_on: str = "boundary",
    strokes: Sequence[FloatArray] = (),
    singularities: Singular | None = None,
    symmetry: str = "none",
    waiting: Callable[[str], object] = lambda stage: None,
) -> Aligned:
    """Make a net of quads along a surface's lines of curvature, or at 45 degrees to them.

    Args:
        vertices: (V, 3) coordinates, in the model's unit.
        triangles: (T, 3) vertex numbers.
        net: ``principal`` or ``developable`` (along curvature), ``asymptotic`` or ``cmc`` (at 45
            degrees to it), ``asymptotic-angle`` (along asymptotic lines, at whatever angle they
            cross), ``stress`` (along the stresses of a shell under its weight).
        edge: wanted edge length.
        ratio: edge length of the other family of lines over that.
        border: ``trim`` lets the net overhang, ``follow`` bends it to the border.
        stands_on: ``boundary`` or ``corners``: what carries the shell that a stress net follows.
        strokes: polylines (n, 3) on the surface along which lines of the net run.
        singularities: where the net has vertices with 3, 5 or 6 faces, and nowhere else; the
            fewest that it needs by default.
        symmetry: planes in which the net is its own mirror image: ``none``, ``auto`` for those of
            the surface, or those across ``x``, ``y``, ``z`` or ``x,y`` through its middle;
            ``x,y,xy`` has the diagonals of x and y too, so that quarters of a turn change nothing.
        waiting: called with the name of each stage as it begins; what it raises is passed on.

    Raises:
        InputError: no such net, bad lengths, no single open surface, no such lines, no map, no such
            symmetry, or a stroke or a singularity that is off the surface.
    """
    settings = {"net": net, "edge": edge, "ratio": ratio, "border": border, "stands_on": stands_on}
    for name, value in {**settings, "symmetry": symmetry}.items():
        OPTIONS[name].check(value, "")
    waiting("curvature")
    given = one_surface(*sound_triangles(vertices, triangles))
    grain = _grain(given.points)
    surface = TriangleMesh(grain * np.round(given.points / grain), given.triangles)
    _refuse_size(surface, edge, edge * ratio)
    remarks: list[str] = []
    mirrors = mirrors_of(surface, symmetry, edge, remarks)
    if mirrors:
        given = surface = symmetric_surface(surface, mirrors)
        singularities = singularities and symmetric_singular(singularities, mirrors, edge)
    # What is asked for beside creases is followed by directions only.
    plain = net in _ALONG and ratio == 1 and not strokes and singularities is None
    faced = net_on_flat_faces(surface, mirrors, edge, remarks) if plain else None
    if faced is not None:
        return _whole(faced, remarks)
    loops = openings(surface, edge, remarks)
    smooth, work = prepared(surface, edge, min(edge, edge * ratio), remarks)
    waiting("directions")
    guide = net_guide(work.mesh, work.inner, work.tensors, net, edge, stands_on, remarks)
    faced = net_along_creases(smooth, work, guide, mirrors, edge, remarks) if plain else None
    if faced is not None:
        return _whole(faced, remarks)
    lines = [grain * np.round(np.asarray(stroke) / grain) for stroke in strokes]
    lines = with_images(lines, mirrors)
    follows = border == "follow"
    if follows and net in _ALONG:
        say_border(work.mesh, guide, edge, remarks)
    say_strokes(work.mesh, guide, lines, edge, net, remarks)
    asked = _Asked.of(work, guide, (edge, edge * ratio), follows, lines, singularities, mirrors)
    # A stroke is followed, and a border, at the price of right angles.
    asked = replace(asked, slides=net == "principal" and not follows and not strokes)
    mesh, field = _mapped(asked, waiting, remarks)
    say_openings(smooth, loops, mesh, remarks)
    say_bunched(mesh, min(edge, edge * ratio), remarks)
    # What was not smoothed is where it was given.
    kept = smooth.points[: len(given.points)]
    places = np.where((kept == surface.points).all(axis=1)[:, None], given.points, kept)
    connected = mesh.connectivity
    irregular = np.flatnonzero(~connected.regular & ~connected.boundary_vertices)
    return Aligned(
        mesh,
        irregular,
        tuple(places[loop] for loop in loops if not follows),
        symmetric_crosses(Crosses.of(work.mesh, field, asked.guide), mirrors),
        symmetric_singular(Singular.of(work.mesh, field, asked.guide), mirrors, edge),
        tuple(remarks),
    )


def _whole(net: QuadMesh, remarks: list[str]) -> Aligned:
    """A net that ends at the border, and did not come of a field."""
    connected = net.connectivity
    irregular = np.flatnonzero(~connected.regular & ~connected.boundary_vertices)
    crosses, singular = Crosses.of_net(net), Singular.of_net(net)
    return Aligned(net, irregular, (), crosses, singular, tuple(remarks))


def _grain(points: FloatArray) -> float:
    """What coordinates are rounded to, so that their last digits do not decide between two nets.

    A surface that was written and read again has others.
    """
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    return float(2.0 ** (np.floor(np.log2(size)) - _GRAINS)) if size > 0 else 1.0


def _refuse_size(surface: TriangleMesh, edge: float, other: float) -> None:
    area = float(surface.areas.sum())
    count = area / (edge * other)
    if count < _FEWEST:
        raise InputError(
            f"edge: {edge:.4g} leaves room for {count:.1f} faces on this surface; "
            f"{_rounded(np.sqrt(area / 100))} or less would do (is the unit right?)"
        )
    if count > _MOST:
        raise InputError(
            f"edge: {edge:.4g} makes {count:,.0f} faces, {_MOST:,} at most; "
            f"{_rounded(np.sqrt(area / 1000))} would give about a thousand (is the unit right?)"
        )


def _rounded(length: float) -> str:
    """A length with two digits that count, as one would type it."""
    return f"{float(f'{length:.2g}'):.10g}"


@dataclass(frozen=True, eq=False)
class _Asked:
    """A surface, and what a net on it is to follow; whether its vertices slide to right angles."""

    work: Work
    guide: GuidingField
    features: Features
    edges: tuple[float, float]
    singular: Wanted | None
    mirrors: Sequence[Mirror] = ()
    slides: bool = False

    @classmethod
    def of(
        cls,
        work: Work,
        guide: GuidingField,
        edges: tuple[float, float],
        follows: bool,
        strokes: Sequence[FloatArray],
        singular: Singular | None,
        mirrors: Sequence[Mirror],
    ) -> _Asked:
        """Add creases, planes, the border if followed, strokes and singular vertices to a guide."""
        mesh, edge = work.mesh, edges[0]
        features = Features.creases(mesh, work.inner, edge)
        bound = np.zeros(len(mesh.points), dtype=bool)
        if follows:
            work = replace(work, covered=work.inner)
            rim = Features.border(mesh, work.inner, edge)
            features = features.and_others(rim)
            bound[[side[rim.edges] for side in mesh.ends]] = True
        guide = along_features(mesh, guide, features, edge)
        if mirrors:
            features = features.and_others(along_planes(mesh, mirrors, edge))
        guide = with_strokes(mesh, guide, strokes, edge)
        wanted = None if singular is None else Wanted.of(work, singular, edge, bound)
        return cls(work, guide, features, edges, wanted, mirrors)

    def automatic(self, calm: float, step: Callable[[], object]) -> DirectionField:
        """The directions along a part of the guide, singular where they have to be."""
        return smooth_field(self.work.mesh, self.guide.calmed(calm), self.edges[0], step)

    def field(self, calm: float, automatic: DirectionField) -> DirectionField:
        """The directions, singular where they are asked to be."""
        if self.singular is None:
            return automatic
        quarters = self.singular.quarters(automatic)
        mesh, edge = self.work.mesh, self.edges[0]
        return given_field(mesh, self.guide, calm, edge, automatic, quarters)

    def misfit(self, automatic: DirectionField) -> str:
        """Why it cannot be singular as it is asked to be."""
        return "" if self.singular is None else self.singular.misfit(automatic)


@dataclass(frozen=True, eq=False)
class _Trial:
    """A net of one map, and how many of its faces are folded; or why there is none."""

    field: DirectionField
    close: bool
    mesh: QuadMesh | None = None
    folded: int = 0
    bunched: bool = False
    refusal: str = ""

    @property
    def faults(self) -> tuple[int, bool]:
        """What is wrong with the net, the worst first."""
        return self.folded, self.bunched


def _mapped(
    asked: _Asked, waiting: Callable[[str], object], remarks: list[str]
) -> tuple[QuadMesh, DirectionField]:
    """The quads of a map along the guide, as closely as lines do not run into each other."""
    best: _Trial | None = None
    refusal = ""
    for trial in _trials(asked, waiting):
        if trial.mesh is not None and (best is None or trial.faults < best.faults):
            best = trial
        if best is not None and not any(best.faults):
            break
        refusal = refusal or trial.refusal
    if best is None or best.mesh is None:
        raise InputError(refusal)
    if not best.close:
        remarks.append(
            Sentence(
                "lines that follow the surface's own directions closely would run into each other, "
                "or bunch, here; these do less so"
            )
        )
    if best.folded:
        remarks.append(_said_folded(best.folded))
    return best.mesh, best.field


def _said_folded(count: int) -> Sentence:
    if count == 1:
        return Sentence("1 face is folded; give a shorter edge, or smooth the surface there")
    return Sentence("{} faces are folded; give a shorter edge, or smooth the surface there", count)


def _trials(asked: _Asked, waiting: Callable[[str], object]) -> Iterator[_Trial]:
    """Nets that follow the guide less and less."""
    work, mesh, edges = asked.work, asked.work.mesh, asked.edges
    for calm in _CALM:
        waiting("directions")
        field = asked.automatic(calm, lambda: waiting("directions"))
        misfit = asked.misfit(field)
        if misfit:
            yield _Trial(field, False, refusal=misfit)
            continue
        field = asked.field(calm, field)
        cut = cut_open(mesh, field)
        layout = seams(mesh, cut, field.quarters != 0)
        for firm in FIRM:
            waiting("map")
            made = seamless_map(
                *(mesh, cut, layout, asked.guide.firmness, edges, work.covered),
                firm=firm,
                features=asked.features,
                skew=asked.guide.skew,
                step=lambda: waiting("map"),
            )
            waiting("quads")
            found = quads(mesh, cut, made, work.covered)
            close = (calm, firm) == (_CALM[0], FIRM[0])
            crossed = crossing(found)
            places = found.places if crossed is not None else carried_on(mesh, cut, made, found)
            if work.covered > work.inner and (crossed is not None or _torn(places, min(edges))):
                # Beyond the border lines may do so: the surface is covered without that strip.
                less = quads(mesh, cut, made, work.inner)
                if crossed is not None or crossing(less) is None:
                    found, crossed = less, crossing(less)
                    places = carried_on(mesh, cut, made, found) if crossed is None else places
            if crossed is not None:
                refusal = f"map: lines run into each other near {at(crossed)}; {_REMEDY}"
                yield _Trial(field, close, refusal=refusal)
                continue
            try:
                net = unfolded(quad_mesh(places, found.faces.tolist())[0], mesh)
            except InputError as error:
                where = mesh.centres[made.folded[0]] if len(made.folded) else places.mean(axis=0)
                refusal = f"map: it folds near {at(where)} ({error}); {_REMEDY}"
                yield _Trial(field, close, refusal=refusal)
                continue
            try:
                if asked.slides:
                    net = slid(net, mesh, asked.features.ends(mesh))
                net = symmetric_net(net, asked.mirrors, edges[0])
            except InputError as error:
                yield _Trial(field, close, refusal=str(error))
                continue
            bunched = short_edges(net) < BUNCHED * min(edges)
            yield _Trial(field, close, net, int(flipped(net).sum()), bunched)
            if bunched:
                # Lines are drawn together by their directions: others have to be smoother.
                break


def _torn(places: FloatArray, edge: float) -> bool:
    """Whether a net meets itself, as over an opening, where it would come apart."""
    return bool(cKDTree(places).query_pairs(_TORN * edge))
