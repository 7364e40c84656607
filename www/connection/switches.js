// @ts-check
// Switches that show what is on, not what was clicked last.
import { make, setAttribute, setEnabled } from "../dom.js";

/** @param {string} title @param {...Node} nodes */
export const group = (title, ...nodes) => make("fieldset", { className: "connection-set" }, make("legend", {}, title), ...nodes);

/**
 * What is on, with wishes that the robot's connection hasn't answered yet: without them, the second of two quick clicks
 * would undo the first.
 * @template {object} T
 * @param {import("./tab.js").ConnectionTab} it
 * @param {T} now
 */
export function wishes(it, now) {
  let unanswered = 0;
  /** The view at the last answer: it can be older than what was answered. @type {unknown} */
  let outdated;
  return {
    get now() {
      return now;
    },
    /** @param {Partial<T>} wish */
    wish: (wish) => (now = { ...now, ...wish }),
    /** @param {import("./types").Request} request */
    async ask(request) {
      unanswered += 1;
      await it.request(request);
      unanswered -= 1;
      outdated = it.view;
    },
    /** What is on by the latest view. @param {T} real */
    take(real) {
      if (unanswered === 0 && (it.view !== outdated || !it.view.is_open)) now = real;
      return now;
    },
  };
}

/**
 * Toggles of a byte's bits.
 * @param {[bit: number, name: string, tip?: string][]} list
 * @param {(bit: number) => void} act
 */
export function toggles(list, act) {
  const all = list.map(([bit, name, tip]) => {
    const node = make("button", { type: "button", className: "toggle", "aria-pressed": "false", ...(tip ? { "data-tip": tip } : {}) }, name);
    node.addEventListener("click", () => {
      if (node.getAttribute("aria-disabled") !== "true") act(bit);
    });
    return { bit, node };
  });
  return {
    node: make("div", { className: "connection-hand" }, ...all.map(({ node }) => node)),
    /** @param {number} bits @param {boolean} can */
    show(bits, can) {
      for (const { bit, node } of all) {
        setAttribute(node, "aria-pressed", String((bits & bit) !== 0));
        setEnabled(node, can);
      }
    },
  };
}

/**
 * A range that acts when it is let go.
 * @param {string} label @param {number} min @param {number} max @param {(value: number) => void} act
 */
export function slider(label, min, max, act) {
  const node = make("input", { type: "range", min: String(min), max: String(max), value: "0" });
  let isHeld = false;
  node.addEventListener("input", () => (isHeld = true));
  node.addEventListener("change", () => {
    isHeld = false;
    act(node.valueAsNumber);
  });
  return {
    field: make("label", { className: "field" }, make("span", { className: "label" }, label), node),
    get value() {
      return node.valueAsNumber;
    },
    /** @param {number} value @param {boolean} can */
    show(value, can) {
      if (!isHeld && node.valueAsNumber !== value) node.value = String(value);
      if (node.disabled === can) node.disabled = !can;
    },
  };
}
