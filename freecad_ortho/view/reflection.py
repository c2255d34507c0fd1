"""Reflection lines: the stripes that a bright tunnel throws onto a polished surface.

They turn with the camera and break where the surface has a crease, so they show how smooth it is.
"""

from __future__ import annotations

import numpy as np
from pivy import coin

from solver.mesh.quadmesh import QuadMesh

_SIZE = 256
_STRIPES = 14
_DARK, _BRIGHT = 40, 250


class ReflectionLines:
    """Coin nodes that, put before a face set, draw it with stripes instead of colours.

    Attributes:
        root: the nodes behind a switch.
    """

    def __init__(self) -> None:
        self.root = coin.SoSwitch()
        group = coin.SoGroup()
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.PHONG
        material = coin.SoMaterial()
        material.diffuseColor = (0.0, 0.0, 0.0)
        material.emissiveColor = (1.0, 1.0, 1.0)
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.OVERALL
        self._normals = coin.SoNormal()
        normal_binding = coin.SoNormalBinding()
        normal_binding.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
        environment = coin.SoTextureCoordinateEnvironment()
        for child in (light, material, binding, self._normals, normal_binding):
            group.addChild(child)
        group.addChild(_stripes())
        group.addChild(environment)
        self.root.addChild(group)
        self.hide()

    def show(self, mesh: QuadMesh) -> None:
        """Draw the stripes with the mesh's normals at its vertices."""
        normals = mesh.vertex_normals
        self._normals.vector.deleteValues(len(normals))
        self._normals.vector.setValues(0, len(normals), normals)
        self.root.whichChild = coin.SO_SWITCH_ALL

    def hide(self) -> None:
        """Leave the colours as they are."""
        self.root.whichChild = coin.SO_SWITCH_NONE


def _stripes() -> coin.SoTexture2:
    """Soft stripes across the direction from which the surface mirrors."""
    across = np.linspace(0.0, 1.0, _SIZE, endpoint=False)
    wave = np.clip(0.5 + 2.0 * np.sin(2 * np.pi * _STRIPES * across), 0.0, 1.0)
    grey = np.round(_DARK + (_BRIGHT - _DARK) * wave).astype(np.uint8)
    image = coin.SbVec2s(_SIZE, _SIZE)
    texture = coin.SoTexture2()
    texture.image.setValue(image, 1, np.tile(grey, _SIZE).tobytes())
    return texture
