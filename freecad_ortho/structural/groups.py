"""Members in groups, each with a section of its own."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.material import MATERIALS, Material
from freecad_ortho.fabrication.profiles import Profile, profile
from freecad_ortho.structural.strength import Rules, rules_for
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray

# Before the name of a group; polygons have commas of their own.
_BEFORE_GROUP = re.compile(r",(?=\s*[A-Za-z][\w ]*=)")


@dataclass(frozen=True, eq=False)
class Group:
    """Members of one section.

    Attributes:
        name: of the group, empty for all members that are in no other.
        members: (M,) true for its members.
        profile: of them.
        material: of them.
        rules: by which they are checked.
    """

    name: str
    members: BoolArray
    profile: Profile
    material: Material
    rules: Rules


def groups_of(sections: str, material: str, names: Sequence[str]) -> tuple[Group, ...]:
    """Members with the sections of their groups.

    Args:
        sections: of all, then of groups: ``tube:100x60x5,border=tube:150x100x6.3``.
        material: of all of them, empty for that which each section is of.
        names: (M,) of each member's group.

    Raises:
        InputError: no such section, material or group.
    """
    given = _sections(sections)
    unknown = [name for name in given if name and name not in names]
    if unknown:
        known = sorted(set(names))
        raise InputError(
            f"section: there is no group '{unknown[0]}' of members; there are {', '.join(known)}"
        )
    own = np.array([name if name in given else "" for name in names])
    missing = own == ""
    if missing.any() and "" not in given:
        raise InputError(
            f"section: members of '{names[int(missing.argmax())]}' have none; give one for all "
            "first, as tube:100x60x5,border=tube:120x60x5"
        )
    found = []
    for name, text in given.items():
        section = profile(text)
        word = material or section.material
        if (own == name).any():
            rules = rules_for(section, word)
            found.append(Group(name, own == name, section, MATERIALS[word], rules))
    return tuple(found)


def _sections(text: str) -> dict[str, str]:
    """Names of sections by the groups that have them, empty for all others."""
    found: dict[str, str] = {}
    for part in _BEFORE_GROUP.split(text):
        name, equals, section = part.partition("=")
        group, words = (name.strip(), section) if equals else ("", part)
        if group in found:
            raise InputError(f"section: '{group or 'all'}' has two; give each group one")
        found[group] = words.strip()
    return found


def written(sections: dict[str, str]) -> str:
    """The text that stands for sections of groups; of one for all its name."""
    first, *others = dict.fromkeys(sections.values())
    if not others:
        return first
    return ",".join([first, *(f"{name}={words}" for name, words in sections.items())])
