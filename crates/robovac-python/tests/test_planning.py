"""Rooms, plans, comparisons."""

import copy
import dataclasses
import json
import pickle
import pickle
import xml.etree.ElementTree as xml

import numpy as np
import pytest
import robovac

TEXT = """
; resolution 0.2
S....
..#..
.....
"""


def test_a_room_is_the_same_whatever_describes_it(tmp_path):
    text = robovac.Room.from_text(TEXT, name="Nook")
    assert (text.name, text.resolution_m, text.cells.shape) == ("Nook", 0.2, (3, 5))
    assert text.cells[1].tolist() == [0, 0, 100, 0, 0]
    array = robovac.Room.from_array(text.cells, resolution_m=0.2, start=(0.1, 0.5, 0.0))
    assert np.array_equal(array.cells, text.cells) and array.start == text.start
    flags = robovac.Room.from_array(text.cells != 0, resolution_m=0.2)
    assert np.array_equal(flags.cells, text.cells)
    path = tmp_path / "nook.txt"
    path.write_text(text.to_text())
    plans = [robovac.plan(room, "snake") for room in (text, TEXT, path, str(path), array)]
    assert all(np.array_equal(plan.cells, plans[0].cells) for plan in plans)
    again = pickle.loads(pickle.dumps(robovac.Room.shipped("flat")))
    assert np.array_equal(again.cells, robovac.Room.shipped("flat").cells)


def test_ros_maps_and_drawings_are_read_as_the_command_line_reads_them(tmp_path):
    (tmp_path / "map.pgm").write_bytes(b"P5 3 2 255\n" + bytes([0, 254, 254, 254, 254, 205]))
    (tmp_path / "map.yaml").write_text(
        "image: map.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"
    )
    room = robovac.Room.open(tmp_path / "map.yaml")
    assert room.cells.tolist() == [[0, 0, -1], [100, 0, 0]] and room.resolution_m == 0.5
    square = '<svg xmlns="http://www.w3.org/2000/svg"><rect x="0" y="0" width="3000" height="2000" fill="none" stroke="black"/></svg>'
    (tmp_path / "room.svg").write_text(square)
    with pytest.raises(robovac.UsageError, match="unit"):
        robovac.Room.open(tmp_path / "room.svg")
    drawn = robovac.Room.open(tmp_path / "room.svg", units="mm")
    assert 2.9 < drawn.width_m < 3.5 and 1.9 < drawn.height_m < 2.5


def test_a_plan_has_its_walk_its_line_and_its_numbers():
    plan = robovac.plan(TEXT, "boustrophedon")
    assert plan.cells.dtype == np.int32 and plan.cells.shape == (plan.steps + 1, 2)
    assert tuple(plan.cells[0]) == plan.start == (0, 2)
    assert plan.visited_cells == plan.reachable_cells == plan.free.sum() == 14
    assert plan.coverage == 1.0 and plan.steps >= plan.bound_steps
    assert plan.line_m[0].tolist() == pytest.approx([0.1, 0.5])
    assert plan.length_m == pytest.approx(np.hypot(*np.diff(plan.line_m, axis=0).T).sum())
    assert set(plan.metrics) == set(robovac.metrics())
    assert plan.metrics["steps"] == plan.steps


@pytest.mark.parametrize("planner", list(robovac.planners()))
def test_every_planner_of_the_list_plans(planner):
    robot = "roomba600"
    plan = robovac.plan("room12ft", planner, robot=robot, seed=2)
    assert plan.planner == planner and plan.coverage > 0.7 and len(plan.line_m) > 2


def test_parameters_are_those_of_the_command_line():
    plain = robovac.plan("clutter", "snake")
    patient = robovac.plan("clutter", "snake", patience=5)
    assert patient.params["patience"] == 5.0 and plain.params["patience"] == 2.0
    with pytest.raises(robovac.UsageError, match='there is no parameter "pace"; there are: '):
        robovac.plan("clutter", "snake", pace=1)
    with pytest.raises(robovac.UsageError, match="use a whole number from 0 to 20"):
        robovac.plan("clutter", "snake", patience="fast")
    suited = robovac.plan("bedroom", robot="roomba600", coverage_percent=95)
    plain = robovac.plan("bedroom", robot="roomba600")
    assert suited.coverage > 0.9 and suited.cell_m != plain.cell_m
    assert plain.cell_offset_m == (0.0, 0.0) and all(0 <= by < suited.cell_m for by in suited.cell_offset_m)
    with pytest.raises(robovac.UsageError, match='the planner "lanes" needs no planning cells'):
        robovac.plan("bedroom", "lanes", robot="roomba600", coverage_percent=95)
    with pytest.raises(robovac.UsageError, match="the coverage can't be 120 %"):
        robovac.plan("bedroom", robot="roomba600", coverage_percent=120)


def snake_by_rows(job):
    """Row by row, in rooms without obstacles."""
    height, width = job.free.shape
    return [(x if y % 2 == 0 else width - 1 - x, y) for y in range(height) for x in range(width)]


def depth_first(job):
    """Into every cell and back."""
    walk, seen, way = [job.start], {job.start}, [job.start]
    while way:
        x, y = way[-1]
        for cell in ((x + 1, y), (x, y + 1), (x - 1, y), (x, y - 1)):
            inside = 0 <= cell[0] < job.free.shape[1] and 0 <= cell[1] < job.free.shape[0]
            if inside and cell not in seen and job.free[cell[1], cell[0]]:
                seen.add(cell)
                way.append(cell)
                walk.append(cell)
                break
        else:
            way.pop()
            walk.extend(way[-1:])
    return walk


def test_a_function_is_a_planner_and_is_checked_like_one():
    room = robovac.Room.from_array(np.zeros((4, 6)), resolution_m=0.3)
    plan = robovac.plan(room, snake_by_rows)
    assert (plan.planner, plan.steps, plan.turns, plan.coverage) == ("snake_by_rows", 23, 6, 1.0)
    robovac.contract.check_planner(depth_first)
    run = robovac.simulate(robovac.plan("bedroom", depth_first, robot="roomba600"))
    assert run.finished and run.coverage > 0.8 and run.driver == "depth_first"


def test_faults_of_planners_are_told_in_words():
    def refused(planner, words):
        with pytest.raises(robovac.ContractError, match=words):
            robovac.contract.check_planner(planner)

    refused(lambda job: [], r"returned an invalid walk: the walk doesn't start in \(0, 0\)")
    refused(lambda job: [job.start, (job.start[0] + 2, job.start[1])], "isn't free|doesn't lead to a neighbouring cell")
    refused(lambda job: [job.start], "it visits 1 of 2 cells; give complete=False")
    refused(lambda job: [(0.5, 0)], "must return cells \\(x, y\\) of whole numbers; 0.5 isn't the number of a cell")
    refused(lambda job: None, "must return cells")
    times = iter(range(1000))

    def moody(job):
        walk = depth_first(job)
        return walk if next(times) % 2 else walk[:1]

    refused(moody, "the same seed gives another walk")


def test_errors_are_the_command_lines_sentences():
    for call, error, words in [
        (lambda: robovac.plan("bedrom"), robovac.UsageError, r'there is no room "bedrom"; robovac.rooms\(\) lists them'),
        (lambda: robovac.plan("bedroom", "snail"), robovac.UsageError, r'there is no planner "snail"'),
        (lambda: robovac.plan("bedroom", "bounce"), robovac.UsageError, r'"bounce" is a behaviour: simulate\(room, behav'),
        (lambda: robovac.plan("bedroom", 3), robovac.UsageError, "planner can't be 3"),
        (lambda: robovac.plan("bedroom", seed=-1), robovac.UsageError, "seed can't be -1; use a whole number from 0 to"),
        (lambda: robovac.plan("bedroom", start=(1.5, 2)), robovac.UsageError, r"start can't be \(1.5, 2\): .*float"),
        (lambda: robovac.plan("nowhere.png"), robovac.FileError, "nowhere.png: .*; check the path"),
        (lambda: robovac.plan(None), robovac.UsageError, "a room can't be None"),
        (lambda: robovac.plan(np.ones((9, 9))), robovac.MapError, "the array has no free cell"),
        (lambda: robovac.Room.flat(1.5), robovac.UsageError, "seed can't be 1.5"),
        (lambda: robovac.simulate("bedroom", behaviour="bounce", noise=3), robovac.UsageError, "noise can't be"),
        (lambda: robovac.simulate("bedroom", behaviour="bounce", max_time_s="1h"), robovac.UsageError, "max_time_s can't be '1h'"),
        (lambda: robovac.plan("bedroom", robot="r2d2"), robovac.UsageError, r'there is no robot "r2d2"'),
        (lambda: robovac.plan(TEXT, start=(2, 1)), robovac.PlacementError, r"the start cell \(2, 1\) is inside a wall"),
        (lambda: robovac.plan("...\n...", robot="roomba600"), robovac.PlacementError, "robot"),
        (lambda: robovac.plan("..x\n..."), robovac.MapError, "x"),
        (lambda: robovac.Room.open("nowhere.txt"), robovac.FileError, "nowhere.txt: .*; check the path"),
        (lambda: robovac.Room.from_array(np.zeros(3)), robovac.UsageError, "rows and columns"),
        (lambda: robovac.Room.from_array(np.zeros((2, 2)), resolution_m=-1), robovac.MapError, "-1"),
        (lambda: robovac.Room.from_array(np.zeros((0, 2))), robovac.MapError, "rows and columns, not 0 x 2"),
        (lambda: robovac.plan(TEXT, cell_m=float("nan")), robovac.UsageError, "planning cells of NaN m"),
    ]:
        with pytest.raises(error, match=words) as caught:
            call()
        assert isinstance(caught.value, robovac.RobovacError)


def test_a_comparison_has_a_row_for_each_trial():
    compared = robovac.compare(["thesis8", TEXT], ["snake", ("snake", {"patience": 5}), "genetic", depth_first], seeds=2)
    assert len(compared) == 2 * (1 + 1 + 2 + 1)
    assert all(trial.error is None and trial.metrics["coverage"] == 100.0 for trial in compared)
    table, name = compared.table("steps"), robovac.rooms()["thesis8"]["title"]
    assert set(table) == {"snake~patience:2", "snake~patience:5", "genetic", "depth_first"}
    assert table["depth_first"][name] > table["snake~patience:2"][name]
    first = compared.records()[0]
    assert first["room"] == name and first["params"] == "patience:2~rules:text"
    assert set(robovac.compare("thesis8", "snake").table()) == {"snake"}
    for call, words in [
        (lambda: compared.table("speed"), 'there is no metric "speed"'),
        (lambda: robovac.compare("thesis8", "snake", seeds=0), "at least one seed"),
        (lambda: robovac.compare("thesis8", "snake", seeds=[-1]), "seeds can't be -1"),
    ]:
        with pytest.raises(robovac.UsageError, match=words):
            call()
    assert robovac.compare("...\n...", ["snake"], robot="roomba600").trials[0].error is not None


def test_plans_can_be_pickled_and_copied():
    plan = robovac.plan(robovac.Room.flat(3, area_m2=(25, 40)), "snake", robot="roomba600")
    again = pickle.loads(pickle.dumps(plan))
    assert np.array_equal(again.line_m, plan.line_m) and np.array_equal(again.room.cells, plan.room.cells)
    assert robovac.simulate(copy.deepcopy(plan), max_time_s=30).digest == robovac.simulate(plan, max_time_s=30).digest
    assert dataclasses.asdict(plan)["length_m"] == plan.length_m


def test_rooms_and_paths_draw_themselves():
    room = robovac.Room.shipped("flat")
    for drawn in (room, robovac.plan(room, "spiral_stc")):
        svg = drawn._repr_svg_()
        root = xml.fromstring(svg)
        assert root.tag.endswith("svg") and float(root.get("width")) <= 720
        assert len(svg) < 300_000
    json.loads(room.to_scenario())
