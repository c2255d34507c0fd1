"""Task panels whose OK does one piece of work."""

from __future__ import annotations

import FreeCADGui

from freecad_ortho.window import messages


class WorkPanel:
    """OK does the work and closes the panel, an error keeps it open; Cancel changes nothing."""

    def accept(self) -> bool:
        """Do the work, if what it is done on is still there."""
        done = True
        if self.possible():
            done = False
            with messages.errors_shown(), messages.busy():
                done = self.work()
        if done:
            FreeCADGui.Control.closeDialog()
        return done

    def reject(self) -> bool:
        """Leave everything as it was."""
        FreeCADGui.Control.closeDialog()
        return True

    def possible(self) -> bool:
        """Tell whether what the panel was opened for has not gone meanwhile."""
        raise NotImplementedError

    def work(self) -> bool:
        """Run and record the document function; false where the user went back.

        Raises:
            OrthoError: it cannot be done as asked.
        """
        raise NotImplementedError
