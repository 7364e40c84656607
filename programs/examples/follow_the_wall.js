// Follows the wall on its right by the light bumper: a PD controller steers by how far the signal is off, and by how
// fast that changes. Around a room it turns left; once it has turned right by more than a circle, it has gone round
// something that stands alone, and looks for another wall.
const TARGET = 1000; // signal to keep: about 3 cm from a light wall
const [P, D] = [70, 22];
let state = "search";
let last = 0;
let until = 0;
let met = 0;

function step(robot) {
  const light = robot.light;
  const right = light[5];
  const ahead = Math.max(light[2], light[3], light[4]);
  if (robot.bump || robot.cliff) {
    if (state === "search") met = robot.turned;
    state = "back";
    until = robot.time + 0.25;
  }
  if (state === "search") {
    robot.go(0.25);
    if (ahead > 300 || right > 300) {
      state = "follow";
      met = robot.turned;
    }
  } else if (state === "back") {
    robot.go(-0.12, 60);
    if (robot.time > until) state = "follow";
  } else if (state === "leave") {
    robot.go(0, 90);
    if (robot.time > until) state = "search";
  } else if (met - robot.turned > 400) {
    state = "leave";
    until = robot.time + 1;
  } else if (ahead > 500) {
    robot.go(0.05, 80); // an inner corner
  } else {
    const error = Math.max(-1, Math.min(1, (right - TARGET) / TARGET));
    const change = (error - last) / 0.015;
    last = error;
    robot.go(0.22, Math.max(-75, Math.min(75, P * error + D * 0.05 * change)));
  }
}
