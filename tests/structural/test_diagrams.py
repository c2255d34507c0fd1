"""Diagrams of forces: their values, their sides, and how they are drawn."""

import re

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.structural.diagram_pictures import NEGATIVE, POSITIVE, diagram_picture
from freecad_ortho.structural.diagrams import (
    FORCES,
    Diagram,
    across,
    drawn_combination,
    fitting,
    forces_along,
    strips,
)
from solver.mesh.primitives import primitive


def test_a_diagram_goes_through_its_forces_and_has_its_zeros_and_turns():
    """12 x (1 - x) - 2 has zeros at (1 -+ 1 / sqrt 3) / 2 and 1 as its largest."""
    rows = np.array([[-2.0, 1.0, -2.0], [3.0, 1.0, -1.0], [5.0, 5.0, 5.0], [0.0, 0.0, 0.0]])
    found = Diagram.through(rows)
    arch = 12 * found.parts[0] * (1 - found.parts[0]) - 2
    assert found.values[0] == pytest.approx(arch, abs=1e-12)
    assert found.values[0].max() == pytest.approx(1.0, abs=1e-12)
    zeros = found.parts[0][found.values[0] == 0.0]
    assert np.unique(zeros) == pytest.approx(0.5 - np.array([1, -1]) / np.sqrt(12))
    assert found.values[1] == pytest.approx(3 - 4 * found.parts[1], abs=1e-12)
    assert (found.parts[1][found.values[1] == 0.0] == 0.75).all()
    assert (found.values[2] == 5).all() and (found.values[3] == 0).all()
    assert (np.diff(found.parts, axis=1) >= 0).all()
    (most, least), size = found.extremes(), found.largest
    assert (found.values[most], found.values[least], size) == (5.0, -2.0, 5.0)
    ends = np.array([[[0.0, 0, 0], [1000.0, 0, 0]], [[0, 0, 0], [0, 2000.0, 0]]])
    assert fitting(found, ends) * size == pytest.approx(0.08 * 2000)
    assert strips(2, 3).tolist() == [[0, 1, 7, 6], [1, 2, 8, 7], [3, 4, 10, 9], [4, 5, 11, 10]]


@pytest.fixture(scope="module")
def beams():
    """Two beams of 8 m side by side under snow, built in at their ends."""
    mesh = primitive("rectangle", 3, 2, length=8000.0, width=1000.0)
    x = mesh.vertices[:, 0]
    ends = np.flatnonzero(np.abs(x - x.mean()) > 1000).tolist()
    supports = f"{','.join(map(str, ends))}:fixed"
    return api.check_structure(mesh, unit="mm", supports=supports, snow=10.0, self_weight=False)


def test_moments_are_drawn_at_the_side_that_they_pull_at(beams):
    """Built in beams pull above at their ends, below in the middle; a member by q l^2 / 8."""
    forces, frame = forces_along(beams), beams.model.bare
    (snow,) = beams.model.cases
    factor = drawn_combination(beams).combination.factors["snow"]
    long = np.flatnonzero(frame.lengths > 2000)
    load = -factor * snow.loads.spread[long, 2] * frame.lengths[long] ** 2 / 1e6
    above = forces[long, :, 4] * across("My", frame.axes)[long, 2:]
    assert above[:, [0, 2]].mean(axis=1) - above[:, 1] == pytest.approx(load / 8, rel=1e-9)
    assert (above[:, [0, 2]].max(axis=1) > load / 12).all()
    assert (above[:, [0, 2]].min(axis=1) < -load / 24).all()
    assert across("Mz", frame.axes) == pytest.approx(-frame.axes[:, 1])
    assert across("Vy", frame.axes) == pytest.approx(frame.axes[:, 1])


def test_a_picture_has_both_signs_its_extremes_and_a_bar(beams):
    forces, frame = forces_along(beams), beams.model.bare
    picture = diagram_picture(frame, "My", forces[:, :, 4], (0.3, -0.7, 0.6), "moments")
    areas = {
        colour: re.search(f'd="([^"]*)" fill="{colour}"', picture).group(1)
        for colour in (POSITIVE, NEGATIVE)
    }
    # Above at the built in ends of four members, below at the others; or the other way round.
    assert all(path.count("M") >= 4 for path in areas.values())
    for value in (forces[:, :, 4].max(), forces[:, :, 4].min()):
        assert f">{value:.3g} kNm</text>" in picture
    bar = re.search(r"h([\d.]+)m0", picture).group(1)
    number = float(re.search(r">([\d.e-]+) kNm</text><rect", picture).group(1))
    assert float(bar) > 0 and 0.2 <= number / np.abs(forces[:, :, 4]).max() <= 1
    empty = diagram_picture(frame, "T", 0 * forces[:, :, 3], (0.3, -0.7, 0.6), "torsion")
    assert ">nothing</text>" in empty and "nan" not in empty


def test_the_page_has_a_diagram_of_each_force(beams, tmp_path):
    api.write_structural_check(beams, tmp_path)
    page = (tmp_path / "check.html").read_text(encoding="utf-8")
    part = page.split("<h2>Diagrams</h2>")[1].split("<h2>")[0]
    assert part.count("<svg") == len(FORCES)
    assert drawn_combination(beams).combination.name in part
