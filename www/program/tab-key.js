// @ts-check
// Tab passes through the editor for those who come by it, and indents once they write: a program isn't changed in passing.
import * as cm from "../../codemirror.js";

let isByTab = false;
addEventListener("keydown", ({ key }) => (isByTab = key === "Tab"), { capture: true });
addEventListener("pointerdown", () => (isByTab = false), { capture: true });

const SIGN = "by-tab";
const pass = (/** @type {import("@codemirror/view").EditorView} */ view, /** @type {boolean} */ passes) => {
  view.setTabFocusMode(passes);
  // CodeMirror writes the classes of its own element.
  view.dom.parentElement?.classList.toggle(SIGN, passes);
};

export const leaveByTab = cm.EditorView.domEventHandlers({
  focus: (_event, view) => void pass(view, isByTab),
  blur: (_event, view) => void pass(view, false),
  mousedown: (_event, view) => void pass(view, false),
  keydown: ({ key }, view) => void (["Tab", "Shift"].includes(key) || pass(view, false)),
});
