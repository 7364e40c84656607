"""Simulated runs, behaviours in Python, exploring, signals."""

import signal
import threading
import time
import xml.etree.ElementTree as xml

import numpy as np
import pytest
import robovac


class Bounce:
    """Straight on, and away from what it hits."""

    def __init__(self, speed_mps=0.3):
        self.speed, self.left = speed_mps, 0.0

    def step(self, sensed, dt_s):
        if sensed.bumped or sensed.sees_cliff:
            self.left = 1.2
        self.left -= dt_s
        return (self.speed, self.speed) if self.left <= 0 else (-0.2, 0.1)


def test_a_run_has_its_curve_its_trail_and_its_grid():
    run = robovac.simulate("bedroom", behaviour="bounce", max_time_s=300, slip="typical", noise="typical", seed=4)
    assert run.time_s == pytest.approx(300, abs=0.02) and not run.finished
    assert run.times_s.shape == run.coverages.shape == (301,)
    assert np.all(np.diff(run.coverages) >= 0) and run.coverages[-1] == run.coverage > 0.2
    assert run.poses.shape == run.estimates.shape == (301, 3)
    assert run.visits.shape == run.floor.shape and run.visits.dtype == np.uint8
    swept = ((run.visits > 0) & run.floor).sum() / run.floor.sum()
    assert swept == pytest.approx(run.coverage)
    assert np.hypot(*np.diff(run.trail_m, axis=0).T).sum() == pytest.approx(run.distance_m, rel=0.05)
    again = robovac.simulate("bedroom", behaviour="bounce", max_time_s=300, slip="typical", noise="typical", seed=4)
    assert again.digest == run.digest
    assert robovac.simulate("bedroom", behaviour="bounce", max_time_s=300, seed=5).digest != run.digest


def test_a_plan_is_driven_as_it_was_planned():
    plan = robovac.plan("room12ft", "boustrophedon", robot="roomba600")
    run = robovac.simulate(plan)
    assert run.finished and run.coverage == pytest.approx(plan.coverage, abs=0.02)
    assert np.array_equal(run.line_m, plan.line_m)
    assert robovac.simulate("room12ft", "boustrophedon").digest == run.digest
    smooth = robovac.simulate(plan, smooth=True)
    assert smooth.finished and smooth.time_s < run.time_s
    with pytest.raises(robovac.UsageError, match="either a planner or a behaviour"):
        robovac.simulate("room12ft")
    with pytest.raises(robovac.UsageError, match="driven as it is, by its own robot"):
        robovac.simulate(plan, robot="cbot")


def test_the_seed_of_a_run_changes_no_plan():
    plans = [robovac.plan("room12ft", "genetic", robot="roomba600", seed=seed) for seed in (1, 2)]
    assert not np.array_equal(plans[0].line_m, plans[1].line_m)
    for plan in plans:
        run = robovac.simulate(plan, slip="typical", seed=0, max_time_s=60)
        assert np.array_equal(run.line_m, plan.line_m) and run.seed == 0
    assert robovac.simulate(plans[1], max_time_s=5).seed == 2


def test_noise_is_chosen_for_each_kind_of_sensor():
    run = robovac.simulate("room12ft", behaviour="bounce", max_time_s=10, noise={"cliff": "harsh"})
    assert "cliff" in run.noise and "harsh" in run.noise
    for noise, words in [("loud", "there is no level of noise"), ({"nose": "harsh"}, "there is no kind of sensor")]:
        with pytest.raises(robovac.UsageError, match=words):
            robovac.simulate("room12ft", behaviour="bounce", noise=noise)
    with pytest.raises(robovac.UsageError, match="from 1 to 100"):
        robovac.simulate("room12ft", behaviour="bounce", charge_percent=0)


def test_a_class_is_a_behaviour_and_is_checked_like_one():
    robovac.contract.check_behaviour(Bounce)
    run = robovac.simulate("bedroom", behaviour=Bounce, max_time_s=120)
    assert run.coverage > 0.15 and run.bumps > 2 and run.driver == "Bounce"
    slow = robovac.simulate("bedroom", behaviour=Bounce, max_time_s=120, speed_mps=0.1)
    assert slow.distance_m < 0.6 * run.distance_m
    assert robovac.simulate("bedroom", behaviour=Bounce(), max_time_s=120).digest == run.digest


def test_faults_of_behaviours_are_told_in_words():
    class Answers:
        answer = None

        def step(self, sensed, dt_s):
            return self.answer

    def refused(answer, words):
        with pytest.raises(robovac.ContractError, match=words):
            robovac.contract.check_behaviour(type("Odd", (Answers,), {"answer": answer}))

    refused((0.1, float("nan")), "must return the speeds of the left and right wheel")
    refused((0.1,), "must return the speeds")
    refused("ahead", "must return the speeds|step fails")
    refused((0.0, 0.0), "it sweeps 0.. % of a room of 12 ft")

    class Broken:
        def step(self, sensed, dt_s):
            return (0.1, 0.1) if not sensed.bumped else sensed.nothing

    with pytest.raises(robovac.ContractError, match="step fails at readings {'bump_left': True}"):
        robovac.contract.check_behaviour(Broken)
    with pytest.raises(AttributeError, match="nothing"):
        robovac.simulate("bedroom", behaviour=Broken)
    with pytest.raises(robovac.ContractError, match="it returned \\(1, 2, 3\\)"):
        robovac.simulate("bedroom", behaviour=type("Odd", (Answers,), {"answer": (1, 2, 3)}))
    with pytest.raises(robovac.ContractError, match="has no step"):
        robovac.simulate("bedroom", behaviour=object)
    array = type("Array", (Answers,), {"answer": np.array([0.3, 0.3])})
    assert robovac.simulate("bedroom", behaviour=array, max_time_s=5).distance_m > 1


def test_exploring_makes_a_map_that_can_be_planned_in():
    explored = robovac.explore("room12ft", "wall_follow", max_time_s=120, noise="typical", slip="typical", seed=1)
    assert explored.map is not None and explored.right > 0.9 and explored.boundary > 0.5
    assert explored.pose_error_m < 0.3 and explored.poses.shape == explored.estimates.shape
    assert explored.map.cells.max() == 100 and explored.known_cells > 100
    assert robovac.plan(explored.map, "snake").visited_cells > 10
    xml.fromstring(explored._repr_svg_())
    with pytest.raises(robovac.UsageError, match='tracking can\'t be "gps"'):
        robovac.explore("room12ft", tracking="gps")


def test_runs_draw_themselves():
    svg = robovac.simulate("flat", behaviour="bounce", max_time_s=600)._repr_svg_()
    root = xml.fromstring(svg)
    assert len(svg) < 1_000_000 and root.findall(".//{*}polyline")


# slow: it waits for signals and for a thread
def test_long_work_ends_by_a_signal_and_lets_other_threads_go_on():
    class Stopped(Exception):
        pass

    def stop(*_):
        raise Stopped

    before = signal.signal(signal.SIGALRM, stop)
    try:
        for work in (
            lambda: robovac.simulate("hall20", behaviour="bounce", max_time_s=1e9),
            lambda: robovac.explore("hall20", "wall_follow", max_time_s=1e9),
            lambda: robovac.plan("hall20", "near_optimal", effort=100),
            lambda: robovac.compare("hall20", [("near_optimal", {"effort": 100})], seeds=4),
        ):
            ticks = []
            ticker = threading.Thread(target=lambda: [ticks.append(time.sleep(0.01)) for _ in range(10)])
            ticker.start()
            # Soon: a run is over when its battery is empty, which takes 0.3 s.
            signal.setitimer(signal.ITIMER_REAL, 0.1)
            begin = time.monotonic()
            with pytest.raises(Stopped):
                work()
            assert time.monotonic() - begin < 5 and len(ticks) > 3
            ticker.join()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
