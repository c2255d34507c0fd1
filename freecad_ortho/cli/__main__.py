"""The process in which the work of the command line is done."""

from __future__ import annotations

import os
import sys

from freecad_ortho.cli.endings import EXIT_STOPPED, end_once, kept_whole, let_through, past_stopping
from freecad_ortho.processes import end_with_parent

if __name__ == "__main__":
    end_with_parent()
    try:
        end_once()
        let_through()
        with kept_whole():
            from freecad_ortho.cli import commands
        code = commands.run()
        past_stopping()
    except KeyboardInterrupt:
        code = EXIT_STOPPED
    sys.stdout.flush()
    sys.stderr.flush()
    # What is done is done: while Python ends by itself, freeing all there is, it heeds no handler
    # of ours, and a process that was killed then would be called stopped.
    os._exit(code)
