"""Tasks that events start."""

from robovac_program.motions import Motion


class Pause(Motion):
    """Until the next step."""

    def step(self, robot):
        return True


async def hand_over():
    """Lets other tasks run."""
    await Pause()


class Event:
    """A function that is started by an event, unless it still runs."""

    def __init__(self, condition, task):
        self.condition = condition
        self.task = task
        self.is_running = False


def event(method, condition=None):
    """`@event(robot.when_bumped, [True, False])` before an async function."""

    def register(function):
        if condition is None:
            method(function)
        else:
            method(condition, function)
        return function

    return register
