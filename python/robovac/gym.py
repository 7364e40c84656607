"""Cleaning as Gymnasium environments: ``robovac/Clean-v0``, alone and many at once.

``gymnasium.make("robovac/Clean-v0")`` and ``gymnasium.make_vec("robovac/Clean-v0", num_envs=1024)`` take the arguments of
:class:`CleanVectorEnv`. In the second, all robots are stepped in Rust over all cores.

Observations, by name; several as in ``observation=("oi", "map")`` give a dictionary:

``"oi"``
    What a Roomba's Open Interface reports, 33 numbers from -1 to 1: see :data:`OI_NAMES`.
``"map"``
    The robot's own map, kept from wheel counts, bumper, light bumper and cliff sensors, with their errors: patches of 32 x 32
    pixels at four scales, 5, 10, 20 and 40 cm a pixel. The robot is in the middle and looks up. 0 is an obstacle, 128
    unknown, 255 swept floor; coarser pixels are means.
``"truth"``
    What only the simulator knows, 24 numbers: see :data:`TRUTH_NAMES`.

Actions are two numbers from -1 to 1 (what is beyond counts as -1 or 1): with ``"twist"`` forward and turn speed (left positive), with ``"wheels"`` left and right
wheel, as shares of the largest wheel speed (0.5 m/s for a Roomba).

Rewards are the sum of :class:`RewardWeights` times what a step gained; ``infos`` has the gains one by one, so that
``rewards`` can also be a function of them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import astuple, dataclass
from numbers import Real
from typing import Any, Union

import gymnasium
import numpy as np
from gymnasium import spaces
from gymnasium.utils import EzPickle
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from . import _native
from ._checks import SEEDS, told, whole
from ._errors import UsageError
from ._lists import rooms as _shipped
from ._room import RoomLike, as_room

#: Names of the values of the observation "oi". Switches are 0 or 1; signals, dirt, infrared characters and charge are shares of
#: their range; way, turn and commands are shares of the largest, from -1 to 1.
OI_NAMES: tuple[str, ...] = tuple(_native.reading_names())

#: Names of the values of the observation "truth": true pose, speeds, coverage, share of the time, and 16 distances to the
#: next obstacle, counter-clockwise from straight ahead, up to 5 m.
TRUTH_NAMES: tuple[str, ...] = tuple(_native.truth_names())

#: What a step gained: entries of ``infos``. Floor swept for the first time (m²), turning (rad), presses of the bumper, time (s),
#: falls, and 1 in the step that reached the goal.
GAINS = ("swept_m2", "turned_rad", "bumps", "time_s", "falls", "finished")

#: Seconds of a simulation step.
_SIM_STEP_S = 0.015


@dataclass(frozen=True)
class RewardWeights:
    """What the gains of a step are worth. By default, driving straight over new floor gains about 1 a second."""

    #: For each m² of floor swept for the first time.
    swept_m2: float = 20.0
    #: For each radian of turning.
    turned_rad: float = -0.02
    #: For each press of the bumper.
    bump: float = -0.1
    #: For each second.
    second: float = -0.1
    #: For each fall down a drop-off.
    fall: float = -10.0
    #: For reaching the goal.
    finish: float = 10.0


@dataclass(frozen=True)
class Drawn:
    """What was drawn at random for an episode."""

    #: Name of the room; None for a generated flat.
    room: str | None
    #: Seed of the generated flat, or None.
    flat: int | None
    #: Level of wheel slip.
    slip: str
    #: Level of sensor noise.
    noise: str
    #: Charge of the battery at the start, %.
    charge_percent: int


#: Rewards from ``infos``: an array with one for each environment, also where there is only one. What it returns for steps
#: that only reset an environment doesn't count.
RewardFunction = Callable[[dict[str, Any]], Any]


class CleanVectorEnv(VectorEnv, EzPickle):
    """Many robots that clean, each in a room of its own.

    A copy, or what comes out of a pickle, is a new environment with the same arguments, to be reset.

    Args:
        num_envs: Number of robots.
        observation: Name of a set of observations, or several.
        action: "twist" or "wheels".
        rooms: "generated" flats, "shipped" rooms, or a room or rooms (names, paths, arrays, :class:`robovac.Room`). Each
            episode takes one at random.
        flats: Number of different generated flats.
        first_flat: Seed of the first; others give flats that were never seen.
        area_m2: Least and greatest area of generated flats, from 25 to 120 m².
        furniture: How much of the furniture that a flat can have is in it, from 0 (empty) to 1 (crammed).
        robot: Id of the robot, see :func:`robovac.robots`.
        step_s: Time of a step, s; rounded to whole simulation steps of 15 ms.
        time_limit_s: Simulated time after which an episode is truncated, s.
        goal: Share of the reachable floor with which an episode terminates; more than 1 for never.
        rewards: Weights, or a function of ``infos``.
        slip: Level of wheel slip (none, typical, harsh), or levels of which each episode takes one at random.
        noise: Level of sensor noise (off, typical, harsh), or levels likewise.
        charge_percent: Charge of the battery at the start, or the lowest and the highest.
        start: "anywhere", or "room" for the room's own start.
        autoreset_mode: When an environment whose episode ended begins the next one, as in Gymnasium: "NextStep", "SameStep" or
            "Disabled". With "SameStep", gains and coverage in ``infos`` are still those of the step that ended the episode.
        copy: Whether observations, rewards and infos are copies. By default they are the same arrays in every step: the
            next step overwrites them.
        threads: Threads; without it one for each core.
        render_mode: "rgb_array" or None.
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 10, "autoreset_mode": AutoresetMode.NEXT_STEP}

    def __init__(
        self,
        num_envs: int = 1,
        *,
        observation: str | Sequence[str] = "oi",
        action: str = "twist",
        rooms: str | RoomLike | Sequence[RoomLike] = "generated",
        flats: int = 1000,
        first_flat: int = 0,
        area_m2: tuple[float, float] = (25.0, 120.0),
        furniture: float = 0.7,
        robot: str = "roomba600",
        step_s: float = 0.105,
        time_limit_s: float = 1200.0,
        goal: float = 0.95,
        rewards: RewardWeights | RewardFunction | None = None,
        slip: str | Sequence[str] = "typical",
        noise: str | Sequence[str] = "typical",
        charge_percent: float | tuple[float, float] = 100,
        start: str = "anywhere",
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
        copy: bool = False,
        threads: int | None = None,
        render_mode: str | None = None,
    ) -> None:
        # Before anything else becomes a local variable.
        arguments = {name: value for name, value in locals().items() if name not in ("self", "__class__")}
        EzPickle.__init__(self, **arguments)
        self.num_envs = num_envs = whole("num_envs", num_envs, 1)
        self.render_mode = _one_of("render_mode", render_mode, (None, "rgb_array"))
        modes = tuple(mode.value for mode in AutoresetMode)
        is_mode = isinstance(autoreset_mode, AutoresetMode)
        self._mode = AutoresetMode(autoreset_mode if is_mode else _one_of("autoreset_mode", autoreset_mode, modes))
        self.metadata = {**self.metadata, "autoreset_mode": self._mode}
        self._copy = copy
        self._names = (observation,) if isinstance(observation, str) else tuple(observation)
        for name in self._names:
            _one_of("observation", name, ("oi", "map", "truth"))
        if not self._names or len(set(self._names)) < len(self._names):
            raise UsageError("observation: name each set once, e.g. (\"oi\", \"map\")")
        weights = rewards if isinstance(rewards, RewardWeights) else RewardWeights()
        self._reward = rewards if callable(rewards) else None
        if self._reward is None and not isinstance(rewards, (RewardWeights, type(None))):
            raise UsageError("rewards: give RewardWeights, or a function of infos")
        for name, seconds in (("step_s", step_s), ("time_limit_s", time_limit_s)):
            if not (isinstance(seconds, Real) and np.isfinite(seconds) and seconds > 0):
                raise UsageError(f"{name} can't be {seconds!r}; use a finite number of seconds greater than 0")
        sim_steps = max(1, round(step_s / _SIM_STEP_S))
        charge = tuple(charge_percent) if isinstance(charge_percent, (tuple, list)) else (charge_percent, charge_percent)
        self._batch: _native.Batch = told(
            _native.Batch,
            {
                "num_envs": num_envs,
                "rooms": _rooms(rooms),
                "flats": flats,
                "first_flat": first_flat,
                "area_m2": tuple(area_m2) if isinstance(area_m2, list) else area_m2,
                "furniture": furniture,
                "robot": robot,
                "sim_steps": sim_steps,
                "most_steps": max(1, round(time_limit_s / (sim_steps * _SIM_STEP_S))),
                "goal": goal,
                "observes": list(self._names),
                "action": _one_of("action", action, ("twist", "wheels")),
                "weights": list(astuple(weights)),
                "slip": [slip] if isinstance(slip, str) else slip,
                "noise": [noise] if isinstance(noise, str) else noise,
                "charge_percent": charge,
                "anywhere": _one_of("start", start, ("anywhere", "room")) == "anywhere",
                "autoreset": self._mode.value,
                "threads": threads,
            },
        )
        #: Time of a step, s.
        self.step_s: float = self._batch.step_s
        boxes = {name: _box(name) for name in self._names}
        is_plain = isinstance(observation, str)
        self.single_observation_space = boxes[self._names[0]] if is_plain else spaces.Dict(boxes)
        self.single_action_space = spaces.Box(-1.0, 1.0, (2,), np.float32)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._is_seeded = False
        self._make_buffers(is_plain, boxes)

    def _make_buffers(self, is_plain: bool, boxes: dict[str, spaces.Box]) -> None:
        count, names = self.num_envs, ("oi", "map", "truth")

        def seen() -> dict[str, Any]:
            return {name: np.zeros((count, *boxes[name].shape), boxes[name].dtype) if name in boxes else None for name in names}

        now, last = seen(), seen() if self._mode == AutoresetMode.SAME_STEP else dict.fromkeys(names)
        self._buffers = {
            **now,
            **{f"final_{name}": array for name, array in last.items()},
            "rewards": np.zeros(count),
            "terminated": np.zeros(count, np.bool_),
            "truncated": np.zeros(count, np.bool_),
            "gains": np.zeros((count, len(GAINS))),
            "coverage": np.zeros(count),
        }
        self._observations = now[self._names[0]] if is_plain else {name: now[name] for name in self._names}
        self._last = last[self._names[0]] if is_plain else {name: last[name] for name in self._names}
        everywhere = np.ones(count, np.bool_)
        self._infos: dict[str, Any] = {"coverage": self._buffers["coverage"]}
        self._infos |= {name: self._buffers["gains"][:, index] for index, name in enumerate(GAINS)}
        self._infos |= {f"_{name}": everywhere for name in list(self._infos)}

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Any, dict[str, Any]]:
        """Begins new episodes: all, or those of ``options["reset_mask"]``.

        ``seed`` is one for each environment, or a number from which they count up. Without it the environments continue with
        their random numbers.
        """
        count = self.num_envs
        mask = (options or {}).get("reset_mask")
        if mask is None:
            mask = np.ones(count, np.bool_)
        elif not (isinstance(mask, np.ndarray) and mask.dtype == np.bool_ and mask.shape == (count,) and mask.any()):
            raise UsageError(f"reset_mask: give a numpy array of {count} bools, at least one of them True")
        if seed is None and not self._is_seeded:
            seed = int(self.np_random.integers(2**62))
        if seed is None:
            seeds: list[int | None] = [None] * count
        elif isinstance(seed, Sequence) or np.ndim(seed) == 1:
            if len(seed) != count:
                raise UsageError(f"seed: give one number, or one for each of {count} environments, not {len(seed)}")
            seeds = [None if number is None else whole("seed", number) for number in seed]
        else:
            seed = whole("seed", seed, below=SEEDS - count)
            super().reset(seed=seed)
            seeds = [seed + index for index in range(count)]
        self._is_seeded = True
        self._batch.reset(np.ascontiguousarray(mask), seeds, self._buffers)
        return self._given(self._observations), self._told()

    def step(self, actions: Any) -> tuple[Any, np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        """One step of ``step_s`` for every robot."""
        shape = (self.num_envs, 2)
        actions = _array(actions, shape, f"give one action for each of {self.num_envs} environments, an array of shape {shape}")
        buffers = self._buffers
        self._batch.step(actions, buffers)
        infos = self._told()
        if self._reward is not None:
            buffers["rewards"][:] = self._rewarded(self._reward(infos), infos["time_s"])
        ended = buffers["terminated"] | buffers["truncated"]
        if self._mode == AutoresetMode.SAME_STEP and ended.any():
            infos |= self._final(ended)
        outcome = (buffers[name] for name in ("rewards", "terminated", "truncated"))
        rewards, terminated, truncated = map(self._given, outcome)
        return self._given(self._observations), rewards, terminated, truncated, infos

    def _rewarded(self, given: Any, time_s: np.ndarray) -> np.ndarray:
        """Rewards of a function; those of steps that only reset, which take no time, are 0."""
        rewards = np.asarray(given, np.float64)
        if rewards.shape not in ((), (self.num_envs,)) or np.isnan(rewards).any():
            rule = f"rewards: the function must return a number for each of {self.num_envs} environments"
            raise UsageError(f"{rule}; it returned {given!r}")
        return np.where(time_s > 0.0, rewards, 0.0)

    def _final(self, ended: np.ndarray) -> dict[str, Any]:
        """Last observations and infos of the episodes that ended, as Gymnasium has them."""
        observations = np.full(self.num_envs, None, dtype=object)
        for index in np.flatnonzero(ended):
            last = self._last
            observations[index] = (
                {name: array[index].copy() for name, array in last.items()} if isinstance(last, dict) else last[index].copy()
            )
        info: dict[str, Any] = {}
        for name in ("coverage", *GAINS):
            info[name], info[f"_{name}"] = np.where(ended, self._infos[name], 0.0), ended
        return {"final_obs": observations, "_final_obs": ended, "final_info": info, "_final_info": ended}

    def _given(self, values: Any) -> Any:
        if not self._copy:
            return values
        return {name: array.copy() for name, array in values.items()} if isinstance(values, dict) else values.copy()

    def _told(self) -> dict[str, Any]:
        return {name: array.copy() for name, array in self._infos.items()} if self._copy else dict(self._infos)

    def drawn(self) -> tuple[Drawn, ...]:
        """What was drawn at random for each environment's present episode."""
        return tuple(Drawn(*parts) for parts in self._batch.drawn())

    def render(self) -> tuple[np.ndarray, ...] | None:
        """A picture of every room, which fills 480 x 480 pixels: walls, floor, swept floor and robot."""
        if self.render_mode is None:
            return None
        return tuple(self._batch.picture(index) for index in range(self.num_envs))

    def close_extras(self, **kwargs: Any) -> None:
        """There is nothing to close."""


class CleanEnv(gymnasium.Env, EzPickle):
    """One robot that cleans; arguments as for :class:`CleanVectorEnv`, of which it is one environment."""

    metadata = {"render_modes": ["rgb_array"], "render_fps": 10}

    def __init__(self, *, render_mode: str | None = None, **settings: Any) -> None:
        for name in ("num_envs", "autoreset_mode", "copy", "threads"):
            if name in settings:
                raise UsageError(f"{name} is for many environments: gymnasium.make_vec(\"robovac/Clean-v0\", ...)")
        EzPickle.__init__(self, render_mode=render_mode, **settings)
        self._is_over = False
        mode = AutoresetMode.DISABLED
        self._envs = CleanVectorEnv(1, autoreset_mode=mode, copy=True, threads=1, render_mode=render_mode, **settings)
        self.render_mode = render_mode
        self.observation_space = self._envs.single_observation_space
        self.action_space = self._envs.single_action_space
        self.step_s = self._envs.step_s

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Begins a new episode."""
        super().reset(seed=seed)
        observations, infos = self._envs.reset(seed=seed)
        self._is_over = False
        return _only(observations), _only_info(infos)

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """One step of ``step_s``."""
        if self._is_over:
            raise UsageError("the episode is over; call reset()")
        action = _array(action, (2,), "an action is an array of shape (2,)")
        observations, rewards, terminated, truncated, infos = self._envs.step(action[None])
        is_over, is_late = bool(terminated[0]), bool(truncated[0])
        self._is_over = is_over or is_late
        return _only(observations), float(rewards[0]), is_over, is_late, _only_info(infos)

    def drawn(self) -> Drawn:
        """What was drawn at random for the present episode."""
        return self._envs.drawn()[0]

    def render(self) -> np.ndarray | None:
        """A picture of the room."""
        frames = self._envs.render()
        return None if frames is None else frames[0]


def _array(given: Any, shape: tuple[int, ...], rule: str) -> np.ndarray:
    """``given`` as the native part takes it."""
    try:
        array = np.asarray(given, np.float32, order="C")
    except (TypeError, ValueError):
        raise UsageError(f"{rule}, not {given!r}") from None
    if array.shape != shape:
        raise UsageError(f"{rule}, not {array.shape}")
    return array


def _only(observations: Any) -> Any:
    if isinstance(observations, dict):
        return {name: array[0] for name, array in observations.items()}
    return observations[0]


def _only_info(infos: dict[str, Any]) -> dict[str, Any]:
    return {name: float(values[0]) for name, values in infos.items() if not name.startswith("_")}


def _box(name: str) -> spaces.Box:
    if name == "map":
        return spaces.Box(0, 255, (4, 32, 32), np.uint8)
    if name == "truth":
        return spaces.Box(-np.inf, np.inf, (len(TRUTH_NAMES),), np.float32)
    signed = {"way", "turn", "left_command", "right_command"}
    low = np.array([-1.0 if value in signed else 0.0 for value in OI_NAMES], np.float32)
    return spaces.Box(low, np.ones_like(low), dtype=np.float32)


def _rooms(rooms: Union[str, RoomLike, Sequence[RoomLike]]) -> list[Any] | None:
    if isinstance(rooms, str) and rooms == "generated":
        return None
    if isinstance(rooms, str) and rooms == "shipped":
        rooms = list(_shipped())
    is_one = isinstance(rooms, (str, np.ndarray)) or not isinstance(rooms, Sequence)
    return [as_room(room)._native for room in ([rooms] if is_one else rooms)]


def _one_of(name: str, value: Any, known: tuple[Any, ...]) -> Any:
    if value not in known:
        raise UsageError(f"{name} can't be {value!r}; use {', '.join(map(repr, known))}")
    return value
