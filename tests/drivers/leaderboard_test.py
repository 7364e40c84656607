"""The leaderboard of docs/teaching.md: a workflow that GitHub takes, whose command marks the answers that lie beside it."""

import pathlib
import subprocess
import sys
import tempfile

from ruamel.yaml import YAML

ROOT = pathlib.Path(__file__).resolve().parents[2]
robovac = pathlib.Path(sys.argv[1]).resolve()

text = (ROOT / "docs/teaching.md").read_text(encoding="utf-8")
workflow = YAML(typ="safe").load(text.split("```yaml\n")[1].split("```")[0])
assert workflow["on"]["push"]["paths"] == ["answers/**"], workflow["on"]
(job,) = workflow["jobs"].values()
# Pages refuses what comes from a job without it.
assert job["environment"] == "github-pages" and workflow["permissions"]["pages"] == "write"
assert workflow["permissions"]["id-token"] == "write" and job["runs-on"] == "ubuntu-latest"
assert all(("uses" in step) != ("run" in step) for step in job["steps"]), job["steps"]
used = [step["uses"].split("@")[0] for step in job["steps"] if "uses" in step]
assert used == ["actions/checkout", "actions/checkout", "actions/upload-pages-artifact", "actions/deploy-pages"], used

(manifest,) = [word for step in job["steps"] for word in step.get("run", "").split() if word.endswith("Cargo.toml")]
assert (ROOT / manifest.removeprefix("robovac/")).is_file(), manifest
(command,) = [step["run"] for step in job["steps"] if " grade " in step.get("run", "")]
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    built = folder / "robovac/target/release"
    built.mkdir(parents=True)
    (built / "robovac").symlink_to(robovac)
    (folder / "answers").mkdir()
    (folder / "lesson.md").write_bytes((ROOT / "lessons/09-real-robot.md").read_bytes())
    (folder / "answers/ada.json").write_bytes((ROOT / "lessons/answers/09-real-robot.json").read_bytes())
    subprocess.run(["bash", "-ec", command], cwd=folder, check=True)
    (upload,) = [step["with"]["path"] for step in job["steps"] if "upload" in step.get("uses", "")]
    page = (folder / upload / "index.html").read_text(encoding="utf-8")
assert "<table" in page and "Answer" in page, page
print("leaderboard: the workflow is in order, and its command marks answers")
