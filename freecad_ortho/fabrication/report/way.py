"""How a net came to be, for the reports of what is made of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple


class Stage(NamedTuple):
    """A stage of the way, in words: what was asked and what came of it."""

    name: str
    asked: str
    reached: str


@dataclass(frozen=True)
class StagesBefore:
    """The stages before the parts.

    Attributes:
        stages: in words, for people.
        numbers: entries of ``report.json``, none of which a report of parts has itself.
    """

    stages: Sequence[Stage]
    numbers: dict[str, Any]
