"""`robovac virtual-roomba` as a child process, with its orders."""

import json
import os
import subprocess
import tempfile
import time


class VirtualRoomba:
    """A running program; its serial port is `port`."""

    def __init__(self, program, *arguments):
        self.port = os.path.join(tempfile.mkdtemp(prefix="robovac-"), "roomba")
        command = [program, "virtual-roomba", "--pty", self.port, "--control", *arguments]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        ready = self.process.stdout.readline()
        assert ready == f"ready {self.port}\n", ready

    def __enter__(self):
        return self

    def __exit__(self, *_):
        # The end of its input ends it.
        self.process.stdin.close()
        assert self.process.wait(10) == 0
        os.rmdir(os.path.dirname(self.port))

    def order(self, order):
        self.process.stdin.write(order + "\n")
        self.process.stdin.flush()

    def state(self):
        """What is really so, whatever the robot says."""
        self.order("state")
        return json.loads(self.process.stdout.readline())

    def wait_for(self, what, holds, seconds=15.0):
        begin = time.monotonic()
        while not holds(state := self.state()):
            assert time.monotonic() - begin < seconds, f"{what}: {state}"
            time.sleep(0.01)
        return state
