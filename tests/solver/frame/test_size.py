"""How large a frame is solved in how long."""

import resource
import time

import numpy as np
import pytest

from solver.frame.model import Loads
from solver.frame.response import imbalance, response
from tests.solver.frame import frames


@pytest.mark.slow
def test_ten_thousand_nodes_in_less_than_twenty_seconds_and_two_gigabytes():
    side = 100
    x, y = np.meshgrid(np.linspace(-1, 1, side), np.linspace(-1, 1, side), indexing="ij")
    height = 0.4 * (1 - x**2) * (1 - y**2)
    nodes = 50_000.0 * np.stack([x, y, height], axis=-1).reshape(-1, 3)
    number = np.arange(side**2).reshape(side, side)
    pairs = [(number[:-1], number[1:]), (number[:, :-1], number[:, 1:])]
    members = np.concatenate([np.stack([a.ravel(), b.ravel()], axis=1) for a, b in pairs])
    built = frames.frame(nodes, members)
    border = np.unique([number[0], number[-1], number[:, 0], number[:, -1]])
    loads = Loads.none(built)
    loads.spread[:, 2] = -1.5
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    start = time.process_time()
    system = frames.system(built, dict.fromkeys(border.tolist(), "x y z"))
    found = response(system, loads)
    assert time.process_time() - start < 20
    more = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    assert more < 2 * 1024**2, "more than 2 GB"
    assert imbalance(built, loads, found.reactions) < 1e-9
