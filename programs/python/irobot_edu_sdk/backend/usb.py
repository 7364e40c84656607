from . import Backend


class USB(Backend):
    """See Backend."""
