"""Nets that are optimised again, as they were before, when what they were made from has changed."""

from __future__ import annotations

from collections.abc import Sequence

import FreeCAD

from freecad_ortho import answers, convert
from freecad_ortho.documents import net_settings
from freecad_ortho.documents.common import open_document, progress, require_net, transaction
from freecad_ortho.documents.nets import optimise_within, store_outcome
from freecad_ortho.objects import source_net
from solver import Outcome, StepRecord, optimise
from solver.errors import InputError

# Steps at which the bar is full.
_STEPS = 200


def optimise_again(
    nets: FreeCAD.DocumentObject | Sequence[FreeCAD.DocumentObject] = (),
    document: FreeCAD.Document | None = None,
) -> list[Outcome]:
    """Optimise outdated nets as before, from what their sources make now; structures follow.

    Args:
        nets: a Net or several; those that are not outdated stay as they are. Without them all of a
            document.
        document: whose, if no nets are given; the active one by default.

    Returns:
        The outcomes, in the order in which the nets stand on each other.

    Raises:
        InputError: no Net, or one whose settings name vertices that its source does not make any
            more; the document is unchanged.
    """
    chosen = list(nets) if isinstance(nets, (list, tuple)) else [nets]
    for net in chosen:
        require_net(net)
    target = chosen[0].Document if chosen else open_document(document)
    done: dict[str, Outcome] = {}
    with transaction(target, FreeCAD.Qt.translate("Ortho", "Optimise again")):
        # What stands on a net that was optimised may be outdated by that.
        while left := [net for net in outdated_nets(target, chosen) if net.Name not in done]:
            require_same_vertices(left[0])
            done[left[0].Name] = optimise_within(left[0])
    return list(done.values())


def outdated_nets(
    document: FreeCAD.Document, among: Sequence[FreeCAD.DocumentObject] = ()
) -> list[FreeCAD.DocumentObject]:
    """Nets of a document whose source has changed since they were moved, what they stand on first.

    Args:
        document: the document.
        among: only these count, if there are any.
    """
    found = [item for item in document.Objects if source_net.is_outdated(item)]
    found = [item for item in found if not among or item in among]
    return sorted(found, key=lambda net: len(net.OutListRecursive))


def require_same_vertices(net: FreeCAD.DocumentObject) -> None:
    """Raise InputError where settings name vertices that the source of a net makes no more."""
    mesh = source_net.made_mesh(net)
    if convert.quad_mesh(net).faces.tobytes() == mesh.faces.tobytes():
        return
    named = {
        "fixed vertices": bool(net.FixedVertices),
        "handles": bool(net.Handles),
        "gliding vertices": bool(net.GlidingVertices),
        "supports": any(map(str.isdigit, str(net_settings.words(net)["supports"]))),
    }
    if any(named.values()):
        words = ", ".join(word for word, some in named.items() if some)
        raise InputError(
            f"{net.Label}: its source makes other vertices now, and its {words} are numbers of "
            "those before; choose them anew in Optimise"
        )


def _renew(net: FreeCAD.DocumentObject) -> None:
    """Optimise an outdated net again, in a recompute of its document.

    Raises:
        OrthoError: its settings do not fit any more, or the user has pressed Esc.
    """
    mesh = source_net.starting_mesh(net)
    require_same_vertices(net)
    with progress(net.Label) as move:

        def stepped(record: StepRecord) -> None:
            if move is not None:
                move(min(record.step / _STEPS, 1.0), "")

        outcome = optimise(mesh, callback=stepped, **net_settings.for_solver(net, mesh))
    source_net.remake(net)
    store_outcome(net, outcome)


answers.give("optimise again", _renew)
