"""Studies beyond one machine: the shards of `robovac study` on the cores of this machine or on a Ray cluster.

The program `robovac` makes the runs; it has to be on the path of every node, in the same version. A shard that a node
returned is stored on the disk of the caller before anything else happens, so a stopped study continues where it left off,
with either engine, and its results are the same bytes.
"""

from __future__ import annotations

import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from ._errors import RobovacError, UsageError

__all__ = ["StudyError", "run"]

#: Most parts into which a study is split for a cluster.
_MOST_PARTS = 2000
#: Time between two looks at how far a study on this machine is, s.
_LOOK_S = 0.5
#: Least time between two lines of progress where they can't replace each other, s.
_QUIET_S = 10.0


class StudyError(RobovacError, RuntimeError):
    """The program refuses the study or can't make it; the text is its message."""


def run(
    study: str | os.PathLike[str] | dict[str, Any],
    out: str | os.PathLike[str],
    *,
    engine: str = "local",
    program: str | None = None,
    address: str | None = None,
    jobs: int | None = None,
    parts: int | None = None,
    progress: bool | Callable[[int, int, float | None], None] = True,
) -> Path:
    """Makes all runs of a study and writes the results as Parquet; returns the path of the results.

    study: path of the study file, or the study as a dict
    out: path of the results; its shards are in a folder of the same name with `.shards` behind it until it is complete
    engine: "local" for all cores of this machine, or "ray" for a Ray cluster
    program: path of the program `robovac`; by default the one on the path. On a cluster it is that of every node
    address: of the Ray cluster; by default the one that Ray finds, or else one on this machine
    jobs: runs in parallel of the engine "local"; by default one per core
    parts: tasks of the engine "ray"; by default one per shard, at most 2,000
    progress: whether stderr tells how many runs are done and how long the rest takes, or a function that is called with the
        runs that are done, all runs and the seconds left (None before the first are done)

    Ctrl-C, or an exception of `progress`, ends the work on all nodes. Finished shards are kept: the same call goes on.
    """
    program = program or shutil.which("robovac")
    if program is None:
        raise StudyError("the program robovac isn't on the path; give program=")
    with tempfile.TemporaryDirectory(prefix="robovac-study-") as folder:
        if isinstance(study, dict):
            path = os.path.join(folder, "study.json")
            Path(path).write_text(json.dumps(study))
        else:
            path = os.fspath(study)
        if engine == "local":
            far = _Far(progress, *_counted(program, path), out)
            _call([program, "study", path, "--out", os.fspath(out), *(["--jobs", str(jobs)] if jobs else [])], far.look)
            far.end()
        elif engine == "ray":
            _run_on_ray(program, path, out, address, parts, progress)
        else:
            raise UsageError(f'there is no engine "{engine}"; there are: local, ray')
    return Path(out)


class _Far:
    """How far a study is, by the shards that are stored."""

    def __init__(self, progress, runs, shards, out):
        self.tell = progress if callable(progress) else self.write if progress else None
        self.runs, self.shards, self.store = runs, shards, _store(out)
        self.before, self.begin = self.count(), time.monotonic()
        self.said = None

    def count(self):
        return len(list(self.store.glob("*.jsonl")))

    def look(self):
        if self.tell is None:
            return
        there = self.count()
        made = there - self.before
        left = (time.monotonic() - self.begin) / made * (self.shards - there) if made > 0 else None
        # The last shard may have fewer runs.
        self.tell(self.runs * there // self.shards, self.runs, left)

    def end(self):
        if self.tell is not None:
            self.tell(self.runs, self.runs, 0.0)

    def write(self, done, runs, left):
        """Writes a line to stderr, in the place of the last one if that is a terminal."""
        now, replaces, is_end = time.monotonic(), sys.stderr.isatty(), done == runs
        if not (replaces or is_end or now - (self.said or self.begin) >= _QUIET_S):
            return
        self.said = now
        rest = "" if left is None else f", {_time(left)} left"
        text = f"{done} of {runs} runs, {100 * done / max(runs, 1):.1f} %{rest}"
        start, end = ("\r", "   \n" if is_end else "   ") if replaces else ("", "\n")
        print(f"{start}{text}", end=end, file=sys.stderr, flush=True)


def _time(seconds):
    minutes, seconds = divmod(math.ceil(seconds), 60)
    return f"{minutes // 60}:{minutes % 60:02}:{seconds:02} h" if minutes >= 60 else f"{minutes}:{seconds:02} min"


def _call(command, look=lambda: None):
    """What a command prints; calls `look` now and then. An exception meanwhile ends the command, too."""
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        try:
            while True:
                try:
                    printed, told = process.communicate(timeout=_LOOK_S)
                    break
                except subprocess.TimeoutExpired:
                    look()
        except BaseException:
            # What it has stored is complete at any moment.
            process.kill()
            raise
    if process.returncode != 0:
        # Lines of progress come before it.
        _, _, fault = f"\n{told}".rpartition("\nrobovac: ")
        raise StudyError(fault.strip() or f"{command[0]} ended with {process.returncode}; the same call goes on where it was")
    return printed


def _store(out):
    return Path(f"{os.fspath(out)}.shards")


def _run_on_ray(program, study, out, address, parts, progress):
    import ray

    if not ray.is_initialized():
        ray.init(address=address, log_to_driver=False)
    if os.path.exists(out):
        raise StudyError(f"{out}: the file exists; choose another name or delete it")
    runs, shards = _counted(program, study)
    parts = min(parts or _MOST_PARTS, shards)
    store = _store(out)
    store.mkdir(parents=True, exist_ok=True)
    missing = [part for part in range(parts) if any(not (store / _name(shard)).exists() for shard in range(part, shards, parts))]
    files = ray.put(_bundle(study))
    # A node can be lost at any time: its tasks are made again elsewhere.
    task = ray.remote(num_cpus=1, max_retries=-1)(_make_part)
    waiting = [task.remote(program, files, part + 1, parts) for part in missing]
    far = _Far(progress, runs, shards, out)
    try:
        while waiting:
            ready, waiting = ray.wait(waiting, num_returns=1)
            for name, content in ray.get(ready[0]).items():
                _put(store / name, content)
            far.look()
    finally:
        for one in waiting:
            ray.cancel(one)
    _call([program, "study", "merge", study, "--out", os.fspath(out)])
    far.end()


def _counted(program, study):
    """Numbers of runs and of shards."""
    text = _call([program, "study", "check", study])
    found = re.match(r"(\d+) runs in \d+ rooms, (\d+) shards", text)
    if found is None:
        raise StudyError(f"{program}: another version than this module: {text!r}")
    return int(found[1]), int(found[2])


def _name(shard):
    return f"{shard:08}.jsonl"


def _bundle(study):
    """The study and the maps that it names, by their names: what a node needs."""
    folder = Path(study).parent
    content = Path(study).read_bytes()
    files = {"study.json": content}
    for room in json.loads(content)["rooms"]:
        if "file" in room:
            named = folder / room["file"]
            # A ROS map has its image beside it.
            for file in named.parent.glob(named.stem + ".*"):
                files[os.path.relpath(file, folder)] = file.read_bytes()
    return files


def _make_part(program, files, part, parts):
    """On a node: makes a part and returns its shards by their names."""
    with tempfile.TemporaryDirectory(prefix="robovac-study-") as folder:
        for name, content in files.items():
            path = Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
        out = os.path.join(folder, "results.parquet")
        _call([program, "study", os.path.join(folder, "study.json"), "--out", out, "--shard", f"{part}/{parts}", "--jobs", "1"])
        made = Path(f"{out}.shards")
        return {file.name: file.read_bytes() for file in made.iterdir() if file.suffix == ".jsonl" or file.name == "identity"}


def _put(path, content):
    """Stores a file completely or not at all."""
    part = path.with_name(f".{path.name}.{os.getpid()}")
    with open(part, "wb") as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())
    os.replace(part, path)
    folder = os.open(path.parent, os.O_RDONLY)
    try:
        os.fsync(folder)
    finally:
        os.close(folder)
