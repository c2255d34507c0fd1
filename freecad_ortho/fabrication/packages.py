"""The packages that fabrication needs and the solver does not."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from solver.errors import OrthoError


@contextmanager
def missing_package_named() -> Iterator[None]:
    """Say in plain words which Python package fabrication lacks.

    Raises:
        OrthoError: a package could not be imported.
    """
    try:
        yield
    except ModuleNotFoundError as error:
        raise OrthoError(
            f"fabrication: the Python package '{error.name}' is missing; "
            "run scripts/setup.sh in the project's folder, or install it for FreeCAD's Python"
        ) from error
