"""What is said of panels that bear too little says by how much beams have to grow."""

import re

import pytest

from freecad_ortho import api


@pytest.mark.parametrize("panels", ["glass:8", "plywood"])
def test_the_width_that_is_named_is_enough(roof, panels):
    def said(thickness):
        made = api.fabricate(
            roof,
            "beams+panels",
            material=f"steel,panels={panels}",
            thickness=thickness,
            panel_thickness=8.0,
        )
        return [words for words in made.report()["messages"] if "bear on" in words], made

    [words], _ = said(20.0)
    more = int(re.search(r"beams (\d+) mm thicker or a section that much wider", words)[1])
    wide, made = said(20.0 + more)
    assert not wide and set(made.verdicts) == {"ok"}
    assert said(20.0 + more - 2)[0]
