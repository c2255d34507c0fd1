"""The one family of errors that a user of the solver can meet."""


class OrthoError(Exception):
    """Base of every error that this project raises on purpose.

    The message is one line: what is wrong, where, and what to do.
    """


class InputError(OrthoError, ValueError):
    """Data or a parameter that the user gave cannot be used as it is."""


class OutputError(OrthoError, OSError):
    """A result could not be written; nothing half-written is left behind."""


class SingularSystemError(OrthoError):
    """A linear system could not be solved; the solver answers with more damping."""
