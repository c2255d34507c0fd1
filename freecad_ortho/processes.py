"""What processes that work for another one have in common. Imports nothing heavy."""

from __future__ import annotations

import os
import threading
import time

# Seconds between looks at whether the process is still there for which this one works.
_LOOK = 0.2


def end_with_parent() -> None:
    """End this process when the one that started it has gone, even if that was killed.

    Where a process that lost its parent cannot tell, on Windows, it goes on to its own end.
    """
    parent = os.getppid()

    def watch() -> None:
        while os.getppid() == parent:
            time.sleep(_LOOK)
        os._exit(1)

    threading.Thread(target=watch, name="end with parent", daemon=True).start()
