from .robot import Robot


class Create3(Robot):
    """Create 3."""

    class DockStatus:
        SUCCEEDED = 0
        ABORTED = 1
        CANCELED = 2

    class DockResult:
        UNDOCKED = 0
        DOCKED = 1
