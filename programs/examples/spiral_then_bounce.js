// Drives a growing spiral until it bumps, bounces a few times to get elsewhere, and starts a new spiral.
const SPEED = 0.3;

function* spiral(robot) {
  let radius = 0.15;
  while (!(robot.bump || robot.cliff)) {
    robot.go(SPEED, (57.3 * SPEED) / radius);
    // Wider by a tool's width in each round, less some overlap.
    radius = radius + (0.9 * robot.toolWidth * SPEED * 0.015) / (6.28 * radius);
    yield;
  }
}

function* run(robot) {
  while (true) {
    yield* spiral(robot);
    for (let bounce = 0; bounce < 4; bounce++) {
      yield robot.forward(-0.06);
      yield robot.turn(100 + 80 * robot.random());
      yield robot.forward(1 + 4 * robot.random());
    }
  }
}
