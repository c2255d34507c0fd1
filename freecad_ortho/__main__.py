"""The command line: runs one command and turns how it ends into an exit code."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from freecad_ortho.cli.endings import (
    EXIT_NOT_CONVERGED,
    kept_whole,
    stopped_as_before,
    stopped_words,
)
from freecad_ortho.cli.supervising import supervised


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command in this process; return its exit code.

    0: done; 1: not converged, or stopped; 2: bad input.
    """
    try:
        with kept_whole():
            from freecad_ortho.cli import commands
        with stopped_as_before():
            return commands.run(arguments)
    except KeyboardInterrupt:
        sys.stderr.write(stopped_words(sys.argv[1:] if arguments is None else arguments))
        return EXIT_NOT_CONVERGED


if __name__ == "__main__":
    sys.exit(supervised())
