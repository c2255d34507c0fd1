"""The process in which the work of the command line is done."""

from __future__ import annotations

import sys

from freecad_ortho.cli.endings import EXIT_STOPPED, end_once, kept_whole, let_through
from freecad_ortho.processes import end_with_parent

if __name__ == "__main__":
    end_with_parent()
    try:
        end_once()
        let_through()
        with kept_whole():
            from freecad_ortho.cli import commands
        code = commands.run()
    except KeyboardInterrupt:
        code = EXIT_STOPPED
    sys.exit(code)
