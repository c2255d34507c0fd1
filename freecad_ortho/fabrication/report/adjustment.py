"""What bolted nodes give on site, as a section of the report."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


def adjustment(nodes: Mapping[str, Any]) -> str:
    """Erection gap, shims and play of bolted nodes; nothing for others.

    Args:
        nodes: what the report says of them.
    """
    if "gap_mm" not in nodes:
        return ""
    words = [f"Beams are {nodes['gap_mm']:g} mm shorter at each end than what they are bolted to"]
    if "shims_mm" in nodes:
        words.append(
            f"with the bolts listed a joint takes shims of up to {nodes['shims_mm']:g} mm there"
        )
    if "play_along_mm" in nodes:
        words.append(f"holes let a beam move by {nodes['play_along_mm']:g} mm along itself")
    words.append(f"and by {nodes['play_across_mm']:g} mm across")
    return (
        f"<h2>Adjustment on site</h2><p>{'; '.join(words)}, before bolts are tightened. What "
        "cutting and drilling may be off by for all of it to go together, the command "
        "<code>tolerances</code> says.</p>"
    )
