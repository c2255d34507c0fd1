"""A frame of straight members in space: response, buckling, large displacements."""
