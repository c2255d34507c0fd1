"""Energies, one a file: residual and Jacobian together."""
