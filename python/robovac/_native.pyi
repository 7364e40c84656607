"""Types of the compiled part. Its arguments are made by the modules beside it; use those."""

from typing import Any

import numpy as np
import numpy.typing as npt

__version__: str

class Sensed:
    """One reading of all sensors: what a Roomba's Open Interface reports, in its units. Numbers are packet numbers."""

    bump_left: bool
    """The bumper is pressed on its left half (packet 7)."""
    bump_right: bool
    """The bumper is pressed on its right half (packet 7)."""
    bumped: bool
    """The bumper is pressed anywhere."""
    wheel_drop_left: bool
    """The left wheel hangs down (packet 7)."""
    wheel_drop_right: bool
    """The right wheel hangs down (packet 7)."""
    cliff: list[bool]
    """No floor at left, front left, front right, right (packets 9 to 12)."""
    cliff_signal: list[int]
    """Signals of the cliff sensors, 0 to 4095 (packets 28 to 31)."""
    sees_cliff: bool
    """Any cliff sensor sees no floor."""
    wall: bool
    """The wall sensor on the right detects something (packet 8)."""
    wall_signal: int
    """Its signal, 0 to 1023 (packet 27)."""
    virtual_wall: bool
    """The beam of a virtual wall is detected (packet 13)."""
    light_bumper: list[bool]
    """Detections of the light bumper, from left to right (packet 45)."""
    light_signal: list[int]
    """Its signals, from left to right, 0 to 4095 (packets 46 to 51)."""
    dirt: int
    """Dirt being picked up, 0 to 255 (packet 15)."""
    infrared: list[int]
    """Infrared characters received all around, left and right; 0 for none (packets 17, 52, 53)."""
    left_counts: int
    """Left wheel encoder, wraps at 65536 (packet 43)."""
    right_counts: int
    """Right wheel encoder, wraps at 65536 (packet 44)."""
    distance_mm: int | None
    """Distance since the last report, mm (packet 19); None between reports."""
    angle_deg: int | None
    """Turn since the last report, degrees, counter-clockwise (packet 20); None between reports."""
    stasis: bool
    """The castor turns: the robot moves ahead (packet 58)."""
    overcurrent: list[bool]
    """The left and right wheel's motors draw too much current (packet 14)."""
    charge_mah: int
    """Charge of the battery, mAh (packet 25)."""
    capacity_mah: int
    """Capacity, mAh (packet 26); 0 for a robot without a gauge."""
    voltage_mv: int
    """Voltage, mV (packet 22)."""
    current_ma: int
    """Current, mA, negative while it discharges (packet 23)."""
    on_dock: bool
    """The robot is charged on its dock (packet 34)."""

    def __init__(
        self,
        *,
        bump_left: bool = False,
        bump_right: bool = False,
        wheel_drop: bool = False,
        cliff: list[bool] = ...,
        light_signal: list[int] = ...,
        left_counts: int = 0,
        right_counts: int = 0,
        charge_mah: int = 2696,
    ) -> None: ...

class Room:
    name: str
    note: str
    resolution_m: float
    width_m: float
    height_m: float
    start: tuple[float, float, float] | None
    cells: npt.NDArray[np.int8]

    @staticmethod
    def shipped(id: str) -> Room: ...
    @staticmethod
    def from_text(text: str, name: str) -> Room: ...
    @staticmethod
    def open(path: str, metre: float | None, resolution_m: float) -> Room: ...
    @staticmethod
    def from_cells(
        cells: npt.NDArray[np.int8], resolution_m: float, start: tuple[float, float, float] | None, name: str
    ) -> Room: ...
    @staticmethod
    def flat(seed: int, area_m2: tuple[float, float], furniture: float, rugs: bool) -> Room: ...
    def to_text(self) -> str: ...
    def to_scenario(self) -> str: ...
    def to_svg(self, line: list[tuple[float, float]]) -> str: ...

class Batch:
    step_s: float
    threads: int

    def __init__(self, arguments: dict[str, Any]) -> None: ...
    def reset(self, mask: npt.NDArray[np.bool_], seeds: list[int | None], buffers: dict[str, Any]) -> None: ...
    def step(self, actions: npt.NDArray[np.float32], buffers: dict[str, Any]) -> None: ...
    def bench(self, actions: npt.NDArray[np.float32], buffers: dict[str, Any], steps: int) -> float: ...
    def drawn(self) -> list[tuple[str | None, int | None, str, str, int]]: ...
    def picture(self, index: int) -> npt.NDArray[np.uint8]: ...

def planners() -> str: ...
def behaviours() -> str: ...
def rooms() -> str: ...
def robots() -> str: ...
def metrics() -> str: ...
def reading_names() -> list[str]: ...
def truth_names() -> list[str]: ...
def plan(
    place: dict[str, Any], planner: str, params: list[tuple[str, str]], coverage_percent: float | None, seed: int
) -> dict[str, Any]: ...
def plan_given(
    place: dict[str, Any], name: str, cells: list[tuple[int, int]], planning_s: float
) -> dict[str, Any]: ...
def planning_job(place: dict[str, Any]) -> dict[str, Any]: ...
def simulate(place: dict[str, Any], driver: dict[str, Any], conditions: dict[str, Any]) -> dict[str, Any]: ...
def compare(
    rooms: list[Room],
    planners: list[str],
    robot: str,
    cell_m: float | None,
    smooth: bool,
    seeds: list[int],
    threads: int | None,
) -> str: ...
def explore(place: dict[str, Any], explorer: dict[str, Any], conditions: dict[str, Any]) -> dict[str, Any]: ...
