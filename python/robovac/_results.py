"""Results: plain data with units in their names. Angles in degrees count counter-clockwise from 0 = right."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Iterator

from ._errors import UsageError
from ._svg import cells as draw_cells
from ._svg import disc, fitted, line

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from ._room import Room

#: Colours of the page.
_SWEPT, _TRAIL, _PATH, _END = "#9ecae1", "#08519c", "#0072b2", "#d55e00"


@dataclass(frozen=True, eq=False)
class Job:
    """What a planner written in Python gets: the planning cells that the robot can reach."""

    #: Free cells, ``free[y, x]``; all are connected with the start by steps to the four neighbours. Row 0 is at the bottom.
    free: npt.NDArray[np.bool_]
    #: The start cell (x, y), where the walk must begin.
    start: tuple[int, int]
    #: Where the robot looks: right, up, left or down.
    heading: str
    #: Side of a cell, m.
    cell_m: float
    #: Time of a step straight on, s.
    step_s: float
    #: Time of a quarter turn, s.
    turn_s: float
    #: The room, for those who want more than the grid.
    room: Room = field(repr=False)
    #: Parameters given to :func:`robovac.plan`.
    params: dict[str, Any] = field(default_factory=dict)
    #: Seed for what is random.
    seed: int = 0


@dataclass(frozen=True, eq=False)
class Plan:
    """A planned path with its numbers; ``robovac metrics`` defines each."""

    #: The room, and the robot's id.
    room: Room = field(repr=False)
    robot: str
    #: The planner's id, or the name of a function; its parameters, and the seed.
    planner: str
    params: dict[str, Any]
    seed: int | None
    #: The walk over planning cells: a row (x, y) for each, the start included. Empty for planners in metres.
    cells: npt.NDArray[np.int32] = field(repr=False)
    #: Corners of the line that the robot drives: rows of x and y, m.
    line_m: npt.NDArray[np.float64] = field(repr=False)
    #: Planning cells that can be reached, ``free[y, x]``; row 0 is at the bottom.
    free: npt.NDArray[np.bool_] = field(repr=False)
    #: Side of a planning cell, m.
    cell_m: float
    #: How far the cells begin to the left of the room's lower-left corner and below it, m.
    cell_offset_m: tuple[float, float]
    #: The start cell (x, y), and the heading there, degrees.
    start: tuple[int, int]
    heading_deg: float
    #: Swept share of the reachable floor, 0 to 1.
    coverage: float
    #: Length of the path, m.
    length_m: float
    #: Time by the robot's motion model, s.
    duration_s: float
    #: Sum of all turns, degrees.
    turning_deg: float
    #: Energy from the battery, Wh.
    energy_wh: float
    #: Area swept again, as a share of the area swept.
    overlap: float
    #: Planning time, s.
    planning_s: float
    #: Steps, quarter turns and revisits of the walk; None for a path in metres.
    steps: int | None
    turns: int | None
    revisits: int | None
    #: Cells that can be reached, and those of them that the walk visits.
    reachable_cells: int | None
    visited_cells: int | None
    #: Least steps, quarter turns and steps + 2 x quarter turns of any walk.
    bound_steps: int
    bound_turns: int
    bound_cost: int
    #: How far steps + 2 x quarter turns exceed that, percent; None if the walk misses cells.
    above_bound_percent: float | None
    #: All metrics by id, see :func:`robovac.metrics`; None where one doesn't apply.
    metrics: dict[str, float | None] = field(repr=False)
    #: What the plan was asked for, to drive it again: arguments of :func:`robovac.simulate`.
    task: dict[str, Any] = field(repr=False)

    def to_svg(self) -> str:
        """Room and path as an SVG drawing; a unit is a millimetre."""
        return self.room._native.to_svg([tuple(point) for point in self.line_m.tolist()])

    def _repr_svg_(self) -> str:
        return fitted(self.to_svg(), self.room.width_m, self.room.height_m)


@dataclass(frozen=True, eq=False)
class Simulation:
    """A simulated run."""

    #: The room, and the robot's id.
    room: Room = field(repr=False)
    robot: str
    #: The planner or behaviour, its parameters, and the seed.
    driver: str
    params: dict[str, Any]
    seed: int
    #: Levels of slip and noise.
    slip: str
    noise: str
    #: Simulated time, s.
    time_s: float
    #: Swept share of the reachable floor at the end, 0 to 1.
    coverage: float
    #: Distance driven, m; sum of all turning, degrees.
    distance_m: float
    turning_deg: float
    #: How often the bumper was pressed; falls down a drop-off.
    bumps: int
    falls: int
    #: Area swept again, as a share of the area swept.
    overlap: float
    #: Distance between true and estimated position at the end, m.
    pose_error_m: float | None
    #: Whether the robot ended by itself, and whether its battery was empty before that.
    finished: bool
    battery_empty: bool
    #: Reachable floor, m².
    floor_m2: float
    #: Equal only for runs in the same state, to the last bit.
    digest: str
    #: Times of the samples, s.
    times_s: npt.NDArray[np.float64] = field(repr=False)
    #: Coverage at these times, 0 to 1: the coverage curve.
    coverages: npt.NDArray[np.float64] = field(repr=False)
    #: True poses at these times: rows of x, y in m and heading in rad.
    poses: npt.NDArray[np.float64] = field(repr=False)
    #: The robot's estimates of them; NaN where it has none.
    estimates: npt.NDArray[np.float64] = field(repr=False)
    #: The way that the robot took: rows of x and y, m, about 2 cm apart.
    trail_m: npt.NDArray[np.float64] = field(repr=False)
    #: The planned line: rows of x and y, m. Empty for behaviours.
    line_m: npt.NDArray[np.float64] = field(repr=False)
    #: Passes of the tool over each fine cell, at most 255: ``visits[y, x]``, row 0 at the bottom.
    visits: npt.NDArray[np.uint8] = field(repr=False)
    #: Fine cells that the tool can reach.
    floor: npt.NDArray[np.bool_] = field(repr=False)
    #: Side of a fine cell, m.
    resolution_m: float

    def to_svg(self) -> str:
        """Room, swept floor and trail as an SVG drawing."""
        over = draw_cells(self.visits > 0, self.resolution_m, _SWEPT) + line(self.trail_m, _TRAIL, 0.015)
        over += disc(*self.poses[0, :2], 0.06, _PATH) + disc(*self.poses[-1, :2], 0.06, _END)
        return fitted(self.room.to_svg(), self.room.width_m, self.room.height_m, over)

    def _repr_svg_(self) -> str:
        return self.to_svg()


@dataclass(frozen=True, eq=False)
class Exploration:
    """A map that a robot made, measured against the room."""

    #: The room, and the robot's id.
    room: Room = field(repr=False)
    robot: str
    #: The behaviour, its parameters, the seed, and how the robot tracked its pose.
    behaviour: str
    params: dict[str, Any]
    seed: int
    tracking: str
    #: Simulated time, s; distance driven, m; bumps; whether the robot ended by itself.
    time_s: float
    distance_m: float
    bumps: int
    finished: bool
    #: The map as a room, which can be planned in; None if nothing is known. Its cells: -1 unknown, 0 free, 100 occupied.
    map: Room | None = field(repr=False)
    #: Where the map's lower left corner is in the room, x and y in m.
    origin_m: tuple[float, float] | None
    #: Share of the known cells that are right within one cell.
    right: float
    #: Share of the reachable floor that is known.
    known: float
    #: Share of the reachable boundary that is mapped; mean distance of occupied cells from a true edge, m.
    boundary: float
    boundary_error_m: float | None
    #: Number of known cells, of 5 cm.
    known_cells: int
    #: Error of the estimated pose at the end, m and degrees.
    pose_error_m: float
    heading_error_deg: float
    #: True and estimated poses, once a second: rows of x, y in m and heading in rad.
    poses: npt.NDArray[np.float64] = field(repr=False)
    estimates: npt.NDArray[np.float64] = field(repr=False)

    def to_svg(self) -> str:
        """The room with the map over it: occupied cells, and the estimated trail."""
        over = ""
        if self.map is not None and self.origin_m is not None:
            cells, side = self.map.cells, self.map.resolution_m
            x, y = self.origin_m
            drawn = draw_cells(cells == 0, side, "#cfe8d5") + draw_cells(cells == 100, side, _END)
            over = f'<g transform="translate({x:.3f} {y:.3f})">{drawn}</g>' + line(self.estimates[:, :2], _TRAIL, 0.015)
        return fitted(self.room.to_svg(), self.room.width_m, self.room.height_m, over)

    def _repr_svg_(self) -> str:
        return self.to_svg()


@dataclass(frozen=True, eq=False)
class Trial:
    """One planner in one room with one seed."""

    #: Name of the room, id of the robot, and side of a planning cell, m.
    room: str
    robot: str
    cell_m: float
    #: The planner with its parameters, and the seed.
    planner: str
    params: dict[str, Any]
    seed: int | None
    #: All metrics by id, see :func:`robovac.metrics`; empty if the trial failed.
    metrics: dict[str, float | None] = field(repr=False)
    #: Why there is no result, if there is none.
    error: str | None = None


@dataclass(frozen=True, eq=False)
class Comparison:
    """Planners against each other in the same rooms."""

    #: One for each room, planner and seed.
    trials: list[Trial]

    def __iter__(self) -> Iterator[Trial]:
        return iter(self.trials)

    def __len__(self) -> int:
        return len(self.trials)

    def records(self) -> list[dict[str, Any]]:
        """A flat dictionary for each trial, as ``pandas.DataFrame`` takes them."""
        names = ("room", "robot", "cell_m", "planner", "seed", "error")
        return [
            {name: getattr(trial, name) for name in names} | {"params": _written(trial.params)} | trial.metrics
            for trial in self.trials
        ]

    def table(self, metric: str = "duration") -> dict[str, dict[str, float | None]]:
        """The median of a metric over seeds: by planner, then by room. None where no trial has one.

        Where a planner took part with several parameters, they are behind its id: ``snake~patience:5``.
        """
        from statistics import median

        from ._lists import metrics

        if metric not in metrics():
            raise UsageError(f'there is no metric "{metric}"; robovac.metrics() lists them')
        values: dict[str, dict[str, list[float]]] = {}
        for trial in self.trials:
            value = trial.metrics.get(metric)
            cell = values.setdefault(self._label(trial), {}).setdefault(trial.room, [])
            if value is not None:
                cell.append(value)
        return {
            planner: {room: median(found) if found else None for room, found in rooms.items()}
            for planner, rooms in values.items()
        }

    def _label(self, trial: Trial) -> str:
        """The planner, with the parameters that tell its trials apart."""
        others = [other.params for other in self.trials if other.planner == trial.planner]
        varied = {name: value for name, value in trial.params.items() if any(other.get(name) != value for other in others)}
        return "~".join(filter(None, (trial.planner, _written(varied))))


def _written(params: dict[str, Any]) -> str:
    """Parameters as on the command line."""
    return "~".join(f"{name}:{value:g}" if isinstance(value, float) else f"{name}:{value}" for name, value in params.items())
