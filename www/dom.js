// @ts-check
// The few helpers for the document that every module needs.

/**
 * The element with that id.
 * @param {string} id
 * @returns {HTMLElement}
 */
export function byId(id) {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no #${id}`);
  return found;
}

/**
 * The element with that id, as one of a class.
 * @template {Element} T
 * @param {string} id
 * @param {{ new (): T, prototype: T }} type
 * @returns {T}
 */
export function typed(id, type) {
  const found = document.getElementById(id);
  if (!(found instanceof type)) throw new Error(`the page has no ${type.name} #${id}`);
  return found;
}

/** @param {string} id */
export const button = (id) => typed(id, HTMLButtonElement);
/** @param {string} id */
export const select = (id) => typed(id, HTMLSelectElement);
/** @param {string} id */
export const input = (id) => typed(id, HTMLInputElement);

/**
 * A new element; properties are set as properties, `data-`, `aria-` and others with a dash as attributes.
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag
 * @param {Record<string, unknown>} [properties]
 * @param {...(Node | string)} children
 * @returns {HTMLElementTagNameMap[K]}
 */
export function make(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.includes("-") || name === "for" || name === "scope") element.setAttribute(name, String(value));
    else Reflect.set(element, name, value);
  }
  element.append(...children);
  return element;
}

/**
 * The options of a select, replaced.
 * @param {HTMLSelectElement} into
 * @param {[value: string, label: string][]} options
 */
export function fill(into, options) {
  into.replaceChildren(...options.map(([value, label]) => make("option", { value }, label)));
}

/** @type {WeakMap<Node, Map<string, unknown>>} */
const written = new WeakMap();

/**
 * Whether `value` differs from the last one for this node and key: the page writes only changes.
 * @param {Node} node
 * @param {string} key
 * @param {unknown} value
 */
export function changed(node, key, value) {
  let known = written.get(node);
  if (!known) written.set(node, (known = new Map()));
  if (known.get(key) === value) return false;
  known.set(key, value);
  return true;
}

/**
 * @param {Element} node
 * @param {string} value
 */
export function setText(node, value) {
  if (changed(node, "text", value)) node.textContent = value;
}

/**
 * @param {HTMLElement} node
 * @param {boolean} value
 */
export function setHidden(node, value) {
  if (changed(node, "hidden", value)) node.hidden = value;
}

/**
 * @param {Element} node
 * @param {string} name
 * @param {string} value
 */
export function setAttribute(node, name, value) {
  if (changed(node, name, value)) node.setAttribute(name, value);
}

/**
 * Enables or disables a control. One with the focus would lose it, so it is only marked as disabled.
 * @param {HTMLButtonElement | HTMLSelectElement} node
 * @param {boolean} enabled
 */
export function setEnabled(node, enabled) {
  const focused = document.activeElement === node;
  const disabled = !enabled && !focused;
  if (node.disabled !== disabled) node.disabled = disabled;
  setAttribute(node, "aria-disabled", String(!enabled));
}
