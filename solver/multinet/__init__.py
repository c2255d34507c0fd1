"""Orthogonal multi-nets: nets whose parameter rectangles all have equal diagonals.

Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 3.
"""

from solver.multinet.elliptic import EllipticSystem, elliptic_net
from solver.multinet.fit import MultiNetFit, fit_multi_net
from solver.multinet.inverse import MultiNetResidual, is_multi_net, multi_net_residual
from solver.multinet.net import MultiNet
from solver.multinet.planar import confocal_conics, confocal_parabolas
from solver.multinet.polyline import multi_net
from solver.multinet.quadric import Quadric
from solver.multinet.reflection import reflected
from solver.multinet.rotational import rotational_net

__all__ = [
    "EllipticSystem",
    "MultiNet",
    "MultiNetFit",
    "MultiNetResidual",
    "Quadric",
    "confocal_conics",
    "confocal_parabolas",
    "elliptic_net",
    "fit_multi_net",
    "is_multi_net",
    "multi_net",
    "multi_net_residual",
    "reflected",
    "rotational_net",
]
