// @ts-check
// Python's text, as far as one gets without a parser: what is outside strings and comments, and where statements begin.

/** A statement, or the head of one: its first line, counted from 0, its indentation, and its text with all its lines.
 * @typedef {{at: number, indent: string, text: string}} Statement */

/** Goes through Python's text; calls `seen(index, depth)` for each character outside strings and comments, with the depth of
 * its brackets. @param {string} source @param {(index: number, depth: number) => void} seen */
export function scan(source, seen) {
  let depth = 0;
  for (let at = 0; at < source.length; at++) {
    const character = source[at];
    if (character === "#") {
      while (at + 1 < source.length && source[at + 1] !== "\n") at++;
    } else if (character === '"' || character === "'") {
      const triple = source.startsWith(character.repeat(3), at);
      const end = triple ? character.repeat(3) : character;
      at += end.length;
      while (at < source.length && !source.startsWith(end, at) && (triple || source[at] !== "\n")) at += source[at] === "\\" ? 2 : 1;
      at += end.length - 1;
    } else if (character === "\\" && source[at + 1] === "\n") {
      at++;
    } else {
      if ("([{".includes(character)) depth++;
      if (")]}".includes(character)) depth = Math.max(0, depth - 1);
      seen(at, depth);
    }
  }
}

/** The statements of a program. @param {string} source @returns {Statement[]} */
export function statements(source) {
  const ends = new Set();
  scan(source, (index, depth) => { if (source[index] === "\n" && depth === 0) ends.add(index); });
  const lines = source.split("\n");
  /** @type {Statement[]} */
  const found = [];
  let [at, start, from, line] = [0, 0, 0, 0];
  for (const text of lines) {
    const end = from + text.length;
    if (ends.has(end) || end >= source.length) {
      const whole = source.slice(start, end);
      if (!/^\s*(#.*)?$/.test(whole)) found.push({ at, indent: /^[ \t]*/.exec(whole)?.[0] ?? "", text: whole.trim() });
      [at, start] = [line + 1, end + 1];
    }
    from = end + 1;
    line++;
  }
  return found;
}
