// @ts-check
// Which line a Python program is in: MicroPython has no sys.settrace, so before each statement stands one that sets the
// line; in loops it is a call that also counts. Inserting lines at the indentation of the next statement needs no parser,
// only where statements begin; `lines` leads back from the text that is run to the program's own.

import { scan, statements } from "./python-text.js";

/** @typedef {{line: number, condition?: string}} Breakpoint */
/** @typedef {import("./python-text.js").Statement} Statement */

/** Parts of a statement that began before. */
const PARTS = /^(elif|else|except|finally)\b/;
const LOOP = /^(while|for|async for)\b/;
const BEHAVIOUR = /^(?:async )?def (step|run|plan)\b/;
const ASSIGNED = /^([A-Za-z_]\w*(?:\s*,\s*[A-Za-z_]\w*)*)\s*(?:=(?!=)|[-+*/%&|^@]=|\/\/=|\*\*=|<<=|>>=)/;
const LOOPED = /^for\s+\(?\s*([A-Za-z_]\w*(?:\s*,\s*[A-Za-z_]\w*)*)\s*\)?\s+in\b/;
const NAMED = /\bas\s+([A-Za-z_]\w*)/;

/** Names that a function has: its parameters and what it sets. @param {Statement} head @param {Statement[]} body */
export function namesOf(head, body) {
  const names = (/\(([^]*)\)/.exec(head.text)?.[1] ?? "").split(",").map((parameter) => /[A-Za-z_]\w*/.exec(parameter)?.[0] ?? "");
  const outer = new Set();
  for (const { text } of body) {
    if (/^(global|nonlocal)\b/.test(text)) for (const name of text.replace(/^\w+/, "").split(",")) outer.add(name.trim());
    const set = ASSIGNED.exec(text) ?? LOOPED.exec(text) ?? (/^with\b/.test(text) ? NAMED.exec(text) : null);
    if (set) names.push(...set[1].split(",").map((name) => name.trim()));
  }
  return [...new Set(names)].filter((name) => name && !outer.has(name) && name !== "robot");
}

/** Where the first colon outside of brackets and lambdas ends a head; -1 if there is none. @param {string} text */
function headEnd(text) {
  let end = -1;
  let lambdas = 0;
  scan(text, (index, depth) => {
    if (depth > 0 || end >= 0) return;
    if (text.startsWith("lambda", index) && !/\w/.test(text[index - 1] ?? " ")) lambdas++;
    if (text[index] === ":" && text[index + 1] !== "=" && lambdas-- === 0) end = index;
    if (lambdas < 0) lambdas = 0;
  });
  return end;
}

/** The program with its calls, and the line of the program for each line of it, from 1. @param {string} source @param {Breakpoint[]} breakpoints */
export function instrument(source, breakpoints) {
  const lines = source.split("\n");
  const all = statements(source);
  /** @type {string[]} */
  const text = [];
  /** @type {number[]} */
  const numbers = [0];
  const put = (/** @type {string} */ words, /** @type {number} */ number) => {
    text.push(words);
    numbers.push(number);
  };
  let isDecorated = false;
  let next = 0;
  all.forEach((statement, index) => {
    const { at, indent } = statement;
    const number = at + 1;
    for (; next < at; next++) put(lines[next], next + 1);
    if (!PARTS.test(statement.text) && !isDecorated) {
      const before = all[index - 1];
      const isInLoop = before && LOOP.test(before.text) && indent.length > before.indent.length;
      put(`${indent}${isInLoop ? `_trace_at(${number})` : `_trace_line[0] = ${number}`}`, number);
      const stop = breakpoints.find(({ line }) => line === number);
      if (stop) put(`${indent}_trace_stop(${number}, lambda: (${stop.condition?.trim().replace(/\n/g, " ") || "True"}))`, number);
    }
    isDecorated = statement.text.startsWith("@");
    const count = statement.text.split("\n").length;
    const end = LOOP.test(statement.text) ? headEnd(statement.text) : -1;
    const rest = end < 0 ? "" : statement.text.slice(end + 1).trim();
    if (rest && !rest.startsWith("#") && count === 1) {
      // A loop on one line.
      put(indent + statement.text.slice(0, end + 1), number);
      put(`${indent} _trace_at(${number})`, number);
      put(`${indent} ${rest}`, number);
      next = at + 1;
      return;
    }
    for (; next < at + count; next++) put(lines[next], next + 1);
    if (indent === "" && BEHAVIOUR.test(statement.text)) {
      const body = [];
      for (let inner = index + 1; inner < all.length && all[inner].indent !== ""; inner++) body.push(all[inner]);
      const names = namesOf(statement, body);
      if (body.length > 0 && names.length > 0) put(`${body[0].indent}_trace_locals({${names.map((name) => `"${name}": lambda: ${name}`).join(", ")}})`, number);
    }
  });
  for (; next < lines.length; next++) put(lines[next], next + 1);
  return { source: text.join("\n"), lines: numbers };
}
