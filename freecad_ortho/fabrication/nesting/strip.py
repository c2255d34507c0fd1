"""The library that packs strips (spyrrow), as it is called in its own process."""

from __future__ import annotations

from collections.abc import Sequence

LIBRARY = "spyrrow"

Outline = Sequence[tuple[float, float]]


class StripPacker:
    """Calls of the library; for :class:`solver.isolated.Isolated`."""

    def pack(
        self,
        outlines: Sequence[Outline],
        angles: Sequence[Sequence[float]],
        height: float,
        seconds: int,
        seed: int,
    ) -> list[tuple[int, float, float, float]]:
        """Pack outlines into a strip that is as short as can be.

        Args:
            outlines: corners of each, mm.
            angles: degrees by which each may turn; an orientation higher than the strip brings the
                library down.
            height: of the strip, mm.
            seconds: that each of the two parts of the search takes.
            seed: of the search.

        Returns:
            Number of the outline, its turn in degrees and its shift along x and y, mm.
        """
        import spyrrow

        items = [
            spyrrow.Item(str(number), list(outline), 1, list(turns))
            for number, (outline, turns) in enumerate(zip(outlines, angles, strict=True))
        ]
        search = spyrrow.StripPackingConfig(
            total_computation_time=None,
            exploration_time=seconds,
            compression_time=seconds,
            num_workers=1,
            seed=seed,
        )
        solution = spyrrow.StripPackingInstance("", height, items).solve(search)
        return [(int(p.id), p.rotation, *p.translation) for p in solution.placed_items]
