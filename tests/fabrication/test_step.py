"""STEP files: small, whole, the same every time; shared geometry loses nothing."""

import re
from collections import Counter

import pytest

from freecad_ortho.fabrication import Beams, Lamellas, build
from freecad_ortho.fabrication.step import read_step, write_step
from freecad_ortho.fabrication.step_text import compacted
from tests.meshes import helicoid


def entities(path):
    return re.findall(rb"#(\d+)=([^;]*);\n", path.read_bytes())


@pytest.fixture(scope="module")
def twisted_lamellas():
    net = helicoid(rows=9, columns=7).scaled(1000.0)
    return build(net, [Lamellas(width=40, thickness=4, layers=2, strip="twisted")]).parts[:4]


def test_beams_take_a_third_of_what_the_kernel_writes(roof, tmp_path):
    """With curves in the parameters of planes they were 24 kB each, now less than 8 kB."""
    parts = build(roof, [Beams(200, 12)]).parts
    write_step(tmp_path / "beams.step", parts)
    assert (tmp_path / "beams.step").stat().st_size < 8000 * len(parts)
    kinds = Counter(
        re.match(rb"\(?\s*(\w+)", body)[1] for _, body in entities(tmp_path / "beams.step")
    )
    assert not kinds[b"PCURVE"] and not kinds[b"SURFACE_CURVE"]
    # Each solid has its own corners and edges.
    assert kinds[b"VERTEX_POINT"] == 12 * len(parts) and kinds[b"EDGE_CURVE"] == 18 * len(parts)
    assert kinds[b"CARTESIAN_POINT"] < 14 * len(parts)


def test_no_geometry_is_written_twice_and_numbers_run_on(structure, tmp_path):
    write_step(tmp_path / "all.step", structure.parts)
    found = entities(tmp_path / "all.step")
    assert [int(number) for number, _ in found] == list(range(1, len(found) + 1))
    shared = [
        body for _, body in found if body.startswith((b"CARTESIAN_POINT", b"DIRECTION", b"LINE"))
    ]
    assert len(set(shared)) == len(shared)
    used = {int(number) for _, body in found for number in re.findall(rb"#(\d+)", body)}
    assert used <= set(range(1, len(found) + 1))


def test_twisted_lamellas_are_valid_and_small_without_flat_curves(twisted_lamellas, tmp_path):
    write_step(tmp_path / "lamellas.step", twisted_lamellas)
    assert b"PCURVE" not in (tmp_path / "lamellas.step").read_bytes()
    read = read_step(tmp_path / "lamellas.step")
    assert [name for name, _ in read] == [part.name for part in twisted_lamellas]
    for (_, solid), part in zip(read, twisted_lamellas, strict=True):
        assert solid.isValid()
        assert solid.Volume() == pytest.approx(part.volume, rel=1e-4)


def test_equal_geometry_is_one_and_topology_is_not():
    text = b"""ISO-10303-21;
HEADER;
ENDSEC;
DATA;
#1 = VERTEX_POINT('',#3);
#2 = VERTEX_POINT('a #3; b',#4);
#3 = CARTESIAN_POINT('',(1.E+03,-0.,
    2.5E-02));
#4 = CARTESIAN_POINT('',(1000.,0.,0.025));
#5 = LINE('',#3,#7);
#6 = LINE('',#4,#8);
#7 = VECTOR('',#9,1.);
#8 = VECTOR('',#10,1.);
#9 = DIRECTION('',(0.,0.,1.));
#10 = DIRECTION('',(0.,1.E-17,1.));
#11 = EDGE_CURVE('',#1,#2,#6,.T.);
ENDSEC;
END-ISO-10303-21;
"""
    assert (
        compacted(text)
        == b"""ISO-10303-21;
HEADER;
ENDSEC;
DATA;
#1=VERTEX_POINT('',#3);
#2=VERTEX_POINT('a #3; b',#3);
#3=CARTESIAN_POINT('',(1000.,0.,0.025));
#4=LINE('',#3,#5);
#5=VECTOR('',#6,1.);
#6=DIRECTION('',(0.,0.,1.));
#7=EDGE_CURVE('',#1,#2,#4,.T.);
ENDSEC;
END-ISO-10303-21;
"""
    )
