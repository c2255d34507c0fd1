"""One file a net or a few of a kind: recipe, options, measures, words; the table has them all."""

from solver.nets.net import Easier, Measure, Net, Way
from solver.nets.table import (
    NETS,
    all_measures,
    net_named,
    nets_with,
    refuse_foreign,
    register,
    unregister,
)

__all__ = [
    "NETS",
    "Easier",
    "Measure",
    "Net",
    "Way",
    "all_measures",
    "net_named",
    "nets_with",
    "refuse_foreign",
    "register",
    "unregister",
]
