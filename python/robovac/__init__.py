"""Robot vacuums: plan, simulate, compare and map, and learn in a fast Gymnasium environment.

>>> import robovac
>>> plan = robovac.plan("bedroom", planner="spiral_stc", robot="roomba600")
>>> run = robovac.simulate(plan, slip="typical", noise="typical")

Metres, seconds and radians unless a name says otherwise; x to the right, y up, row 0 of arrays at the bottom. The environment
for reinforcement learning is ``gymnasium.make_vec("robovac/Clean-v0", num_envs=64)``, see :mod:`robovac.gym`.
"""

from typing import Any

from . import contract
from ._api import Behaviour, compare, explore, plan, simulate
from ._errors import ContractError, FileError, MapError, PlacementError, PlannerError, RobovacError, UsageError
from ._lists import behaviours, metrics, planners, robots, rooms
from ._native import Sensed
from ._register import register_with_gymnasium
from ._results import Comparison, Exploration, Job, Plan, Simulation, Trial
from ._room import Room
from ._version import __version__

register_with_gymnasium()


def __getattr__(name: str) -> Any:
    """``gym``, which needs Gymnasium, and ``study`` are imported when they are used."""
    if name not in ("gym", "study"):
        raise AttributeError(f"module 'robovac' has no attribute '{name}'")
    from importlib import import_module

    return import_module(f"{__name__}.{name}")


__all__ = [
    "Behaviour",
    "Comparison",
    "ContractError",
    "Exploration",
    "FileError",
    "Job",
    "MapError",
    "PlacementError",
    "Plan",
    "PlannerError",
    "RobovacError",
    "Room",
    "Sensed",
    "Simulation",
    "Trial",
    "UsageError",
    "__version__",
    "behaviours",
    "compare",
    "contract",
    "explore",
    "metrics",
    "plan",
    "planners",
    "robots",
    "rooms",
    "simulate",
]
