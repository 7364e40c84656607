"""The robot as a program sees it."""

from array import array

from .chance import Chance
from .motions import RADIANS, Arc, Forward, Turn, Until, Wait
from .words import ProgramError, number, unknown

# Readings that are fractions, in the order in which a host writes them to Robot._f; the laser's ranges follow.
FLOATS = ("time", "x", "y", "heading", "distance", "turned", "charge", "voltage", "current", "left_speed", "right_speed")
# Flags and whole numbers, which a host sets as attributes.
FLAGS = (
    "bump", "bump_left", "bump_right", "wheel_drop", "wheel_drop_left", "wheel_drop_right",
    "cliff", "cliff_left", "cliff_front_left", "cliff_front_right", "cliff_right", "wall", "virtual_wall",
    "docked", "stasis", "overcurrent_left", "overcurrent_right", "overcurrent_brush", "overcurrent_side_brush",
)
WHOLE = (
    "step", "cliff_left_signal", "cliff_front_left_signal", "cliff_front_right_signal", "cliff_right_signal",
    "wall_signal", "dirt", "infrared_omni", "infrared_left", "infrared_right", "left_counts", "right_counts", "laser_scan",
)
# Lists of six: from left to right.
LISTS = ("light_bumper", "light")
# Parts of a robot that others than programs use.
LEFT, RIGHT, EVENTS, DONE = range(4)
# The most that a program may say in one step.
MOST_EVENTS = 2000


class Robot:
    """Sensors, commands, chance and marks. SI units, degrees counter-clockwise."""

    def __init__(self, facts, seed):
        self.radius = facts["radius"]
        self.wheel_base = facts["wheel_base"]
        self.top_speed = facts["top_speed"]
        self.tool_width = facts["tool_width"]
        self.model = facts.get("name", "")
        beams = facts.get("laser")
        beams = beams["beams"] if beams else 0
        self._beams = beams
        self._f = array("d", [0.0] * (len(FLOATS) + beams))
        self._clear()
        # Left and right wheel (m/s), number of events, whether it is done.
        self._out = array("d", [0.0] * 4)
        self._half = RADIANS * self.wheel_base * 0.5
        self._chance = Chance(seed)
        self._events = []
        # Whether the program is a generator, and the motion that it has made but not yet yielded.
        self._waits = False
        self._made = None

    def _clear(self):
        """Sensors that have read nothing yet."""
        for name in FLAGS:
            setattr(self, name, False)
        for name in WHOLE:
            setattr(self, name, 0)
        # One attribute for each of the six, as a host sets whole numbers and flags only.
        self._b0 = self._b1 = self._b2 = self._b3 = self._b4 = self._b5 = False
        # Whether they have changed since they were last put together.
        self._old_b = self._old_s = True
        self._b = self._s = None
        self._s0 = self._s1 = self._s2 = self._s3 = self._s4 = self._s5 = 0

    # Sensors.

    @property
    def time(self):
        return self._f[0]

    @property
    def x(self):
        return self._f[1]

    @property
    def y(self):
        return self._f[2]

    @property
    def heading(self):
        return self._f[3]

    @property
    def distance(self):
        return self._f[4]

    @property
    def turned(self):
        return self._f[5]

    @property
    def charge(self):
        return self._f[6]

    @property
    def voltage(self):
        return self._f[7]

    @property
    def current(self):
        return self._f[8]

    @property
    def left_speed(self):
        return self._f[9]

    @property
    def right_speed(self):
        return self._f[10]

    @property
    def light_bumper(self):
        if self._old_b:
            self._old_b = False
            self._b = (self._b0, self._b1, self._b2, self._b3, self._b4, self._b5)
        return self._b

    @property
    def light(self):
        if self._old_s:
            self._old_s = False
            self._s = (self._s0, self._s1, self._s2, self._s3, self._s4, self._s5)
        return self._s

    @property
    def laser(self):
        if self.laser_scan == 0:
            return None
        return list(self._f[len(FLOATS) :])

    def blocked(self):
        return self.bump or self.cliff or self.wheel_drop

    # Commands.

    def drive(self, left, right):
        out = self._out
        try:
            out[0] = left
            out[1] = right
        except TypeError:
            number("robot.drive: left", left)
            number("robot.drive: right", right)

    def go(self, speed, turn_rate=0.0):
        out = self._out
        try:
            spin = turn_rate * self._half
            out[0] = speed - spin
            out[1] = speed + spin
        except TypeError:
            number("robot.go: speed", speed)
            number("robot.go: turn_rate", turn_rate)

    def stop(self):
        self._out[0] = 0.0
        self._out[1] = 0.0

    def done(self):
        self.stop()
        self._out[DONE] = 1.0

    # Motions.

    def forward(self, distance, speed=0.3):
        return self._motion("forward", Forward(distance, speed))

    def turn(self, degrees, rate=90):
        return self._motion("turn", Turn(degrees, rate))

    def arc(self, radius, degrees, speed=0.3):
        return self._motion("arc", Arc(radius, degrees, speed))

    def wait(self, seconds):
        return self._motion("wait", Wait(seconds))

    def until(self, condition, timeout=None):
        return self._motion("until", Until(condition, timeout))

    def _motion(self, name, motion):
        if not self._waits:
            raise ProgramError("robot.%s takes time, so it needs def run(robot) and yield robot.%s(...)" % (name, name))
        if self._made is not None:
            raise ProgramError(self._unyielded())
        motion.name = name
        self._made = motion
        return motion

    def _unyielded(self):
        return "robot.%s(...) does nothing without yield: write yield robot.%s(...)" % (self._made.name, self._made.name)

    # Chance.

    def random(self):
        return self._chance.next()

    def randint(self, least, most):
        return least + int(self._chance.next() * (most - least + 1))

    def choice(self, items):
        if not items:
            raise ProgramError("robot.choice: the list is empty")
        return items[int(self._chance.next() * len(items))]

    # Drawing on the floor.

    def mark(self, x, y, colour=None):
        self._say({"kind": "mark", "x": number("robot.mark: x", x), "y": number("robot.mark: y", y), "colour": _colour(colour)})

    def line(self, x1, y1, x2, y2, colour=None):
        ends = [number("robot.line: end", end) for end in (x1, y1, x2, y2)]
        self._say({"kind": "line", "x1": ends[0], "y1": ends[1], "x2": ends[2], "y2": ends[3], "colour": _colour(colour)})

    def text(self, x, y, words):
        self._say({"kind": "text", "x": number("robot.text: x", x), "y": number("robot.text: y", y), "text": str(words)[:200]})

    def clear(self):
        self._say({"kind": "clear"})

    def _say(self, event):
        if len(self._events) >= MOST_EVENTS:
            raise ProgramError("more than %d marks, lines and texts in one step" % MOST_EVENTS)
        self._events.append(event)
        self._out[EVENTS] = len(self._events)

    def _take(self):
        events = self._events
        self._events = []
        self._out[EVENTS] = 0.0
        return events

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        raise AttributeError(unknown(name))


def _colour(colour):
    return None if colour is None else str(colour)[:30]


NAMES = FLOATS + FLAGS + WHOLE + LISTS + (
    "laser", "radius", "wheel_base", "top_speed", "tool_width", "model",
    "drive", "go", "stop", "done", "forward", "turn", "arc", "wait", "until",
    "random", "randint", "choice", "mark", "line", "text", "clear", "blocked",
)
