"""The command line: runs one command and turns how it ends into an exit code."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from freecad_ortho.cli.endings import EXIT_NOT_CONVERGED, end_like_ctrl_c, kept_whole


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command; return its exit code (0 done, 1 not converged or stopped, 2 bad input)."""
    try:
        with kept_whole():
            from freecad_ortho.cli import commands
        return commands.run(arguments)
    except KeyboardInterrupt:
        sys.stderr.write("stopped; nothing was written\n")
        return EXIT_NOT_CONVERGED


if __name__ == "__main__":
    end_like_ctrl_c()
    sys.exit(main())
