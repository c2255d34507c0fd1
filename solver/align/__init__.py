"""Quads on a design surface, along its lines of curvature: from triangles to a net to optimise."""
