"""What the user has set on the preference page (Edit > Preferences > Ortho).

The page itself is ``resources/preferences.ui``; its first values are the ones below.
"""

from __future__ import annotations

from typing import Any

import FreeCAD

PATH = "User parameter:BaseApp/Preferences/Mod/Ortho"

LENGTHS = {"BeamHeight": 200.0, "BeamThickness": 20.0, "PanelThickness": 12.0, "PanelGap": 8.0}
COLOURS = {
    "NetColour": (0.80, 0.84, 0.88),
    "BeamColour": (0.58, 0.63, 0.69),
    "PanelColour": (0.62, 0.80, 0.88),
}
# In the order of the boxes on the page; the first choice leaves it to the file, to the solver.
IMPORT_UNITS = (None, "mm", "cm", "m", "in", "ft")
IMPORT_UPS = ("z", "y")
SPARSE_SOLVERS = (None, "rslab", "scipy")


def length(name: str) -> float:
    """Give a size in mm that panels start with; the names are those of ``LENGTHS``."""
    return float(group().GetFloat(name, LENGTHS[name]))


def colour(name: str) -> tuple[float, float, float]:
    """Give the colour of new objects, red, green and blue from 0 to 1, by a name of ``COLOURS``."""
    packed = group().GetUnsigned(name, _packed(COLOURS[name]))
    red, green, blue = ((packed >> shift & 255) / 255 for shift in (24, 16, 8))
    return red, green, blue


def import_unit() -> str | None:
    """Give the unit that files are read in; None leaves it to the file."""
    return _choice("ImportUnit", IMPORT_UNITS)


def import_up() -> str:
    """Give the axis that points up in files."""
    return _choice("ImportUp", IMPORT_UPS) or IMPORT_UPS[0]


def import_settings() -> dict[str, str]:
    """Give those settings of :func:`freecad_ortho.api.import_net` that are not the usual ones."""
    unit, up = import_unit(), import_up()
    return ({"unit": unit} if unit else {}) | ({"up": up} if up != IMPORT_UPS[0] else {})


def solver_settings() -> dict[str, str]:
    """Give the settings of :func:`freecad_ortho.api.optimise` that the user has chosen for all."""
    chosen = _choice("SparseSolver", SPARSE_SOLVERS)
    return {} if chosen is None else {"backend": chosen}


def at_once() -> float:
    """Give the seconds that a shape may take to be built at once when its net changes."""
    return float(group().GetFloat("AtOnceSeconds", 1.0))


def workers() -> int:
    """Give the number of processes that share the work on fabrication files."""
    return max(1, int(group().GetInt("Workers", 1)))


def asks_for_packages() -> bool:
    """Tell whether to offer the installation of missing packages."""
    return bool(group().GetBool("AskForPackages", True))


def group() -> Any:
    """Give FreeCAD's group of the workbench's parameters."""
    return FreeCAD.ParamGet(PATH)


def _choice(name: str, choices: tuple[str | None, ...]) -> str | None:
    number = group().GetInt(name, 0)
    return choices[number] if 0 <= number < len(choices) else None


def _packed(rgb: tuple[float, float, float]) -> int:
    red, green, blue = (round(255 * part) for part in rgb)
    return red << 24 | green << 16 | blue << 8 | 255
