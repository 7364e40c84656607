// Drives lane after lane, a little less than a tool's width apart. Where it can't move over, it goes on in another direction.
function* run(robot) {
  let side = 90;
  let short = 0;
  while (true) {
    const before = robot.distance;
    yield robot.forward(10);
    short = robot.distance - before < 0.3 ? short + 1 : 0;
    yield robot.forward(-0.05);
    yield robot.turn(side);
    const moved = yield robot.forward(0.85 * robot.toolWidth);
    if (!moved || short > 2) {
      // The room ends here, or this corner is done.
      yield robot.forward(-0.05);
      yield robot.turn(robot.randint(30, 150));
      short = 0;
    } else {
      yield robot.turn(side);
    }
    side = -side;
  }
}
