// @ts-check
// Which line a JavaScript program is in: a call before each statement. Works on the tree of @lezer/javascript, which the
// editor has, and inserts on the same line, so that lines stay the same.
import { SourceError } from "./words.js";

/** @typedef {{name: string, from: number, to: number, parent: Node | null, firstChild: Node | null, nextSibling: Node | null, type: {isError: boolean}}} Node */
/** @typedef {{topNode: Node, iterate(of: {enter: (node: {name: string, from: number, to: number, type: {isError: boolean}, node: Node}) => void}): void}} Tree */
/** @typedef {{line: number, condition?: string}} Breakpoint */

/** The first mistake in the tree as an error; undefined if there is none. @param {string} source @param {Tree} tree */
export function syntaxError(source, tree) {
  let at = -1;
  tree.iterate({ enter: ({ type, from }) => { if (type.isError && at < 0) at = from; } });
  if (at < 0) return undefined;
  const before = source.slice(0, at).split("\n");
  const rest = source.slice(at).split("\n")[0].trim().slice(0, 20);
  return new SourceError(`SyntaxError: ${rest ? `${JSON.stringify(rest)} is not expected here` : "something is missing at the end of this line"}`, before.length, before[before.length - 1].length + 1);
}

/** Whether the node is a statement. @param {Node} node */
const isStatement = ({ name }) => /Statement$|^VariableDeclaration$|^Block$/.test(name);

/** The program with calls of `$trace`. @param {string} source @param {Tree} tree @param {Breakpoint[]} breakpoints */
export function instrument(source, tree, breakpoints) {
  /** @type {[at: number, text: string][]} */
  const inserts = [];
  const starts = [0];
  for (let at = source.indexOf("\n"); at >= 0; at = source.indexOf("\n", at + 1)) starts.push(at + 1);
  const lineOf = (/** @type {number} */ at) => {
    let [low, high] = [0, starts.length];
    while (high - low > 1) starts[(low + high) >> 1] <= at ? (low = (low + high) >> 1) : (high = (low + high) >> 1);
    return low + 1;
  };
  const stopped = new Set();
  const call = (/** @type {number} */ at) => {
    const line = lineOf(at);
    const stop = breakpoints.find((breakpoint) => breakpoint.line === line && !stopped.has(line));
    if (stop) stopped.add(line);
    return `$trace.at(${line});${stop ? `$trace.stop(${line}, () => (${stop.condition?.trim() || "true"}));` : ""}`;
  };
  tree.iterate({
    enter: ({ node }) => {
      const parent = node.parent;
      if (node.name === "export") inserts.push([node.from, "/*"], [node.to, "*/"]);
      if (!parent) return;
      // A loop over nothing.
      if (node.name === ";" && (/^(For|While)Statement$/.test(parent.name) || (parent.name === "DoStatement" && parent.firstChild?.nextSibling?.from === node.from))) {
        inserts.push([node.from, `{${call(node.from)}`], [node.to, "}"]);
      }
      if (!isStatement(node)) return;
      if (["Script", "Block", "ExportDeclaration"].includes(parent.name)) {
        // Its loop or function says where it is.
        if (node.name !== "Block" && parent.name !== "ExportDeclaration") inserts.push([node.from, call(node.from)]);
      } else if (node.name !== "Block" && /^(If|For|While|Do|With)Statement$/.test(parent.name) && !(parent.name === "ForStatement" && node.name === "VariableDeclaration")) {
        inserts.push([node.from, `{${call(node.from)}`], [node.to, "}"]);
      } else if (node.name === "Block" && /^(For|While|Do)Statement$/.test(parent.name)) {
        inserts.push([node.from + 1, call(node.from)]);
      } else if (parent.name === "SwitchStatement" || parent.name === "SwitchBody") {
        inserts.push([node.from, call(node.from)]);
      }
    },
  });
  const top = variablesOf(tree.topNode, source);
  inserts.push([0, `$trace.globals({${thunks(top)}});`]);
  for (let node = tree.topNode.firstChild; node; node = node.nextSibling) {
    const declared = node.name === "ExportDeclaration" ? child(node, "FunctionDeclaration") : node;
    if (declared?.name !== "FunctionDeclaration") continue;
    const [name, parameters, body] = [child(declared, "VariableDefinition"), child(declared, "ParamList"), child(declared, "Block")];
    if (!name || !body || !["step", "run", "plan"].includes(source.slice(name.from, name.to))) continue;
    const own = [...(parameters ? definitions(parameters, source) : []), ...variablesOf(body, source)];
    inserts.push([body.from + 1, `$trace.locals({${thunks(own)}});`]);
  }
  inserts.sort((a, b) => a[0] - b[0]);
  let [text, at] = ["", 0];
  for (const [place, insert] of inserts) {
    text += source.slice(at, place) + insert;
    at = place;
  }
  return text + source.slice(at);
}

/** @param {string[]} names */
const thunks = (names) => [...new Set(names)].map((name) => `${name}: () => ${name}`).join(", ");

/** @param {Node} node @param {string} name */
function child(node, name) {
  for (let part = node.firstChild; part; part = part.nextSibling) if (part.name === name) return part;
  return null;
}

/** Variables that a block itself declares. @param {Node} block @param {string} source */
function variablesOf(block, source) {
  const names = [];
  for (let node = block.firstChild; node; node = node.nextSibling) if (node.name === "VariableDeclaration") names.push(...definitions(node, source));
  return names;
}

/** Names that are defined in a declaration or a list of parameters, not in functions therein. @param {Node} within @param {string} source @returns {string[]} */
function definitions(within, source) {
  const names = [];
  for (let node = within.firstChild; node; node = node.nextSibling) {
    if (node.name === "VariableDefinition") names.push(source.slice(node.from, node.to));
    else if (/Pattern/.test(node.name)) names.push(...definitions(node, source));
  }
  return names;
}
