// Drives a square of 60 cm and draws it on the floor.
const SIDE = 0.6;

function* run(robot) {
  for (let corner = 0; corner < 4; corner++) {
    const [x, y] = [robot.x, robot.y];
    robot.text(x, y, corner + 1);
    if (!(yield robot.forward(SIDE))) {
      print("Something is in the way of side", corner + 1);
    }
    robot.line(x, y, robot.x, robot.y, "blue");
    yield robot.turn(90);
  }
  print("Back after", Math.round(robot.time), "s");
}
