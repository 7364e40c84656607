"""A recording as MCAP, read by the readers of Foxglove's project, and as a table, read by Python's own.

They know nothing of this project. The recording is of the virtual Roomba, by `robovac monitor`; as that never drives, a
command is written into it.
"""

import csv
import json
import math
import os
import signal
import subprocess
import sys
import tempfile

from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory

from virtual_roomba import VirtualRoomba


def record(program, file):
    """Lifts a robot and puts it down while its sensors are recorded."""
    with VirtualRoomba(program) as roomba:
        command = [program, "monitor", roomba.port, "--record", file]
        monitor = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)

        def hear(what):
            while what not in (line := monitor.stdout.readline()):
                assert line, f"{what} was never reported"

        hear("frames/s")
        roomba.order("lift")
        hear("wheel drops 11")
        roomba.order("drop")
        hear("wheel drops 00")
        monitor.send_signal(signal.SIGINT)
        monitor.stdout.read()
        assert monitor.wait(10) == 0


def with_command(file):
    """Adds Drive Direct, right 300 and left 100 mm/s, in the middle."""
    lines = open(file).read().splitlines()
    at = len(lines) // 2
    lines.insert(at, lines[at].split(" ")[0] + " > 91 01 2C 00 64")
    with open(file, "w") as out:
        out.write("\n".join(lines) + "\n")


def check_messages(file, table):
    messages = {}
    with open(file, "rb") as stream:
        reader = make_reader(stream, decoder_factories=[DecoderFactory()])
        assert reader.get_header().profile == "ros2"
        for schema, channel, message, decoded in reader.iter_decoded_messages():
            messages.setdefault((channel.topic, schema.name), []).append((message.log_time, decoded))
    times = {name: [time for time, _ in all] for name, all in messages.items()}
    assert all(sorted(all) == all for all in times.values()), times.keys()
    of = lambda topic, schema: [decoded for _, decoded in messages[topic, schema]]
    battery = of("/battery_state", "sensor_msgs/msg/BatteryState")[0]
    first = table[0]
    assert abs(battery.voltage - float(first["voltage (mV)"]) / 1000) < 1e-3, battery
    assert abs(battery.charge - float(first["battery_charge (mAh)"]) / 1000) < 1e-3, battery
    assert abs(battery.percentage - 0.8) < 0.01 and math.isnan(battery.design_capacity), battery
    assert battery.power_supply_status == 2 and battery.present and list(battery.cell_voltage) == [], battery
    odometry = of("/odom", "nav_msgs/msg/Odometry")
    assert odometry[0].header.frame_id == "odom" and odometry[0].child_frame_id == "base_link", odometry[0]
    assert odometry[0].pose.pose.orientation.w == 1.0 and len(odometry[0].pose.covariance) == 36, odometry[0]
    stamp = odometry[0].header.stamp
    assert abs(stamp.sec + 1e-9 * stamp.nanosec - float(first["time (s)"])) < 1e-3, stamp
    # The others are the monitor's stops.
    (command,) = [twist for twist in of("/cmd_vel", "geometry_msgs/msg/Twist") if twist.linear.x != 0]
    assert command.linear.x == 0.2 and abs(command.angular.z - 200 / 235) < 1e-12, command
    assert [drop.data for drop in of("/wheel_drop", "std_msgs/msg/Bool")] == [False, True, False]
    cliffs = of("/cliff", "create_msgs/msg/Cliff")
    bumpers = of("/bumper", "create_msgs/msg/Bumper")
    assert len(cliffs) == len(bumpers) == len(table), (len(cliffs), len(bumpers), len(table))
    for cliff, bumper, row in zip(cliffs, bumpers, table):
        assert cliff.is_cliff_front_right == (row["cliff_front_right"] == "1"), (cliff, row)
        assert bumper.light_signal_right == int(row["light_bump_right"]), (bumper, row)
        assert not bumper.is_left_pressed
    assert [mode.mode for mode in of("/mode", "create_msgs/msg/Mode")] == [1]
    return [(log.level, log.msg) for log in of("/rosout", "rcl_interfaces/msg/Log")]


def main(program):
    with tempfile.TemporaryDirectory(prefix="robovac-") as folder:
        file, table, messages = (os.path.join(folder, name) for name in ["line.txt", "line.csv", "line.mcap"])
        record(program, file)
        with_command(file)
        command = [program, "recording", file, "--csv", table, "--mcap", messages, "--json"]
        timeline = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        with open(table, newline="") as lines:
            rows = list(csv.DictReader(lines))
        assert len(rows) == timeline["readings"] > 100, (len(rows), timeline)
        assert None not in rows[0] and {row["mode"] for row in rows} == {"Passive"}, rows[0]
        drops = [row["wheel_drop_left"] for row in rows]
        assert "".join(drops).strip("0").strip("1") == "" and "1" in drops, drops
        assert 13_000 < int(rows[-1]["voltage (mV)"]) < 17_000, rows[-1]
        texts = [entry["text"] for entry in timeline["entries"] if entry["is_fault"]]
        assert any(text.startswith("Both wheels dropped for ") for text in texts), timeline["entries"]
        logs = check_messages(messages, rows)
        assert logs == [(30 if e["is_fault"] else 20, e["text"]) for e in timeline["entries"]], logs
    print("    mcap and csv: a recording is read")


main(sys.argv[1])
