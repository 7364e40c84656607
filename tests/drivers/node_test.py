"""A node of ROS 2 (`robovac ros2`, `robovac monitor --ros2`) against CycloneDDS, an independent implementation of DDS.

Both run on this computer, so all of it goes over the loopback interface, and without multicast. They use the address of
another interface, though: RustDDS 0.14 does not send data to participants that only have loopback addresses.
"""

import math
import os
import signal
import subprocess
import sys
import time

# Whom to look for is read when the library is loaded.
os.environ["CYCLONEDDS_URI"] = """<CycloneDDS><Domain Id="any">
  <General><AllowMulticast>false</AllowMulticast></General>
  <Discovery><SPDPInterval>1s</SPDPInterval><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>9</MaxAutoParticipantIndex>
  <Peers><Peer address="127.0.0.1"/></Peers></Discovery>
</Domain></CycloneDDS>"""

from dataclasses import dataclass  # noqa: E402

from cyclonedds.core import Policy, Qos  # noqa: E402
from cyclonedds.domain import DomainParticipant  # noqa: E402
from cyclonedds.idl import IdlStruct  # noqa: E402
from cyclonedds.idl.types import array, float32, float64, int8, int32, sequence, uint8, uint16, uint32  # noqa: E402
from cyclonedds.pub import DataWriter  # noqa: E402
from cyclonedds.sub import DataReader  # noqa: E402
from cyclonedds.topic import Topic  # noqa: E402
from cyclonedds.util import duration  # noqa: E402

from virtual_roomba import VirtualRoomba  # noqa: E402

# Apart from nodes that somebody else may run here.
DOMAIN = 87
# Far beyond what discovery takes; only a failure waits so long.
PATIENCE = 60


# ROS 2 names types in this way.
@dataclass
class Time(IdlStruct, typename="builtin_interfaces::msg::dds_::Time_"):
    sec: int32
    nanosec: uint32


@dataclass
class Header(IdlStruct, typename="std_msgs::msg::dds_::Header_"):
    stamp: Time
    frame_id: str


@dataclass
class Vector3(IdlStruct, typename="geometry_msgs::msg::dds_::Vector3_"):
    x: float64
    y: float64
    z: float64


@dataclass
class Quaternion(IdlStruct, typename="geometry_msgs::msg::dds_::Quaternion_"):
    x: float64
    y: float64
    z: float64
    w: float64


@dataclass
class Pose(IdlStruct, typename="geometry_msgs::msg::dds_::Pose_"):
    position: Vector3
    orientation: Quaternion


@dataclass
class PoseWithCovariance(IdlStruct, typename="geometry_msgs::msg::dds_::PoseWithCovariance_"):
    pose: Pose
    covariance: array[float64, 36]


@dataclass
class Twist(IdlStruct, typename="geometry_msgs::msg::dds_::Twist_"):
    linear: Vector3
    angular: Vector3


@dataclass
class TwistWithCovariance(IdlStruct, typename="geometry_msgs::msg::dds_::TwistWithCovariance_"):
    twist: Twist
    covariance: array[float64, 36]


@dataclass
class Odometry(IdlStruct, typename="nav_msgs::msg::dds_::Odometry_"):
    header: Header
    child_frame_id: str
    pose: PoseWithCovariance
    twist: TwistWithCovariance


@dataclass
class MapMetaData(IdlStruct, typename="nav_msgs::msg::dds_::MapMetaData_"):
    map_load_time: Time
    resolution: float32
    width: uint32
    height: uint32
    origin: Pose


@dataclass
class OccupancyGrid(IdlStruct, typename="nav_msgs::msg::dds_::OccupancyGrid_"):
    header: Header
    info: MapMetaData
    data: sequence[int8]


@dataclass
class LaserScan(IdlStruct, typename="sensor_msgs::msg::dds_::LaserScan_"):
    header: Header
    angle_min: float32
    angle_max: float32
    angle_increment: float32
    time_increment: float32
    scan_time: float32
    range_min: float32
    range_max: float32
    ranges: sequence[float32]
    intensities: sequence[float32]


@dataclass
class Bumper(IdlStruct, typename="create_msgs::msg::dds_::Bumper_"):
    header: Header
    is_left_pressed: bool
    is_right_pressed: bool
    is_light_left: bool
    is_light_front_left: bool
    is_light_center_left: bool
    is_light_center_right: bool
    is_light_front_right: bool
    is_light_right: bool
    light_signal_left: uint16
    light_signal_front_left: uint16
    light_signal_center_left: uint16
    light_signal_center_right: uint16
    light_signal_front_right: uint16
    light_signal_right: uint16


@dataclass
class Mode(IdlStruct, typename="create_msgs::msg::dds_::Mode_"):
    header: Header
    mode: uint8


@dataclass
class Bool(IdlStruct, typename="std_msgs::msg::dds_::Bool_"):
    data: bool


@dataclass
class Clock(IdlStruct, typename="rosgraph_msgs::msg::dds_::Clock_"):
    clock: Time


SENSORS = Qos(Policy.Reliability.Reliable(duration(seconds=1)), Policy.History.KeepLast(50))
LATCHED = Qos(Policy.Reliability.Reliable(duration(seconds=1)), Policy.Durability.TransientLocal, Policy.History.KeepLast(1))


class Program:
    """A running program that says when it is ready."""

    def __init__(self, *command, ready):
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        while ready not in (line := self.process.stdout.readline()):
            assert line, f"{command} ended before it said {ready!r}"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGINT)
        self.process.stdout.read()
        assert self.process.wait(20) == 0


def reader(participant, name, kind, quality=SENSORS):
    return DataReader(participant, Topic(participant, f"rt/{name}", kind, qos=quality), qos=quality)


def await_message(reader, holds, what, meanwhile=lambda: None):
    """The first message that `holds`."""
    until = time.monotonic() + PATIENCE
    last = None
    while time.monotonic() < until:
        meanwhile()
        for last in reader.take(N=50):
            if holds(last):
                return last
        time.sleep(0.02)
    raise AssertionError(f"never {what}; last {last}. Is there a network interface besides loopback, whose address is used?")


def seconds(stamp):
    return stamp.sec + 1e-9 * stamp.nanosec


def check_driving(program):
    """By cmd_vel, a robot drives an arc, stops without commands, and bumps."""
    participant = DomainParticipant(DOMAIN)
    odometry, bumper = reader(participant, "cbot/odom", Odometry), reader(participant, "cbot/bumper", Bumper)
    scans = reader(participant, "cbot/laser/scan", LaserScan)
    commands = DataWriter(participant, Topic(participant, "rt/cbot/cmd_vel", Twist, qos=SENSORS), qos=SENSORS)

    def drive(ahead, turn):
        return lambda: commands.write(Twist(linear=Vector3(ahead, 0.0, 0.0), angular=Vector3(0.0, 0.0, turn)))

    node = ("ros2", "--room", "lshape", "--robot", "roomba600_lidar", "--namespace", "cbot", "--remap", "scan:=laser/scan")
    with Program(program, *node, "--domain", str(DOMAIN), ready="ready"):
        at_rest = await_message(odometry, lambda _: True, "odometry")
        assert (at_rest.header.frame_id, at_rest.child_frame_id) == ("odom", "base_link"), at_rest
        assert abs(seconds(at_rest.header.stamp) - time.time()) < 30, at_rest.header
        assert at_rest.twist.twist.linear.x == 0, at_rest
        # The map is there for those who come later.
        (room,) = [await_message(reader(participant, "cbot/map", OccupancyGrid, LATCHED), lambda _: True, "a map")]
        assert len(room.data) == room.info.width * room.info.height > 1000 and {0, 100} <= set(room.data), room.info
        arc = await_message(odometry, lambda o: o.twist.twist.linear.x > 0.19 and o.twist.twist.angular.z > 0.49, "driving an arc", drive(0.2, 0.5))
        assert abs(arc.twist.twist.linear.x - 0.2) < 0.02 and abs(arc.twist.twist.angular.z - 0.5) < 0.05, arc.twist
        # Nobody commands any more.
        await_message(odometry, lambda o: o.twist.twist.linear.x == 0 and o.twist.twist.angular.z == 0, "stopped by itself")
        await_message(bumper, lambda b: b.is_left_pressed or b.is_right_pressed, "a bump", drive(0.4, 0.0))
        scan = await_message(scans, lambda s: min(s.ranges) < 0.4, "a scan of the wall")
        assert sum(map(math.isfinite, scan.ranges)) > 100 and min(scan.ranges) >= scan.range_min, scan.range_min


def check_namespaces(program):
    """Two robots in namespaces of their own, many times as fast as real time, driven by a behaviour."""
    participant = DomainParticipant(DOMAIN)
    odometry = [reader(participant, f"{name}/odom", Odometry) for name in ("one", "two")]
    clock = reader(participant, "clock", Clock)
    node = ("ros2", "--room", "empty", "--behaviour", "random_walk", "--speed", "16", "--namespace", "one", "--namespace", "two")
    with Program(program, *node, "--domain", str(DOMAIN), ready="two"):
        first = [await_message(one, lambda o: seconds(o.header.stamp) > 3, "odometry") for one in odometry]
        now = await_message(clock, lambda _: True, "a clock")
        assert 3 < seconds(now.clock) < 1000 and 3 < seconds(first[0].header.stamp) < 1000, (now, first)
        # They have different seeds.
        later = [await_message(one, lambda o: seconds(o.header.stamp) > 60, "odometry") for one in odometry]
        turns = [o.pose.pose.orientation.z for o in later]
        assert abs(turns[0] - turns[1]) > 0.01, turns


def check_real_robot(program):
    """A monitored robot is published while it is lifted."""
    participant = DomainParticipant(DOMAIN)
    dropped, modes = reader(participant, "wheel_drop", Bool, SENSORS), reader(participant, "mode", Mode)
    with VirtualRoomba(program) as roomba:
        monitor = (program, "monitor", roomba.port, "--ros2", "--domain", str(DOMAIN))
        with Program(*monitor, ready="frames/s"):
            # What is told once, when it changes, could have been told before this reader was found.
            lifted = False

            def shake():
                nonlocal lifted
                lifted = not lifted
                roomba.order("lift" if lifted else "drop")
                time.sleep(0.2)

            await_message(dropped, lambda drop: drop.data, "lifted", shake)
            await_message(dropped, lambda drop: not drop.data, "put down", shake)
            assert all(mode.mode == 1 for mode in modes.take(N=50))


def main(program):
    has_node = "--namespace" in subprocess.run([program, "ros2", "--help"], capture_output=True, text=True).stdout
    assert has_node, f"{program} was built without its node: cargo build -p robovac-cli --features ros2"
    for check in (check_driving, check_namespaces, check_real_robot):
        check(program)
    print("    cyclonedds: nodes are read and driven")


main(sys.argv[1])
