class Color:
    """Red, green and blue, each 0 to 255."""

    def __init__(self, red, green, blue):
        self.red, self.green, self.blue = [max(0, min(255, int(part))) for part in (red, green, blue)]
