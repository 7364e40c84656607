// Drives lanes to and fro, a little less than a tool's width apart. After a while, or where it can't move over, it looks
// for another place.
function* run(robot) {
  while (true) {
    let side = robot.choice([90, -90]);
    for (let lane = 0; lane < 12; lane++) {
      const before = robot.distance;
      yield robot.forward(10);
      const short = lane > 0 && robot.distance - before < 0.2;
      yield robot.forward(-0.05);
      yield robot.turn(side);
      const moved = yield robot.forward(0.85 * robot.toolWidth);
      if (short || !moved) break;
      yield robot.turn(side);
      side = -side;
    }
    for (let bounce = 0; bounce < 4; bounce++) {
      yield robot.forward(-0.05);
      yield robot.turn(robot.randint(90, 270));
      yield robot.forward(10);
    }
  }
}
