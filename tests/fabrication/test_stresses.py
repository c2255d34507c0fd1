"""Bending and torsion of plates: formulas, the verdict on both, and what the files say of them."""

import csv
import math
from dataclasses import replace
from pathlib import Path

import pytest

from freecad_ortho.fabrication import Lamellas, Limits, Measures, build, material, write
from freecad_ortho.fabrication.limits import verdict
from tests.meshes import helicoid

WORKSHOP = (Path(__file__).parents[2] / "docs" / "workshop.md").read_text(encoding="utf-8")


def test_torsion_counts_beside_bending(structure):
    """A lamella of 3 mm at 49 degrees a metre: neither alone is too much, both together are."""
    steel = material("steel")
    shear = steel.shear_stress(3.0, math.radians(49) / 1000)
    assert shear == pytest.approx(210_000 / 2.6 * 3 * 0.855211e-3, rel=1e-5)
    measures = Measures(stress_MPa=321.0, min_bend_radius_mm=981.3, torsion_deg_per_m=49.0)
    part = replace(structure.parts[0], measures=measures)
    assert verdict(part, Limits()) == "ok"
    part = replace(part, measures=replace(measures, shear_MPa=shear))
    assert verdict(part, Limits()) == (
        "stress 482 MPa exceeds 355 MPa of steel: bending 321 MPa, bent to 981 mm, and 207 MPa of "
        "shear from torsion of 49 degrees a metre"
    )


@pytest.mark.parametrize(
    "name, modulus", [("steel", 81e3), ("aluminium", 27e3), ("timber", 690), ("glass", 29e3)]
)
def test_shear_moduli_are_those_of_the_standards(name, modulus):
    """EN 1993-1-1, EN 1999-1-1, EN 338; of glass 70 GPa / 2.4, after EN 572-1."""
    assert material(name).shear_modulus == pytest.approx(modulus, rel=0.01)


@pytest.mark.parametrize(
    ("name", "density", "modulus", "strength"),
    [
        ("steel", 7850, 210_000, 355),
        ("S235", 7850, 210_000, 235),
        ("S275", 7850, 210_000, 275),
        ("S355", 7850, 210_000, 355),
        ("stainless", 7900, 200_000, 210),
        ("aluminium", 2700, 70_000, 150),
        ("timber", 420, 11_000, 24),
        ("C24", 420, 11_000, 24),
        ("C30", 460, 12_000, 30),
        ("GL24h", 420, 11_500, 24),
        ("GL28h", 460, 12_600, 28),
        ("GL30h", 480, 13_600, 30),
        ("GL32h", 490, 14_200, 32),
        ("gfrp", 1900, 23_000, 240),
        ("glass", 2500, 70_000, 45),
        ("strengthened-glass", 2500, 70_000, 70),
        ("toughened-glass", 2500, 70_000, 120),
    ],
)
def test_strengths_are_those_of_the_standards_and_of_the_manual(name, density, modulus, strength):
    """EN 1993-1-1 and 1-4, 1999-1-1, 338, 14080, 13706-3, 572-1, 1863-1, 12150-1."""
    made = material(name)
    assert (made.density, made.youngs_modulus, made.bending_limit) == (density, modulus, strength)
    row = next(line for line in WORKSHOP.splitlines() if line.startswith(f"| {name} "))
    cells = [cell.strip().replace(",", "") for cell in row.split("|")[2:6]]
    assert cells == [
        *(f"{value:.0f}" for value in (density, modulus, strength)),
        f"{made.least_radius(1.0):.0f}",
    ]


def test_twisted_lamellas_are_held_against_bending_and_torsion(tmp_path):
    """On a helicoid z = angle, in m, its middle ruling turns by 1 rad a metre."""
    net = helicoid(rows=17, columns=13).scaled(1000.0)
    lamellas = Lamellas(width=40, thickness=4, layers=2, strip="twisted")
    structure = build(net, [lamellas])
    write(structure, tmp_path)
    with (tmp_path / "parts.csv").open(newline="") as stream:
        rows = {row["name"]: row for row in csv.DictReader(stream)}
    shear = {name: float(row["shear_MPa"]) for name, row in rows.items()}
    assert max(shear.values()) == pytest.approx(210_000 / 2.6 * 4e-3, rel=0.01)
    for part in structure.parts:
        row = rows[part.name]
        bending = float(row["stress_MPa"] or 0.0)
        combined = math.hypot(bending, math.sqrt(3) * shear[part.name])
        assert float(row["combined_MPa"]) == pytest.approx(combined, rel=1e-4)
        assert (combined > 355) == ("MPa of shear from torsion" in row["verdict"])
    assert any("MPa of shear" in row["verdict"] for row in rows.values())
    assert "combined, MPa" in (tmp_path / "report.html").read_text(encoding="utf-8")
