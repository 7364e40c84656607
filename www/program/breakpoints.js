// @ts-check
// Breakpoints: a column beside the line numbers, the key F9, and a condition for each.
import * as cm from "../../codemirror.js";
import { make } from "../dom.js";

/** @typedef {import("@codemirror/view").EditorView} EditorView */
/** @typedef {import("@codemirror/state").EditorState} EditorState */

/** @type {import("@codemirror/state").StateEffectType<{ at: number, condition: string | undefined }>} A point set, or taken away without condition. */
const setPoint = cm.StateEffect.define({ map: ({ at, condition }, changes) => ({ at: changes.mapPos(at), condition }) });

class Point extends cm.GutterMarker {
  /** @param {string} condition Empty for none. */
  constructor(condition) {
    super();
    this.condition = condition;
  }

  /** @param {import("@codemirror/view").GutterMarker} other */
  eq(other) {
    return other instanceof Point && other.condition === this.condition;
  }

  toDOM() {
    return make("span", { className: this.condition ? "cm-point conditional" : "cm-point", title: this.condition ? `Stops when ${this.condition}` : "Stops here" }, this.condition ? "?" : "");
  }
}

const points = cm.StateField.define({
  /** @returns {import("@codemirror/state").RangeSet<Point>} */
  create: () => cm.RangeSet.empty,
  update(set, { changes, effects }) {
    let next = set.map(changes);
    for (const effect of effects) {
      if (!effect.is(setPoint)) continue;
      const { at, condition } = effect.value;
      next = next.update({ filter: (from) => from !== at, add: condition === undefined ? [] : [new Point(condition).range(at)] });
    }
    return next;
  },
});

/** @param {EditorState} state @returns {{ line: number, condition: string }[]} */
export function breakpointsOf(state) {
  /** @type {{ line: number, condition: string }[]} */
  const found = [];
  state.field(points).between(0, state.doc.length, (from, _to, point) => void found.push({ line: state.doc.lineAt(from).number, condition: point.condition }));
  return found;
}

/** @param {EditorView} view @param {{ line: number, condition: string }[]} wanted */
export function setBreakpoints(view, wanted) {
  const { doc } = view.state;
  view.dispatch({ effects: wanted.filter(({ line }) => line <= doc.lines).map(({ line, condition }) => setPoint.of({ at: doc.line(line).from, condition })) });
}

/** Sets one at the line of the cursor, or takes it away. @param {EditorView} view @param {number} [at] Start of another line. */
export function toggleBreakpoint(view, at = view.state.doc.lineAt(view.state.selection.main.head).from) {
  const { number } = view.state.doc.lineAt(at);
  const has = breakpointsOf(view.state).some(({ line }) => line === number);
  view.dispatch({ effects: setPoint.of({ at, condition: has ? undefined : "" }) });
  return true;
}

/** Asks for the condition in a line below the gutter. @param {EditorView} view @param {number} at */
function askCondition(view, at) {
  const { number } = view.state.doc.lineAt(at);
  const known = breakpointsOf(view.state).find(({ line }) => line === number)?.condition ?? "";
  const box = make("input", { type: "text", value: known, className: "cm-condition", placeholder: "stop when, such as robot.bump", "aria-label": `Condition of the breakpoint in line ${number}`, maxLength: 200 });
  const where = view.coordsAtPos(at);
  if (!where) return;
  Object.assign(box.style, { left: `${where.left}px`, top: `${where.top}px` });
  let isOpen = true;
  const close = (/** @type {boolean} */ isTaken) => {
    if (!isOpen) return;
    isOpen = false;
    if (isTaken) view.dispatch({ effects: setPoint.of({ at, condition: box.value.trim() }) });
    box.remove();
    view.focus();
  };
  box.addEventListener("keydown", (event) => {
    event.stopPropagation();
    if (event.key !== "Enter" && event.key !== "Escape") return;
    // Else the key would go on to the editor, which has the focus now.
    event.preventDefault();
    close(event.key === "Enter");
  });
  box.addEventListener("blur", () => close(true));
  document.body.append(box);
  box.focus();
}

/** Hands on the column and on the line numbers. @type {Record<string, (view: EditorView, block: import("@codemirror/view").BlockInfo, event: Event) => boolean>} */
const hands = {
  mousedown(view, { from }, event) {
    const { shiftKey, altKey, button } = /** @type {MouseEvent} */ (event);
    if (button === 2) return true;
    if (shiftKey || altKey) askCondition(view, from);
    else toggleBreakpoint(view, from);
    return true;
  },
  contextmenu(view, { from }, event) {
    event.preventDefault();
    askCondition(view, from);
    return true;
  },
};

/** The column. @param {() => void} marked Called when a breakpoint changes. */
export function breakpoints(marked) {
  return [
    points,
    cm.lineNumbers({ domEventHandlers: hands }),
    cm.gutter({
      class: "cm-points",
      markers: (view) => view.state.field(points),
      initialSpacer: () => new Point(""),
      domEventHandlers: hands,
    }),
    cm.keymap.of([
      {
        key: "Shift-F9",
        run: (view) => {
          askCondition(view, view.state.doc.lineAt(view.state.selection.main.head).from);
          return true;
        },
      },
    ]),
    cm.EditorView.updateListener.of(({ transactions }) => {
      if (transactions.some(({ effects }) => effects.some((effect) => effect.is(setPoint)))) marked();
    }),
  ];
}
