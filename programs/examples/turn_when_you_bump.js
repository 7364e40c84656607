// Drives straight on; at a bump, backs off and turns.
let turnUntil = 0;

function step(robot) {
  if (robot.bump || robot.cliff) {
    robot.go(-0.15);
    turnUntil = robot.time + 0.4 + robot.random();
  } else if (robot.time < turnUntil) {
    robot.go(0, 120);
  } else {
    robot.go(0.3);
  }
}
