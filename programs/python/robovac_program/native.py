"""The protocol of docs/programs.md: one JSON object a line on standard input and output."""

import io
import json
import os
import sys

from .frames import Alone, Framed
from .program import Program, error_of

VERSION = 1


class Printed(io.TextIOBase):
    """What the program prints, kept for the next answer."""

    def __init__(self):
        self.text = []

    def write(self, text):
        self.text.append(text)
        return len(text)

    def take(self):
        text = "".join(self.text)
        self.text = []
        return text.split("\n")[:-1] if text.endswith("\n") else text.split("\n") if text else []


def serve(path, read, write):
    """Runs the program of that file until the host closes the connection. Returns the exit code."""
    printed = Printed()

    def answer(message):
        lines = printed.take()
        if lines:
            message["print"] = lines
        write(json.dumps(message) + "\n")

    hello = json.loads(read() or "{}")
    if hello.get("kind") != "hello" or hello.get("robovac") != VERSION:
        answer({"error": "this program speaks version %d of the protocol; the host does not" % VERSION})
        return 1
    own = sys.stdout
    sys.stdout = printed
    try:
        return _converse(path, hello, read, answer)
    finally:
        sys.stdout = own


def _converse(path, hello, read, answer):
    try:
        import random

        random.seed(hello["seed"])
        with open(path, encoding="utf-8") as file:
            source = file.read()
        if "frames" in hello and hasattr(os, "readv"):
            try:
                framed = Framed(path, source, hello, sys.stdout)
                answer({"ready": "behaviour", "frames": True})
                return framed.serve() or 0
            except Alone:
                # The first run alone, from its start.
                random.seed(hello["seed"])
                sys.stdout.take()
        program = Program(source, path, hello["robot"], hello["seed"])
        holds = hello.get("holds", False)
        at = 0
        answer({"ready": "planner" if program.kind == "plan" else "behaviour"})
        while True:
            line = read()
            if not line:
                return 0
            message = json.loads(line)
            if "room" in message:
                _plan(program, message["room"], answer)
            else:
                if message["step"] > at:
                    program.skip(message["step"] - at)
                at = message["step"] + 1
                _step(program, message, holds, answer)
    except Exception as error:
        words, line = error_of(error, path)
        answer({"error": words, "line": line} if line else {"error": words})
        return 1


def _step(program, readings, holds, answer):
    left, right = program.step(readings)
    message = {"left": left, "right": right}
    if program.robot._events:
        message["events"] = program.robot._take()
    if program.is_done():
        message["done"] = True
    elif holds:
        steps = program.hold()
        if steps:
            message["hold"] = steps
    answer(message)


def _plan(program, room, answer):
    cells = []
    for cell in program.cells(room):
        cells.append(cell)
        if len(cells) == 1000:
            answer({"cells": cells})
            cells = []
    if cells:
        answer({"cells": cells})
    answer({"done": True})
