// Keeps a map by odometry, always goes to the nearest place where it hasn't been, and drives home when there is none.
const CELL = 0.16;
const AHEAD = [[1, 0], [0, 1], [-1, 0], [0, -1]]; // right, up, left, down: headings 0, 90, 180 and 270 degrees
const known = new Map(); // "clean", "open" (seen from beside) or "blocked" for each cell
let home;

/** Rounded to the nearest, and from the middle to the even one, as Python does. */
function round(value) {
  const floor = Math.floor(value);
  return value - floor === 0.5 ? floor + (floor % 2 === 0 ? 0 : 1) : Math.round(value);
}

const name = (x, y) => `${x} ${y}`;
const cellOf = (robot) => [round(robot.x / CELL), round(robot.y / CELL)];

/** The shortest way over clean cells to one that is wanted, as directions; null if there is none. */
function way(start, wanted) {
  const queue = [start];
  const came = new Map([[name(...start), null]]);
  for (const cell of queue) {
    let at = name(...cell);
    if (known.get(at) === wanted || (wanted === "home" && at === name(...home))) {
      const steps = [];
      for (; came.get(at); at = came.get(at)[0]) steps.unshift(came.get(at)[1]);
      return steps;
    }
    AHEAD.forEach(([x, y], direction) => {
      const beside = [cell[0] + x, cell[1] + y];
      if (!came.has(name(...beside)) && (known.get(name(...beside)) ?? "blocked") !== "blocked") {
        came.set(name(...beside), [at, direction]);
        queue.push(beside);
      }
    });
  }
  return null;
}

function visit(robot, [x, y]) {
  known.set(name(x, y), "clean");
  robot.mark(x * CELL, y * CELL, "green");
  for (const [dx, dy] of AHEAD) if (!known.has(name(x + dx, y + dy))) known.set(name(x + dx, y + dy), "open");
}

/** Drives to the next cell in that direction. Says whether it got there. */
function* go(robot, direction) {
  const here = cellOf(robot);
  const [dx, dy] = AHEAD[direction];
  const [x, y] = [here[0] + dx, here[1] + dy];
  // Its heading and place aren't exact: aim at the cell's middle.
  yield robot.turn(((90 * direction - robot.heading + 540) % 360) - 180);
  const along = (x * CELL - robot.x) * dx + (y * CELL - robot.y) * dy;
  const near = Math.max(...robot.light.slice(1, 5)) > 20; // carefully: at a bump the wheels slip
  if (yield robot.forward(along, near ? 0.12 : 0.3)) return true;
  known.set(name(x, y), "blocked");
  robot.mark(x * CELL, y * CELL, "red");
  yield robot.forward(-0.04);
  return false;
}

function* run(robot) {
  home = cellOf(robot);
  visit(robot, home);
  let steps = way(home, "open");
  while (steps !== null) {
    for (const direction of steps) {
      if (!(yield* go(robot, direction))) break;
    }
    visit(robot, cellOf(robot));
    steps = way(cellOf(robot), "open");
  }
  print("Everything that I can reach is clean. Going home.");
  for (const direction of way(cellOf(robot), "home") ?? []) {
    if (!(yield* go(robot, direction))) break;
  }
}
