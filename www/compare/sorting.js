// @ts-check
// How a table is sorted: by a column, best first. A second press on its head turns that round, a third one takes it back.
import { make } from "../dom.js";

/** @typedef {{ key: string, down: boolean } | undefined} Order */

/** What a press on the head of a column makes of an order. @param {Order} order @param {string} key @returns {Order} */
export function pressed(order, key) {
  if (order?.key !== key) return { key, down: false };
  return order.down ? undefined : { key, down: true };
}

/** An order as a part of a link. @param {Order} order */
export const inLink = (order) => (order ? `&sort=${order.key}${order.down ? "-" : ""}` : "");

/** @param {URLSearchParams} pairs Of a link. @returns {Order} */
export function fromLink(pairs) {
  const [, key, down] = /^(\w+)(-?)$/.exec(pairs.get("sort") ?? "") ?? [];
  return key ? { key, down: down === "-" } : undefined;
}

/** The head of a column, by which one sorts. @param {HTMLElement} cell @param {string} label @param {string} key @param {"lower" | "higher"} better @param {Order} order @param {(key: string) => void} sortBy */
export function sortHead(cell, label, key, better, order, sortBy) {
  cell.prepend(make("button", { type: "button", className: "term", "data-key": key, onclick: () => sortBy(key) }, label));
  cell.setAttribute("aria-sort", order?.key !== key ? "none" : order.down === (better === "lower") ? "descending" : "ascending");
}

/**
 * Rows by their values, those without one last.
 * @template Row
 * @param {readonly Row[]} rows
 * @param {Exclude<Order, undefined>} order
 * @param {"lower" | "higher"} better
 * @param {(row: Row) => number | null | undefined} value
 */
export function sorted(rows, { down }, better, value) {
  const sign = (better === "lower") === down ? -1 : 1;
  const known = (/** @type {Row} */ row) => value(row) ?? sign * Infinity;
  return [...rows].sort((a, b) => (known(a) === known(b) ? 0 : sign * (known(a) - known(b))));
}

/** Rebuilds a table, but leaves the keyboard focus where it was. @param {HTMLElement} table @param {() => void} rebuild */
export function keepingFocus(table, rebuild) {
  const key = table.contains(document.activeElement) ? document.activeElement?.closest("[data-key]")?.getAttribute("data-key") : undefined;
  rebuild();
  const same = key && table.querySelector(`[data-key="${key}"]`);
  if (same instanceof HTMLElement) same.focus({ preventScroll: true });
}
