// Answers quizzes of Learn from what the page shows of them, by other code than the page's.

/** What is known of a Roomba's wheels, as the question says it: counts of a turn, diameter and distance, mm. */
const [COUNTS, WHEEL, BASE] = [508.8, 72, 235];

/** @param {string} text @returns {number[]} */
const numbers = (text) => (text.match(/-?\d+(\.\d+)?/g) ?? []).map(Number);

/** A room by the description of its picture: cells by "x,y". */
function roomOf(description) {
  const rows = /rows from the top: ([#.S ]+);/.exec(description)[1].trim().split(" ");
  const cells = rows.flatMap((row, y) => [...row].flatMap((sign, x) => (sign === "#" ? [] : [`${x},${y}`])));
  const start = rows.flatMap((row, y) => [...row].flatMap((sign, x) => (sign === "S" ? [`${x},${y}`] : [])))[0] ?? cells[0];
  return { cells: new Set(cells), start, size: [rows[0].length, rows.length] };
}

function neighbours(cells, cell) {
  const [x, y] = cell.split(",").map(Number);
  return [`${x - 1},${y}`, `${x + 1},${y}`, `${x},${y - 1}`, `${x},${y + 1}`].filter((next) => cells.has(next));
}

function reached({ cells, start }) {
  const seen = new Set([start]);
  for (const cell of seen) for (const next of neighbours(cells, cell)) seen.add(next);
  return seen.size;
}

/** Lanes along the rows, or along the columns: those that begin at a wall. */
const lanes = ({ cells }, [dx, dy]) => [...cells].filter((cell) => {
  const [x, y] = cell.split(",").map(Number);
  return !cells.has(`${x - dx},${y - dy}`);
}).length;

/** Whether a closed walk visits every cell once. */
function closes({ cells, start }) {
  const left = new Set(cells);
  const goOn = (cell) => {
    left.delete(cell);
    const next = neighbours(cells, cell);
    const found = left.size === 0 ? next.includes(start) : next.some((step) => left.has(step) && goOn(step));
    left.add(cell);
    return found;
  };
  return goOn(start);
}

const KINDS = [
  [/How many cells can it reach/, (_, room) => reached(room)],
  [/in parallel lanes/, (_, room) => (lanes(room, [1, 0]) < lanes(room, [0, 1]) ? "along the rows" : "along the columns")],
  [/exactly once and returns/, (_, room) => (closes(room) ? "yes" : "no")],
  [/What is the median/, (text) => numbers(text).sort((a, b) => a - b)[2]],
  [/left encoder counts/, (text) => {
    const [left, right] = numbers(text);
    return ((((right - left) / COUNTS) * Math.PI * WHEEL) / BASE) * (180 / Math.PI);
  }],
  [/A cell begins at 50 %/, (text) => {
    const [, hits, , misses] = numbers(text);
    const odds = (0.7 / 0.3) ** hits * (0.4 / 0.6) ** misses;
    return (100 * odds) / (1 + odds);
  }],
  [/Drive Direct is opcode 145/, (text) => {
    const [right, left] = numbers(text).slice(-2);
    const bytes = (speed) => [(speed >> 8) & 255, speed & 255];
    return [145, ...bytes(right), ...bytes(left)].join(" ");
  }],
];

/** The right answer to a question: text to write, or of the button to press. `room` describes its picture, if there is one. */
export function rightAnswer(text, room) {
  const [, solve] = KINDS.find(([pattern]) => pattern.test(text)) ?? [];
  if (!solve) throw new Error(`a question of no known kind: ${text}`);
  return String(solve(text, room && roomOf(room)));
}
