from . import Backend


class Serial(Backend):
    """See Backend."""
