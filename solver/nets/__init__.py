"""One recipe a net: the terms that must vanish."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

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

# Of these, the one that a doubly curved start does not reach.
RIGID = ("geodesic-chebyshev",)


@dataclass(frozen=True)
class Stage:
    """An easier net that is made first.

    Attributes:
        net: name of its recipe.
        fairness: factor on the fairness of its attempts.
        evenness: weight of evenness, on the way to the wanted net too; zero for none.
    """

    net: str
    fairness: float = 1.0
    evenness: float = 0.0


# Where the start leads nowhere, these are tried one after the other.
CONTINUED: dict[str, tuple[Stage, ...]] = {
    "circular": (Stage("principal"),),
    "conical": (Stage("principal"),),
    "stress": (
        Stage("orthogonal", 10.0, evenness=1.0),
        Stage("orthogonal", 100.0),
        Stage("orthogonal"),
    ),
}

# Nets reached as easily with faces crossed over as without: guards stand by from the start.
GUARDED = ("stress",)

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
