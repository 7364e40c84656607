from .event import Pause
from .robot import Robot


class Root(Robot):
    """Root. What it has and this robot lacks is said once."""

    class MarkerPos:
        UP = 0
        DOWN = 1
        ERASE = 2

    class GravityComp:
        OFF = 0
        ON = 1
        WHEN_MARKER = 2

    class ColorID:
        SKIP = IGNORE = -1
        WHITE = 0
        BLACK = 1
        RED = 2
        GREEN = 3
        BLUE = 4
        ORANGE = RED_YELLOW = YELLOW_RED = 5
        YELLOW = 6
        MAGENTA = 7
        LIME = YELLOW_GREEN = GREEN_YELLOW = 8
        CYAN = GREEN_BLUE = BLUE_GREEN = 9
        VIOLET = BLUE_MAGENTA = MAGENTA_BLUE = 10
        CERISE = MAGENTA_RED = RED_MAGENTA = 11
        LOW_INT = LOW_INTENSITY = 13
        LOW_SAT = LOW_SATURATION = 14

    class ColorLighting:
        OFF = 0
        RED = 1
        GREEN = 2
        BLUE = 3
        ALL = 4

    class ColorFormat:
        ADC_COUNTS = 0
        MILLIVOLTS = 1

    class LightEvent:
        UNKNOWN = 0
        DARKER = 4
        RIGHT_BRIGHTER_THAN_LEFT = 5
        LEFT_BRIGHTER_THAN_RIGHT = 6
        BRIGHTER = 7

    async def set_gravity_compensation(self, gravity, amount):
        self._cannot("set_gravity_compensation", "this robot drives on floors only")
        await Pause()

    async def get_light_values(self):
        self._cannot("get_light_values", "this robot has no light sensors of that kind")
        await Pause()
        return (0, 0)

    async def get_color_ids(self):
        self._cannot("get_color_ids", "this robot has no colour sensors")
        await Pause()
        return None

    def get_color_ids_cached(self):
        return None

    async def get_color_values(self, lighting, data_format):
        self._cannot("get_color_values", "this robot has no colour sensors")
        await Pause()
        return None
