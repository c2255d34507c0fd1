"""Where a descent stands: a shape, its terms linearised there, and what each term weighs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from solver.assembly import NormalEquations
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Term, follows


@dataclass(frozen=True, eq=False)
class Point:
    """A point in the landscape of an energy.

    Attributes:
        system: assembles the normal equations of the terms.
        terms: in the order of the system.
        x: the flat vector of unknowns.
        linearisations: of each term at ``x``; of those that weigh nothing, at some point before.
        weights: factor of the energy of each term.
    """

    system: NormalEquations
    terms: Sequence[Term]
    x: FloatArray
    linearisations: Sequence[Linearisation]
    weights: FloatArray

    @classmethod
    def at(cls, system: NormalEquations, terms: Sequence[Term], x: FloatArray) -> Point:
        """Linearise all terms at ``x``; each weighs one."""
        parts = [term.linearise(x) for term in terms]
        return cls(system, terms, x, parts, np.ones(len(terms)))

    @cached_property
    def energy(self) -> float:
        """Weighted sum of squares."""
        # Not a dot product: its threads cost more than these sums where the machine is busy.
        return float(
            sum(
                weight * np.einsum("nm,nm->", part.residual, part.residual)
                for weight, part in zip(self.weights, self.linearisations, strict=True)
                if weight > 0
            )
        )

    @property
    def matrix(self) -> FloatArray:
        """(nnz,) lower triangle of the sum of ``weight * J^T J``, computed afresh."""
        return self.system.matrix(self.linearisations, self.weights)

    @cached_property
    def gradient(self) -> FloatArray:
        """(n,) the sum of ``weight * J^T r`` over the free unknowns."""
        return self.system.gradient(self.linearisations, self.weights)

    def full(self, move: FloatArray) -> FloatArray:
        """A move of the free unknowns as a flat vector of all."""
        full = np.zeros(len(self.x))
        full[self.system.sparsity.unknowns] = move
        return full

    def moved(self, move: FloatArray) -> Point:
        """The point (n,) free unknowns on; terms that weigh nothing keep their last values."""
        there = self.x.copy()
        there[self.system.sparsity.unknowns] += move
        return replace(self, x=there, linearisations=self.linearised(there, self.weights))

    def linearised(self, x: FloatArray, weights: FloatArray) -> list[Linearisation]:
        """The terms at ``x``; those that weigh nothing as they are here."""
        return [
            term.linearise(x) if weight > 0 else old
            for term, weight, old in zip(self.terms, weights, self.linearisations, strict=True)
        ]

    def weighed(self, weights: FloatArray) -> Point:
        """The same with other weights."""
        return replace(self, weights=weights)

    def standing_at(self, x: FloatArray) -> Point:
        """The same terms at another vector, all linearised there, whatever they weigh."""
        parts = [term.linearise(x) for term in self.terms]
        return replace(self, x=x, linearisations=parts)

    def followed(self, weighty: bool = False) -> Point:
        """Let terms that depend on where the mesh is (closest points, loads) look again.

        Args:
            weighty: only those that weigh anything.
        """
        terms, parts = list(self.terms), list(self.linearisations)
        for k, term in enumerate(terms):
            if follows(term) and (self.weights[k] > 0 or not weighty):
                terms[k] = term.follow(self.x)
                parts[k] = terms[k].linearise(self.x)
        return replace(self, terms=terms, linearisations=parts)

    def with_term(self, k: int, term: Term) -> Point:
        """The same with another term in the place of the k-th; its stencil must be the same."""
        terms, parts = list(self.terms), list(self.linearisations)
        terms[k], parts[k] = term, term.linearise(self.x)
        return replace(self, terms=terms, linearisations=parts)
