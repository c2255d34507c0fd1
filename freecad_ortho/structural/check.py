"""The check: every combination of loads on the frame, and what it comes to."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeVar

import numpy as np

from freecad_ortho.structural.bending import share_of_bending, strain_energies
from freecad_ortho.structural.combinations import SERVICE, STRENGTH, Combination
from freecad_ortho.structural.membrane import MembraneForces, membrane
from freecad_ortho.structural.model import Model
from freecad_ortho.structural.slots import at_slots
from freecad_ortho.structural.strength import used_words
from solver.errors import InputError
from solver.frame.buckling import Buckling, buckling
from solver.frame.model import Loads
from solver.frame.response import Response, imbalance, response
from solver.frame.second_order import imperfect, second_order
from solver.frame.system import FrameSystem
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray

Progress = Callable[[float, str], None]
_Part = TypeVar("_Part", Response, Loads)
# Sections along a member in which it is checked.
STATIONS = np.linspace(0.0, 1.0, 11)
# Buckling factor from which on balance in the deformed shape matters little: EN 1993-1-1, 5.2.1.
ENOUGH = 10.0
# Size of an imperfection by the span, where none is given.
_IMPERFECTION = 1 / 300


@dataclass(frozen=True, eq=False)
class CombinationResult:
    """What one combination does.

    Attributes:
        combination: of loads.
        response: of the frame, first order.
        balance: imbalance of loads and reactions.
        section: (M,) utilisation of sections; zero for service.
        member: (M,) utilisation of members with buckling between their ends.
        forces: (M, 6) N, Vy, Vz, T, My, Mz that govern each member: those of the section that is
            used most, or where buckling between its ends governs the most compression and the
            largest others along it.
        deformed: (M,) whether these are those of balance in the deformed shape.
        buckling: modes under it, for strength.
        slot: (M,) utilisation of the sections that slots leave, which is in ``section`` too.
        bent: share of the strain energy that is not of axial forces, first order; 0 is a shell
            that carries by its form alone.
        carried: part of it that is balanced in the deformed, imperfect shape, where that was
            looked for.
        membrane: how far it carries by axial forces, for strength.
    """

    combination: Combination
    response: Response
    balance: float
    section: FloatArray
    member: FloatArray
    forces: FloatArray
    deformed: BoolArray
    buckling: Buckling | None = None
    slot: FloatArray | None = None
    bent: float | None = None
    carried: float | None = None
    membrane: MembraneForces | None = None

    @property
    def utilisation(self) -> FloatArray:
        """(M,) the larger of both."""
        return np.maximum(self.section, self.member)

    def by(self, member: int) -> str:
        """What uses a member most, in a word."""
        if self.member[member] > self.section[member]:
            return "buckling"
        slot = 0.0 if self.slot is None else float(self.slot[member])
        return "slot" if 0 < slot >= self.section[member] else "section"

    @property
    def factor(self) -> float | None:
        """The first buckling factor; None where nothing buckles."""
        some = self.buckling is not None and len(self.buckling.factors)
        return float(self.buckling.factors[0]) if self.buckling and some else None

    @property
    def displacement(self) -> FloatArray:
        """(N,) of the nodes, mm."""
        return np.asarray(np.linalg.norm(self.response.displacements[:, :3], axis=1))


@dataclass(frozen=True, eq=False)
class StructuralCheck:
    """A checked model.

    Attributes:
        model: what was checked.
        cases: response to each load case.
        found: of every combination.
        imperfection: size of the imperfection, mm, where balance is in the deformed shape.
    """

    model: Model
    cases: tuple[Response, ...]
    found: tuple[CombinationResult, ...]
    imperfection: float | None = None

    @cached_property
    def strength(self) -> tuple[CombinationResult, ...]:
        """Combinations for forces and buckling."""
        return tuple(one for one in self.found if one.combination.kind == STRENGTH)

    @cached_property
    def service(self) -> tuple[CombinationResult, ...]:
        """Combinations for displacements."""
        return tuple(one for one in self.found if one.combination.kind == SERVICE)

    @cached_property
    def utilisation(self) -> FloatArray:
        """(M,) largest of all combinations."""
        none = np.zeros(len(self.model.families))
        each = [none, *(one.utilisation for one in self.strength)]
        return np.asarray(np.max(each, axis=0))

    @cached_property
    def governing(self) -> IntArray:
        """(M,) number among ``strength`` of the combination that uses each member most."""
        return np.asarray(np.argmax([one.utilisation for one in self.strength], axis=0))

    @cached_property
    def governing_forces(self) -> FloatArray:
        """(M, 6) N, Vy, Vz, T, My, Mz by which each member is used most, N and Nmm."""
        each = np.stack([one.forces for one in self.strength])
        return np.asarray(each[self.governing, np.arange(each.shape[1])])

    @cached_property
    def governed_deformed(self) -> BoolArray:
        """(M,) whether these forces are those of balance in the deformed shape."""
        each = np.stack([one.deformed for one in self.strength])
        return np.asarray(each[self.governing, np.arange(each.shape[1])])

    @property
    def factor(self) -> float | None:
        """Least buckling factor of all; None where nothing buckles."""
        first = self.first_to_buckle
        return None if first is None else first.factor

    @cached_property
    def first_to_buckle(self) -> CombinationResult | None:
        """The combination with the least buckling factor; None where nothing buckles."""
        some = [one for one in self.strength if one.factor is not None]
        return min(some, key=lambda one: one.factor or 0.0, default=None)

    @property
    def deflection(self) -> float:
        """Largest displacement of a node in service, mm."""
        return max((float(one.displacement.max()) for one in self.service), default=0.0)

    @property
    def deflection_limit(self) -> float:
        """Largest displacement that passes, mm."""
        return self.model.span / self.model.design.deflection

    @property
    def largest_reactions(self) -> tuple[float, float, float]:
        """Largest force of one support down, up and sideways on the frame, for strength, N."""
        forces = np.concatenate([one.response.reactions[:, :3] for one in self.strength])
        sideways = float(np.hypot(forces[:, 0], forces[:, 1]).max())
        return max(0.0, -float(forces[:, 2].min())), float(forces[:, 2].max()), sideways

    @cached_property
    def largest_end_forces(self) -> tuple[float, float, float, float]:
        """Largest tension, compression, shear and moment at ends of members, N and Nmm."""
        each = [
            one.response.forces_at(self.model.frame, part)
            for one in self.strength
            for part in (0.0, 1.0)
        ]
        forces = np.concatenate(each)
        shear = np.hypot(forces[:, 1], forces[:, 2]).max()
        moment = np.hypot(forces[:, 4], forces[:, 5]).max()
        pulls = max(0.0, float(forces[:, 0].max()))
        return pulls, max(0.0, -float(forces[:, 0].min())), float(shear), float(moment)

    @property
    def balance(self) -> float:
        """Largest imbalance of loads and reactions."""
        return max(one.balance for one in self.found)

    @cached_property
    def arm_forces(self) -> tuple[float, float]:
        """Largest force along an arm or bolt and across it, for strength, N; 0 without any."""
        frame, first = self.model.frame, len(self.model.families)
        if len(frame.members) == first:
            return 0.0, 0.0
        forces = np.stack([one.response.forces_at(frame, 0.5)[first:] for one in self.strength])
        across = np.hypot(forces[:, :, 1], forces[:, :, 2])
        return float(np.abs(forces[:, :, 0]).max()), float(across.max())

    @cached_property
    def panel_shear(self) -> float:
        """Largest shear in panels that stiffen, force by the length of their sides, N/mm."""
        frame = self.model.frame
        if not len(frame.panels.corners):
            return 0.0
        flows = [
            frame.panels.shear_flows(frame.nodes, one.response.displacements[:, :3])
            for one in self.strength
        ]
        return float(np.abs(flows).max())

    @property
    def failures(self) -> tuple[str, ...]:
        """What does not hold, each in words."""
        words = []
        worst = int(np.argmax(self.utilisation))
        if self.utilisation[worst] > 1:
            over = int((self.utilisation > 1).sum())
            words.append(
                f"{over} of {len(self.utilisation)} members are used beyond 100 %, member {worst} "
                f"{used_words(self.utilisation[worst])}"
            )
        least = min((one.carried for one in self.strength if one.carried is not None), default=1.0)
        if least < 1:
            words.append(f"with its imperfection the shell carries {100 * least:.0f} % of the load")
        factor = self.factor
        if factor is not None and factor <= 1:
            words.append(f"it buckles under {factor:.2f} of the load")
        elif factor is not None and factor < ENOUGH and not self.model.design.second_order:
            words.append(
                f"buckling factor {factor:.2f} is below {ENOUGH:g}, so only balance in the "
                "deformed shape (second order) can tell"
            )
        if self.deflection > self.deflection_limit:
            words.append(
                f"a node moves {self.deflection:.1f} mm, beyond {self.deflection_limit:.1f} mm"
            )
        return tuple(words)

    @property
    def fails_first_order(self) -> bool:
        """Whether it would not pass by balance in the deformed shape either."""
        buckles = self.factor is not None and self.factor <= 1
        moves = self.deflection > self.deflection_limit
        return bool(buckles or moves or self.utilisation.max() > 1)

    @property
    def passed(self) -> bool:
        """Whether all that was checked holds."""
        return not self.failures

    @property
    def verdict(self) -> str:
        """What it comes to, in one line."""
        factor = self.factor
        words = [f"members used to {100 * self.utilisation.max():.0f} %"]
        words.append("nothing buckles" if factor is None else f"buckling factor {factor:.2f}")
        moved = f"largest displacement {self.deflection:.1f} mm"
        words.append(moved if self.service else "displacements are not checked")
        if self.passed:
            order = "second order" if self.model.design.second_order else "first order"
            return f"Passes this check ({order}): {', '.join(words)}."
        return f"Does not pass this check: {'; '.join(self.failures)}."


def check_model(
    model: Model, combinations: Sequence[Combination], progress: Progress | None = None
) -> StructuralCheck:
    """Check a model under combinations of its loads.

    Args:
        model: frame, supports, load cases.
        combinations: of the cases; one for strength at least.
        progress: called with a fraction and words; may raise to stop.

    Raises:
        InputError: a mechanism, a loose part, no combination for strength.
    """
    if not any(one.kind == STRENGTH for one in combinations):
        raise InputError("combinations: none is for strength; give one at least")
    say = progress or (lambda fraction, words: None)
    say(0.0, "forces")
    system = FrameSystem(model.frame, model.supports)
    cases = tuple(response(system, case.loads) for case in model.cases)
    pieces = _Pieces(model)
    found = []
    for number, combination in enumerate(combinations):
        say((number + 1) / (len(combinations) + 1), combination.name)
        found.append(_one(model, combination, cases, pieces))
    size = pieces.imperfection if model.design.second_order else None
    return StructuralCheck(model, cases, tuple(found), size)


class _Pieces:
    """The frame with its members divided, so that they bow and buckle between the nodes."""

    def __init__(self, model: Model) -> None:
        design = model.design
        self.count = design.pieces
        self.frame = model.frame.divided(self.count)
        self.supports = model.supports.followed_by(len(self.frame.nodes))
        self.system = FrameSystem(self.frame, self.supports)
        self.loads = [case.loads.divided(model.frame, self.count) for case in model.cases]
        self.cases = [response(self.system, loads) for loads in self.loads]
        given = design.imperfection
        self.imperfection = model.span * _IMPERFECTION if given is None else given

    def second_order(self, mode: Buckling, loads: Loads) -> tuple[float, FloatArray]:
        """Part of a load that is carried, and forces, of a frame that is imperfect as it buckles.

        The imperfection is put to either side.
        """
        carried, forces = 1.0, []
        for sign in (1.0, -1.0):
            frame = imperfect(self.frame, mode.shapes[0], sign * self.imperfection)
            found = second_order(FrameSystem(frame, self.supports), loads)
            carried = min(carried, found.factor)
            forces.append(_along(self, found.response))
        return carried, np.concatenate(forces)


def _one(
    model: Model, combination: Combination, cases: Sequence[Response], pieces: _Pieces
) -> CombinationResult:
    factors = [combination.factors.get(case.name, 0.0) for case in model.cases]
    whole = _summed(factors, cases)
    loads = _summed(factors, [case.loads for case in model.cases])
    balance = imbalance(model.frame, loads, whole.reactions)
    count = len(model.families)
    if combination.kind == SERVICE:
        none = np.zeros(count)
        return CombinationResult(
            combination, whole, balance, none, none, np.zeros((count, 6)), np.zeros(count, bool)
        )
    mode = buckling(pieces.system, _summed(factors, pieces.cases), model.design.modes)
    carried = None
    forces = np.stack([whole.forces_at(model.frame, part) for part in STATIONS])[:, :count]
    share, drawn = share_of_bending(strain_energies(model, forces)), len(forces)
    # What buckles under its load does not pass anyway.
    if model.design.second_order and len(mode.factors) and 1 < mode.factors[0] < ENOUGH:
        carried, deformed = pieces.second_order(mode, _summed(factors, pieces.loads))
        forces = np.concatenate([forces, deformed[:, :count]])
    lengths = model.design.buckling_length * model.bare.lengths
    permanent = combination.permanent(model.cases)
    section, member = np.empty(forces.shape[:2]), np.empty(count)
    for group in model.groups:
        own = group.members
        section[:, own] = group.rules.section(forces[:, own], permanent)
        member[own] = group.rules.member(forces[:, own], lengths[own], permanent)
    slot = at_slots(model, forces, drawn, permanent)
    section = np.maximum(section, slot)
    most, at = section.max(axis=0), _governing(section, member, forces)
    governing = np.take_along_axis(forces, at[None], axis=0)[0]
    second = np.asarray((at >= drawn).any(axis=1))
    axial = membrane(model, loads, whole)
    return CombinationResult(
        combination,
        whole,
        balance,
        most,
        member,
        governing,
        second,
        mode,
        slot.max(axis=0),
        share,
        carried,
        axial,
    )


def _governing(section: FloatArray, member: FloatArray, forces: FloatArray) -> IntArray:
    """(M, 6) in which of the sections (K, M) the forces are that govern each member."""
    own = np.repeat(section.argmax(axis=0)[:, None], 6, axis=1)
    along = np.abs(forces).argmax(axis=0)
    along[:, 0] = forces[:, :, 0].argmin(axis=0)
    return np.asarray(np.where((member > section.max(axis=0))[:, None], along, own))


def _along(pieces: _Pieces, found: Response) -> FloatArray:
    """(K, M, 6) forces in the ends and the middle of all pieces of each member."""
    parts = [found.forces_at(pieces.frame, part) for part in (0.0, 0.5, 1.0)]
    whole = np.stack(parts).reshape(3, -1, pieces.count, 6)
    return np.moveaxis(whole, 2, 1).reshape(3 * pieces.count, -1, 6)


def _summed(factors: Sequence[float], parts: Sequence[_Part]) -> _Part:
    """Sum of responses or loads with their factors."""
    total = factors[0] * parts[0]
    for factor, part in zip(factors[1:], parts[1:], strict=True):
        total = total + factor * part
    return total
