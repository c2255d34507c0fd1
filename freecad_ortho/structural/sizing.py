"""The lightest section of a list with which a shell passes its check."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from freecad_ortho.fabrication.material import MATERIALS
from freecad_ortho.fabrication.profiles import profile
from freecad_ortho.structural.check import Progress, StructuralCheck
from solver.errors import InputError

# Sections in use, by the names of lists: EN 10210-2, table A.3, flats and glued timber in stock.
LISTS = {
    "tubes": (
        "tube:50x30x3.2", "tube:60x40x4", "tube:80x40x4", "tube:90x50x5", "tube:100x60x5",
        "tube:120x60x5", "tube:120x80x6.3", "tube:140x80x6.3", "tube:150x100x6.3",
        "tube:160x80x8", "tube:180x100x8", "tube:200x100x8", "tube:200x120x10", "tube:250x150x10",
    ),
    "plates": (
        "plate:8x80", "plate:10x100", "plate:12x120", "plate:15x150", "plate:20x150",
        "plate:20x200", "plate:25x200", "plate:25x250", "plate:30x250", "plate:30x300",
        "plate:40x300",
    ),
    "glulam": (
        "GL24h:60x120", "GL24h:80x120", "GL24h:80x160", "GL24h:100x160", "GL24h:100x200",
        "GL24h:120x200", "GL24h:120x240", "GL24h:140x280", "GL24h:160x320", "GL24h:200x400",
    ),
}  # fmt: skip
# Most checks that are made.
MOST = 20


@dataclass(frozen=True)
class Try:
    """What one section came to.

    Attributes:
        section: its name.
        mass: of all members, kg.
        utilisation: largest.
        factor: least buckling factor, None where nothing buckles.
        displacement: largest of a node in service, mm.
        passed: whether the check was passed.
    """

    section: str
    mass: float
    utilisation: float
    factor: float | None
    displacement: float
    passed: bool


@dataclass(frozen=True, eq=False)
class Sizing:
    """The lightest section that passes, and what was tried on the way.

    Attributes:
        tries: from the lightest section on.
        check: of the lightest that passed, or of the last where none did.
    """

    tries: tuple[Try, ...]
    check: StructuralCheck

    @property
    def verdict(self) -> str:
        """What it comes to, in one line."""
        model, count = self.check.model, len(self.tries)
        if not self.check.passed:
            return f"None of {count} sections passes. {model.section_words}: {self.check.verdict}"
        found = (
            "is the lightest that passes" if len(model.groups) == 1 else "pass, the lightest found"
        )
        return (
            f"{model.section_words} {found} ({model.mass / 1000:.2f} t, {count} tried). "
            f"{self.check.verdict}"
        )


def tried(section: str, found: StructuralCheck) -> Try:
    """What a section, or those of groups, came to."""
    used = float(found.utilisation.max())
    return Try(section, found.model.mass, used, found.factor, found.deflection, found.passed)


def sections_of(text: str, material: str = "") -> list[str]:
    """Names of sections, the lightest by the metre first.

    Args:
        text: a list (tubes, plates, glulam) or names joined by "+".
        material: of all of them; by default what each is made of.

    Raises:
        InputError: a name that is no section, or more than twenty.
    """
    names = LISTS.get(text.strip(), [name.strip() for name in text.split("+")])
    if len(names) > MOST:
        raise InputError(f"sections: {len(names)} are too many; name {MOST} at most")

    def weight(name: str) -> float:
        section = profile(name)
        return section.mass_per_metre(MATERIALS.get(material) or MATERIALS[section.material])

    return sorted(names, key=weight)


def least(
    names: Sequence[str],
    check: Callable[[str], StructuralCheck],
    progress: Progress | None = None,
) -> Sizing:
    """Check with one section after the other until one passes.

    Args:
        names: of the sections, the lightest first.
        check: with one of them.
        progress: called with a fraction and words; may raise to stop.
    """
    tries: list[Try] = []
    for number, name in enumerate(names):
        if progress is not None:
            progress(number / len(names), name)
        found = check(name)
        tries.append(tried(name, found))
        if found.passed:
            break
    return Sizing(tuple(tries), found)
