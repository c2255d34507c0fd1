"""STL: the surface of a solid in triangles, for 3D printers."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from freecad_ortho.fabrication.part import Part

_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_DEVIATION = 0.02  # of triangles from round faces, mm


def write_stl(path: Path, part: Part) -> None:
    """Write a part in its own coordinates, standing on z = 0, in mm, as a binary file.

    Raises:
        OSError: the file cannot be written.
    """
    solid = part.body.solid()
    vertices, triangles = solid.tessellate(_DEVIATION, 0.1)
    points = np.array([vertex.toTuple() for vertex in vertices])
    points -= [0.0, 0.0, points[:, 2].min()]
    corners = points[np.array(triangles)]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    table = np.zeros(len(corners), dtype=_TRIANGLE)
    table["normal"] = normals / np.linalg.norm(normals, axis=1)[:, None]
    table["corners"] = corners
    header = f"{part.name}, mm".encode("ascii").ljust(80)
    path.write_bytes(header + np.uint32(len(table)).tobytes() + table.tobytes())
