"""Sparse symmetric systems: their pattern, its numbering, and their factorisation."""
