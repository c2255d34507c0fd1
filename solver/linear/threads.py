"""How many threads dense linear algebra takes."""

from __future__ import annotations

import importlib.util
import warnings
from contextlib import AbstractContextManager, nullcontext
from functools import cache
from typing import Any


def one_thread() -> AbstractContextManager[Any]:
    """Keep BLAS to one thread inside a ``with``.

    Small blocks gain nothing from a second thread; on a busy machine threads that wait for each
    other cost several times what they save; and the same bytes come out whatever the number of
    cores. Without the optional package ``threadpoolctl`` nothing changes.
    """
    controller = _controller()
    return nullcontext() if controller is None else controller.limit(limits=1, user_api="blas")


@cache
def _controller() -> Any:
    if importlib.util.find_spec("threadpoolctl") is None:
        return None
    import threadpoolctl

    try:
        # It governs the libraries that are loaded by now; its importer has loaded them.
        controller = threadpoolctl.ThreadpoolController()
        with controller.limit(limits=1, user_api="blas"):
            return controller
    except (AttributeError, OSError, RuntimeError, TypeError, ValueError) as error:
        # It asks libraries that it does not know: whatever comes of that is no reason to stop.
        warnings.warn(f"threadpoolctl failed ({error}): BLAS keeps its threads", stacklevel=2)
        return None
