"""What an undo, a saved file and a refusal must leave of a document."""

import numpy as np
import ortho_suite_tools as tools

from freecad_ortho.objects.flat_patterns import is_flat_patterns
from freecad_ortho.objects.net import is_net
from freecad_ortho.objects.structural_check import is_check
from freecad_ortho.objects.structure import is_structure


def snapshot(document):
    """What must not change: positions, faces, settings, parts and their volumes, by object."""
    found = {}
    for item in document.Objects:
        if is_net(item):
            found[item.Name] = (tools.vertices(item).tobytes(), tuple(item.Faces)), []
        elif is_structure(item):
            solids = item.Shape.Solids
            numbers = [solid.Volume for solid in solids]
            numbers += list(item.Shape.BoundBox.Center) if solids else []
            numbers += [float(value) for value in values(item, "Length", "Distance", "Float")]
            links = [getattr(link, "Name", None) for link in values(item, "Link")]
            words = values(item, "Enumeration", "Integer")
            found[item.Name] = (tuple(item.PartNames), *links, *words), numbers
        elif is_flat_patterns(item):
            found[item.Name] = tuple(item.PartNames), [item.Shape.Length, item.Shape.Area]
        elif is_check(item):
            found[item.Name] = (item.Supports, item.Verdict), [*item.MemberUtilisation]
    return found


def values(item, *kinds):
    wanted = [f"App::Property{kind}" for kind in kinds]
    names = [n for n in item.PropertiesList if item.getTypeIdOfProperty(n) in wanted]
    return [getattr(item, name) for name in names]


def assert_same(one, two, tolerance):
    assert one.keys() == two.keys(), f"{sorted(one)} became {sorted(two)}"
    for name in one:
        assert one[name][0] == two[name][0], f"{name} changed"
        assert len(one[name][1]) == len(two[name][1]), f"{name} has other solids"
        np.testing.assert_allclose(
            one[name][1], two[name][1], rtol=tolerance, atol=1e3 * tolerance, err_msg=name
        )
