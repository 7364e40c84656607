"""Runs, maps and sweeps as MCAP bags with ROS 2 messages, read by two readers that know nothing of this project: that of
Foxglove's project, which takes the definitions from the file, and rosbags, which brings its own and decodes CDR by itself.
"""

import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from rosbags.rosbag2 import Reader
from rosbags.typesys import Stores, get_types_from_msg, get_typestore


def read_mcap(file):
    """Messages by topic: (time in s, message)."""
    messages = {}
    with open(file, "rb") as stream:
        reader = make_reader(stream, decoder_factories=[DecoderFactory()])
        assert reader.get_header().profile == "ros2"
        for schema, channel, message, decoded in reader.iter_decoded_messages():
            messages.setdefault(channel.topic, []).append((message.log_time / 1e9, decoded))
    return messages


def read_rosbags(file):
    """The same by rosbags: standard messages are decoded by its own definitions, others by those in the file."""
    store = get_typestore(Stores.ROS2_JAZZY)
    messages, latched = {}, set()
    with Reader(Path(file)) as reader:
        for connection in reader.connections:
            if connection.msgtype not in store.types:
                store.register(get_types_from_msg(connection.msgdef.data, connection.msgtype))
            if any(profile.durability.name == "TRANSIENT_LOCAL" for profile in connection.ext.offered_qos_profiles):
                latched.add(connection.topic)
        for connection, time, data in reader.messages():
            messages.setdefault(connection.topic, []).append((time / 1e9, store.deserialize_cdr(data, connection.msgtype)))
    return messages, latched


def seconds(stamp):
    return stamp.sec + 1e-9 * stamp.nanosec


def heading(orientation):
    assert orientation.x == orientation.y == 0 and abs(math.hypot(orientation.z, orientation.w) - 1) < 1e-12
    return 2 * math.atan2(orientation.z, orientation.w)


def robot_on_map(at, transforms):
    """The pose of base_link in the map by the last transforms at a time."""
    place = (0.0, 0.0, 0.0)
    frame = "map"
    now = next(message for time, message in reversed(transforms) if time <= at)
    while frame != "base_link":
        (link,) = [link for link in now.transforms if link.header.frame_id == frame]
        x, y, turn = place
        shift, cos, sin = link.transform.translation, math.cos(turn), math.sin(turn)
        place = (x + cos * shift.x - sin * shift.y, y + sin * shift.x + cos * shift.y, turn + heading(link.transform.rotation))
        frame = link.child_frame_id
    return place


def is_wall(grid, column, row):
    """Whether a cell is occupied; everything outside is."""
    info = grid.info
    return not (0 <= column < info.width and 0 <= row < info.height) or grid.data[row * info.width + column] == 100


def same(name, ours, theirs):
    """Both readers have read the same numbers."""
    assert ours.keys() == theirs.keys(), (name, ours.keys() ^ theirs.keys())
    for topic, messages in ours.items():
        assert [time for time, _ in messages] == [time for time, _ in theirs[topic]], (name, topic)
        assert sorted(time for time, _ in messages) == [time for time, _ in messages], (name, topic)
    for (_, a), (_, b) in zip(ours["/odom"], theirs["/odom"]):
        assert a.pose.pose.position.x == b.pose.pose.position.x, (name, a, b)
        assert a.twist.twist.angular.z == b.twist.twist.angular.z, (name, a, b)
    for (_, a), (_, b) in zip(ours["/map"], theirs["/map"]):
        assert (a.info.width, a.info.height) == (b.info.width, b.info.height) and list(a.data) == list(b.data), name


def run(program, *arguments):
    result = subprocess.run([program, *arguments], check=True, capture_output=True, text=True)
    return result.stdout


def check_run(program, folder):
    """A CBot follows a plan: all topics of a robot with a laser."""
    file = os.path.join(folder, "run.mcap")
    report = json.loads(run(program, "simulate", "--room", "lshape", "--planner", "boustrophedon", "--robot", "cbot", "--slip", "typical", "--max-time", "60", "--json", "--mcap", file))
    messages = read_mcap(file)
    others, latched = read_rosbags(file)
    same("run", messages, others)
    assert latched == {"/map", "/plan", "/tf_static"}, latched
    # The report's last sample is the truth.
    end = report["samples"][-1]
    time, truth = messages["/ground_truth/odom"][-1]
    assert abs(time - end["time_s"]) < 0.1, (time, end)
    at = truth.pose.pose.position
    assert math.hypot(at.x - end["pose"]["x"], at.y - end["pose"]["y"]) < 0.05, (at, end)
    # Its estimate is what the frames say.
    x, y, turn = robot_on_map(time, messages["/tf"])
    estimate = end["estimate"]
    assert math.hypot(x - estimate["x"], y - estimate["y"]) < 0.05, (x, y, estimate)
    assert math.hypot(x - at.x, y - at.y) > 1e-3, "slip makes a difference"
    (_, room), = messages["/map"]
    assert room.header.frame_id == "map" and abs(room.info.resolution - 0.1) < 1e-6, room.info
    assert set(room.data) >= {0, 100} and room.info.width * room.info.height == len(room.data), room.info
    (_, plan), = messages["/plan"]
    first = plan.poses[0].pose.position
    assert math.hypot(first.x - report["samples"][0]["pose"]["x"], first.y - report["samples"][0]["pose"]["y"]) < 1e-9
    assert seconds(plan.poses[-1].header.stamp) > 60, plan.poses[-1]
    # A scan hits what the map has: the points of the first one end at an occupied cell, or beside one. The outside is wall.
    (_, mounted), = messages["/tf_static"]
    (link,) = mounted.transforms
    assert (link.header.frame_id, link.child_frame_id) == ("base_link", "laser"), link
    time, scan = messages["/scan"][0]
    x, y, turn = robot_on_map(time, messages["/tf"])
    shift = link.transform.translation
    x, y = x + math.cos(turn) * shift.x - math.sin(turn) * shift.y, y + math.sin(turn) * shift.x + math.cos(turn) * shift.y
    hits = found = 0
    for i, distance in enumerate(scan.ranges):
        if not math.isfinite(distance):
            continue
        hits += 1
        angle = turn + scan.angle_min + i * scan.angle_increment
        column, row = (math.floor((at + distance * way) / room.info.resolution) for at, way in ((x, math.cos(angle)), (y, math.sin(angle))))
        near = ((column + dx, row + dy) for dx in (-1, 0, 1) for dy in (-1, 0, 1))
        found += any(is_wall(room, i, j) for i, j in near)
    assert hits > 100 and found / hits > 0.95, (hits, found)
    assert abs(scan.angle_min + (len(scan.ranges) - 1) * scan.angle_increment - scan.angle_max) < 1e-4, scan.angle_max
    # Commands are what the wheels follow.
    assert max(twist.linear.x for _, twist in messages["/cmd_vel"]) > 0.1
    speeds = [odometry.twist.twist.linear.x for _, odometry in messages["/odom"]]
    assert 0.1 < max(speeds) < 1, max(speeds)
    print(f"    run: {sum(map(len, messages.values()))} messages on {len(messages)} topics, {os.path.getsize(file) / 1e6:.1f} MB")


def check_bumps(program, folder):
    """A Roomba that bumps: contacts, battery and events."""
    file = os.path.join(folder, "bumps.mcap")
    report = json.loads(run(program, "simulate", "--room", "bedroom", "--behaviour", "bounce", "--max-time", "60", "--json", "--mcap", file))
    messages = read_mcap(file)
    others, _ = read_rosbags(file)
    same("bumps", messages, others)
    pressed = [bumper.is_left_pressed or bumper.is_right_pressed for _, bumper in messages["/bumper"]]
    edges = sum(now and not before for before, now in zip([False, *pressed], pressed))
    assert edges == report["bumps"] > 0, (edges, report["bumps"])
    assert [log.msg for _, log in messages["/rosout"] if log.msg.startswith("bump")].__len__() == edges
    _, battery = messages["/battery_state"][0]
    assert 12 < battery.voltage < 18 and battery.percentage == 1.0 and battery.power_supply_status == 2, battery
    assert messages["/battery_state"][-1][1].charge < battery.charge
    assert len(messages["/cliff"]) == len(messages["/bumper"]) and [drop.data for _, drop in messages["/wheel_drop"]] == [False]
    assert "/scan" not in messages and "/tf_static" not in messages and "/plan" not in messages, messages.keys()


def check_map(program, folder):
    """A robot that maps: its map grows, and the truth is beside it."""
    file = os.path.join(folder, "map.mcap")
    run(program, "map", "--room", "bedroom", "--behaviour", "wall_follow", "--seeds", "1", "--minutes", "1", "--tracking", "corrected", "--noise", "typical", "--slip", "typical", "--mcap", file)
    messages = read_mcap(file)
    others, latched = read_rosbags(file)
    same("map", messages, others)
    assert latched == {"/map", "/ground_truth/map", "/rosout"}, latched
    known = [sum(cell >= 0 for cell in grid.data) for _, grid in messages["/map"]]
    assert len(known) >= 6 and known[-1] > known[0], known
    (_, truth), = messages["/ground_truth/map"]
    _, last = messages["/map"][-1]
    # The walls of the map are walls of the room, or of its outside, or next to them.
    room = truth.info
    walls = right = 0
    for i, cell in enumerate(last.data):
        if cell != 100:
            continue
        walls += 1
        x = last.info.origin.position.x + (i % last.info.width + 0.5) * last.info.resolution
        y = last.info.origin.position.y + (i // last.info.width + 0.5) * last.info.resolution
        right += any(is_wall(truth, math.floor(x / room.resolution) + dx, math.floor(y / room.resolution) + dy) for dx in (-2, 0, 2) for dy in (-2, 0, 2))
    assert walls > 20 and right / walls > 0.9, (walls, right)


def check_sweep(program, folder):
    """A sweep: its path, and the drive along it."""
    file, table = os.path.join(folder, "sweep.mcap"), os.path.join(folder, "sweep.csv")
    run(program, "sweep", "--room", "bedroom", "--out", file, "--out", table)
    messages = read_mcap(file)
    others, _ = read_rosbags(file)
    same("sweep", messages, others)
    stops = [[float(number) for number in line.split(",")] for line in open(table).read().splitlines()[1:]]
    (_, plan), = messages["/plan"]
    assert len(plan.poses) == len(stops)
    for pose, (x, y, turn, _, time) in zip(plan.poses, stops):
        assert math.hypot(pose.pose.position.x - x, pose.pose.position.y - y) < 1e-4, (pose, x, y)
        assert abs(seconds(pose.header.stamp) - time) < 1e-3 and abs(heading(pose.pose.orientation) - turn) < 1e-6
    # At its last moment it stands at the end of the path.
    x, y, _ = robot_on_map(math.inf, messages["/tf"])
    assert math.hypot(x - stops[-1][0], y - stops[-1][1]) < 1e-3, (x, y, stops[-1])
    length = sum(math.hypot(b.pose.pose.position.x - a.pose.pose.position.x, b.pose.pose.position.y - a.pose.pose.position.y) for (_, a), (_, b) in zip(messages["/odom"], messages["/odom"][1:]))
    # Samples cut corners.
    assert 0.97 * stops[-1][3] < length < stops[-1][3] + 1e-3, (length, stops[-1][3])


def main(program):
    with tempfile.TemporaryDirectory(prefix="robovac-") as folder:
        for check in (check_run, check_bumps, check_map, check_sweep):
            check(program, folder)
    print("    mcap and rosbags: bags of runs, maps and sweeps are read")


main(sys.argv[1])
