"""Offsets of quad meshes: parallel meshes and the axes that they give."""
