"""Errors that name the cause and the mend."""

import math


class ProgramError(Exception):
    """A mistake in a program, said in words."""


def distance(a, b):
    """Letters to insert, delete, replace or swap to get from `a` to `b`."""
    before, row = [], list(range(len(b) + 1))
    for i in range(1, len(a) + 1):
        older, before, row = before, row, [i] + [0] * len(b)
        for j in range(1, len(b) + 1):
            cost = before[j - 1] + (a[i - 1] != b[j - 1])
            cost = min(cost, before[j] + 1, row[j - 1] + 1)
            if i > 1 and j > 1 and a[i - 1] == b[j - 2] and a[i - 2] == b[j - 1]:
                cost = min(cost, older[j - 2] + 1)
            row[j] = cost
    return row[len(b)]


def nearest(name, names):
    """The one of `names` that is meant by `name`, or None."""
    plain = name.replace("_", "").lower()
    best, least = None, max(1, len(plain) // 3) + 1
    for other in names:
        off = distance(plain, other.replace("_", "").lower())
        if off < least:
            best, least = other, off
    return best


# What may come after "robot.", for hints.
names = []


def unknown(name):
    """Says that a robot has no `name`. What may be meant is looked for only when somebody reads it: dir() tries many."""
    return "robot.%s: there is no such name" % name


def hinted(message):
    """The same with what may be meant."""
    if message.startswith("NameError: name '"):
        return message + _meant(message.split("'")[1])
    parts = message.split(": there is no such name")
    if len(parts) == 2 and not parts[1] and parts[0].startswith("robot."):
        meant = nearest(parts[0][6:], names)
        if meant:
            return "%s; did you mean %s?" % (message, meant)
    return message


def _meant(name):
    """What a name that isn't defined may mean."""
    if name == "robot":
        return "; it is known inside def step(robot) and def run(robot) only"
    if name in names:
        return "; did you mean robot.%s?" % name
    if hasattr(math, name):
        return "; write import math in the first line, and math.%s" % name
    meant = nearest(name, ("robot", "print", "range", "True", "False", "None"))
    return "; did you mean %s?" % meant if meant else ""


def number(place, value):
    """`value` as a float, or an error that names `place`."""
    if isinstance(value, (int, float)):
        value = float(value)
        if value - value == 0.0:
            return value
    raise ProgramError("%s must be a number, not %r" % (place, value))
