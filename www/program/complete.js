// @ts-check
// Completion and help at the pointer for the interface that programs see.
import * as cm from "../../codemirror.js";
import { make } from "../dom.js";
import { callHelp } from "./call-help.js";

/**
 * @typedef {object} Part As programs/interface.json lists them.
 * @property {string} name
 * @property {string} js
 * @property {string} kind
 * @property {string} group
 * @property {string} [args]
 * @property {string} [jsArgs]
 * @property {string} [unit]
 * @property {string} text
 * @property {Record<"python" | "javascript", string>} [example]
 */

/** @type {Part[]} */
let all = [];

/** @param {Part[]} list The interface: programs/interface.json. */
export const setInterface = (list) => void (all = list);
export const parts = () => all;

/** @param {Part} part @param {import("./editor.js").Language} language */
export const nameIn = ({ name, js }, language) => (language === "python" ? name : js);

/** @param {Part} part */
const ownerOf = ({ kind, group }) => (kind === "function" ? "" : group === "room" ? "room." : "robot.");

/** What it is, with an example. @param {Part} part @param {import("./editor.js").Language} language @param {boolean} [isShort] Without the example. */
export function about(part, language, isShort = false) {
  const args = (language === "python" ? part.args : part.jsArgs) ?? "";
  const head = make("code", {}, ownerOf(part) + nameIn(part, language) + (part.kind === "property" ? "" : `(${args})`));
  const example = isShort ? undefined : part.example?.[language];
  return make("div", { className: "cm-about" }, head, part.unit ? `, ${part.unit}` : "", make("p", {}, part.text), ...(example ? [make("pre", {}, example)] : []));
}

/** Completes a call; what is to be told stands between the brackets. @param {string} name @param {boolean} hasArgs */
const call = (name, hasArgs) => (/** @type {import("@codemirror/view").EditorView} */ view, /** @type {unknown} */ _, /** @type {number} */ from, /** @type {number} */ to) => {
  const isCalled = view.state.sliceDoc(to, to + 1) === "(";
  const text = name + (isCalled ? "" : "()");
  view.dispatch({ changes: { from, to, insert: text }, selection: { anchor: from + name.length + (hasArgs ? 1 : 2) }, userEvent: "input.complete" });
};

/** @param {import("./editor.js").Language} language @returns {(context: import("@codemirror/autocomplete").CompletionContext) => import("@codemirror/autocomplete").CompletionResult | null} */
function complete(language) {
  return (context) => {
    const member = context.matchBefore(/\b(\w+)\.\w*$/);
    if (!member) return null;
    const owner = member.text.slice(0, member.text.indexOf("."));
    const isRoom = owner === "room";
    const own = all.filter((part) => part.kind !== "function" && (part.group === "room") === isRoom);
    if (!isRoom && owner !== "robot" && owner !== "r") return null;
    return {
      from: member.from + owner.length + 1,
      validFor: /^\w*$/,
      options: own.map((part) => ({
        label: nameIn(part, language),
        detail: part.unit ?? "",
        type: part.kind,
        apply: part.kind === "property" ? nameIn(part, language) : call(nameIn(part, language), Boolean(part.args)),
        info: () => about(part, language),
      })),
    };
  };
}

/** @param {import("./editor.js").Language} language */
const hover = (language) =>
  cm.hoverTooltip((view, pos) => {
    const { from, text } = view.state.doc.lineAt(pos);
    for (const { index, 0: word } of text.matchAll(/\w+/g)) {
      const [start, end] = [from + index, from + index + word.length];
      if (pos < start || pos > end) continue;
      const before = text.slice(0, index);
      const isRoom = /\broom\.$/.test(before);
      const isMember = before.endsWith(".");
      const part = all.find((one) => nameIn(one, language) === word && (one.kind === "function" ? !isMember : isMember && (one.group === "room") === isRoom));
      return part ? { pos: start, end, above: true, create: () => ({ dom: about(part, language) }) } : null;
    }
    return null;
  });

/** @param {import("./editor.js").Language} language */
export const help = (language) => [(language === "python" ? cm.pythonLanguage : cm.javascriptLanguage).data.of({ autocomplete: complete(language) }), hover(language), callHelp(language)];
