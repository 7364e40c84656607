"""What all robots of the SDK have in common."""

from math import atan2, cos, degrees, radians, sin, sqrt

from robovac_program.motions import Arc, Forward, Turn, Wait
from robovac_program.program import current, registered
from robovac_program.words import ProgramError, names, unknown

from .color import Color
from .event import Event, Pause
from .getter_types import Movement, Pose, Values

# m/s and degrees/s of motions.
_SPEED = 0.2
_RATE = 90
# Seconds for each letter that is said.
_LETTER_S = 0.07
# The pen draws again after so many metres.
_STROKE = 0.03


class _Task:
    """An async function that has begun, and what it waits for."""

    def __init__(self, coroutine, event=None):
        self.coroutine = coroutine
        self.event = event
        self.motion = None
        if event:
            event.is_running = True


class Robot:
    """A robot of the SDK on the robot of this program."""

    class Dir:
        LEFT = 0
        RIGHT = 1

    class LightPattern:
        OFF = 0
        ON = 1
        BLINK = 2
        SPIN = 3

    class StallMotor:
        LEFT = 0
        RIGHT = 1
        MARKER = 2

    class Vars:
        pass

    def __init__(self, backend=None):
        if not current:
            raise ProgramError("this program is run by robovac: open it in the page, or `robovac run` it")
        self._robot = current[0]
        names[:] = [name for name in Robot.__dict__ if not name.startswith("_")]
        self.vars = Robot.Vars()
        self.pose = Pose()
        self.bumpers = Values(left=False, right=False)
        self.cliff_sensor = Values(disable_motors=False, left=False, front_left=False, front_right=False, right=False)
        self.touch_sensors = Values(front_left=False, front_right=False, back_left=False, back_right=False)
        self.battery = Values(millivolts=0, percent=0)
        self.motor_stall = Values(motor=0, cause=0)
        self.docking_sensor = Values(contacts=None, sensors=(None, None, None))
        self._handlers = {}
        self._tasks = []
        self._moving = None
        self._said = []
        self._pen = None
        self._origin = None

    # Events.

    def _when(self, name, condition, task):
        self._handlers.setdefault(name, []).append(Event(condition, task))

    def when_play(self, task):
        self._when("play", None, task)

    def when_stop(self, task):
        self._when("stop", None, task)

    def when_bumped(self, condition, task):
        self._when("bumped", condition, task)

    def when_cliff_sensor(self, condition, task):
        self._when("cliff", condition, task)

    def when_battery(self, condition, task):
        self._when("battery", condition, task)

    def when_motor_stalled(self, condition, task):
        self._when("stalled", condition, task)

    def when_docking_sensor(self, task):
        self._when("docking", None, task)

    def when_touched(self, condition, task):
        self._cannot("when_touched", "this robot has no touch sensors that a program can read; the event never happens")

    def when_color_scanned(self, condition, task):
        self._cannot("when_color_scanned", "this robot has no colour sensors; the event never happens")

    def when_light_seen(self, condition, task):
        self._cannot("when_light_seen", "this robot has no light sensors of that kind; the event never happens")

    def _cannot(self, name, why):
        if name not in self._said:
            self._said.append(name)
            print("%s: %s." % (name, why))

    def play(self):
        """Starts the program."""
        if registered:
            print("The robot program is already running.")
            return
        registered.append(self._main)

    def _start(self, name, matches=None):
        for event in self._handlers.get(name, ()):
            if not event.is_running and (matches is None or matches(event.condition)):
                self._tasks.append(_Task(event.task(self), event))

    def _main(self, robot):
        """The program of this package that runs the tasks."""
        self.reset()
        self._start("play")
        while True:
            self._sense(robot)
            # Tasks that are started meanwhile begin in this step, too.
            for task in self._tasks:
                self._go_on(task, robot)
            self._tasks = [task for task in self._tasks if task.coroutine is not None]
            if self._pen is not None:
                self._draw(robot)
            if not self._tasks and not any(self._handlers.get(name) for name in self._handlers if name not in ("play", "stop")):
                return
            yield

    def _go_on(self, task, robot):
        motion = task.motion
        result = None
        if motion is not None:
            # A later motion has taken the wheels.
            replaced = motion.drives and motion is not self._moving
            result = False if replaced else motion.step(robot)
            if result is None:
                return
        try:
            motion = task.coroutine.send(result)
        except StopIteration:
            task.coroutine = None
            if task.event:
                task.event.is_running = False
            return
        if motion is None:
            motion = Pause()
        if not hasattr(motion, "step"):
            raise ProgramError("await something of the robot, such as robot.wait(1): asyncio has no place here")
        motion.drives = isinstance(motion, (Forward, Turn, Arc))
        if motion.drives:
            self._moving = motion
        task.motion = motion
        motion.start(robot)

    def _sense(self, robot):
        """Notices what has changed."""
        bumpers, cliff = self.bumpers, self.cliff_sensor
        if (robot.bump_left, robot.bump_right) != (bumpers.left, bumpers.right):
            bumpers.left, bumpers.right = robot.bump_left, robot.bump_right
            if robot.bump:
                self._start("bumped", lambda c: not c or (c[0] and bumpers.left) or (len(c) > 1 and c[1] and bumpers.right))
        seen = (robot.cliff_left, robot.cliff_front_left, robot.cliff_front_right, robot.cliff_right)
        if seen != (cliff.left, cliff.front_left, cliff.front_right, cliff.right):
            cliff.left, cliff.front_left, cliff.front_right, cliff.right = seen
            cliff.disable_motors = any(seen)

            def matches(condition):
                if not condition:
                    return cliff.disable_motors
                if len(condition) < 4:
                    return condition[0] == cliff.disable_motors
                return any(wanted and is_there for wanted, is_there in zip(condition, seen))

            self._start("cliff", matches)
        percent = int(100 * robot.charge + 0.5)
        if percent != self.battery.percent:
            is_first = self.battery.millivolts == 0
            self.battery.millivolts, self.battery.percent = int(1000 * robot.voltage + 0.5), percent
            if not is_first:
                self._start("battery")
        stalled = 1 if robot.overcurrent_left else 2 if robot.overcurrent_right else 0
        if stalled and not self.motor_stall.cause:
            self.motor_stall.motor, self.motor_stall.cause = stalled - 1, 1
            self._start("stalled")
        elif not stalled:
            self.motor_stall.cause = 0
        docking = (robot.docked, robot.infrared_omni, robot.infrared_left, robot.infrared_right)
        if docking != (self.docking_sensor.contacts,) + self.docking_sensor.sensors:
            is_first = self.docking_sensor.contacts is None
            self.docking_sensor.contacts, self.docking_sensor.sensors = docking[0], docking[1:]
            if not is_first:
                self._start("docking")

    # Motions.

    async def wait(self, time):
        await Wait(time)

    async def stop(self):
        self._moving = None
        self._robot.stop()
        await self.set_lights_off()

    async def set_wheel_speeds(self, left, right):
        self._moving = None
        self._robot.drive(left / 100, right / 100)
        await Pause()

    async def set_left_speed(self, speed):
        await self.set_wheel_speeds(speed, 100 * self._robot._out[1])

    async def set_right_speed(self, speed):
        await self.set_wheel_speeds(100 * self._robot._out[0], speed)

    async def move(self, distance):
        await Forward(distance / 100, _SPEED)
        return await self.get_position()

    async def turn(self, direction, angle):
        await Turn(angle if direction == Robot.Dir.LEFT else -angle, _RATE)
        return await self.get_position()

    async def turn_left(self, angle):
        return await self.turn(Robot.Dir.LEFT, angle)

    async def turn_right(self, angle):
        return await self.turn(Robot.Dir.RIGHT, angle)

    async def arc(self, direction, angle, radius):
        if angle < 0 or radius < 0:
            self._cannot("arc", "this robot drives arcs forward only: angle and radius are taken as positive")
        way = abs(angle) if direction == Robot.Dir.LEFT else -abs(angle)
        await Arc(abs(radius) / 100, way, _SPEED)
        return await self.get_position()

    async def arc_left(self, angle, radius):
        return await self.arc(Robot.Dir.LEFT, angle, radius)

    async def arc_right(self, angle, radius):
        return await self.arc(Robot.Dir.RIGHT, angle, radius)

    async def navigate_to(self, x, y, heading=None):
        movement = await self.compute_movement_to(x, y)
        if movement.distance > 0.1:
            await self.turn_left(movement.angle)
            await self.move(movement.distance)
        if heading is not None:
            await self.get_position()
            await self.turn_left(Movement.minimize_angle(heading - self.pose.heading))
        return await self.get_position()

    async def compute_movement_to(self, x, y):
        await self.get_position()
        dx, dy = x - self.pose.x, y - self.pose.y
        return Movement(sqrt(dx * dx + dy * dy), degrees(atan2(dy, dx)) - self.pose.heading)

    # Pose.

    def reset(self):
        robot = self._robot
        self._origin = (robot.x, robot.y, robot.heading)
        self.pose.set(0, 0, 90)

    async def reset_navigation(self):
        self.reset()
        await Pause()

    async def reset_position(self):
        await self.reset_navigation()

    async def get_position(self):
        robot = self._robot
        x, y, heading = self._origin
        dx, dy = 100 * (robot.x - x), 100 * (robot.y - y)
        turn = radians(90 - heading)
        self.pose.set(dx * cos(turn) - dy * sin(turn), dx * sin(turn) + dy * cos(turn), Movement.minimize_angle(robot.heading - heading + 90))
        return self.pose

    # Sensors.

    def get_bumpers_cached(self):
        return (self.bumpers.left, self.bumpers.right)

    async def get_bumpers(self):
        await Pause()
        return (self._robot.bump_left, self._robot.bump_right)

    def get_cliff_sensors_cached(self):
        cliff = self.cliff_sensor
        return (cliff.left, cliff.front_left, cliff.front_right, cliff.right)

    async def get_cliff_sensors(self):
        await Pause()
        return self.get_cliff_sensors_cached()

    def get_touch_sensors_cached(self):
        return (False, False, False, False)

    async def get_touch_sensors(self):
        self._cannot("get_touch_sensors", "this robot has no touch sensors that a program can read")
        await Pause()
        return self.get_touch_sensors_cached()

    async def get_battery_level(self):
        await Pause()
        return (int(1000 * self._robot.voltage + 0.5), int(100 * self._robot.charge + 0.5))

    async def get_ir_proximity(self):
        """Seven signals from left to right; the middle one is the greater of this robot's two middle ones."""
        await Pause()
        light = list(self._robot.light)
        return Values(sensors=light[:3] + [max(light[2], light[3])] + light[3:])

    get_7x_ir_proximity = get_ir_proximity
    get_packed_ir_proximity = get_ir_proximity

    async def get_6x_ir_proximity(self):
        await Pause()
        return Values(sensors=list(self._robot.light))

    async def get_docking_values(self):
        await Pause()
        robot = self._robot
        return {
            "timestamp": int(robot.time * 1000), "contacts": int(robot.docked), "IR sensor 0": robot.infrared_omni,
            "IR sensor 1": robot.infrared_left, "IR sensor 2": robot.infrared_right,
        }

    async def get_accelerometer(self):
        self._cannot("get_accelerometer", "this robot has no accelerometer; it reports rest")
        await Pause()
        return (0, 0, 1)

    async def get_name(self):
        await Pause()
        return self._robot.model

    async def set_name(self, name):
        self._cannot("set_name", "this robot keeps its name")
        await Pause()

    async def get_serial_number(self):
        await Pause()
        return "robovac"

    async def get_sku(self):
        await Pause()
        return "robovac"

    async def get_versions(self, board):
        await Pause()
        return [board, 0, 0, 0, 0, 0, 0, 0, 0, 0]

    async def get_version_string(self):
        await Pause()
        return "0.0.0"

    async def get_ipv4_address(self):
        self._cannot("get_ipv4_address", "this robot has no network")
        await Pause()
        return Values(wlan0=[0, 0, 0, 0], wlan1=[0, 0, 0, 0], usb0=[0, 0, 0, 0])

    async def dock(self):
        self._cannot("dock", "a program of this kind can't find the dock; the behaviour Dock can")
        await Pause()
        return self._docking(1)

    async def undock(self):
        if self._robot.docked:
            await self.move(-30)
            await self.turn_left(180)
        await Pause()
        return self._docking(0)

    def _docking(self, status):
        return {"timestamp": int(self._robot.time * 1000), "status": status, "result": int(self._robot.docked)}

    async def disconnect(self):
        await Pause()

    # Lights and sounds: shown by the page.

    async def set_lights(self, animation, color=Color(255, 255, 255)):
        rgb = [0, 0, 0] if animation == Robot.LightPattern.OFF else [color.red, color.green, color.blue]
        pattern = ("off", "on", "blink", "spin")[max(0, min(3, int(animation)))]
        self._robot._say({"kind": "lights", "colour": rgb, "pattern": pattern})
        await Pause()

    async def set_lights_off(self):
        await self.set_lights(Robot.LightPattern.OFF)

    async def set_lights_rgb(self, red, green, blue):
        await self.set_lights(Robot.LightPattern.ON, Color(red, green, blue))

    async def set_lights_on_rgb(self, red, green, blue):
        await self.set_lights(Robot.LightPattern.ON, Color(red, green, blue))

    async def set_lights_blink_rgb(self, red, green, blue):
        await self.set_lights(Robot.LightPattern.BLINK, Color(red, green, blue))

    async def set_lights_spin_rgb(self, red, green, blue):
        await self.set_lights(Robot.LightPattern.SPIN, Color(red, green, blue))

    async def play_note(self, frequency, duration):
        self._robot._say({"kind": "note", "hz": int(frequency), "seconds": duration})
        await Wait(duration)

    async def play_tone(self, frequency, duration):
        await self.play_note(frequency, duration)

    async def stop_sound(self):
        self._robot._say({"kind": "note", "hz": 0, "seconds": 0})
        await Pause()

    async def say(self, phrase):
        print("says:", phrase)
        await Wait(_LETTER_S * len(str(phrase)))

    # Pen: the page draws the way of a robot that has none.

    async def set_marker(self, position):
        self._cannot("set_marker", "this robot has no pen; its way is drawn on the page's floor instead")
        is_down = position == 1
        self._pen = (self._robot.x, self._robot.y) if is_down else None
        await Pause()

    async def set_marker_up(self):
        await self.set_marker(0)

    async def set_marker_down(self):
        await self.set_marker(1)

    async def set_eraser_down(self):
        self._cannot("set_eraser_down", "this robot has no eraser")
        await self.set_marker(0)

    async def set_marker_and_eraser_up(self):
        await self.set_marker(0)

    async def set_eraser_up(self):
        await self.set_marker(0)

    def _draw(self, robot):
        x, y = self._pen
        if abs(robot.x - x) + abs(robot.y - y) > _STROKE:
            robot.line(x, y, robot.x, robot.y, "blue")
            self._pen = (robot.x, robot.y)

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        raise AttributeError(unknown(name))
