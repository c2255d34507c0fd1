"""The process in which the work of the command line is done."""

from __future__ import annotations

import sys

from freecad_ortho.cli.endings import EXIT_STOPPED, end_once, held_back, kept_whole, let_through
from freecad_ortho.processes import end_with_parent

if __name__ == "__main__":
    end_with_parent()
    try:
        end_once()
        let_through()
        with kept_whole():
            from freecad_ortho.cli import commands
        code = commands.run()
        # What is done is done: were the rest of the process killed, it would be called stopped.
        held_back()
    except KeyboardInterrupt:
        code = EXIT_STOPPED
    sys.exit(code)
