"""How nets look: colour map, its range, overlays."""

from __future__ import annotations

from collections.abc import Sequence

import FreeCAD

from freecad_ortho.documents.common import require_net, transaction
from freecad_ortho.objects.net import COLOUR_MAPS
from solver.errors import InputError
from solver.option import one_of


def show_net(
    net: FreeCAD.DocumentObject,
    colour_map: str | None = None,
    value_range: tuple[float, float] | None = None,
    overlays: Sequence[str] | None = None,
    legend: bool = True,
) -> None:
    """Choose what the view shows of a net; without a window only the colour map is kept.

    Args:
        net: the Net.
        colour_map: ``"None"``, ``"Target"`` (what the kind of net is judged by), or a field of
            :func:`solver.analysis.fields.fields`; None leaves it as it is.
        value_range: lowest and highest value of the scale in mm, 1/m, 1/m2 or degrees; of residuals
            powers of ten, such as ``(-6, -1)``. Without it the range follows the values.
        overlays: names of the view's overlays (``"Diagonals"``, ``"Axes"``, ...), all others are
            hidden; None leaves them as they are.
        legend: whether the scale is shown.

    Raises:
        InputError: an unknown name, or a range without width; nothing was changed.
    """
    require_net(net)
    if colour_map is not None:
        one_of("colour map", colour_map, COLOUR_MAPS)
    if value_range is not None and not value_range[0] < value_range[1]:
        low, high = value_range
        raise InputError(f"range: expected a lower and a higher value, got {low} and {high}")
    if FreeCAD.GuiUp:
        _refuse_unknown(overlays or ())
    with transaction(net.Document, FreeCAD.Qt.translate("Ortho", "Display")):
        chosen = net.ColourMap if colour_map is None else colour_map
        if not FreeCAD.GuiUp:
            net.ColourMap = chosen
            return
        from freecad_ortho.view import look

        if not net.Visibility:
            words = FreeCAD.Qt.translate("Ortho", "{} is hidden: nothing of this is seen yet")
            FreeCAD.Console.PrintMessage(words.format(net.Label) + "\n")
        look.show(net, look.wanted(net, chosen, value_range, overlays, legend))


def _refuse_unknown(overlays: Sequence[str]) -> None:
    from freecad_ortho.view.net_properties import OVERLAY_NAMES

    for name in overlays:
        one_of("overlay", name, OVERLAY_NAMES)
