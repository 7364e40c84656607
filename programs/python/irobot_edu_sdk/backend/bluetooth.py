from . import Backend


class Bluetooth(Backend):
    """See Backend."""
