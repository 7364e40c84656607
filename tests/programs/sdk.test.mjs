// Programs in the manner of iRobot's lessons (its Python SDK, folder examples/), rewritten: they run, and do what they should.
import assert from "node:assert/strict";
import { test } from "node:test";
import { answers, loaded, message } from "./files.mjs";
import { Toy } from "./toy.mjs";

const HEAD = `from irobot_edu_sdk.backend.bluetooth import Bluetooth
from irobot_edu_sdk.robots import event, hand_over, Color, Robot, Root, Create3
from irobot_edu_sdk.music import Note

`;
const SQUARE = `${HEAD}robot = Root(Bluetooth('any'))

@event(robot.when_play)
async def draw(robot):
    await robot.set_marker_down()
    for side in range(4):
        await robot.move(30)
        await robot.turn_left(90)
    await robot.set_marker_and_eraser_up()
    print(robot.pose)

robot.play()
`;
const BUMPERS = `${HEAD}robot = Create3(Bluetooth())
pace = 20

@event(robot.when_bumped, [True, False])
async def left(robot):
    print('left')
    await robot.set_lights_on_rgb(255, -3, 999.5)

@event(robot.when_bumped, [True, True])
async def away(robot):
    await robot.move(-10)
    await robot.turn_right(100)
    await robot.set_wheel_speeds(pace, pace)

@event(robot.when_play)
async def play(robot):
    await robot.play_note(Note.A4, Note.QUARTER)
    await robot.set_wheel_speeds(pace, pace)

@event(robot.when_play)
async def count(robot):
    for second in range(3):
        await robot.wait(1)
        print('second', second)

robot.play()
`;
const SENSES = `${HEAD}robot = Create3(Bluetooth())

@event(robot.when_touched, [True, False])
async def touched(robot):
    print('touched')

@event(robot.when_play)
async def play(robot):
    await robot.navigate_to(16, 0)
    await robot.reset_navigation()
    millivolts, percent = await robot.get_battery_level()
    print(percent, await robot.get_bumpers(), len((await robot.get_ir_proximity()).sensors))
    x = 0
    while x < 5:
        x += 1
        await hand_over()
    await robot.arc_left(90, 20)
    await robot.say('done')
    await robot.stop()

robot.play()
`;

/** What a program says and where its robot ends. */
async function played(source, most = 3000) {
  const program = await loaded("python", source);
  const toy = new Toy({ x: 1.9, y: 1.2 });
  const readings = [];
  const commands = [];
  const said = [];
  for (let goesOn = true; goesOn && readings.length < most; ) {
    readings.push(message(toy.readings));
    goesOn = program.step(toy.readings);
    commands.push([program.left, program.right]);
    said.push(...program.output.splice(0));
    toy.step(program.left, program.right);
  }
  const outside = answers("python", source, readings).slice(1);
  assert.deepEqual(outside.map(({ left, right }) => [left, right]), commands, "CPython does the same");
  return { said, toy, steps: readings.length, prints: said.filter(({ kind }) => kind === "print").map(({ text }) => text) };
}

test("A square with a pen that this robot lacks", async () => {
  const { said, toy, prints, steps } = await played(SQUARE);
  assert.ok(steps < 1500);
  assert.ok(Math.hypot(toy.x - 1.9, toy.y - 1.2) < 0.02);
  assert.match(prints[0], /^set_marker: this robot has no pen/);
  assert.equal(prints.length, 2);
  assert.match(prints[1], /^Pose \(-?0\.\d\d, -?0\.\d\d, (89|90)\.\d°\)$/);
  assert.ok(said.filter(({ kind }) => kind === "line").length > 20);
});

test("Bumpers, lights, notes and tasks side by side", async () => {
  const { said, prints } = await played(BUMPERS);
  assert.deepEqual(prints.filter((text) => text.startsWith("second")), ["second 0", "second 1", "second 2"]);
  assert.ok(prints.includes("left"));
  assert.deepEqual(said.find(({ kind }) => kind === "note"), { kind: "note", hz: 440, seconds: 0.25 });
  assert.deepEqual(said.find(({ kind }) => kind === "lights"), { kind: "lights", colour: [255, 0, 255], pattern: "on" });
});

test("Senses; what is missing is said once", async () => {
  const { prints, steps } = await played(SENSES);
  assert.ok(steps < 3000);
  assert.match(prints[0], /^when_touched: this robot has no touch sensors/);
  assert.deepEqual(prints.slice(1), ["100 (False, False) 7", "says: done"]);
});

test("Notes have the frequencies of equal temperament, cut to whole Hz", async () => {
  const { prints } = await played(`${HEAD}robot = Root(Bluetooth())\n@event(robot.when_play)\nasync def play(robot):\n    print(Note.C1, Note.A1, Note.C4, Note.F4_SHARP, Note.A4, Note.B8, Note.C9)\nrobot.play()\n`);
  assert.deepEqual(prints, ["32 55 261 369 440 7902 8372"]);
});

test("A wrong name is told with its line", async () => {
  await assert.rejects(played(`${HEAD}robot = Root(Bluetooth())\n@event(robot.when_play)\nasync def play(robot):\n    await robot.turn_lefd(90)\nrobot.play()\n`), { line: 8, message: /robot\.turn_lefd: there is no such name; did you mean turn_left\?/ });
});
