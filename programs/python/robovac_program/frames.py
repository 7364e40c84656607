"""Many runs of a program in one process, for a host that speaks in frames: see docs/program-protocol.md.

All numbers are little-endian. A question is its length (32 bits), the number of runs in it (32 bits), and for each its number
(32 bits), the number of the laser's ranges (32 bits), the readings and the ranges (64 bits each). The answer is its length (32 bits);
for each run of the question the speeds of the wheels in mm/s, the steps for which they hold, and 1 if it is done (32 bits each); then
what was said, as JSON, if anything was.
"""

import builtins
import importlib.util
import json
import os
import sys
import types
from struct import Struct

from .program import Program, error_of, whole
from .robot import DONE, FLAGS, FLOATS, LEFT, RIGHT, Robot
from .words import ProgramError

# Bytes of a reading, and of the head of a run's part.
_NUMBER = 8
_COMMAND = Struct("<iiII")
_WORD = Struct("<I")
# Modules without a state of their own; each run gets copies, as it could put something into them.
_SHARED = frozenset(
    "__future__ abc array bisect cmath collections copy dataclasses enum fractions functools heapq itertools json math numbers operator "
    "re statistics string struct time types typing".split()
)


class Alone(Exception):
    """Runs of this program can't share a process."""


def robot_of(layout):
    """The class of a robot whose readings are numbers in `_r`, at the places of that layout."""
    places = {slot["name"]: (slot["index"], slot["count"]) for slot in layout["slots"]}

    def measured(name):
        def refuse(self, value):
            raise ProgramError("robot.%s is measured: a program can't set it" % name)

        return refuse

    def one(name, index):
        if name in FLOATS:
            return lambda self: self._r[index]
        if name in FLAGS:
            return lambda self: self._r[index] != 0.0
        return lambda self: int(self._r[index])

    def six(index, is_flag):
        def get(self):
            kept = self._lists.get(index)
            if kept is None:
                kept = self._r[index : index + 6].tolist()
                kept = self._lists[index] = tuple([value != 0.0 for value in kept] if is_flag else [int(value) for value in kept])
            return kept

        return get

    def some(first, last):
        return lambda self: 1.0 in self._r[first : last + 1].tolist()

    own = {}
    for name, (index, count) in places.items():
        get = one(name, index) if count == 1 else six(index, name == "light_bumper")
        own[name] = property(get, measured(name))
    for name, first, last in (
        ("bump", "bump_left", "bump_right"),
        ("wheel_drop", "wheel_drop_left", "wheel_drop_right"),
        ("cliff", "cliff_left", "cliff_right"),
    ):
        own[name] = property(some(places[first][0], places[last][0]), measured(name))
    # Bumper, wheels and cliff sensors are side by side.
    first, last = places["bump_left"][0], places["cliff_right"][0]
    own["blocked"] = lambda self: 1.0 in self._r[first : last + 1].tolist()
    own["laser"] = property(lambda self: list(self._ranges) if self._ranges else None, measured("laser"))

    def clear(self):
        self._r = memoryview(bytes(_NUMBER * layout["laser"])).cast("d")
        self._ranges = []
        self._lists = {}

    own["_clear"] = clear
    return type("Robot", (Robot,), own)


class Run:
    """One run of the program."""

    def __init__(self, source, path, facts, seed, robot_class, isolation):
        scope = isolation and {"__builtins__": isolation.builtins(seed)}
        self.program = Program(source, path, facts, seed, scope, robot_class)
        self.at = 0
        self.wanted = self.command = None

    def step(self, readings, ranges):
        """One step. The command: left, right, steps that it holds, whether it is done."""
        program = self.program
        robot = program.robot
        robot._r = readings
        if robot._lists:
            robot._lists = {}
        if ranges:
            robot._ranges = ranges
        step = int(readings[0])
        if step > self.at:
            program.skip(step - self.at)
        self.at = step + 1
        program.work()
        out = robot._out
        wanted = out[LEFT], out[RIGHT]
        if wanted != self.wanted:
            self.command = whole(wanted[0], robot.top_speed), whole(wanted[1], robot.top_speed)
            self.wanted = wanted
        if out[DONE] != 0.0:
            return *self.command, 0, 1
        motion = program.motion
        return *self.command, 0 if motion is None else motion.hold(robot), 0


class Isolation:
    """Keeps the runs of a process apart: each has its own `random`, and none changes what others have."""

    def __init__(self):
        # A module that they would share.
        self.broken = None

    def builtins(self, seed):
        own, chance = {}, []

        def copied(module):
            if module.__name__ not in own:
                copy = own[module.__name__] = types.ModuleType(module.__name__)
                vars(copy).update({key: copied(value) if isinstance(value, types.ModuleType) else value for key, value in vars(module).items()})
            return own[module.__name__]

        def load(name, *rest):
            first = name.partition(".")[0]
            if first == "random":
                if not chance:
                    spec = importlib.util.find_spec("random")
                    chance.append(importlib.util.module_from_spec(spec))
                    spec.loader.exec_module(chance[0])
                    chance[0].seed(seed)
                return chance[0]
            if first not in _SHARED:
                self.broken = first
                return builtins.__import__(name, *rest)
            return copied(builtins.__import__(name, *rest))

        return {**vars(builtins), "__import__": load}


class Framed:
    """The runs of all seeds that a host offers."""

    def __init__(self, path, source, hello, printed):
        offer = hello["frames"]
        self.path = path
        self.printed = printed
        self.slots = offer["layout"]["laser"]
        seeds = offer["seeds"]
        self.isolation = Isolation() if len(seeds) > 1 else None
        self.runs = []
        self.sayings = []
        for number, seed in enumerate(seeds):
            run = Run(source, path, hello["robot"], seed, robot_of(offer["layout"]), self.isolation)
            self.runs.append(run)
            self.listen(number)
            if run.program.kind == "plan":
                raise Alone
        self.look()

    def look(self):
        if self.isolation and self.isolation.broken:
            raise Alone

    def listen(self, number):
        """Takes what the program has said in a step."""
        robot = self.runs[number].program.robot
        if robot._events:
            robot._take()
        if self.printed.text:
            self.sayings.append({"run": number, "print": self.printed.take()})

    def serve(self):
        """Answers until the host closes the connection."""
        buffer = bytearray(1 << 16)
        filled = 0
        while True:
            size = 4 + _WORD.unpack_from(buffer)[0] if filled >= 4 else 4
            if filled < 4 or filled < size:
                if size > len(buffer):
                    buffer = buffer + bytes(size)
                got = os.readv(0, [memoryview(buffer)[filled:]])
                if got == 0:
                    return
                filled += got
                continue
            answer = self.answer(buffer)
            filled = 0
            sent = memoryview(answer)
            while sent:
                sent = sent[os.write(1, sent) :]

    def answer(self, buffer):
        """The answer to a question."""
        numbers = memoryview(buffer)[: len(buffer) & -_NUMBER].cast("d")
        words = memoryview(buffer)[: len(buffer) & -_NUMBER].cast("I")
        count = words[1]
        answer = bytearray(4 + _COMMAND.size * count)
        place, slots = 1, self.slots
        printed = self.printed
        number = 0
        try:
            for index in range(count):
                number, beams = words[2 * place], words[2 * place + 1]
                end = place + 1 + slots
                run = self.runs[number]
                ranges = numbers[end : end + beams].tolist() if beams else None
                _COMMAND.pack_into(answer, 4 + 16 * index, *run.step(numbers[place + 1 : end], ranges))
                if printed.text or run.program.robot._events:
                    self.listen(number)
                place = end + beams
            self.look()
        except Exception as error:
            words, line = error_of(error, self.path)
            self.sayings.append({"run": number, "error": words, "line": line or None})
        if self.sayings:
            answer += json.dumps(self.sayings).encode()
            self.sayings = []
        _WORD.pack_into(answer, 0, len(answer) - 4)
        return answer
