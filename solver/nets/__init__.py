"""One recipe a net: the terms that must vanish."""

from __future__ import annotations

from collections.abc import Callable

from solver.nets.curvature import asymptotic, cmc, snet
from solver.nets.developable import chebyshev, dog, geodesic, geodesic_chebyshev, isometric
from solver.nets.options import NetOptions
from solver.nets.orthogonal import orthogonal
from solver.nets.principal import circular, conical, principal
from solver.nets.stress import stress
from solver.problem import Problem

# Nets that exist on developable surfaces only: where a doubly curved start leads nowhere, a start
# bent in one direction is tried.
DEVELOPABLE = ("geodesic", "dog", "chebyshev", "geodesic-chebyshev")

# Where the start leads nowhere, an easier net is made first, with so much more fairness.
CONTINUED: dict[str, tuple[tuple[str, float], ...]] = {
    "circular": (("principal", 1.0),),
    "conical": (("principal", 1.0),),
    "stress": (("orthogonal", 100.0), ("orthogonal", 1.0)),
}

RECIPES: dict[str, Callable[[Problem, NetOptions], Problem]] = {
    "orthogonal": orthogonal,
    "principal": principal,
    "circular": circular,
    "conical": conical,
    "geodesic": geodesic,
    "dog": dog,
    "chebyshev": chebyshev,
    "geodesic-chebyshev": geodesic_chebyshev,
    "asymptotic": asymptotic,
    "cmc": cmc,
    "snet": snet,
    "stress": stress,
    "isometric": isometric,
}
