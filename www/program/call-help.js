// @ts-check
// While one writes what a call takes: what that is, above the line.
import * as cm from "../../codemirror.js";
import { about, nameIn, parts } from "./complete.js";

/** @typedef {import("@codemirror/view").Tooltip | null} Shown */

/** @type {import("@codemirror/state").StateEffectType<null>} */
const hide = cm.StateEffect.define();

/** The call whose brackets hold the cursor. @param {import("@codemirror/state").EditorState} state @param {import("./editor.js").Language} language @returns {Shown} */
function callAt({ doc, selection }, language) {
  const { head, empty } = selection.main;
  const { from, text } = doc.lineAt(head);
  // From bracket to bracket, outwards.
  for (let at = head - from - 1, closed = 0; empty && at >= 0; at -= 1) {
    if (text[at] === ")") closed += 1;
    if (text[at] !== "(" || closed-- > 0) continue;
    closed = 0;
    const [, owner, name] = text.slice(0, at).match(/\b(robot|room|r)\.(\w+)$/) ?? [];
    const part = parts().find((one) => one.kind !== "property" && nameIn(one, language) === name && (one.group === "room") === (owner === "room"));
    if (part) return { pos: from + at, above: true, create: () => ({ dom: about(part, language, true) }) };
  }
  return null;
}

/** @param {import("./editor.js").Language} language */
export function callHelp(language) {
  const field = cm.StateField.define({
    create: () => /** @type {Shown} */ (null),
    // Where one only moves through the text, it would cover what is read.
    update(shown, { docChanged, selection, effects, state }) {
      if (effects.some((effect) => effect.is(hide))) return null;
      return docChanged || (selection && shown) ? callAt(state, language) : shown;
    },
    provide: (field) => cm.showTooltip.from(field),
  });
  const end = (/** @type {import("@codemirror/view").EditorView} */ view) => {
    // A program in the other language may have been opened since.
    const isShown = Boolean(view.state.field(field, false));
    if (isShown) view.dispatch({ effects: hide.of(null) });
    return isShown;
  };
  return [
    field,
    cm.Prec.high(cm.keymap.of([{ key: "Escape", run: end }, { key: "Mod-Enter", run: (view) => (end(view), false) }])),
    cm.EditorView.domEventHandlers({ blur: (_, view) => void setTimeout(() => end(view)) }),
  ];
}
