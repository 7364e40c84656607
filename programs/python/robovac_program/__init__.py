"""Programs for robot vacuums: what `robovac run` and the page Program run. docs/programs.md describes the interface."""

from .program import Program, error_of
from .robot import Robot
from .room import Room
from .words import ProgramError
