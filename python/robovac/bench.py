"""``python -m robovac.bench``: how many steps a second the environments make on this machine."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable
from typing import Any

#: Steps of a measurement, and how many of them there are of each kind, in turn; their median counts.
_STEPS = 40_000
_TIMES = 5


def _import_ms() -> float:
    """Time that a fresh interpreter takes longer with the import than without: the best of five, ms."""

    def best(code: str) -> float:
        def once() -> float:
            begin = time.perf_counter()
            subprocess.run([sys.executable, "-c", code], check=True)
            return time.perf_counter() - begin

        return min(once() for _ in range(5))

    return 1e3 * (best("import robovac") - best("pass"))


def _rates(num_envs: int, **settings: Any) -> tuple[float, float]:
    """Environment steps a second: natively, and from Python with the same actions."""
    import numpy as np

    from .gym import CleanVectorEnv

    envs = CleanVectorEnv(num_envs, **settings)
    envs.reset(seed=1)
    rng = np.random.default_rng(1)
    # Mostly ahead, with turns: a robot that never moves on costs less.
    actions = np.stack([rng.uniform(0.3, 1.0, num_envs), rng.normal(0.0, 0.3, num_envs)], axis=1)
    actions = actions.clip(-1, 1).astype(np.float32)
    # One thread by its own time, which other programs don't lengthen.
    clock = time.process_time if envs._batch.threads == 1 else time.perf_counter

    def rate(work: Callable[[int], object], count: int) -> float:
        envs.reset(seed=1)
        work(count // 4)
        begin = clock()
        work(count)
        return num_envs * count / (clock() - begin)

    def native(count: int) -> object:
        return envs._batch.bench(actions, envs._buffers, count)

    def from_python(count: int) -> object:
        return [envs.step(actions) for _ in range(count)]

    count = max(8, round(_STEPS / num_envs))
    rates = [(rate(native, count), rate(from_python, count)) for _ in range(_TIMES)]
    both = np.median(rates, axis=0)
    return float(both[0]), float(both[1])


def main() -> None:
    """Prints the table of docs/python.md."""
    print(f"import robovac: {_import_ms():.0f} ms")
    flat: dict[str, Any] = {"rooms": "flat", "threads": 1}
    cases: list[tuple[str, int, dict[str, Any]]] = [
        ("one core, 64 robots, readings, no noise", 64, {**flat, "slip": "none", "noise": "off"}),
        ("one core, 64 robots, readings", 64, flat),
        ("one core, 64 robots, patches", 64, {**flat, "observation": "map"}),
        ("one core, 1,024 robots, readings", 1024, flat),
        ("one core, 1,024 robots, patches", 1024, {**flat, "observation": "map"}),
        ("all cores, 1,024 robots, readings", 1024, {"rooms": "flat"}),
        ("all cores, 1,024 robots, patches", 1024, {"rooms": "flat", "observation": "map"}),
    ]
    print("| steps of 0.105 s a second | native | from Python | steps of the simulator |")
    print("|---|---:|---:|---:|")
    for name, num_envs, settings in cases:
        native, python = _rates(num_envs, **settings)
        print(f"| {name} | {native:,.0f} | {python:,.0f} | {7 * native:,.0f} |", flush=True)


if __name__ == "__main__":
    main()
