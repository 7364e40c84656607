"""The page's side of a program: what programs/javascript/python.js calls in MicroPython."""

import json

import js
import uctypes
from array import array

from .program import Program
from .robot import FLAGS, WHOLE
from .words import hinted

ATTRIBUTES = FLAGS + WHOLE + tuple("_b%d" % i for i in range(6)) + tuple("_s%d" % i for i in range(6)) + ("_old_b", "_old_s")
MARKER = 1000000

program = None
# Line, turns of loops left in this step.
_trace = array("i", [0, 0])
_locals = {}
_hidden = ()


def load(source, name, facts, seed):
    """Loads the program; says where its readings and commands are in memory, as JSON."""
    global program, _hidden
    tracers = {"_trace_line": _trace, "_trace_at": _at, "_trace_stop": _stop, "_trace_locals": _set_locals}
    _hidden = set(tracers)
    program = Program(source, name, json.loads(facts), int(seed), tracers)
    robot = program.robot
    return json.dumps({"kind": program.kind, "floats": uctypes.addressof(robot._f), "out": uctypes.addressof(robot._out)})


def trace():
    """Where the line and the number of statements left are."""
    return uctypes.addressof(_trace)


def mark():
    """Gives each attribute that the page sets a number to find it by. Returns the robot's address."""
    robot = program.robot
    for i in range(len(ATTRIBUTES)):
        setattr(robot, ATTRIBUTES[i], MARKER + i)
    return id(robot)


def attributes():
    return json.dumps({"names": ATTRIBUTES, "flags": len(FLAGS)})


def check():
    """The attributes, as the program sees them, without the two last."""
    return json.dumps([getattr(program.robot, name) for name in ATTRIBUTES[:-2]])


def run(robot):
    """One step."""
    program.work()


def take():
    """What the program has said since the last time, as JSON."""
    return json.dumps(program.robot._take())


def _at(line):
    """Before the first statement of a loop: what runs for ever passes here."""
    _trace[0] = line
    _trace[1] -= 1
    if _trace[1] < 0:
        # Leaves MicroPython for good: the program can't catch it.
        js.never_ends


def _stop(line, condition):
    try:
        if not condition():
            return
    except Exception:
        # A condition that fails is one to look at.
        pass
    program.robot._say({"kind": "break", "line": line, "variables": _table()})


def _set_locals(names):
    global _locals
    _locals = names


def _table():
    table = []
    scope = program.scope if program else {}
    for name in scope:
        _add(table, name, scope[name])
    for name in _locals:
        try:
            value = _locals[name]()
        except Exception:
            # It has no value yet.
            continue
        _add(table, name, value)
    return table


def _add(table, name, value):
    kind = type(value).__name__
    if name.startswith("_") or name in _hidden or callable(value) or kind in ("module", "Robot", "generator"):
        return
    try:
        text = repr(value)
    except Exception:
        text = "a value that can't be shown"
    table.append((name, text if len(text) <= 80 else text[:79] + "…", kind))


def variables():
    return json.dumps(_table())


cells = None


def plan(room):
    """Begins a plan."""
    global cells
    cells = program.cells(json.loads(room))


def more():
    """The next cells of the plan, at most 256, as JSON; an empty list at its end."""
    part = []
    for cell in cells:
        part.append(cell)
        if len(part) == 256:
            break
    return json.dumps(part)
