"""``python -m robovac.bench``: how many steps a second the environments make on this machine."""

from __future__ import annotations

import subprocess
import sys
import time
from typing import Any

#: Time of a measurement, s.
_WHILE_S = 3.0


def _import_ms() -> float:
    """Time that a fresh interpreter takes longer with the import than without: the best of five, ms."""

    def best(code: str) -> float:
        def once() -> float:
            begin = time.perf_counter()
            subprocess.run([sys.executable, "-c", code], check=True)
            return time.perf_counter() - begin

        return min(once() for _ in range(5))

    return 1e3 * (best("import robovac") - best("pass"))


def _steps(num_envs: int, **settings: Any) -> tuple[float, float]:
    """Environment steps a second: natively, and from Python with the same actions."""
    import numpy as np

    from .gym import CleanVectorEnv

    envs = CleanVectorEnv(num_envs, **settings)
    envs.reset(seed=1)
    rng = np.random.default_rng(1)
    # Mostly ahead, with turns: a robot that never moves on costs less.
    actions = np.stack([rng.uniform(0.3, 1.0, num_envs), rng.normal(0.0, 0.3, num_envs)], axis=1)
    actions = actions.clip(-1, 1).astype(np.float32)
    count = 1
    while (seconds := envs._batch.bench(actions, envs._buffers, count)) < 0.3:
        count *= 2
    count = max(1, round(count * _WHILE_S / seconds))
    native = num_envs * count / envs._batch.bench(actions, envs._buffers, count)
    envs.reset(seed=1)
    begin = time.perf_counter()
    for _ in range(count):
        envs.step(actions)
    return native, num_envs * count / (time.perf_counter() - begin)


def main() -> None:
    """Prints the table of docs/python.md."""
    print(f"import robovac                                   {_import_ms():9.0f} ms")
    quiet: dict[str, Any] = {"slip": "none", "noise": "off"}
    cases: list[tuple[str, int, dict[str, Any]]] = [
        ("1 thread, 64 robots, 33 readings, no noise", 64, {"threads": 1, **quiet}),
        ("1 thread, 64 robots, bumper alone (cbot), no noise", 64, {"threads": 1, "robot": "cbot", **quiet}),
        ("1 thread, 64 robots, 33 readings", 64, {"threads": 1}),
        ("1 thread, 64 robots, patches of 4 x 32 x 32", 64, {"threads": 1, "observation": "map"}),
        ("all cores, 1,024 robots, 33 readings", 1024, {"flats": 64}),
        ("all cores, 1,024 robots, patches of 4 x 32 x 32", 1024, {"observation": "map", "flats": 64}),
    ]
    print("steps of 0.105 s, each 7 steps of the simulator      native    from Python   simulator steps/s")
    for name, num_envs, settings in cases:
        native, python = _steps(num_envs, **settings)
        print(f"{name:50} {native:9,.0f}/s    {python:9,.0f}/s         {7 * native:11,.0f}", flush=True)


if __name__ == "__main__":
    main()
