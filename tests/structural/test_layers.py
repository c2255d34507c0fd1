"""Members beside the net: eccentric ones, and two layers with a bolt where lines cross."""

import json
import os
import shutil
import subprocess

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.structural.calculix import input_file
from freecad_ortho.structural.check import StructuralCheck
from freecad_ortho.structural.design import Design
from freecad_ortho.structural.model import model_of
from freecad_ortho.structural.words import assumptions
from solver.errors import InputError
from solver.frame.response import imbalance, response
from solver.frame.system import FrameSystem
from solver.mesh.primitives import primitive

SECTION = "tube:100x60x5"
# So much the arms give way, by their stiffness of 300 members each.
ARMS = 0.01


@pytest.fixture(scope="module")
def dome():
    mesh = primitive("translational", 7, 5)
    return mesh.with_vertices(2000.0 * mesh.vertices)


def flat(count, across, length, width):
    mesh = primitive("rectangle", count, across, length=length, width=width)
    return mesh.with_vertices(mesh.vertices - mesh.vertices.min(axis=0))


def moved(mesh, **settings):
    model = model_of(mesh, Design.of({"section": SECTION, "self_weight": False} | settings))
    return model, response(FrameSystem(model.frame, model.supports), model.cases[0].loads)


@pytest.mark.parametrize("height", [40.0, -25.0])
def test_an_eccentric_beam_is_squeezed_by_its_pinned_ends(height):
    """Ends that are held e below the middle of the section would part by 2 e times their turn.

    -N (L / E A + e^2 L / E I) = 2 e P L^2 / (16 E I), P in the middle.
    """
    length, force = 4000.0, 1000.0
    mesh = flat(3, 2, length, 1000.0)
    ends = np.flatnonzero(~np.isclose(mesh.vertices[:, 0], length / 2)).tolist()
    middle = np.flatnonzero(np.isclose(mesh.vertices[:, 0], length / 2)).tolist()
    model, found = moved(
        mesh,
        eccentric=height,
        supports=",".join(map(str, ends)),
        load=[f"{vertex}:0,0,{-force / 1000}" for vertex in middle],
    )
    of = model.bare.stiffness
    bend, stretch = of.youngs[0] * of.about_y[0], of.youngs[0] * of.area[0]
    thrust = -height * force * length**2 / (8 * bend)
    thrust /= length / stretch + height**2 * length / bend
    span = model.bare.nodes[model.bare.members[:, 1]] - model.bare.nodes[model.bare.members[:, 0]]
    along = np.abs(span[:, 0]) > 1.0
    got = found.forces_at(model.frame, 0.5)[: len(along), 0][along]
    assert got == pytest.approx(np.full(along.sum(), thrust), rel=ARMS)


@pytest.mark.parametrize(
    ("crossings", "spring", "layers"),
    [("3", 3e6, 10.0), ("200", 2e8, 10.0), ("rigid", np.inf, 10.0), ("3", 3e6, 0.0)],
)
def test_a_square_is_sheared_as_its_bolts_or_slots_let_it(crossings, spring, layers):
    """H a^2 / 4 (1 / k + a / (3 E I) + 4 / (a G As)): bolts turn and members bend to an S."""
    side, force = 2000.0, 1000.0
    mesh = flat(2, 2, side, side)
    below = np.isclose(mesh.vertices[:, 1], 0.0)
    top = np.flatnonzero(~below).tolist()
    model, found = moved(
        mesh,
        layers=layers,
        crossings=crossings,
        supports=f"{','.join(map(str, np.flatnonzero(below)))}+{','.join(map(str, top))}:sliding",
        load=[f"{vertex}:{force / 2000},0,0" for vertex in top],
    )
    of = model.bare.stiffness
    bent = side / (3 * of.youngs[0] * of.about_z[0])
    sheared = 4 / (side * of.shear[0] * of.shear_area_y[0])
    sway = force * side**2 / 4 * (1 / spring + bent + sheared)
    assert found.displacements[top, 0] == pytest.approx(np.full(2, sway), rel=ARMS)


def test_bolts_that_let_go_of_everything_are_a_mechanism():
    mesh = flat(2, 2, 2000.0, 2000.0)
    settings = {"layers": 10.0, "crossings": "hinged", "load": "3:1,0,0"}
    with pytest.raises(InputError, match=r"a mechanism: node.* freely"):
        moved(mesh, supports="0,1+2,3:sliding", **settings)


def test_layers_are_where_they_are_said_to_be(dome):
    model = model_of(dome, Design.of({"snow": 1.0, "layers": 80.0, "eccentric": 10.0}))
    middles = model.bare.nodes[model.bare.members].mean(axis=1)
    edges = np.asarray(dome.connectivity.edges)
    above = middles - dome.vertices[edges].mean(axis=1)
    height = (above * dome.vertex_normals[edges].mean(axis=1)).sum(axis=1)
    upper = np.array([word == "u" for word in model.families])
    lower = np.array([word == "v" for word in model.families])
    assert above[:, 2].max() > 40 and height[upper].min() > 45 and height[lower].max() < -25
    on_net = model_of(dome, Design.of({"snow": 1.0}))
    for one, two in zip(model.cases, on_net.cases, strict=True):
        assert one.loads.total(model.frame) == pytest.approx(
            two.loads.total(on_net.frame), rel=0.03
        )


def test_layers_that_nearly_touch_are_in_balance_too(dome):
    settings = {"section": "plate:12x120", "snow": 1.0, "layers": 0.1, "crossings": "hinged"}
    model = model_of(dome, Design.of(settings))
    loads = model.cases[1].loads
    found = response(FrameSystem(model.frame, model.supports), loads)
    assert imbalance(model.frame, loads, found.reactions) < 1e-9


@pytest.fixture(scope="module")
def in_layers(dome) -> StructuralCheck:
    low = dome.with_vertices(dome.vertices * [1.0, 1.0, 0.2])
    return api.check_structure(
        low, section="plate:10x60", snow=1.0, layers=70.0, crossings="hinged", second_order=True,
        imperfection=5.0,
    )  # fmt: skip


def test_the_whole_check_of_two_layers(in_layers, tmp_path):
    assert in_layers.balance < 1e-9
    edges = len(in_layers.model.mesh.connectivity.edges)
    assert len(in_layers.utilisation) == edges < len(in_layers.model.frame.members)
    said = " ".join(assumptions(in_layers))
    along, across = in_layers.arm_forces
    assert "in two layers 70 mm apart" in said and along > 0 and f"{across / 1e3:.1f} kN" in said
    names = {path.name for path in api.write_structural_check(in_layers, tmp_path)}
    assert "model.inp" in names
    model = json.loads((tmp_path / "model.json").read_text(encoding="utf-8"))
    assert len(model["members"]) == edges
    assert {row["turning_about_it"] for row in model["arms_and_bolts"]} == {0.0, None}
    with (tmp_path / "forces.csv").open(encoding="utf-8") as stream:
        assert sum(1 for _ in stream) == 1 + 3 * edges * len(in_layers.strength)


def sway(crossings):
    """Lines in two layers, held at their first two crossings and pushed at their ends."""
    mesh = flat(4, 4, 6000.0, 6000.0)
    y = mesh.vertices[:, 1]
    held, ends = (",".join(map(str, np.flatnonzero(rows))) for rows in (y < 2001, y > 5999))
    load = [f"{vertex}:1,0,0" for vertex in ends.split(",")]
    return moved(mesh, layers=120.0, crossings=crossings, supports=f"{held}:fixed", load=load)


def test_calculix_has_arms_and_pins_in_those_that_turn():
    model, _ = sway("hinged")
    text = input_file(model)
    places = {
        int(row[0]): [float(word) for word in row[1:]]
        for row in rows_of(text, "*NODE, NSET=ALL", "*ELEMENT")
    }
    elements = rows_of(text, "*ELEMENT, TYPE=B32R, ELSET=MEMBERS", "*MATERIAL")
    members, every = len(model.families), len(model.frame.members)
    arms = every - members
    assert arms == 2 * 16 and len(elements) == 4 * (every + arms // 2)
    assert text.count("MATERIAL=ARMS") == arms + arms // 2
    lines = text.splitlines()
    held = [lines[n + 2 : n + 4] for n, line in enumerate(lines) if line == "*EQUATION"]
    assert len(held) == 3 * 2 * (arms // 2)
    for (one, direction, factor), (two, other, less) in (
        [line.split(",") for line in pair] for pair in held
    ):
        assert places[int(one)] == places[int(two)] and one != two and direction == other
        assert (float(factor), float(less)) == (1, -1)
    assert input_file(sway("rigid")[0]).count("*EQUATION") == 0


def test_springs_of_supports_are_elements_of_calculix():
    supports = "boundary:springs=5/4000/0"
    model, _ = moved(flat(3, 3, 4000.0, 4000.0), supports=f"{supports}+4:fixed", load=["4:0,0,-1"])
    lines = input_file(model).splitlines()
    cards = [n for n, line in enumerate(lines) if line.startswith("*ELEMENT, TYPE=SPRING1")]
    beams = 4 * len(model.frame.members)
    found = {}
    for number, at in enumerate(cards, beams + 1):
        name = lines[at].split("ELSET=")[1]
        assert lines[at + 2] == f"*SPRING, ELSET={name}"
        element, node = map(int, lines[at + 1].split(","))
        assert element == number
        # With a point, or CalculiX takes it for a direction.
        assert "." in lines[at + 4]
        found[node - 1, int(lines[at + 3]) - 1] = float(lines[at + 4])
    border = np.flatnonzero(model.mesh.connectivity.boundary_vertices)
    assert found == {(n, k): (5e3, 4e6)[k] for n in border.tolist() for k in (0, 1)}


def rows_of(text, start, end):
    part = text.split(f"{start}\n")[1].split(end)[0]
    return [line.split(",") for line in part.strip().splitlines()]


@pytest.mark.skipif(shutil.which("ccx") is None, reason="needs CalculiX: apt install calculix-ccx")
@pytest.mark.parametrize("crossings", ["rigid", "hinged", "3"])
def test_calculix_moves_layers_as_the_check_does(tmp_path, crossings):
    """But for its joints, which are rigid as far as sections reach: an eighth at most."""
    assert apart_from_calculix(*sway(crossings), tmp_path) < 0.13


@pytest.mark.skipif(shutil.which("ccx") is None, reason="needs CalculiX: apt install calculix-ccx")
@pytest.mark.parametrize(
    ("settings", "softer"), [({"joints": "20"}, 2.0), ({"joints": "20", "panel_shear": 10.0}, 0.2)]
)
def test_calculix_has_joints_that_give_and_panels_that_stiffen(tmp_path, settings, softer):
    """A wall of four fields, its foot fixed, pushed and loaded across at its top."""
    mesh = flat(3, 3, 4000.0, 4000.0)
    foot, top = (np.flatnonzero(mesh.vertices[:, 1] == y).tolist() for y in (0.0, 4000.0))
    given = {
        "supports": f"{','.join(map(str, foot))}:fixed",
        "load": [f"{vertex}:1,0,-0.1" for vertex in top],
    }
    rigid = moved(mesh, **given)[1].displacements[top, 0].mean()
    model, found = moved(mesh, **given, **settings)
    by = found.displacements[top, 0].mean() / rigid
    assert by > softer if softer > 1 else by < softer
    assert apart_from_calculix(model, found, tmp_path) < 0.04


def apart_from_calculix(model, found, folder):
    """Largest difference of displacements on the net, by the largest displacement."""
    (folder / "model.inp").write_text(input_file(model), encoding="utf-8")
    alone = {**os.environ, "OMP_NUM_THREADS": "1"}
    subprocess.run(
        ["ccx", "model"], cwd=folder, capture_output=True, check=True, timeout=60, env=alone
    )
    said = (folder / "model.dat").read_text(encoding="utf-8").splitlines()
    rows = [line.split() for line in said if len(line.split()) == 4 and line.split()[0].isdigit()]
    moves = {int(row[0]) - 1: [float(word) for word in row[1:]] for row in rows}
    got = np.array([moves[node] for node in range(len(model.mesh.vertices))])
    own = found.displacements[: len(got), :3]
    return np.abs(got - own).max() / np.abs(own).max()


def test_hinged_bolts_buckle_earlier_than_rigid_ones(in_layers):
    design = {"section": "plate:10x60", "snow": 1.0, "layers": 70.0}
    rigid = api.check_structure(in_layers.model.mesh, **design)
    assert in_layers.factor < 0.99 * rigid.factor


@pytest.mark.parametrize(
    ("settings", "said"),
    [
        ({"layers": -5.0}, "layers: expected"),
        ({"layers": 50.0, "crossings": "loose"}, "crossings: expected rigid, hinged or a stiff"),
    ],
)
def test_what_cannot_be_is_refused_in_one_line(dome, settings, said):
    with pytest.raises(InputError, match=said) as found:
        model_of(dome, Design.of({"snow": 1.0} | settings))
    assert "\n" not in str(found.value)
