"""Pictures of structures and sheets as SVG text."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence
from html import escape
from typing import Any

import numpy as np

from freecad_ortho.fabrication.limits import OK
from freecad_ortho.fabrication.nesting import Placement, Sheet
from freecad_ortho.fabrication.part import Part
from solver.mesh.quadmesh import FloatArray, unit_rows

GOOD, BAD, INK, PAPER = "#9db8d2", "#d1495b", "#26333f", "#f4f1ea"
# Where the eye is for the two views: above, and above a corner.
PLAN, CORNER = (0.0, 0.0, 1.0), (0.55, -0.7, 0.6)


def structure_view(
    parts: Sequence[Part], verdicts: Sequence[str], eye: tuple[float, float, float], words: str
) -> str:
    """Draw parts in parallel projection, those that do not pass in red.

    Args:
        parts: what to draw, each as the hulls of its pieces.
        verdicts: one a part.
        eye: direction towards the viewer.
        words: what the picture shows.
    """
    frame = view_frame(eye)
    base = parts[0].origin
    seen = []
    owners: list[tuple[str, str]] = []
    for part, verdict in zip(parts, verdicts, strict=True):
        for piece in part.body.pieces():
            seen.append((part.origin - base + piece.corners @ part.frame) @ frame.T)
            owners.append((part.name, verdict))
    hulls = hulls_of([points[:, :2] for points in seen])
    behind = np.argsort([float(points[:, 2].mean()) for points in seen], kind="stable").tolist()
    corners = np.concatenate(hulls)
    low, high = corners.min(axis=0), corners.max(axis=0)
    scale = 800 / max(float((high - low).max()), 1e-9)
    size = (high - low) * scale
    shapes = []
    for number in behind:
        name, verdict = owners[number]
        points = (hulls[number] - [low[0], high[1]]) * [scale, -scale]
        kind = "good" if verdict == OK else "bad"
        title = escape(f"{name}: {verdict}")
        shapes.append(f'<path class="{kind}" d="{_path(points)}"><title>{title}</title></path>')
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" aria-label="{escape(words)}" '
        f'viewBox="-4 -4 {size[0] + 8:.0f} {size[1] + 8:.0f}">{"".join(shapes)}</svg>'
    )


def sheet_picture(sheet: Sheet) -> str:
    """Draw one sheet with the names of its parts."""
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" aria-label="{sheet.name}" '
        f'viewBox="{-0.01 * sheet.width:.4g} {-0.01 * sheet.width:.4g} {1.02 * sheet.width:.6g} '
        f'{sheet.height + 0.02 * sheet.width:.6g}">{_sheet_group(sheet)}</svg>'
    )


def overview(sheets: Sequence[Sheet]) -> str:
    """Draw all sheets in rows, each with its name, thickness and waste."""
    width, height = (max(getattr(sheet, side) for sheet in sheets) for side in ("width", "height"))
    columns = max(1, round(math.sqrt(len(sheets) * height / width * 1.4)))
    text = 0.045 * max(width, height)
    step = np.array([width * 1.06, height + 3 * text])
    groups = []
    for number, sheet in enumerate(sheets):
        x, y = np.array([number % columns, number // columns]) * step
        words = escape(f"{sheet.title}, waste {100 * sheet.waste:.0f} %")
        groups.append(
            f'<g transform="translate({x:.6g} {y:.6g})">'
            f'<text x="0" y="{1.3 * text:.4g}" font-size="{text:.4g}">{words}</text>'
            f'<g transform="translate(0 {2 * text:.4g})">{_sheet_group(sheet)}</g></g>'
        )
    rows = math.ceil(len(sheets) / columns)
    size = step * [min(columns, len(sheets)), rows]
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" font-family="sans-serif" '
        f'viewBox="{-0.02 * width:.4g} 0 {size[0]:.6g} {size[1]:.6g}">{"".join(groups)}</svg>\n'
    )


def _sheet_group(sheet: Sheet) -> str:
    line = sheet.width / 1000
    drawn = [
        f'<rect width="{sheet.width:g}" height="{sheet.height:g}" fill="{PAPER}" stroke="{INK}" '
        f'stroke-width="{line:.4g}"/>'
    ]
    for placement in sheet.placements:
        pattern = placement.pattern
        cut = [placement.outline, *(placement.on_sheet(hole) for hole in pattern.cutouts)]
        path = " ".join(_path(_upright(points, sheet)) for points in cut)
        drawn.append(
            f'<path d="{path}" fill="{GOOD}" fill-rule="evenodd" stroke="{INK}" '
            f'stroke-width="{line:.4g}"/>'
        )
        for hole in pattern.holes:
            x, y = _upright(placement.on_sheet(hole.centre[None]), sheet)[0]
            radius = hole.diameter / 2
            drawn.append(f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{radius:.2f}" fill="{PAPER}"/>')
        drawn.append(_label(placement, sheet))
    return "".join(drawn)


def _label(placement: Placement, sheet: Sheet) -> str:
    """The part's name along the longer side of its box, as large as there is room."""
    low, high = placement.outline.min(axis=0), placement.outline.max(axis=0)
    width, height = (high - low).tolist()
    x, y = _upright(placement.on_sheet(placement.pattern.label[None]), sheet)[0]
    turn = -90 if height > width else 0
    long, short = max(width, height), min(width, height)
    size = min(1.2 * long / len(placement.name), 0.6 * short, 0.1 * sheet.height)
    return (
        f'<text transform="translate({x:.2f} {y:.2f}) rotate({turn})" text-anchor="middle" '
        f'dominant-baseline="central" font-family="sans-serif" font-size="{size:.3g}" '
        f'fill="{INK}">{escape(placement.name)}</text>'
    )


def _upright(points: FloatArray, sheet: Sheet) -> FloatArray:
    """SVG counts y downwards."""
    return np.stack([points[:, 0], sheet.height - points[:, 1]], axis=1)


def _path(points: FloatArray) -> str:
    return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points.tolist()) + "Z"


def hulls_of(clouds: Sequence[FloatArray]) -> list[FloatArray]:
    """Corners of the convex hull of each cloud of points in the plane, (N, 2) each."""
    import shapely

    owner = np.repeat(np.arange(len(clouds)), [len(points) for points in clouds])
    many = shapely.multipoints(shapely.points(np.concatenate(clouds)), indices=owner)
    found, owner = shapely.get_coordinates(shapely.convex_hull(many), return_index=True)
    rings = np.split(found, np.flatnonzero(np.diff(owner)) + 1)
    # A ring ends where it began; what is only a line or a point does not.
    return [ring[:-1] if len(ring) > 2 else ring for ring in rings]


def silhouettes(clouds: Sequence[FloatArray], owners: Sequence[int]) -> dict[int, list[FloatArray]]:
    """What bodies look like from afar that are put together from convex pieces.

    Args:
        clouds: corners in the plane (N, 2) of each piece.
        owners: number of the body of each piece.

    Returns:
        By body the corners of its outlines, the largest first, then those of its openings.
    """
    import shapely

    pieces: dict[int, list[Any]] = defaultdict(list)
    for hull, owner in zip(hulls_of(clouds), owners, strict=True):
        # What is seen from its narrow side is a line.
        pieces[owner].append(shapely.Polygon(hull) if len(hull) > 2 else shapely.LineString(hull))
    found: dict[int, list[FloatArray]] = {}
    for owner, shapes in pieces.items():
        low, high = shapely.total_bounds(shapes).reshape(2, 2)
        # Pieces that touch leave no crack between them.
        whole = shapely.union_all(shapes, grid_size=float((high - low).max()) * 1e-6)
        areas = [part for part in shapely.get_parts(whole) if isinstance(part, shapely.Polygon)]
        areas.sort(key=lambda area: -area.area)
        rings = [area.exterior for area in areas]
        rings += [ring for area in areas for ring in area.interiors]
        found[owner] = [np.array(ring.coords)[:-1] for ring in rings] or [
            shapely.get_coordinates(whole)
        ]
    return found


def view_frame(eye: tuple[float, float, float]) -> FloatArray:
    """Rows to the right, up and towards the viewer."""
    back = unit_rows(np.array([eye]))[0]
    right = np.cross([0.0, 0.0, 1.0], back)
    right = np.array([1.0, 0.0, 0.0]) if np.linalg.norm(right) < 1e-9 else right
    right = right / np.linalg.norm(right)
    return np.stack([right, np.cross(back, right), back])
