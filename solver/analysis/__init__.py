"""Measures of a mesh: how far it is from each net."""
