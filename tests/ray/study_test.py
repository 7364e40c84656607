"""A study on a Ray cluster of two nodes, which is interrupted, goes on, and loses a node by a kill: the results are those of one
machine.

    ./dev python
    python3 -m venv target/ray && target/ray/bin/pip install -r tests/ray/requirements.txt target/wheels/robovac-*.whl
    target/ray/bin/python tests/ray/study_test.py target/debug/robovac
"""

import os
import sys
import tempfile
import threading
import time
from pathlib import Path

import ray
from ray.cluster_utils import Cluster

from robovac import study

STUDY = {
    "format": "robovac-study",
    "version": 1,
    "rooms": [{"flats": {"first": 1, "count": 2, "area_m2": [25, 30]}}],
    "robots": [{"robot": "roomba600"}],
    "algorithms": [{"behaviour": "bounce"}, {"behaviour": "random_walk"}],
    "conditions": [{"name": "typical", "slip": "typical", "noise": "typical"}],
    "seeds": {"first": 1, "count": 250},
    "minutes": 4,
}


def main(program):
    program = os.path.abspath(program)
    with tempfile.TemporaryDirectory(prefix="robovac-") as folder:
        one, many = Path(folder, "one.parquet"), Path(folder, "many.parquet")
        study.run(STUDY, one, program=program)
        cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 1, "include_dashboard": False})
        worker = cluster.add_node(num_cpus=1)
        ray.init(address=cluster.address, log_to_driver=False)
        assert ray.cluster_resources()["CPU"] == 2, ray.cluster_resources()

        def interrupt(done, runs, left_s):
            assert runs == 1000 and left_s > 0
            if done >= 100:
                raise KeyboardInterrupt

        try:
            study.run(STUDY, many, engine="ray", program=program, progress=interrupt)
            raise AssertionError("it wasn't interrupted")
        except KeyboardInterrupt:
            pass
        shards = Path(f"{many}.shards")
        kept = len(list(shards.glob("*.jsonl")))
        assert 2 <= kept < 20, kept
        # Its tasks have ended, too.
        late = time.monotonic() + 60
        while ray.available_resources().get("CPU", 0) < 2:
            assert time.monotonic() < late, ray.available_resources()
            time.sleep(0.1)
        failed = []

        def work():
            try:
                study.run(STUDY, many, engine="ray", program=program)
            except Exception as error:
                failed.append(error)

        # With a runtime of its own, as the test goes on meanwhile.
        thread = threading.Thread(target=work)
        thread.start()
        while len(list(shards.glob("*.jsonl"))) < kept + 3 and thread.is_alive():
            time.sleep(0.01)
        left = len(list(shards.glob("*.jsonl")))
        cluster.remove_node(worker, allow_graceful=False)
        assert left < 20, "the node was killed too late"
        thread.join()
        assert not failed, failed
        # Ray notices it by and by.
        late = time.monotonic() + 60
        while sum(node["Alive"] for node in ray.nodes()) > 1:
            assert time.monotonic() < late, ray.nodes()
            time.sleep(0.1)
        assert one.read_bytes() == many.read_bytes(), "other results"
        ray.shutdown()
        cluster.shutdown()
    print(f"    ray: a node was killed after {left} of 20 shards; the results are the same bytes")


main(sys.argv[1])
