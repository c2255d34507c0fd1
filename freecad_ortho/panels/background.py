"""The thread in which panels have the solver work while FreeCAD draws."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

# Milliseconds between looks at whether a step is done.
LOOK = 1

# Works one thing off after the other, in the order in which they are asked for. What it is given
# must not touch anything of FreeCAD's: documents and views belong to the thread of the window.
worker = ThreadPoolExecutor(max_workers=1, thread_name_prefix="ortho-solver")
