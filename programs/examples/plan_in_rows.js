// A planner: row after row, to and fro. At the end of a row it hops to the nearest cell that is left, over floor only.
const name = (x, y) => `${x} ${y}`;

/** The shortest way to a cell that is left, without its start; breadth first. */
function hop(room, start, left) {
  const queue = [start];
  const came = new Map([[name(...start), null]]);
  for (let cell of queue) {
    if (left.has(name(...cell))) {
      const path = [];
      for (; came.get(name(...cell)); cell = came.get(name(...cell))) path.unshift(cell);
      return path;
    }
    const [x, y] = cell;
    for (const beside of [[x + 1, y], [x - 1, y], [x, y + 1], [x, y - 1]]) {
      if (!came.has(name(...beside)) && room.isFree(...beside)) {
        came.set(name(...beside), cell);
        queue.push(beside);
      }
    }
  }
  return [];
}

function* plan(room) {
  const left = new Set(room.free.map(([x, y]) => name(x, y)));
  let [x, y] = room.start;
  let ahead = 1;
  yield [x, y];
  left.delete(name(x, y));
  while (left.size > 0) {
    let path;
    if (left.has(name(x + ahead, y))) {
      path = [[x + ahead, y]];
    } else if (left.has(name(x - ahead, y))) {
      ahead = -ahead;
      path = [[x + ahead, y]];
    } else {
      path = hop(room, [x, y], left);
      if (path.length === 0) return; // the rest can't be reached
      ahead = -ahead;
    }
    for ([x, y] of path) {
      yield [x, y];
      left.delete(name(x, y));
    }
  }
}
