// @ts-check
// What is meant by MicroPython's errors: it says "invalid syntax" to all mistakes of spelling. CPython says it by itself.
import { scan, statements } from "./python-text.js";
import { namesOf } from "./trace-python.js";

/** @typedef {{ message: string, line: number | undefined }} Told */

/** Heads of blocks. */
const HEAD = /^(async\s+)?(def|if|elif|else|for|while|class|try|except|finally|with)\b/;
/** What other languages write, and Python's way. @type {[RegExp, string][]} */
const FOREIGN = [
  [/^else\s+if\b/, "Python writes elif"],
  [/&&/, 'Python writes "and" for &&'],
  [/\|\|/, 'Python writes "or" for ||'],
  [/!(?!=)/, 'Python writes "not" for !'],
  [/\+\+|--$/, "Python has no ++ and --: write += 1 or -= 1"],
  [/^\/\//, "a comment begins with #"],
  [/\{$|^\}/, "Python has a colon and indented lines in place of { and }"],
  [/^print\s+[^(=]/, "print needs parentheses: print(...)"],
  [/^(function|var|let|const)\b/, "this looks like JavaScript: choose it as the program's language"],
];
/** Names of other languages. @type {Record<string, string>} */
const NAMES = { true: "True", false: "False", null: "None", none: "None", undefined: "None", this: "robot", self: "robot" };
const MODULES = new Set(["math", "random", "json", "time"]);

/** The text without what stands in strings and comments. @param {string} text */
function bare(text) {
  const kept = Array.from({ length: text.length }, () => " ");
  scan(text, (index) => void (kept[index] = text[index]));
  return kept.join("");
}

/** A bracket that isn't closed at the end of a line or one too many: then what it is. @param {string} line */
function brackets(line) {
  let depth = 0;
  for (const character of line) {
    if ("([{".includes(character)) depth += 1;
    else if (")]}".includes(character)) depth -= 1;
    if (depth < 0) return "a closing bracket has no opening one";
  }
  return depth > 0 ? "a bracket isn't closed" : "";
}

/** Whether a text in quotes has no end on its line. @param {string} line */
function isOpenText(line) {
  if (/"""|'''/.test(line)) return false;
  let quote = "";
  for (let at = 0; at < line.length; at += 1) {
    if (line[at] === "\\") at += 1;
    else if (quote) quote = line[at] === quote ? "" : quote;
    else if (line[at] === "#") break;
    else if (line[at] === '"' || line[at] === "'") quote = line[at];
  }
  return quote !== "";
}

const indent = (/** @type {string} */ line) => /^[ \t]*/.exec(line)?.[0] ?? "";

/** Mistakes of spelling, at the line where MicroPython stumbled or the one before. @param {string} source @param {number} line @returns {Told | undefined} */
function spelling(source, line) {
  const lines = source.split("\n");
  const isCode = (/** @type {string} */ text) => !/^\s*(#.*)?$/.test(text);
  const before = lines.slice(0, line - 1).findLastIndex(isCode) + 1;
  for (const number of [line, before].filter((number) => number > 0)) {
    const raw = lines[number - 1] ?? "";
    const code = bare(raw).trim();
    const told = (/** @type {string} */ message) => ({ message, line: number });
    const foreign = FOREIGN.find(([sign]) => sign.test(code));
    if (isOpenText(raw)) return told("a text isn't closed: it ends with the quotation mark that it begins with");
    if (foreign) return told(foreign[1]);
    if (brackets(code)) return told(brackets(code));
    if (HEAD.test(code) && !/:/.test(code)) return told("a colon (:) is missing at the end of the line");
    if (/^(if|elif|while)\b/.test(code) && /[^=!<>]=(?!=)/.test(code)) return told("to compare, write ==; a single = sets a variable");
    if (number === line && before > 0 && /:$/.test(bare(lines[before - 1]).trim()) && indent(raw).length <= indent(lines[before - 1]).length)
      return told(`what belongs to line ${before} must be indented by four spaces`);
    if (number === line && before > 0 && indent(raw).includes("\t") !== indent(lines[before - 1]).includes("\t"))
      return told("tabs and spaces are mixed at the beginnings of lines: use four spaces");
  }
  return undefined;
}

/** The first line whose indentation fits none above it. @param {string} source @returns {Told | undefined} */
function unlike(source) {
  const open = [""];
  let before = "";
  for (const { at, indent, text } of statements(source)) {
    const inner = open[open.length - 1];
    while (open.length > 1 && open[open.length - 1].length > indent.length) open.pop();
    if (open[open.length - 1] !== indent) {
      if (open[open.length - 1].length < inner.length) return { message: "this line's indentation fits none of the lines above", line: at + 1 };
      if (!/:$/.test(bare(before).trim())) return { message: "this line is indented more than the one before it, which doesn't end with a colon", line: at + 1 };
      open.push(indent);
    }
    before = text;
  }
  return undefined;
}

/** A variable of outside that a function sets. @param {string} source @param {number} line */
function outside(source, line) {
  const all = statements(source);
  const head = all.findLastIndex(({ at, indent, text }) => at < line && indent === "" && /^(async\s+)?def\b/.test(text));
  const end = all.findIndex(({ indent }, index) => index > head && indent === "");
  if (head < 0) return undefined;
  const own = namesOf({ ...all[head], text: "" }, all.slice(head + 1, end < 0 ? undefined : end));
  const outer = namesOf({ at: 0, indent: "", text: "" }, all.filter(({ indent }) => indent === ""));
  /** @type {string[]} */
  const words = bare(source.split("\n")[line - 1] ?? "").match(/[A-Za-z_]\w*/g) ?? [];
  return own.find((name) => outer.includes(name) && words.includes(name));
}

/** MicroPython's message in words that name the mend. @param {string} message @param {number | undefined} line @param {string} source @returns {Told} */
export function explained(message, line, source) {
  const text = bare(source.split("\n")[(line ?? 0) - 1] ?? "");
  const is = (/** @type {string} */ told, at = line) => ({ message: told, line: at });
  if (message === "SyntaxError: invalid syntax" && line) {
    const told = spelling(source, line);
    return told ? is(`SyntaxError: ${told.message}`, told.line) : is("SyntaxError: this line isn't Python. Look at its spelling, brackets and colons");
  }
  if (/invalid syntax for (integer|number)/.test(message)) return is("SyntaxError: this number has letters in it");
  if (/^IndentationError/.test(message)) {
    const told = unlike(source);
    return told ? is(`IndentationError: ${told.message}`, told.line) : is(message);
  }
  const name = /^NameError: name '(\w+)'/.exec(message)?.[1] ?? "";
  if (Object.hasOwn(NAMES, name)) return is(`NameError: there is no ${name}; did you mean ${NAMES[name]}?`);
  if (MODULES.has(name)) return is(`NameError: there is no ${name} yet: write import ${name} in the first line`);
  if (/^NameError: local variable referenced/.test(message)) {
    const variable = line ? outside(source, line) : undefined;
    if (variable) return is(`NameError: the function sets ${variable}, so it has a ${variable} of its own, without a value yet. Write global ${variable} as its first line to use the one outside`);
    return is("NameError: a variable is used before it has a value");
  }
  const set = /^'Robot' object has no attribute '(\w+)'/.exec(message)?.[1];
  if (set) return is(`robot.${set} is measured: a program can't set it${/speed$/.test(set) ? ". robot.go and robot.drive set speeds" : ""}`);
  const [, called, takes, given] = /^TypeError: (\w+)\(\) takes (\d+) positional arguments but (\d+) were given/.exec(message) ?? [];
  if (called && (called === "step" || called === "run") && takes === "0") return is(`${called} is given the robot: write def ${called}(robot):`, whereDefined(source, called));
  if (called && new RegExp(`\\brobot\\s*\\.\\s*${called}\\s*\\(`).test(text)) {
    const [most, got] = [Number(takes) - 1, Number(given) - 1];
    return is(`robot.${called} takes ${got < most ? "at least" : "at most"} ${most} value${most === 1 ? "" : "s"} in its parentheses, not ${got}`);
  }
  const reading = /\brobot\s*\.\s*(\w+)\s*\(/.exec(text)?.[1];
  if (reading && /^TypeError: '(bool|int|float|tuple)' object isn't callable/.test(message)) return is(`robot.${reading} is a reading, no function: write it without parentheses`);
  return is(message);
}

/** A command that stands there without parentheses, and so does nothing. @param {string} source @returns {Told | undefined} */
export function uncalled(source) {
  const found = statements(source).find(({ text }) => /^robot\.(stop|done|drive|go|forward|turn|arc|wait|until|mark|line|text|clear)$/.test(bare(text).trim()));
  return found && { message: `${found.text} does nothing without parentheses: write ${found.text}(...)`, line: found.at + 1 };
}

/** @param {string} source @param {string} name */
function whereDefined(source, name) {
  const at = statements(source).find(({ text }) => new RegExp(`^(async\\s+)?def\\s+${name}\\b`).test(text))?.at;
  return at === undefined ? undefined : at + 1;
}
