// Drives lanes up and down, side by side, over floor that is unswept on its own map. If there is none beside it,
// it drives to the nearest over swept floor; if there is none at all, it forgets its map, which has drifted, and starts again.
const CELL = 0.16; // from lane to lane, m: a little less than the tool is wide
const AHEAD = [[0, 1], [0, -1], [1, 0], [-1, 0]]; // up, down, right, left: lanes first
const HEADING = [90, -90, 0, 180];
const swept = new Set();
const blocked = new Set();

/** Rounded to the nearest, and from the middle to the even one, as Python does. */
function round(value) {
  const floor = Math.floor(value);
  return value - floor === 0.5 ? floor + (floor % 2 === 0 ? 0 : 1) : Math.round(value);
}

const cellOf = (robot) => [round(robot.x / CELL), round(robot.y / CELL)];
const name = (cell) => cell.join(" ");
const isNew = (cell) => !swept.has(name(cell)) && !blocked.has(name(cell));

/** The shortest way over swept cells to a new one: its first direction, and its cells; null if there is none. */
function way(start) {
  const queue = [start];
  const came = new Map([[name(start), null]]);
  for (const cell of queue) {
    if (isNew(cell) && cell !== start) {
      const cells = new Set();
      let direction = 0;
      for (let at = name(cell); came.get(at); ) {
        cells.add(at);
        [at, direction] = came.get(at);
      }
      return { direction, cells };
    }
    AHEAD.forEach(([x, y], direction) => {
      const beside = [cell[0] + x, cell[1] + y];
      if (came.has(name(beside)) || blocked.has(name(beside))) return;
      came.set(name(beside), [name(cell), direction]);
      queue.push(beside);
    });
  }
  return null;
}

/** Straight on over those cells, and in a lane as long as the floor ahead is new. */
function* drive(robot, { direction, cells }) {
  const [x, y] = AHEAD[direction];
  yield robot.turn(((HEADING[direction] - robot.heading + 540) % 360) - 180);
  while (true) {
    const here = cellOf(robot);
    swept.add(name(here));
    const ahead = [here[0] + x, here[1] + y];
    if (robot.bump || robot.cliff) {
      blocked.add(name(ahead));
      robot.mark(ahead[0] * CELL, ahead[1] * CELL, "red");
      yield robot.forward(-0.04);
      return;
    }
    const along = (here[0] * CELL - robot.x) * x + (here[1] * CELL - robot.y) * y;
    if (along <= 0.01 && !cells.has(name(ahead)) && !(direction < 2 && isNew(ahead))) {
      robot.stop();
      yield;
      return;
    }
    // Back to the middle of the lane: by how far it is to the left, and by its heading.
    const off = (here[1] * CELL - robot.y) * x - (here[0] * CELL - robot.x) * y;
    const wrong = ((HEADING[direction] - robot.heading + 540) % 360) - 180;
    const near = Math.max(...robot.light.slice(1, 5)) > 300; // carefully: at a bump the wheels slip
    robot.go(near ? 0.15 : 0.3, Math.max(-60, Math.min(60, 300 * off + 2 * wrong)));
    yield;
  }
}

function* run(robot) {
  while (true) {
    const found = way(cellOf(robot));
    if (found) yield* drive(robot, found);
    else {
      print("All lanes are swept. Once more.");
      swept.clear();
      blocked.clear();
      robot.clear();
      yield robot.turn(90);
    }
  }
}
