"""What a program can wait for: `yield robot.forward(0.3)`.

A motion is started in the step that yields it, and asked at every further step: None while it goes on; then True if it
has reached its aim and False if not, which is the value of the yield.
"""

from math import sqrt

from .words import ProgramError, number

RADIANS = 0.017453292519943295
# Slowest wheel speed at which a motion ends, m/s.
_CREEP = 0.02
# What may be left of a way at its end, m: what it creeps in a step.
_CLOSE = 0.0003
# Steps in a second.
_PER_SECOND = 1.0 / 0.015


class Motion:
    """What a program waits for."""

    # Steps after which it gives up; 0 for never.
    limit = 0

    def start(self, robot):
        """Its first command."""

    def step(self, robot):
        """None while it goes on."""

    def hold(self, robot):
        """Number of further steps in which it surely commands the same, unless the robot gets blocked."""
        return 0

    # So that `await` and `yield from` take it, too.
    def __iter__(self):
        done = yield self
        return done

    def __await__(self):
        done = yield self
        return done


def pace(left, speed):
    """The speed with so much left of the way; brakes by 0.5 m/s²."""
    if left < 1.0:
        slow = sqrt(left)
        if slow < speed:
            speed = slow
    return speed if speed > _CREEP else _CREEP


def _ahead(left, speed, limit):
    """Steps until it brakes, in wheels that turn half as fast again as they should."""
    steps = int((left - speed * speed) / (speed * 0.0225)) if left > speed * speed else 0
    return min(steps, limit - 2) if limit > 2 else 0


def _patience(length, speed):
    """Three times as long as the way takes, and 2 s."""
    return int((3.0 * length / speed + 2.0) * _PER_SECOND)


def _positive(place, value):
    value = number(place, value)
    if value <= 0.0:
        raise ProgramError("%s must be more than 0, not %r" % (place, value))
    return value


class Forward(Motion):
    """Straight ahead, or back for a negative distance. Ahead it ends at a bump, a cliff or a wheel drop."""

    def __init__(self, distance, speed):
        self.way = number("robot.forward: distance", distance)
        self.speed = _positive("robot.forward: speed", speed)

    def start(self, robot):
        self.end = robot.distance + self.way
        self.limit = _patience(abs(self.way), self.speed)
        self.step(robot)

    def step(self, robot):
        ahead = self.way >= 0.0
        left = self.end - robot.distance
        if not ahead:
            left = -left
        self.limit -= 1
        if left <= _CLOSE or self.limit == 0 or (ahead and robot.blocked()):
            robot.drive(0.0, 0.0)
            return left <= _CLOSE
        speed = pace(left, self.speed)
        if not ahead:
            speed = -speed
        robot.drive(speed, speed)

    def hold(self, robot):
        # One that begins blocked ends with the next step.
        return 0 if robot.blocked() else _ahead(abs(self.end - robot.distance), self.speed, self.limit)


class Turn(Motion):
    """On the spot, counter-clockwise for positive degrees. A pressed bumper doesn't end it."""

    def __init__(self, degrees, rate):
        self.way = number("robot.turn: degrees", degrees)
        self.rate = _positive("robot.turn: rate", rate)

    def start(self, robot):
        self.end = robot.turned + self.way
        # Metres of a wheel.
        self.scale = RADIANS * robot.wheel_base * 0.5
        self.limit = _patience(abs(self.way) * self.scale, self.rate * self.scale)
        self.step(robot)

    def step(self, robot):
        left = (self.end - robot.turned) * self.scale
        if self.way < 0.0:
            left = -left
        self.limit -= 1
        if left <= _CLOSE or self.limit == 0:
            robot.drive(0.0, 0.0)
            return left <= _CLOSE
        speed = pace(left, self.rate * self.scale)
        if self.way < 0.0:
            speed = -speed
        robot.drive(-speed, speed)

    def hold(self, robot):
        return _ahead(abs(self.end - robot.turned) * self.scale, self.rate * self.scale, self.limit)


class Arc(Motion):
    """Ahead on a circle, to the left for positive degrees. Ends at a bump, a cliff or a wheel drop."""

    def __init__(self, radius, degrees, speed):
        self.radius = number("robot.arc: radius", radius)
        if self.radius < 0.0:
            raise ProgramError("robot.arc: radius must be 0 or more; negative degrees lead to the right")
        self.way = number("robot.arc: degrees", degrees)
        self.speed = _positive("robot.arc: speed", speed)

    def start(self, robot):
        self.end = robot.turned + self.way
        outer = self.radius + 0.5 * robot.wheel_base
        self.limit = _patience(abs(self.way) * RADIANS * outer, self.speed)
        self.step(robot)

    def step(self, robot):
        half = 0.5 * robot.wheel_base
        outer = self.radius + half
        left = (self.end - robot.turned) * RADIANS * outer
        if self.way < 0.0:
            left = -left
        self.limit -= 1
        if left <= _CLOSE or self.limit == 0 or robot.blocked():
            robot.drive(0.0, 0.0)
            return left <= _CLOSE
        fast = pace(left, self.speed)
        slow = fast * (self.radius - half) / outer
        if self.way < 0.0:
            robot.drive(fast, slow)
        else:
            robot.drive(slow, fast)

    def hold(self, robot):
        outer = self.radius + 0.5 * robot.wheel_base
        return 0 if robot.blocked() else _ahead(abs(self.end - robot.turned) * RADIANS * outer, self.speed, self.limit)


class Wait(Motion):
    """Goes on as it was commanded for some seconds."""

    def __init__(self, seconds):
        self.seconds = number("robot.wait: seconds", seconds)

    def start(self, robot):
        self.limit = int(self.seconds * _PER_SECOND + 0.5)

    def step(self, robot):
        self.limit -= 1
        if self.limit <= 0:
            return True

    def hold(self, robot):
        return max(0, self.limit - 2)


class Until(Motion):
    """Goes on as it was commanded until a condition holds: a function of the robot."""

    def __init__(self, condition, timeout):
        if not callable(condition):
            raise ProgramError("robot.until needs a function: robot.until(lambda r: r.bump)")
        self.condition = condition
        self.seconds = None if timeout is None else _positive("robot.until: timeout", timeout)

    def start(self, robot):
        self.limit = 0 if self.seconds is None else int(self.seconds * _PER_SECOND + 0.5)

    def step(self, robot):
        if self.condition(robot):
            return True
        self.limit -= 1
        if self.limit == 0:
            return False
