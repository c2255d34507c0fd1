"""Coin's pairs of whole numbers as arrays."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.mesh.quadmesh import FloatArray


def pixel_pair(pair: Any) -> FloatArray:
    """Make an array (2,) of a SbVec2s, whose ``getValue`` newer Coin bindings cannot unpack."""
    return np.array([pair[0], pair[1]], dtype=np.float64)
