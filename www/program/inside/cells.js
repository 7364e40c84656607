// @ts-check
// The walk of a planner, collected.

/** Longest walk, cells. */
const MOST = 2_000_000;

/** Cells as x and y in turn. @param {import("./drive.js").Program} program @param {string} room As JSON. @returns {Uint32Array} */
export function cellsOf(program, room) {
  /** @type {number[]} */
  const cells = [];
  for (const [x, y] of program.plan(JSON.parse(room))) {
    cells.push(x, y);
    if (cells.length > 2 * MOST) throw { message: `The plan has more than ${MOST} cells. Make it end.`, line: program.line };
  }
  return new Uint32Array(cells);
}
