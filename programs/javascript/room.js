// @ts-check
// The room as a planner sees it: the twin of programs/python/robovac_program/room.py.

/** A grid of cells; x counts to the right and y up, from 0. */
export class Room {
  /** @param {{rows: string[], cell: number, start: number[]}} room rows from the top */
  constructor({ rows, cell, start }) {
    this.rows = rows;
    this.height = rows.length;
    this.width = rows[0]?.length ?? 0;
    this.cell = cell;
    this.start = [start[0], start[1]];
    /** @type {[number, number][]} */
    this.free = [];
    for (let y = 0; y < this.height; y++) for (let x = 0; x < this.width; x++) if (this.isFree(x, y)) this.free.push([x, y]);
  }

  /** Whether that cell is floor; false outside the grid. @param {number} x @param {number} y */
  isFree(x, y) {
    return this.rows[this.height - 1 - y]?.[x] === ".";
  }
}
