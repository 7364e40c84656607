"""Errors of the package. Their sentences are those of the command line."""


class RobovacError(Exception):
    """Any error of this package."""


class UsageError(RobovacError, ValueError):
    """An argument is invalid: an unknown name, or a value out of range."""


class FileError(RobovacError, OSError):
    """A file can't be read."""


class MapError(RobovacError, ValueError):
    """A map, a drawing or an array can't be used as a room."""


class PlacementError(RobovacError, ValueError):
    """The robot or its start doesn't fit into the room."""


class PlannerError(RobovacError, RuntimeError):
    """A planner found no plan."""


class ContractError(RobovacError, ValueError):
    """A planner or behaviour broke a rule that every one keeps."""
