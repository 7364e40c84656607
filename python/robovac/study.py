"""Studies beyond one machine: the shards of `robovac study` on the cores of this machine or on a Ray cluster.

The program `robovac` makes the runs; it has to be on the path of every node, in the same version. A shard that a node
returned is stored on the disk of the caller before anything else happens, so a study that was stopped goes on where it
was, with either engine, and its results are the same bytes.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Any

from ._errors import RobovacError, UsageError

__all__ = ["StudyError", "run"]

#: Most parts into which a study is split for a cluster.
_MOST_PARTS = 2000


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
) -> Path:
    """Makes all runs of a study and writes the results as Parquet; returns the path of the results.

    study: path of the study file, or the study as a dict
    out: path of the results; its shards are in a folder of the same name with `.shards` behind it until it is complete
    engine: "local" for all cores of this machine, or "ray" for a Ray cluster
    program: path of the program `robovac`; by default the one on the path. On a cluster it is that of every node
    address: of the Ray cluster; by default the one that Ray finds, or else one on this machine
    jobs: runs in parallel of the engine "local"; by default one per core
    parts: tasks of the engine "ray"; by default one per shard, at most 2,000
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
            _call([program, "study", path, "--out", os.fspath(out), *(["--jobs", str(jobs)] if jobs else [])])
        elif engine == "ray":
            _run_on_ray(program, path, out, address, parts)
        else:
            raise UsageError(f'there is no engine "{engine}"; there are: local, ray')
    return Path(out)


def _call(command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        told = done.stderr.strip().removeprefix("robovac: ")
        raise StudyError(told or f"{command[0]} ended with {done.returncode}; the same call goes on where it was")
    return done.stdout


def _run_on_ray(program, study, out, address, parts):
    import ray

    if not ray.is_initialized():
        ray.init(address=address, log_to_driver=False)
    if os.path.exists(out):
        raise StudyError(f"{out}: the file exists; choose another name or delete it")
    _, shards = _counted(program, study)
    parts = min(parts or _MOST_PARTS, shards)
    store = Path(f"{os.fspath(out)}.shards")
    store.mkdir(parents=True, exist_ok=True)
    missing = [part for part in range(parts) if any(not (store / _name(shard)).exists() for shard in range(part, shards, parts))]
    files = ray.put(_bundle(study))
    # A node can be lost at any time: its tasks are made again elsewhere.
    task = ray.remote(num_cpus=1, max_retries=-1)(_make_part)
    waiting = [task.remote(program, files, part + 1, parts) for part in missing]
    while waiting:
        ready, waiting = ray.wait(waiting, num_returns=1)
        for name, content in ray.get(ready[0]).items():
            _put(store / name, content)
    _call([program, "study", "merge", study, "--out", os.fspath(out)])


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
