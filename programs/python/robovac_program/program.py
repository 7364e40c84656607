"""A program: its source text, and what it does from step to step."""

import sys

from .robot import DONE, FLAGS, FLOATS, LEFT, NAMES, RIGHT, WHOLE, Robot
from .motions import Motion
from .room import Room
from .words import ProgramError, hinted, names, nearest

KINDS = ("step", "run", "plan")

# What a module such as irobot_edu_sdk wants to be run: a function of the robot that gives a generator.
registered = []
# The robot of the program that is being loaded.
current = []


def whole(speed, top_speed):
    """The command for a wheel, whole mm/s within the top speed: as the Open Interface takes it."""
    if speed != speed:
        raise ProgramError("the wheel speed is not a number (nan)")
    speed = max(-top_speed, min(top_speed, speed)) * 1000.0
    return int(speed + 0.5) if speed >= 0.0 else -int(0.5 - speed)


class Program:
    """Runs `source`. Errors in it are raised as they come; error_of says them with their line."""

    def __init__(self, source, name, facts, seed, extra=None, robot_class=Robot):
        self.name = name
        self.robot = robot = robot_class(facts, seed)
        self.has_printed = False
        self.scope = scope = {"__name__": "__main__", "print": self.print}
        if extra:
            scope.update(extra)
        registered[:] = []
        current[:] = [robot]
        names[:] = NAMES
        try:
            exec(compile(source, name, "exec"), scope)
        except SystemExit:
            pass
        found = [kind for kind in KINDS if callable(scope.get(kind))]
        if registered:
            found = ["run"]
            scope = {"run": registered[-1]}
        if not found and self.has_printed and not _meant(scope):
            # A first lesson: it prints, and that is all.
            found = ["run"]
            scope = {"run": _nothing}
        if not found:
            raise ProgramError(_missing(scope))
        if len(found) > 1:
            raise ProgramError("there are %s and %s: a program has one of them" % (" and ".join(found[:-1]), found[-1]))
        self.kind = found[0]
        self.function = scope[self.kind]
        self.motion = None
        if self.kind == "run":
            robot._waits = True
            self.generator = self.function(robot)
            if not hasattr(self.generator, "send"):
                raise ProgramError("run has no yield: def run(robot) waits with yield; a function for every step is def step(robot)")

    def print(self, *values, **options):
        self.has_printed = True
        print(*values, **options)

    def work(self):
        """One step of a behaviour, with the readings that the robot has. Sets the robot's command."""
        robot = self.robot
        if self.kind == "step":
            if hasattr(self.function(robot), "send"):
                raise ProgramError("step has a yield: a function that waits is def run(robot)")
        else:
            self.go_on()

    def go_on(self):
        """The same of a generator."""
        robot = self.robot
        motion = self.motion
        result = None
        if motion is not None:
            result = motion.step(robot)
            if result is None:
                return
        try:
            motion = self.generator.send(result)
        except (StopIteration, SystemExit):
            robot.done()
            return
        if motion is not None:
            if not isinstance(motion, Motion):
                self.complain("yield takes a motion such as robot.forward(0.3), or nothing for one step; not %r" % (motion,))
            if motion is robot._made:
                robot._made = None
            motion.start(robot)
        if robot._made is not None:
            self.complain(robot._unyielded())
        self.motion = motion

    def complain(self, words):
        """Raises the error where the program waits, so that it has a line."""
        self.generator.throw(ProgramError(words))
        raise ProgramError(words)

    def step(self, readings):
        """One step with new readings, an object of the protocol. The command in whole mm/s, left and right."""
        robot = self.robot
        feed(robot, readings)
        self.work()
        out = robot._out
        return whole(out[LEFT], robot.top_speed), whole(out[RIGHT], robot.top_speed)

    def hold(self):
        """For how many further steps the command surely stays, unless the robot gets blocked."""
        return 0 if self.motion is None else self.motion.hold(self.robot)

    def skip(self, steps):
        """So many steps went by in such a time."""
        if self.motion is not None:
            self.motion.limit -= steps

    def is_done(self):
        return self.robot._out[DONE] != 0.0

    def cells(self, room):
        """The cells of a planner, as pairs, one after the other."""
        for cell in self.function(Room(room["rows"], room["cell"], room["start"])) or ():
            try:
                x, y = cell
            except (TypeError, ValueError):
                raise ProgramError("plan gives cells (x, y), not %r" % (cell,))
            if not (isinstance(x, int) and isinstance(y, int)):
                raise ProgramError("a cell has whole numbers: not %r" % (cell,))
            yield x, y


def feed(robot, readings):
    """Sets a robot's sensors from a reading of the protocol."""
    f = robot._f
    index = 0
    for name in FLOATS:
        f[index] = readings.get(name, 0.0)
        index += 1
    get = readings.get
    for name in FLAGS:
        setattr(robot, name, bool(get(name, False)))
    for name in WHOLE:
        setattr(robot, name, get(name, 0))
    robot.bump = robot.bump_left or robot.bump_right
    robot.wheel_drop = robot.wheel_drop_left or robot.wheel_drop_right
    robot.cliff = robot.cliff_left or robot.cliff_front_left or robot.cliff_front_right or robot.cliff_right
    robot._old_b = robot._old_s = True
    six = get("light_bumper")
    if six:
        robot._b0, robot._b1, robot._b2, robot._b3, robot._b4, robot._b5 = [bool(flag) for flag in six]
    six = get("light")
    if six:
        robot._s0, robot._s1, robot._s2, robot._s3, robot._s4, robot._s5 = six
    laser = get("laser")
    if laser:
        for value in laser[: robot._beams]:
            f[index] = float("inf") if value is None else value
            index += 1


def _nothing(robot):
    """A program that has ended."""
    return
    yield


def _meant(scope):
    """What was meant to be the behaviour, as a pair of the kind and the name that it has; None if nothing was."""
    for name in scope:
        if callable(scope[name]) and name != "print" and not name.startswith("_"):
            kind = nearest(name, KINDS)
            if kind:
                return kind, name


def _missing(scope):
    meant = _meant(scope)
    if meant:
        return "there is no def step(robot), run(robot) or plan(room); did you mean %s instead of %s?" % meant
    return "there is no def step(robot) (called every 15 ms), def run(robot) (with yield) or def plan(room) (a planner)"


def error_of(error, name):
    """(message, line) of an error in the program of that file name; line 0 if unknown."""
    line = 0
    if hasattr(sys, "print_exception"):
        import io

        text = io.StringIO()
        sys.print_exception(error, text)
        mark = 'File "%s", line ' % name
        for part in text.getvalue().split("\n"):
            if mark in part:
                digits = part.split(mark)[1].split(",")[0]
                line = int(digits)
    else:
        line = getattr(error, "lineno", None) or 0 if isinstance(error, SyntaxError) else 0
        trace = error.__traceback__
        while trace is not None:
            if trace.tb_frame.f_code.co_filename == name:
                line = trace.tb_lineno
            trace = trace.tb_next
    return said(error), line


def said(error):
    """An error in words."""
    if isinstance(error, (ProgramError, AttributeError)):
        return hinted(str(error))
    text = getattr(error, "msg", None) or str(error)
    kind = type(error).__name__
    return hinted("%s: %s" % (kind, text)) if text else kind
