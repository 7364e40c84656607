"""The results of a study as Parquet, read by Apache Arrow's own reader, which knows nothing of this project."""

import json
import os
import subprocess
import sys
import tempfile

import pyarrow.compute as compute
import pyarrow.parquet as parquet

STUDY = {
    "format": "robovac-study",
    "version": 1,
    "rooms": [{"flats": {"first": 3, "count": 2, "area_m2": [25, 30]}}, {"room": "thesis8"}],
    "robots": [{"robot": "roomba600"}],
    "algorithms": [{"behaviour": "bounce"}, {"planner": "snake", "params": {"patience": 3}}],
    "conditions": [{"name": "slippery", "slip": "harsh", "noise": {"cliff": "typical"}}],
    "seeds": {"first": 10, "count": 2},
    "minutes": 1,
    "curve": 4,
}


def main(program):
    with tempfile.TemporaryDirectory(prefix="robovac-") as folder:
        study, out = os.path.join(folder, "study.json"), os.path.join(folder, "results.parquet")
        with open(study, "w") as file:
            json.dump(STUDY, file)
        subprocess.run([program, "study", study, "--out", out], check=True, capture_output=True)
        file = parquet.ParquetFile(out)
        told = {key.decode(): value.decode() for key, value in file.metadata.metadata.items()}
        assert json.loads(told["robovac.study"])["seeds"] == STUDY["seeds"], told
        table = file.read()
        rows = table.to_pylist()
        assert [row["run"] for row in rows] == list(range(12)), rows
        assert [row["room"] for row in rows[::4]] == ["flat:3~area:25..30", "flat:4~area:25..30", "thesis8"], rows
        assert [row["seed"] for row in rows[:4]] == [10, 11, 10, 11], rows
        assert {row["params"] for row in rows} == {"", "patience:3"}, rows
        assert {row["noise"] for row in rows} == {"cliff=typical"} and {row["slip"] for row in rows} == {"harsh"}
        for row in rows:
            if row["error"] is not None:
                assert row["coverage"] is None and row["curve"] == [], row
                continue
            assert 0 < row["coverage"] <= 1 and abs(row["curve"][-1] - row["coverage"]) < 1e-6, row
            assert len(row["curve"]) == 5 and row["curve"] == sorted(row["curve"]), row
            assert len(row["digest"]) == 16 and int(row["digest"], 16) >= 0, row
        assert sum(row["error"] is None for row in rows) >= 8, [row["error"] for row in rows]
        assert compute.mean(table["distance_m"]).as_py() > 1
        # Each row's command makes the same run.
        row = next(row for row in rows if row["kind"] == "planner" and row["error"] is None)
        again = subprocess.run([program, *row["command"].split()[1:]], check=True, capture_output=True, text=True)
        (run,) = json.loads(again.stdout)["algorithms"][0]["each"]
        assert run["digest"] == row["digest"], (run, row)
    print("    parquet: results of a study are read")


main(sys.argv[1])
