"""Connectivity and positions."""
