"""pycreate2 0.8.0, which knows nothing of this project, drives the virtual Roomba.

Its known bugs: names of bumps and wheel drops are left for right, bits of the overcurrents are shifted, getMode() sends
nothing that a robot knows. The mode is read from packet 35 instead.
"""

import contextlib
import io
import sys
import time

from pycreate2 import Create2

from virtual_roomba import VirtualRoomba

MM_PER_COUNT = 0.444565


def modes_and_sensors(roomba, robot):
    for change, number, name in [(robot.start, 1, "Passive"), (robot.safe, 2, "Safe"), (robot.full, 3, "Full")]:
        change()
        sensors = robot.get_sensors()
        assert sensors.open_interface_mode == number, sensors
        assert roomba.state()["mode"] == name
    assert sensors.battery_capacity == 2696 and 13_000 < sensors.voltage < 17_000, sensors
    assert -151 <= sensors.current <= -111, sensors.current
    assert 2500 <= sensors.cliff_left_signal <= 2680 and not sensors.cliff_left, sensors
    assert sensors.charger_state == 0 and not any(sensors.charger_available), sensors
    assert (sensors.encoder_counts_left, sensors.encoder_counts_right) == (0, 0), sensors
    roomba.order("lift")
    time.sleep(0.1)
    sensors = robot.get_sensors()
    assert sensors.bumps_wheeldrops.wheeldrop_left and sensors.bumps_wheeldrops.wheeldrop_right, sensors
    assert sensors.cliff_left and sensors.cliff_right, sensors
    robot.stop()
    assert roomba.state()["mode"] == "Off"
    robot.SCI.write(142, (35,))
    assert robot.SCI.read(1) == b"", "a robot that is off answers nothing"


def drives_as_it_is_told(roomba, robot):
    robot.start()
    robot.safe()
    robot.get_sensors()
    start = roomba.state()["pose"]["x"]
    robot.drive_direct(300, 300)
    roomba.wait_for("half a metre", lambda state: state["pose"]["x"] > start + 0.5)
    robot.drive_stop()
    state = roomba.wait_for("standing", lambda state: state["speed"]["left"] == 0.0)
    went = 1000 * (state["pose"]["x"] - start)
    sensors = robot.get_sensors()
    assert abs(sensors.distance - went) <= 2, (sensors.distance, went)
    assert abs(sensors.encoder_counts_left * MM_PER_COUNT - went) <= 2, sensors
    assert (sensors.velocity_right, sensors.velocity_left) == (0, 0), sensors
    # The right wheel comes first: so it turns to the left, counter-clockwise.
    robot.drive_direct(150, -150)
    time.sleep(0.6)
    robot.drive_stop()
    state = roomba.wait_for("standing", lambda state: state["speed"]["left"] == 0.0)
    sensors = robot.get_sensors()
    assert state["pose"]["heading_deg"] > 20, state
    assert abs(sensors.angle - state["pose"]["heading_deg"]) <= 2, (sensors.angle, state)
    robot.drive_pwm(-100, -100)
    roomba.wait_for("backing up", lambda state: state["speed"]["left"] < -50)
    robot.drive_stop()
    robot.led(4, 128, 255)
    robot.digit_led_ascii("Hi")
    robot.createSong(2, [69, 32, 72, 32])
    robot.playSong(2)
    time.sleep(0.1)
    sensors = robot.get_sensors()
    assert sensors.song_playing and sensors.song_number == 2, sensors


def bumps(roomba, robot):
    robot.start()
    robot.full()
    robot.drive_direct(200, 200)
    roomba.wait_for("a bump", lambda state: state["bumped"])
    sensors = robot.get_sensors()
    assert sensors.bumps_wheeldrops.bump_left and sensors.bumps_wheeldrops.bump_right, sensors
    assert sensors.light_bumper.center_left and sensors.light_bumper_center_right > 1000, sensors


def safe_stops_at_a_drop_off(roomba, robot):
    robot.start()
    robot.safe()
    robot.drive_direct(400, 400)
    state = roomba.wait_for("a stop", lambda state: state["mode"] == "Passive")
    state = roomba.wait_for("standing", lambda state: state["speed"]["left"] == 0.0)
    sensors = robot.get_sensors()
    assert sensors.cliff_front_left and sensors.open_interface_mode == 1 and not state["fallen"], (state, sensors)


def tells_its_firmware(roomba, robot):
    robot.start()
    text = robot.reset()
    assert text.startswith(b"Soft reset!"), text
    roomba.wait_for("it listens again", lambda state: state["awake"])
    robot.start()
    # What the banner said since is before the answer.
    robot.SCI.ser.reset_input_buffer()
    assert robot.get_sensors().open_interface_mode == 1


# With what each is tried.
TESTS = {
    modes_and_sensors: [],
    drives_as_it_is_told: [],
    bumps: ["--wall-at", "0.4"],
    safe_stops_at_a_drop_off: ["--cliff-at", "0.6"],
    tells_its_firmware: [],
}


def main():
    for test, arguments in TESTS.items():
        with VirtualRoomba(sys.argv[1], *arguments) as roomba:
            # It prints what it does.
            with contextlib.redirect_stdout(io.StringIO()):
                robot = Create2(roomba.port)
                # Its pauses of half a second are for real robots.
                robot.sleep_timer = 0.05
                test(roomba, robot)
                # Which stops the robot, and closes the port.
                del robot
            assert roomba.state()["mode"] == "Off"
        print(f"    pycreate2: {test.__name__.replace('_', ' ')}")


main()
