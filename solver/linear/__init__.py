"""Sparse symmetric systems: where they have entries, their numbering, and their factorisation."""
