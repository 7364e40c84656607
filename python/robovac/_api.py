"""Planning, simulating, comparing, exploring."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Protocol, Union

from . import _native
from ._checks import told, whole
from ._errors import ContractError, UsageError
from ._native import Sensed
from ._results import Comparison, Exploration, Job, Plan, Simulation, Trial
from ._room import RoomLike, as_room

#: A planner written in Python: from a job to the walk's cells (x, y) in their order.
PlannerFunction = Callable[[Job], Iterable[Sequence[int]]]


class Behaviour(Protocol):
    """A behaviour written in Python."""

    def step(self, sensed: Sensed, dt_s: float) -> tuple[float, float] | None:
        """Takes a reading, ``dt_s`` seconds after the last one; returns the speeds of the left and right wheel in m/s, or
        None to end."""


#: Levels of noise: one for all sensors, or one for each of some kinds (others are off).
NoiseLike = Union[str, Mapping[str, str]]


def plan(
    room: RoomLike,
    planner: str | PlannerFunction = "boustrophedon",
    *,
    robot: str = "cell",
    cell_m: float | None = None,
    start: tuple[int, int] | None = None,
    heading_deg: float | None = None,
    coverage_percent: float | None = None,
    seed: int = 0,
    **params: Any,
) -> Plan:
    """Plans a path that covers ``room``.

    ``planner`` is an id (see :func:`robovac.planners`) with its parameters as keywords, or a function that takes a
    :class:`Job` and returns the cells (x, y) of a walk; its walk is checked like every other. ``robot`` is an id (see
    :func:`robovac.robots`); "cell" fills one planning cell. ``cell_m`` is the side of the planning cells, ``start`` the
    planning cell to start in. With ``coverage_percent`` the cells are those with which the planner sweeps this share of
    the floor in the least time.
    """
    room, seed = as_room(room), whole("seed", seed)
    place = _place(room, robot, cell_m, start, heading_deg)
    if callable(planner):
        if coverage_percent is not None:
            raise UsageError("coverage_percent: only planners of the list choose their cells; give cell_m")
        found = _planned_by(planner, place, room, params, seed)
        task = {"cells": _pairs(found["cells"])}
    else:
        given = _params(params)
        found = told(_native.plan, place, _text("planner", planner), given, coverage_percent, seed)
        task = {"planner": planner, "params": given, "coverage_percent": coverage_percent}
    report = json.loads(found["report"])
    walk, drive, bounds = report["walk"] or {}, report["drive"], report["bounds"]
    return Plan(
        room=room,
        robot=report["robot"],
        planner=report["planner"],
        params=params if callable(planner) else report["params"],
        seed=seed,
        cells=found["cells"],
        line_m=found["line_m"],
        free=found["free"],
        cell_m=report["cell_m"],
        cell_offset_m=tuple(report["cell_offset_m"]),
        start=tuple(report["start"]),
        heading_deg=report["heading_deg"],
        coverage=drive["coverage"],
        length_m=drive["length_m"],
        duration_s=drive["duration_s"],
        turning_deg=drive["turning_deg"],
        energy_wh=drive["energy_wh"],
        overlap=drive["overlap"],
        planning_s=report["planning_s"],
        steps=walk.get("steps"),
        turns=walk.get("turns"),
        revisits=walk.get("revisits"),
        reachable_cells=walk.get("reachable_cells"),
        visited_cells=walk.get("visited_cells"),
        bound_steps=bounds["steps"],
        bound_turns=bounds["turns"],
        bound_cost=bounds["cost"],
        above_bound_percent=report["above_bound_percent"],
        metrics=report["metrics"],
        task={"place": place, **task},
    )


def simulate(
    room: RoomLike | Plan,
    planner: str | PlannerFunction | None = None,
    behaviour: str | Behaviour | Callable[[], Behaviour] | None = None,
    *,
    robot: str | None = None,
    cell_m: float | None = None,
    start: tuple[int, int] | None = None,
    heading_deg: float | None = None,
    coverage_percent: float | None = None,
    smooth: bool = False,
    slip: str = "none",
    noise: NoiseLike = "off",
    quantised: bool = False,
    charge_percent: float = 100,
    odometry: str = "arc",
    sample_s: float = 1.0,
    max_time_s: float | None = None,
    seed: int | None = None,
    **params: Any,
) -> Simulation:
    """Simulates a robot that follows a plan or a behaviour.

    Give a :class:`Plan` in place of the room, or a room with a ``planner`` (as in :func:`plan`) or a ``behaviour``: an id
    (see :func:`robovac.behaviours`), an object with ``step(sensed, dt_s)``, or a class or function that makes one. A plan is
    driven as it is, by its own robot; otherwise ``robot`` is "roomba600" unless you name another. ``seed`` determines all
    that is random about wheels, sensors and behaviour; by default it is the plan's, or 0.
    ``slip`` is none, typical or harsh; ``noise`` is off, typical or harsh, or a level for each of some kinds of sensors as in
    ``{"cliff": "harsh"}``. ``sample_s`` is the time between samples, s; ``max_time_s`` ends the run (1800 s for behaviours
    that never end). Other keywords are parameters of the planner or behaviour.
    """
    if isinstance(room, Plan):
        given = (planner, behaviour, robot, cell_m, start, heading_deg, coverage_percent)
        if params or any(value is not None for value in given):
            raise UsageError("a plan is driven as it is, by its own robot: give it alone, or a room with a planner or a behaviour")
        made, room, place = room, room.room, room.task["place"]
        params = made.params
        driver = {"planner": None, "cells": None, "params": [], "coverage_percent": None, **made.task}
        driver.pop("place")
        name, plan_seed = made.planner, made.seed
        seed = plan_seed if seed is None else whole("seed", seed)
        driver |= {"behaviour": None, "object": None}
    elif (planner is None) == (behaviour is None):
        raise UsageError("give either a planner or a behaviour")
    else:
        room = as_room(room)
        place = _place(room, "roomba600" if robot is None else robot, cell_m, start, heading_deg)
        seed = plan_seed = whole("seed", 0 if seed is None else seed)
        driver = {"planner": None, "behaviour": None, "cells": None, "object": None, "params": []}
        driver["coverage_percent"] = coverage_percent
        if isinstance(planner, str) or isinstance(behaviour, str):
            driver |= {"planner": planner, "behaviour": behaviour, "params": _params(params)}
            name = planner if isinstance(planner, str) else str(behaviour)
        elif planner is not None:
            found = _planned_by(planner, place, room, params, seed)
            driver["cells"], name = _pairs(found["cells"]), _name(planner)
        else:
            made_behaviour = behaviour_of(behaviour, params)
            name = _name(behaviour)
            driver["object"] = (made_behaviour, name)
    driver |= {"smooth": smooth, "seed": seed, "plan_seed": plan_seed, "sample_s": sample_s, "max_time_s": max_time_s}
    conditions = _conditions(slip, noise, quantised, charge_percent, odometry)
    found = told(_native.simulate, place, driver, conditions)
    totals = json.loads(found["totals"])
    totals.pop("cell_m")
    return Simulation(
        room=room,
        driver=name,
        params=params,
        seed=seed,
        times_s=found["time_s"],
        coverages=found["coverage"],
        poses=found["pose"],
        estimates=found["estimate"],
        trail_m=found["trail_m"],
        line_m=found["line_m"],
        visits=found["visits"],
        floor=found["floor"],
        resolution_m=found["resolution_m"],
        **totals,
    )


def compare(
    rooms: RoomLike | Sequence[RoomLike],
    planners: str | PlannerFunction | Sequence[str | PlannerFunction | tuple[str, Mapping[str, Any]]] | None = None,
    *,
    robot: str = "cell",
    cell_m: float | None = None,
    smooth: bool = False,
    seeds: int | Sequence[int] = 1,
    threads: int | None = None,
) -> Comparison:
    """Compares planners in the same rooms, on all cores.

    ``planners`` are ids, pairs of an id and its parameters, or functions (which run one after the other); without them, all
    fast ones. ``seeds`` is how many seeds, from 1 on, or which, for planners that are random.
    """
    alone = isinstance(rooms, str) or not isinstance(rooms, Sequence)
    places = [as_room(room) for room in ([rooms] if alone else rooms)]
    if planners is None:
        planners = [entry["id"] for entry in json.loads(_native.planners()) if entry["fast"]]
    if isinstance(planners, str) or callable(planners):
        planners = [planners]
    numbers = list(range(1, seeds + 1)) if isinstance(seeds, int) else [whole("seeds", seed) for seed in seeds]
    if not numbers or not planners or not places:
        raise UsageError("compare at least one planner in at least one room with at least one seed")
    texts = [_entrant(planner) for planner in planners if not callable(planner)]
    natives = [room._native for room in places]
    found = _native.compare(natives, texts, robot, cell_m, smooth, numbers, threads) if texts else "[]"
    trials = [Trial(**(row | {"metrics": row["metrics"] or {}})) for row in json.loads(found)]
    for function in filter(callable, planners):
        for room in places:
            made = plan(room, function, robot=robot, cell_m=cell_m, seed=numbers[0])
            trials.append(Trial(room.name, made.robot, made.cell_m, made.planner, {}, made.seed, made.metrics))
    return Comparison(trials)


def explore(
    room: RoomLike,
    behaviour: str = "explore_edge",
    *,
    robot: str = "roomba600",
    cell_m: float | None = None,
    start: tuple[int, int] | None = None,
    heading_deg: float | None = None,
    tracking: str = "corrected",
    slip: str = "none",
    noise: NoiseLike = "off",
    quantised: bool = False,
    charge_percent: float = 100,
    odometry: str = "arc",
    max_time_s: float = 1200.0,
    seed: int = 0,
    **params: Any,
) -> Exploration:
    """Lets a robot map a room that it doesn't know, and measures map and pose against the truth.

    ``behaviour`` is an id with its parameters as keywords, ``tracking`` "corrected" (odometry corrected by what bumper, light
    bumper or laser meet) or "odometry".
    """
    room = as_room(room)
    place = _place(room, robot, cell_m, start, heading_deg)
    explorer = {
        "behaviour": behaviour,
        "params": _params(params),
        "tracking": tracking,
        "seed": whole("seed", seed),
        "max_time_s": max_time_s,
    }
    found = told(_native.explore, place, explorer, _conditions(slip, noise, quantised, charge_percent, odometry))
    drawn = found["map"]
    return Exploration(
        room=room,
        params=params,
        map=None if drawn is None else as_room(drawn),
        origin_m=found["origin_m"],
        poses=found["pose"],
        estimates=found["estimate"],
        **json.loads(found["report"]),
    )


def behaviour_of(behaviour: Any, params: Mapping[str, Any]) -> Behaviour:
    """The object that drives: ``behaviour``, or what it makes of ``params``."""
    if isinstance(behaviour, type) or not hasattr(behaviour, "step"):
        if not callable(behaviour):
            raise ContractError(f'behaviour "{_name(behaviour)}" has no step(sensed, dt_s)')
        behaviour = behaviour(**params)
    elif params:
        raise UsageError("parameters are for the ids of behaviours and for classes; this is an object")
    if not callable(getattr(behaviour, "step", None)):
        raise ContractError(f'behaviour "{_name(behaviour)}" has no step(sensed, dt_s)')
    return behaviour


def _planned_by(
    function: PlannerFunction, place: dict[str, Any], room: Any, params: dict[str, Any], seed: int
) -> dict[str, Any]:
    """The checked walk of a planner written in Python."""
    job = Job(room=room, params=params, seed=seed, **told(_native.planning_job, place))
    job.free.flags.writeable = False
    begin = time.perf_counter()
    walk = function(job)
    seconds = time.perf_counter() - begin
    try:
        cells = [(_whole(x), _whole(y)) for x, y in walk]
    except (TypeError, ValueError) as error:
        rule = "a planner must return cells (x, y) of whole numbers"
        raise ContractError(f'planner "{_name(function)}": {rule}; {error}') from None
    return _native.plan_given(place, _name(function), cells, seconds)


def _text(name: str, value: Any) -> str:
    if not isinstance(value, str):
        raise UsageError(f"{name} can't be {value!r}; give an id or a function")
    return value


def _pairs(cells: Any) -> list[tuple[int, int]]:
    return list(map(tuple, cells.tolist()))


def _whole(number: Any) -> int:
    whole = int(number)
    if whole != number or not -(2**31) <= whole < 2**31:
        raise ValueError(f"{number} isn't the number of a cell")
    return whole


def _entrant(planner: str | tuple[str, Mapping[str, Any]]) -> str:
    if isinstance(planner, str):
        return planner
    name, params = planner
    return "~".join([name, *(f"{key}:{value}" for key, value in _params(params))])


def _place(
    room: Any, robot: str, cell_m: float | None, start: tuple[int, int] | None, heading_deg: float | None
) -> dict[str, Any]:
    return {"room": room._native, "robot": robot, "cell_m": cell_m, "start": start, "heading_deg": heading_deg}


def _params(params: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Parameters as the command line has them."""

    def text(value: Any) -> str:
        return str(value).lower() if isinstance(value, bool) else str(value)

    return [(key, text(value)) for key, value in params.items()]


def _conditions(
    slip: str, noise: NoiseLike, quantised: bool, charge_percent: float, odometry: str
) -> dict[str, Any]:
    levels = list(noise.items()) if isinstance(noise, Mapping) else [(None, noise)]
    return {
        "slip": slip,
        "noise": levels,
        "quantised": quantised,
        "charge_percent": charge_percent,
        "odometry": odometry,
    }


def _name(thing: Any) -> str:
    return getattr(thing, "__name__", None) or type(thing).__name__
