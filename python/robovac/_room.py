"""Rooms from whatever describes one."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Union

from ._checks import whole
from ._errors import UsageError
from ._native import Room as _Native
from ._svg import fitted

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

#: Side of a cell where nothing else is said, m: that of text maps on the command line.
DEFAULT_CELL_M = 0.1

#: Length of a drawing's unit, m.
_UNITS = {"mm": 0.001, "cm": 0.01, "m": 1.0, "in": 0.0254, "ft": 0.3048}


class Room:
    """A room: walls, furniture, and where the robot starts.

    Made by :meth:`shipped`, :meth:`from_text`, :meth:`from_array`, :meth:`open` or :meth:`flat`; functions that take a room
    also take what these take. Metres count from the lower left corner, x to the right and y up. A room shows itself in
    notebooks.
    """

    __slots__ = ("_native",)

    def __init__(self, native: _Native) -> None:
        self._native = native

    @classmethod
    def shipped(cls, name: str) -> Room:
        """A shipped room by its name, see :func:`robovac.rooms`."""
        return cls(_Native.shipped(name))

    @classmethod
    def from_text(cls, text: str, *, name: str = "Room") -> Room:
        """A room of ``#`` (wall), ``.`` (floor), ``?`` (unknown) and ``S`` (start), the top row first.

        Cells are 10 cm wide unless a line ``; resolution 0.2`` above says otherwise.
        """
        lines = (line.strip() for line in text.strip().splitlines())
        return cls(_Native.from_text("\n".join(lines) + "\n", name))

    @classmethod
    def from_array(
        cls,
        cells: npt.ArrayLike,
        *,
        resolution_m: float = DEFAULT_CELL_M,
        start: tuple[float, float, float] | None = None,
        name: str = "Room",
    ) -> Room:
        """A room from cells as in a ROS occupancy grid: -1 unknown, 0 free, all else occupied. ``True`` is occupied.

        Row 0 is at the bottom. ``resolution_m`` is the side of a cell; ``start`` is x and y in m and the heading in degrees.
        """
        import numpy as np

        array = np.asarray(cells)
        if array.ndim == 0:
            raise UsageError(f"a room can't be {cells!r}; give a Room, the name of a shipped one, a path, a text or an array")
        if array.ndim != 2:
            raise UsageError(f"a room is an array with rows and columns, not one with {array.ndim} dimensions")
        states = np.where(array == 0, 0, np.where(array == -1, -1, 100)).astype(np.int8)
        return cls(_Native.from_cells(np.ascontiguousarray(states), float(resolution_m), start, name))

    @classmethod
    def open(
        cls, path: str | os.PathLike[str], *, units: str | float | None = None, resolution_m: float = 0.05
    ) -> Room:
        """A room from a file, as the command line reads it.

        Text of ``#`` and ``.``, PNG, PGM, JPEG and WebP, ROS maps (YAML, whose image is found beside it), scenarios (JSON), and
        drawings (DXF, SVG, GeoJSON). ``units`` (mm, cm, m, in, ft, or metres) and ``resolution_m`` count for drawings.
        """
        if isinstance(units, str):
            if units not in _UNITS:
                raise UsageError(f"units can't be \"{units}\"; use {', '.join(_UNITS)} or the length of a unit in metres")
            units = _UNITS[units]
        return cls(_Native.open(os.fspath(path), units, float(resolution_m)))

    @classmethod
    def flat(
        cls,
        seed: int,
        *,
        area_m2: tuple[float, float] = (25.0, 120.0),
        furniture: float = 0.7,
        rugs: bool = True,
    ) -> Room:
        """A furnished flat, determined by its seed; ``robovac generate`` on the command line makes the same.

        ``area_m2`` is the least and the greatest area between the outer walls, from 25 to 120 m²; ``furniture`` goes from 0
        (empty) to 1 (crammed).
        """
        return cls(_Native.flat(whole("seed", seed), area_m2, furniture, rugs))

    @property
    def name(self) -> str:
        """Its name."""
        return self._native.name

    @property
    def note(self) -> str:
        """What it is good for; can be empty."""
        return self._native.note

    @property
    def resolution_m(self) -> float:
        """Side of a cell, m."""
        return self._native.resolution_m

    @property
    def width_m(self) -> float:
        """Width, m."""
        return self._native.width_m

    @property
    def height_m(self) -> float:
        """Height, m."""
        return self._native.height_m

    @property
    def start(self) -> tuple[float, float, float] | None:
        """The robot's start: x and y in m, heading in degrees, counter-clockwise from 0 = right. None if it has none."""
        return self._native.start

    @property
    def cells(self) -> npt.NDArray[np.int8]:
        """Its cells as in a ROS occupancy grid: -1 unknown, 0 free, 100 occupied; row 0 is at the bottom. A copy."""
        return self._native.cells

    def to_text(self) -> str:
        """The room as text of ``#`` and ``.``. Objects that aren't walls are lost."""
        return self._native.to_text()

    def to_scenario(self) -> str:
        """The room as a scenario (JSON), with its objects: what the page and the command line open."""
        return self._native.to_scenario()

    def to_svg(self) -> str:
        """The room as an SVG drawing; a unit is a millimetre."""
        return self._native.to_svg([])

    def _repr_svg_(self) -> str:
        return fitted(self.to_svg(), self.width_m, self.height_m)

    def __repr__(self) -> str:
        return repr(self._native)

    def __reduce__(self) -> tuple[Any, ...]:
        return (_from_scenario, (self.to_scenario(), self.name))


def _from_scenario(text: str, name: str) -> Room:
    return Room(_Native.from_text(text, name))


#: What functions take as a room: a room, the name of a shipped one, a path, text of # and ., or an array of cells.
RoomLike = Union[Room, str, "os.PathLike[str]", "npt.ArrayLike"]


def as_room(room: RoomLike) -> Room:
    """The room that ``room`` describes."""
    if isinstance(room, Room):
        return room
    if isinstance(room, _Native):
        return Room(room)
    if isinstance(room, os.PathLike):
        return Room.open(room)
    if isinstance(room, str):
        if "\n" in room.strip():
            return Room.from_text(room)
        return Room.open(room) if any(mark in room for mark in "./\\") else Room.shipped(room)
    return Room.from_array(room)
