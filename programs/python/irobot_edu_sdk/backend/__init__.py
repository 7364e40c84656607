"""Connections. There is nothing to connect: the program already has its robot."""


class Backend:
    """Takes whatever its namesake takes."""

    def __init__(self, *_, **__):
        pass
