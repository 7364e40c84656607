"""The rules that every planner and behaviour keeps, for those written in Python. Faults are described in words."""

from __future__ import annotations

import math
from typing import Any

from ._api import Behaviour, PlannerFunction, _name, behaviour_of, plan, simulate
from ._errors import ContractError
from ._native import Sensed
from ._room import Room

#: Rooms of a cell, a line of them, corners that diagonal neighbours don't lead out of, and one with an island.
_SMALL = [".", "..", ".\n.", ".......", ".\n.\n.", ".#..\n#...\n....", ".....\n..#..\n.....", "....#\n.##..\n....#\n.#..."]

#: Shipped rooms with obstacles.
_SHIPPED = ["room12ft", "clutter", "comb"]

#: Readings that come suddenly, and together.
_EXTREMES: list[dict[str, Any]] = [
    {},
    {"bump_left": True},
    {"bump_right": True},
    {"bump_left": True, "bump_right": True},
    {"wheel_drop": True},
    {"cliff": [True, True, True, True]},
    {"light_signal": [4095] * 6},
    {"left_counts": 65535, "right_counts": 0},
    {"charge_mah": 0},
]


def check_planner(planner: PlannerFunction, *, complete: bool = True, **params: Any) -> None:
    """Checks a planner written in Python in rooms from one cell to a furnished one.

    Its walk must begin at the start, lead from cell to neighbouring cell over free ones, be the same for the same seed, and
    visit every cell if ``complete``. Raises :class:`robovac.ContractError` with the first fault.
    """
    rooms = [Room.from_text(f"; resolution 0.2\n; name {text!r}\n{text}") for text in _SMALL]
    rooms += [Room.shipped(name) for name in _SHIPPED]
    for room in rooms:
        for heading_deg in (0.0, 90.0):
            walks = [plan(room, planner, heading_deg=heading_deg, seed=seed, **params) for seed in (1, 1)]
            where = f'planner "{_name(planner)}" in room {room.name}'
            if not (walks[0].cells.shape == walks[1].cells.shape and (walks[0].cells == walks[1].cells).all()):
                raise ContractError(f"{where}: the same seed gives another walk; use job.seed for all that is random")
            visited, reachable = walks[0].visited_cells or 0, walks[0].reachable_cells or 0
            if complete and visited < reachable:
                missed = f"it visits {visited} of {reachable} cells; give complete=False if that is meant"
                raise ContractError(f"{where}: {missed}")


def check_behaviour(behaviour: type[Behaviour] | Any, *, cleans: bool = True, **params: Any) -> None:
    """Checks a behaviour written in Python: a class, or a function that makes an object with ``step(sensed, dt_s)``.

    It must answer any readings with finite speeds, drive the same way for the same seed, and clean some floor if ``cleans``.
    Raises :class:`robovac.ContractError` with the first fault.
    """
    name = f'behaviour "{_name(behaviour)}"'
    if not isinstance(behaviour, type) and hasattr(behaviour, "step"):
        raise ContractError(f"{name}: give the class, or a function that makes it, so that each run begins anew")
    for extreme in _EXTREMES:
        driver = behaviour_of(behaviour, params)
        for readings in [{}, *[extreme] * 200, {}]:
            try:
                speeds = driver.step(Sensed(**readings), 0.015)
            except Exception as error:
                raise ContractError(f"{name}: step fails at readings {readings or 'of free floor'}: {error!r}") from error
            if speeds is not None and not _are_speeds(speeds):
                rule = "step must return the speeds of the left and right wheel in m/s, or None to end"
                raise ContractError(f"{name}: {rule}; at readings {readings} it returned {speeds!r}")
            if speeds is None:
                break
    settings: dict[str, Any] = {"slip": "typical", "noise": "typical", "max_time_s": 120.0, "seed": 3}
    runs = [simulate("room12ft", behaviour=behaviour, **settings, **params) for _ in range(2)]
    if runs[0].digest != runs[1].digest:
        raise ContractError(f"{name}: the same seed gives another run; it must depend on its readings alone")
    if cleans and runs[0].coverage < 0.02:
        swept = f"it sweeps {100 * runs[0].coverage:.1f} % of a room of 12 ft in two minutes"
        raise ContractError(f"{name}: {swept}; give cleans=False if that is meant")


def _are_speeds(speeds: Any) -> bool:
    try:
        return len(speeds) == 2 and all(math.isfinite(speed) for speed in speeds)
    except TypeError:
        return False
