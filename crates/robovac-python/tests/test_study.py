"""Studies, which the program `robovac` makes: it isn't in the wheel."""

import os
import signal

import pytest

from robovac import study

PROGRAM = os.environ.get("ROBOVAC", "")
pytestmark = pytest.mark.skipif(not os.path.exists(PROGRAM), reason="the program isn't built: cargo build -p robovac-cli")

STUDY = {
    "format": "robovac-study",
    "version": 1,
    "rooms": [{"room": "bedroom"}],
    "robots": [{"robot": "roomba600"}],
    "algorithms": [{"behaviour": "bounce"}, {"behaviour": "learned"}],
    "conditions": [{"name": "typical", "slip": "typical", "noise": "typical"}],
    "seeds": {"first": 1, "count": 120},
    "minutes": 4,
}


# slow: hundreds of runs, so that the interrupts come in the middle
def test_a_study_tells_how_far_it_is_and_loses_nothing_by_ctrl_c(tmp_path, capfd):
    # Shells have it ignored in what they start in the background.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    whole, stopped = tmp_path / "whole.parquet", tmp_path / "stopped.parquet"
    assert study.run(STUDY, whole, program=PROGRAM) == whole
    assert capfd.readouterr().err.endswith("240 of 240 runs, 100.0 %, 0:00 min left\n")

    def press_ctrl_c(done, runs, left_s):
        assert runs == 240
        if done > 0:
            assert left_s > 0
            signal.raise_signal(signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        study.run(STUDY, stopped, program=PROGRAM, jobs=1, progress=press_ctrl_c)
    kept = len(list((tmp_path / "stopped.parquet.shards").glob("*.jsonl")))
    assert 0 < kept < 5 and not stopped.exists()
    told = []
    study.run(STUDY, stopped, program=PROGRAM, progress=lambda *far: told.append(far))
    assert told[-1] == (240, 240, 0.0) and all(done >= 48 * kept for done, _, _ in told)
    assert stopped.read_bytes() == whole.read_bytes()
    with pytest.raises(study.StudyError, match="^--out .*the file exists"):
        study.run(STUDY, whole, program=PROGRAM)
