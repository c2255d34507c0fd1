"""GLB (glTF 2.0): all parts with names and colours, for viewers; in metres, y upwards."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from freecad_ortho.fabrication.colours import colour_of
from freecad_ortho.fabrication.exchange.facets import facets
from freecad_ortho.fabrication.production import Production

# From x, y, z in mm to x, z, -y in m.
_UPRIGHT = 1e-3 * np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])


def write_glb(
    path: Path, production: Production, project: str, say: Callable[[float], None]
) -> None:
    """Write the parts as meshes of a scene, below one node a system.

    Args:
        path: file to write.
        production: of the structure.
        project: its name.
        say: called with the fraction done; may raise to stop.

    Raises:
        OSError: the file cannot be written.
    """
    from trimesh import Scene, Trimesh
    from trimesh.visual import TextureVisuals
    from trimesh.visual.material import PBRMaterial

    scene = Scene(base_frame=project or "structure")
    materials = {}
    done, count = 0, len(production.structure.parts)
    for system, result in production.structure.results.items():
        scene.graph.update(frame_to=system, frame_from=scene.graph.base_frame, matrix=np.eye(4))
        for part in result.parts:
            if done % 16 == 0:
                say(done / count)
            done += 1
            name = part.material.name
            if name not in materials:
                colour = colour_of(part.material)
                materials[name] = PBRMaterial(
                    name=name,
                    baseColorFactor=colour,
                    metallicFactor=0.1,
                    roughnessFactor=0.6,
                    alphaMode="BLEND" if colour[3] < 255 else "OPAQUE",
                    doubleSided=True,
                )
            corners = (part.origin + facets(part).triangles @ part.frame) @ _UPRIGHT.T
            faces = np.arange(3 * len(corners)).reshape(-1, 3)
            mesh = Trimesh(corners.reshape(-1, 3), faces, process=False)
            mesh.visual = TextureVisuals(material=materials[name])
            scene.add_geometry(mesh, part.name, part.name, system)
    path.write_bytes(scene.export(file_type="glb"))
