// @ts-check
// Errors that name the cause and the mend: the twin of programs/python/robovac_program/words.py.

/** What a program can be: it has one function of these names. */
export const KINDS = ["step", "run", "plan"];

/** A mistake in a program, said in words, with its line and column if they are known. */
export class SourceError extends Error {
  /** @param {string} message @param {number} [line] @param {number} [column] */
  constructor(message, line, column) {
    super(message);
    this.name = "SourceError";
    this.line = line;
    this.column = column;
  }
}

/** Letters to insert, delete, replace or swap to get from `a` to `b`. @param {string} a @param {string} b */
function distance(a, b) {
  /** @type {number[]} */
  let before = [];
  let row = Array.from({ length: b.length + 1 }, (_, index) => index);
  for (let i = 1; i <= a.length; i++) {
    const older = before;
    before = row;
    row = [i];
    for (let j = 1; j <= b.length; j++) {
      let cost = Math.min(before[j - 1] + (a[i - 1] === b[j - 1] ? 0 : 1), before[j] + 1, row[j - 1] + 1);
      if (i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1]) cost = Math.min(cost, older[j - 2] + 1);
      row[j] = cost;
    }
  }
  return row[b.length];
}

/** The one of `names` that is meant by `name`. @param {string} name @param {readonly string[]} names @returns {string | undefined} */
export function nearest(name, names) {
  const plain = (/** @type {string} */ text) => text.replaceAll("_", "").toLowerCase();
  let best;
  let least = Math.max(1, Math.floor(plain(name).length / 3)) + 1;
  for (const other of names) {
    const off = distance(plain(name), plain(other));
    if (off < least) [best, least] = [other, off];
  }
  return best;
}

/** Says that `what` has no `name`, and what may be meant. @param {string} what @param {string} name @param {readonly string[]} names */
export function unknown(what, name, names) {
  const meant = nearest(name, names);
  return `${what}.${name}: there is no such name${meant === undefined ? "" : `; did you mean ${meant}?`}`;
}

/** `value`, or an error that names `place`. @param {string} place @param {unknown} value @returns {number} */
export function number(place, value) {
  if (typeof value === "number" && value - value === 0) return value;
  throw new SourceError(`${place} must be a number, not ${shown(value)}`);
}

/** The value as text for a message or a table. @param {unknown} value @param {number} [most] */
export function shown(value, most = 80) {
  let text;
  try {
    if (typeof value === "function") text = "a function";
    else if (typeof value === "object" && value !== null) {
      text = value instanceof Map || value instanceof Set ? `${value.constructor.name}(${JSON.stringify([...value])})` : JSON.stringify(value);
    } else text = typeof value === "string" ? JSON.stringify(value) : String(value);
  } catch {
    text = "a value that can't be shown";
  }
  text ??= "undefined";
  return text.length > most ? `${text.slice(0, most - 1)}…` : text;
}

/** What was meant to be the behaviour: the kind and the name that it has. @param {string} source */
export function meant(source) {
  for (const [, name] of source.matchAll(/function\s*\*?\s*(\w+)/g)) {
    const kind = nearest(name, KINDS);
    if (kind) return { kind, name };
  }
  return undefined;
}

/** @param {string} source */
export function missing(source) {
  const instead = meant(source);
  if (instead) return `there is no function step(robot), function* run(robot) or plan(room); did you mean ${instead.kind} instead of ${instead.name}?`;
  return "there is no function step(robot) (called every 15 ms), function* run(robot) (with yield) or plan(room) (a planner)";
}

/** The error at the line where a motion is made that nothing waits for: it comes with the next step. @param {SourceError} error @param {string} source */
export function atIdle(error, source) {
  const motion = /^robot\.(\w+)\(\.\.\.\) does nothing without yield/.exec(error.message)?.[1];
  if (!motion) return error;
  const makes = source.split("\n").map((text) => new RegExp(`^\\s*robot\\s*\\.\\s*${motion}\\s*\\(`).test(text));
  error.line = makes.lastIndexOf(true, (error.line ?? makes.length) - 1) + 1 || makes.indexOf(true) + 1 || error.line;
  return error;
}

/** An error with the program's line. @param {any} error @param {string} name @param {number} at the line that is known otherwise */
export function located(error, name, at) {
  if (error instanceof SourceError && error.line) return error;
  /** @type {(number | undefined)[]} */
  let [line, column] = [at || undefined, undefined];
  const escaped = name.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
  // The innermost place in the program.
  const place = new RegExp(`${escaped}:(\\d+)(?::(\\d+))?`).exec(String(error?.stack ?? "").split("\n").slice(error?.stack?.startsWith?.(error?.name) ? 1 : 0).join("\n"));
  if (place) [line, column] = [Number(place[1]), Number(place[2]) || undefined];
  if (error instanceof RangeError && /stack|recursion/i.test(error.message)) return new SourceError("a function calls itself without end", line);
  if (error instanceof SourceError) return new SourceError(error.message, line, column);
  // `yield` is a word only there.
  if (/strict mode reserved word/.test(error?.message) && !line) return new SourceError("SyntaxError: yield needs a generator: write function* run(robot)");
  const words = error instanceof Error ? `${error.name}: ${error.message}` : `thrown: ${shown(error)}`;
  return new SourceError(words, line, column);
}
