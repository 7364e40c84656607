// @ts-check
// Programs that are kept in this browser, each by itself, as rooms are (www/explore/own-rooms.js).
import { newId } from "../explore/own-rooms.js";
import { toast } from "../messages.js";

/**
 * @typedef {import("./editor.js").Language} Language
 * @typedef {object} Program
 * @property {string} id Of an example: its name. Of an own program: a colon and letters.
 * @property {string} name
 * @property {Language} language
 * @property {string} source
 * @property {boolean} [isForeign] It came by a link or a file: its author isn't known.
 */

const LIST = "own-programs";
/** The program that was shown last, for the next visit. */
const LAST = "program-last";
/** Longest program, letters, as in crates/robovac-core/src/program.rs. */
export const MOST_LETTERS = 200_000;
const MOST_NAME = 80;
let warned = false;

/** Texts that are ours or were written here, but aren't kept, by the ids of their programs. @type {Map<string, string>} */
const trusted = new Map();

/** Whether a program's text was written here, or comes with the page: not by a link or a file. @param {string} source */
export const isTrusted = (source) => [...trusted.values()].includes(source) || list().some(({ id, isForeign }) => !isForeign && find(id)?.source === source);

/** An example. @param {Program} program @returns {Program} */
export function trust(program) {
  trusted.set(program.id, program.source);
  return program;
}

const keyOf = (/** @type {string} */ id) => `own-program-${id}`;

/** All but their texts, the latest last. @returns {Omit<Program, "source">[]} */
export function list() {
  try {
    const found = JSON.parse(localStorage.getItem(LIST) ?? "[]");
    return Array.isArray(found) ? found.filter((one) => typeof one?.id === "string" && typeof one.name === "string" && (one.language === "python" || one.language === "javascript")) : [];
  } catch {
    return [];
  }
}

/** @param {string} id @returns {Program | undefined} */
export function find(id) {
  const known = list().find((one) => one.id === id);
  try {
    const source = localStorage.getItem(keyOf(id));
    return known && source !== null ? { ...known, source } : undefined;
  } catch {
    return undefined;
  }
}

/** Keeps a program; a new one comes last. @param {Program} program */
export function put({ source, ...rest }) {
  try {
    localStorage.setItem(keyOf(rest.id), source);
    const programs = list();
    const index = programs.findIndex(({ id }) => id === rest.id);
    if (index < 0) programs.push(rest);
    else programs[index] = rest;
    localStorage.setItem(LIST, JSON.stringify(programs));
  } catch (error) {
    if (!rest.isForeign) trusted.set(rest.id, source);
    // A private window has no storage at all, and the program isn't expected to stay.
    if (warned || !(error instanceof DOMException) || error.name !== "QuotaExceededError") return;
    warned = true;
    toast("There is no space left to keep this program in this browser. Export it before you leave, or delete others.");
  }
}

/** @param {string} id */
export function remove(id) {
  try {
    localStorage.removeItem(keyOf(id));
    localStorage.setItem(LIST, JSON.stringify(list().filter((one) => one.id !== id)));
  } catch {
    // Without storage there is nothing to remove.
  }
}

export const freshId = () => `:${newId()}`;
export const isOwn = (/** @type {string} */ id) => id.startsWith(":");

/** A name that no other program has. @param {string} name @param {string} [id] The program that may have it. */
export function freeName(name, id) {
  const taken = new Set(list().filter((one) => one.id !== id).map((one) => one.name));
  const short = name.trim().slice(0, MOST_NAME - 4) || "Program";
  let free = short;
  for (let number = 2; taken.has(free); number += 1) free = `${short} ${number}`;
  return free;
}

export const endingOf = (/** @type {Language} */ language) => (language === "python" ? ".py" : ".js");

/** Reads a file with a program. @param {File} file @returns {Promise<Program>} Throws messages for users. */
export async function readProgram(file) {
  const ending = /\.(py|js|mjs)$/i.exec(file.name)?.[1]?.toLowerCase();
  if (!ending) throw `${file.name} is not a program: its name should end in .py or .js.`;
  if (file.size > MOST_LETTERS) throw `${file.name} has ${Math.ceil(file.size / 1000)} KB, more than the ${MOST_LETTERS / 1000} KB that a program may have.`;
  const source = (await file.text()).replace(/^\uFEFF/, "").replace(/\r\n?/g, "\n");
  return { id: freshId(), name: freeName(file.name.replace(/\.\w+$/, "")), language: ending === "py" ? "python" : "javascript", source, isForeign: true };
}

/** The program that was shown last. */
export function remembered() {
  try {
    return localStorage.getItem(LAST) ?? "";
  } catch {
    return "";
  }
}

/** @param {string} id */
export function remember(id) {
  try {
    localStorage.setItem(LAST, id);
  } catch {
    // Without storage the first program opens the next time.
  }
}
